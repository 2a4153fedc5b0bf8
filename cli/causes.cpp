// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/causes.hpp"

#include <algorithm>
#include <cstdint>
#include <exception>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "campaign/selection.hpp"
#include "fuzz/identify/attribution.hpp"
#include "oracle/records/finding.hpp"

namespace gonogo::cli {
namespace {

constexpr std::size_t kMostOfFinding = 8;  // cases
constexpr std::size_t kMostOfCycle = 4;    // of those that tell whether a cause holds

using identify::ProgramAsked;

// Cases as the campaign asked for them.
struct Programs {
  std::map<std::string, ProgramAsked> of_findings;              // by their ids
  std::map<std::string, std::vector<ProgramAsked>> of_dialect;  // a few of each cycle
};

// A breakdown has no cause in the reference's terms.
bool may_have_cause(const oracle::Finding& finding) {
  const oracle::VerdictKind kind = finding.key.kind;
  return oracle::is_other_answer(kind) && kind != oracle::VerdictKind::fail_reading;
}

// The smallest case of the finding, and some more.
std::vector<std::string> ids_of(const oracle::Finding& finding) {
  std::vector<std::string> ids = {finding.smallest.id};
  for (const std::string& id : finding.first) {
    if (id != ids.front() && ids.size() < kMostOfFinding) ids.push_back(id);
  }
  return ids;
}

Programs programs_of(const std::vector<const oracle::Finding*>& findings,
                     const oracle::Corpus& corpus, const oracle::CampaignOptions& campaign) {
  std::set<std::string> wanted;
  for (const oracle::Finding* finding : findings) {
    for (std::string& id : ids_of(*finding)) wanted.insert(std::move(id));
  }
  Programs programs;
  std::map<std::pair<std::string, std::string>, std::size_t> of_cycle;
  oracle::CaseReader reader(corpus, oracle::Detail::to_run, campaign.dialects);
  while (const auto test = reader.next()) {
    const bool is_wanted = wanted.contains(test->id);
    if (!is_wanted && of_cycle[{test->dialect, test->cycle}] == kMostOfCycle) continue;
    const auto own = oracle::under(campaign, *test);
    if (!own) continue;
    const ProgramAsked asked{own->id, own->program, own->profile};
    if (is_wanted) {
      programs.of_findings[own->id] = asked;
    } else {
      programs.of_dialect[test->dialect].push_back(asked);
      ++of_cycle[{test->dialect, test->cycle}];
    }
  }
  return programs;
}

std::vector<ProgramAsked> asked_of(const oracle::Finding& finding, const Programs& programs) {
  std::vector<ProgramAsked> own;
  for (const std::string& id : ids_of(finding)) {
    const auto found = programs.of_findings.find(id);
    if (found != programs.of_findings.end()) own.push_back(found->second);
  }
  return own;
}

// The causes of findings, one after the other: those that are known are tried first.
class Naming {
 public:
  Naming(const oracle::Corpus& corpus, const oracle::SubjectMaker& make,
         const identify::ExplanationOptions& options, std::size_t most)
      : corpus_(corpus), make_(make), options_(options), most_(most) {}

  // Throws SubjectUnusable.
  void take(const oracle::Finding& finding, const Programs& programs) {
    const std::vector<ProgramAsked> own = asked_of(finding, programs);
    if (own.empty()) return;
    const auto others = programs.of_dialect.find(finding.key.dialect);
    identify::FindingAsked asked{own, {}};
    if (others != programs.of_dialect.end()) asked.others = others->second;
    const identify::LikelyCause* const known =
        named_.empty() ? nullptr : recognise(named_, *make_(), asked, options_);
    if (known != nullptr) {
      asked_[finding.key] = static_cast<std::size_t>(known - named_.data());
    } else if (attributed_ < most_) {
      ++attributed_;
      const auto subject = make_();
      asked_[finding.key] =
          add(likely_cause(identify::attribute(*subject, corpus_, own.front(), options_)));
    }
  }
  oracle::evidence::Causes causes() const {
    oracle::evidence::Causes causes;
    causes.asked = asked_.size();
    for (const auto& [key, cause] : asked_) {
      if (cause < named_.size()) causes.of[key] = named_[cause].told();
    }
    return causes;
  }

 private:
  static constexpr std::size_t kNone = SIZE_MAX;

  // Its place among those that are named.
  std::size_t add(const identify::LikelyCause& likely) {
    if (likely.empty()) return kNone;
    const auto same = std::ranges::find(named_, likely.name, &identify::LikelyCause::name);
    const auto place = static_cast<std::size_t>(same - named_.begin());
    same == named_.end() ? named_.push_back(likely) : same->add(likely);
    return place;
  }

  const oracle::Corpus& corpus_;
  const oracle::SubjectMaker& make_;
  const identify::ExplanationOptions& options_;
  std::size_t most_;
  std::size_t attributed_ = 0;
  std::vector<identify::LikelyCause> named_;
  std::map<oracle::Finding::Key, std::size_t> asked_;  // of those, or kNone
};

}  // namespace

oracle::evidence::Causes find_causes(const CampaignSummary& summary, const oracle::Corpus& corpus,
                                     const oracle::CampaignOptions& campaign,
                                     const oracle::SubjectMaker& make, std::size_t most) {
  const identify::ExplanationOptions options{campaign.grants, kMostRecordsToExplain};
  std::vector<const oracle::Finding*> findings = summary.findings.list();
  std::erase_if(findings, [](const auto* finding) { return !may_have_cause(*finding); });
  if (findings.empty()) return {};
  Naming naming(corpus, make, options, most);
  try {
    const Programs programs = programs_of(findings, corpus, campaign);
    for (const oracle::Finding* finding : findings) naming.take(*finding, programs);
  } catch (const std::exception&) {
    return naming.causes();  // the run has its answer; what it comes from is a courtesy
  }
  return naming.causes();
}

}  // namespace gonogo::cli
