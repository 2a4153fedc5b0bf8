// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/hunt_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <tuple>

#include "oracle/records/run_scope.hpp"

namespace gonogo::hunt {
namespace {

namespace fs = std::filesystem;
using Time = std::chrono::system_clock::time_point;
using RoundEnds = std::map<std::size_t, Time>;

std::optional<Time> end_of(const RoundEnds& ends, std::size_t round) {
  const auto found = ends.find(round);
  return found == ends.end() ? std::nullopt : std::optional(found->second);
}

void take_earlier(std::optional<Time>& into, const std::optional<Time>& time) {
  if (time && (!into || *time < *into)) into = time;
}
void take_later(std::optional<Time>& into, const std::optional<Time>& time) {
  if (time && (!into || *into < *time)) into = time;
}

void add_symptom(const Signature& signature, const KnownFinding& finding, const std::string& shard,
                 const RoundEnds& ends, std::map<Signature, Symptom>& symptoms) {
  const auto [place, is_new] = symptoms.try_emplace(signature);
  Symptom& symptom = place->second;
  if (is_new) {
    symptom.signature = signature;
    symptom.first = finding.first;
    symptom.stands = false;
  }
  // The program of a shard in which it stands, rather than of one in which it was mended.
  if (is_new || (!symptom.stands && finding.stands())) {
    symptom.folder = shard + "/findings/" + finding.id;
  }
  symptom.stands = symptom.stands || finding.stands();
  symptom.programs += finding.times;
  symptom.first = std::min(symptom.first, finding.first);
  symptom.last = std::max(symptom.last, finding.last);
  take_earlier(symptom.first_seen, end_of(ends, finding.first));
  take_later(symptom.last_seen, end_of(ends, finding.last));
}

void add_shard(const CampaignState& state, const fs::path& folder, HuntSummary& summary,
               std::map<Signature, Symptom>& symptoms) {
  ++summary.shards;
  summary.dialect = state.dialect;
  summary.subject = state.subject;
  summary.rounds += state.rounds;
  summary.count += state.count;
  summary.inputs += state.inputs.size();
  add_features(summary.features, state.features);
  const bool is_told =
      std::ranges::find(summary.left_out, state.left_out) != summary.left_out.end();
  if (!state.left_out.empty() && !is_told) summary.left_out.push_back(state.left_out);
  RoundEnds ends;
  for (const RoundTime& time : read_round_times(folder.string())) {
    ends[time.round] = time.ended;
    summary.seconds += time.took.count();
    summary.timed_programs += time.programs;
    take_earlier(summary.begun, time.ended);
    take_later(summary.ended, time.ended);
  }
  for (const auto& [signature, finding] : state.findings) {
    add_symptom(signature, finding, folder.filename().string(), ends, symptoms);
  }
}

// What symptoms without a cause have in common if they are one finding. What was due in the place
// of an alarm or of a surplus motion is chance, and tells no findings apart.
std::string group_of(const Symptom& symptom, const Causes& causes) {
  const auto cause = causes.find(symptom.signature);
  if (cause != causes.end()) return "cause\n" + cause->second.name;
  const Signature& one = symptom.signature;
  if (!one.undue_alarm().empty()) return "alarm\n" + one.undue_alarm();
  if (one.is_surplus()) return "surplus";
  if (one.clause.empty() || oracle::is_breakdown(one.kind)) return "alone\n" + one.text();
  return fmt::format("step\n{}\n{}", name(one.kind), one.clause);
}

void sort_findings(HuntSummary& summary) {
  for (CampaignFinding& finding : summary.findings) {
    std::ranges::sort(finding.symptoms, {}, [](const Symptom& symptom) {
      return std::tuple(!symptom.stands, oracle::gravity(symptom.signature.kind),
                        SIZE_MAX - symptom.programs, symptom.signature.text());
    });
  }
  std::ranges::sort(summary.findings, {}, [](const CampaignFinding& finding) {
    const Signature& gravest = finding.symptoms.front().signature;
    return std::tuple(!finding.stands(), oracle::gravity(gravest.kind),
                      SIZE_MAX - finding.programs(), gravest.text());
  });
}

}  // namespace

bool CampaignFinding::stands() const {
  return std::ranges::any_of(symptoms, &Symptom::stands);
}

std::size_t CampaignFinding::programs() const {
  std::size_t sum = 0;
  for (const Symptom& symptom : symptoms) sum += symptom.programs;
  return sum;
}

std::size_t HuntSummary::standing() const {
  return static_cast<std::size_t>(std::ranges::count_if(findings, &CampaignFinding::stands));
}

HuntSummary summarize_campaign(const std::string& folder) {
  HuntSummary summary;
  std::map<Signature, Symptom> symptoms;
  for (const std::string& shard : shards_of(folder)) {
    add_shard(*read_campaign_state(shard), shard, summary, symptoms);
  }
  for (auto& [signature, symptom] : symptoms)
    summary.findings.push_back({{}, {std::move(symptom)}});
  sort_findings(summary);
  return summary;
}

void group_findings(HuntSummary& summary, const Causes& causes) {
  std::map<std::string, CampaignFinding> groups;
  for (CampaignFinding& finding : summary.findings) {
    for (Symptom& symptom : finding.symptoms) {
      const auto cause = causes.find(symptom.signature);
      CampaignFinding& group = groups[group_of(symptom, causes)];
      const bool is_told = !group.cause.empty() && !symptom.stands;  // by one that stands
      if (cause != causes.end() && !is_told) group.cause = cause->second;
      group.symptoms.push_back(std::move(symptom));
    }
  }
  summary.findings.clear();
  for (auto& [key, group] : groups) summary.findings.push_back(std::move(group));
  sort_findings(summary);
}

std::string findings_text(const HuntSummary& summary) {
  const std::size_t mended = summary.findings.size() - summary.standing();
  std::size_t symptoms = 0;
  for (const CampaignFinding& finding : summary.findings) {
    if (finding.stands()) symptoms += finding.symptoms.size();
  }
  std::string text = oracle::counted(summary.standing(), "finding", "findings");
  if (symptoms > 0) text += ", " + oracle::counted(symptoms, "symptom", "symptoms");
  return mended == 0 ? text : text + fmt::format("; {} mended", mended);
}

std::string rounds_text(const HuntSummary& summary) {
  return fmt::format("{} of {}", oracle::counted(summary.rounds, "round", "rounds"),
                     oracle::counted(summary.shards, "shard", "shards"));
}

std::string cause_text(const CampaignFinding& finding) {
  if (!finding.cause.empty()) return finding.cause.text();
  const std::string none = "No one mistake that was tried explains it";
  const Signature& first = finding.symptoms.front().signature;
  if (finding.symptoms.size() == 1) return none + ".";
  if (const std::string alarm = first.undue_alarm(); !alarm.empty()) {
    return fmt::format("{}; each is an alarm {} that is not due.", none, alarm);
  }
  return none + (first.is_surplus() ? "; each makes a motion more than its block asks for." : ".");
}

std::string clauses_text(const CampaignFinding& finding) {
  std::set<std::string> clauses;
  for (const Symptom& symptom : finding.symptoms) {
    if (!symptom.signature.clause.empty()) clauses.insert(symptom.signature.clause);
  }
  return clauses.empty() ? "no clause" : fmt::format("{}", fmt::join(clauses, " "));
}

std::string symptoms_text(const CampaignFinding& finding) {
  return oracle::counted(finding.symptoms.size(), "symptom", "symptoms");
}

std::string finding_list_text(const HuntSummary& summary) {
  std::string text;
  std::size_t number = 0;
  for (const CampaignFinding& finding : summary.findings) {
    text += fmt::format("{}. {}{}, {}\n   {}\n", ++number,
                        finding.stands() ? "" : "mended: ", symptoms_text(finding),
                        clauses_text(finding), cause_text(finding));
    for (const Symptom& symptom : finding.symptoms) {
      text += fmt::format("  {:>7} x {}{}  {}\n", symptom.programs, symptom.signature.text(),
                          symptom.stands ? "" : " (mended)", symptom.folder);
    }
  }
  return text;
}

}  // namespace gonogo::hunt
