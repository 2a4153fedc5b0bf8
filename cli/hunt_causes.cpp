// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/hunt_causes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <tuple>
#include <utility>

#include "cli/causes.hpp"
#include "cli/hunt_words.hpp"
#include "cli/subjects.hpp"
#include "fuzz/hunt/campaign_page.hpp"
#include "fuzz/hunt/finding_files.hpp"
#include "fuzz/identify/shared_causes.hpp"
#include "fuzz/program/modes.hpp"
#include "oracle/records/finding.hpp"
#include "reference/descriptor.hpp"

namespace gonogo::cli {
namespace {

using identify::ProgramAsked;

constexpr std::size_t kMostOthers = 800;   // programs
constexpr std::size_t kMostOfCodes = 150;  // of them, with the codes of one symptom

// A breakdown has no cause in the reference's terms, and one program does not show what is left
// over from others.
bool may_have_cause(const hunt::Signature& signature) {
  return oracle::is_other_answer(signature.kind);
}

std::unique_ptr<oracle::Subject> subject_to_ask(const TrialWords& words) {
  const hunt::TrialOptions options = trial_options(words);
  auto made = trial_subject(words)();
  made->set_run_limit(options.run_limit);
  return with_alarm_map(std::move(made), options.alarm_map);
}

identify::ExplanationOptions explanation_options(const TrialWords& words) {
  return {words.limits.grants(), kMostRecordsToExplain};
}

// The codes of a program, without the traverse and the feed that nearly all have.
std::set<std::string> codes_of(const ProgramAsked& asked) {
  std::set<std::string> codes;
  const program::ProgramText text(asked.profile, asked.program);
  for (const program::TextBlock& block : text.blocks) {
    for (const std::string& name : block.codes) {
      const reference::Code* const code = text.table->find(name);
      const bool is_telling = code != nullptr && code->kind != reference::Kind::traverse &&
                              code->kind != reference::Kind::line;
      if (is_telling) codes.insert(name);
    }
  }
  return codes;
}

// Programs that may pass: first the short ones with all codes of a symptom, where its mistake shows
// alone; then any.
std::vector<ProgramAsked> others_beside(const std::vector<ProgramAsked>& symptoms,
                                        const std::vector<ProgramAsked>& all) {
  std::set<std::set<std::string>> wanted;
  for (const ProgramAsked& symptom : symptoms) wanted.insert(codes_of(symptom));
  std::vector<std::pair<const ProgramAsked*, std::set<std::string>>> by_size;
  for (const ProgramAsked& other : all) by_size.emplace_back(&other, codes_of(other));
  std::ranges::sort(by_size, {}, [](const auto& one) {
    return std::tuple(one.first->program.size(), one.first);  // as they stand where as long
  });
  std::set<const ProgramAsked*> chosen;
  for (const std::set<std::string>& codes : wanted) {
    std::size_t taken = 0;
    for (const auto& [other, its] : by_size) {
      if (taken == kMostOfCodes || chosen.size() == kMostOthers) break;
      if (std::ranges::includes(its, codes) && chosen.insert(other).second) ++taken;
    }
  }
  std::vector<ProgramAsked> rest;
  std::vector<ProgramAsked> others;
  for (const ProgramAsked& other : all) (chosen.contains(&other) ? others : rest).push_back(other);
  std::ranges::move(identify::spread(rest, kMostOthers - others.size()),
                    std::back_inserter(others));
  return others;
}

struct Asked {
  std::vector<hunt::Signature> signatures;
  std::vector<ProgramAsked> programs;
};

Asked symptoms_to_ask(const std::string& folder, const hunt::HuntSummary& summary) {
  Asked asked;
  for (const hunt::CampaignFinding& finding : summary.findings) {
    for (const hunt::Symptom& symptom : finding.symptoms) {
      if (!symptom.stands || !may_have_cause(symptom.signature)) continue;
      const generate::GeneratedProgram program =
          hunt::read_reproducer(folder + "/" + symptom.folder, summary.dialect).program;
      asked.signatures.push_back(symptom.signature);
      asked.programs.push_back({symptom.folder, program.text, program.profile});
    }
  }
  return asked;
}

// Programs that showed something new, from all shards.
std::vector<ProgramAsked> other_programs(const std::string& folder) {
  std::vector<ProgramAsked> all;
  for (const std::string& shard : hunt::shards_of(folder)) {
    const hunt::CampaignState state = hunt::read_campaign_state(shard).value();
    for (generate::GeneratedProgram& program : hunt::read_inputs(shard, state)) {
      all.push_back({std::filesystem::path(shard).filename().string(), std::move(program.text),
                     program.profile});
    }
  }
  return all;
}

hunt::Causes causes_of(const Asked& asked, const std::vector<ProgramAsked>& others,
                       const TrialWords& words) {
  hunt::Causes causes;
  if (asked.programs.empty()) return causes;
  const std::unique_ptr<oracle::Subject> subject = subject_to_ask(words);
  const identify::SharedCauses found = find_shared_causes(
      *subject, asked.programs, others_beside(asked.programs, others), explanation_options(words));
  for (const identify::SharedCause& cause : found.causes) {
    for (const std::size_t symptom : cause.symptoms) {
      causes[asked.signatures[symptom]] = cause.told();
    }
  }
  return causes;
}

hunt::Causes causes_of(const std::string& folder, const TrialWords& words,
                       const hunt::HuntSummary& summary) {
  hunt::KnownCauses known = hunt::read_known_causes(folder);
  const bool is_news = std::ranges::any_of(summary.findings, [&](const auto& finding) {
    return std::ranges::any_of(finding.symptoms, [&](const hunt::Symptom& symptom) {
      return !known.asked.contains(symptom.signature);
    });
  });
  if (!is_news) return known.causes;
  try {
    hunt::Causes causes =
        causes_of(symptoms_to_ask(folder, summary), other_programs(folder), words);
    // What was mended is not asked again.
    for (const hunt::CampaignFinding& finding : summary.findings) {
      for (const hunt::Symptom& symptom : finding.symptoms) {
        const auto before = known.causes.find(symptom.signature);
        if (!symptom.stands && before != known.causes.end()) causes.insert(*before);
      }
    }
    return causes;
  } catch (const oracle::SubjectUnusable&) {
    // The hunt has its findings; what they come from is a courtesy.
    return known.causes;
  }
}

}  // namespace

hunt::HuntSummary tell_campaign(const std::string& folder, const TrialWords& words) {
  hunt::HuntSummary summary = hunt::summarize_campaign(folder);
  group_findings(summary, causes_of(folder, words, summary));
  write_campaign_summary(folder, summary);
  write_campaign_page(
      {folder, [&](const std::string& finding) { return reduce_command(finding, words); }},
      summary);
  return summary;
}

hunt::HuntSummary tell_findings(const std::vector<hunt::Finding>& findings, const hunt::Pool& pool,
                                const TrialWords& words) {
  hunt::HuntSummary summary;
  Asked asked;
  for (const hunt::Finding& finding : findings) {
    hunt::Symptom symptom;
    symptom.signature = finding.signature;
    symptom.folder = fmt::format("finding {}", summary.findings.size() + 1);
    symptom.programs = 1;
    summary.findings.push_back({{}, {std::move(symptom)}});
    if (!may_have_cause(finding.signature) || !finding.reproducer.before.empty()) continue;
    const generate::GeneratedProgram& program = finding.reproducer.program;
    asked.signatures.push_back(finding.signature);
    asked.programs.push_back(
        {summary.findings.back().symptoms.front().folder, program.text, program.profile});
  }
  std::vector<ProgramAsked> others;
  for (generate::GeneratedProgram& program : pool.programs()) {
    others.push_back({"tried", std::move(program.text), program.profile});
  }
  try {
    group_findings(summary, causes_of(asked, others, words));
  } catch (const oracle::SubjectUnusable&) {
    group_findings(summary, {});  // what they come from is a courtesy
  }
  return summary;
}

KnownMistakes::KnownMistakes(const std::string& folder, TrialWords words)
    : words_(std::move(words)) {
  hunt::HuntSummary summary = hunt::summarize_campaign(folder);
  group_findings(summary, hunt::read_known_causes(folder).causes);
  for (const hunt::CampaignFinding& finding : summary.findings) {
    if (finding.stands() && !finding.cause.empty()) names_.insert(finding.cause.name);
  }
}

std::string KnownMistakes::cause_of(const hunt::Finding& finding) try {
  if (names_.empty() || !may_have_cause(finding.signature)) return {};
  if (!subject_) subject_ = subject_to_ask(words_);
  subject_->renew();
  const generate::GeneratedProgram& program = finding.reproducer.program;
  return identify::known_cause(*subject_, {"finding", program.text, program.profile}, names_,
                               explanation_options(words_));
} catch (const oracle::SubjectUnusable&) {
  subject_.reset();
  return {};  // the finding is printed as it is
}

}  // namespace gonogo::cli
