// SPDX-License-Identifier: GPL-3.0-or-later
#include "hunt/hunt_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <tuple>

#include "oracle/records/finding.hpp"
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

void add_face(const Signature& signature, const KnownFinding& finding, const std::string& shard,
              const RoundEnds& ends, std::map<Signature, Face>& faces) {
  const auto [place, is_new] = faces.try_emplace(signature);
  Face& face = place->second;
  if (is_new) {
    face.signature = signature;
    face.first = finding.first;
    face.stands = false;
  }
  // The program of a shard in which it stands, rather than of one in which it was mended.
  if (is_new || (!face.stands && finding.stands())) {
    face.folder = shard + "/findings/" + finding.id;
  }
  face.stands = face.stands || finding.stands();
  face.programs += finding.times;
  face.first = std::min(face.first, finding.first);
  face.last = std::max(face.last, finding.last);
  take_earlier(face.first_seen, end_of(ends, finding.first));
  take_later(face.last_seen, end_of(ends, finding.last));
}

void add_shard(const CampaignState& state, const fs::path& folder, HuntSummary& summary,
               std::map<Signature, Face>& faces) {
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
    add_face(signature, finding, folder.filename().string(), ends, faces);
  }
}

// What faces without a cause have in common if they are one finding.
std::string group_of(const Face& face, const Causes& causes) {
  const auto cause = causes.find(face.signature);
  if (cause != causes.end()) return "cause\n" + cause->second;
  const Signature& one = face.signature;
  if (one.clause.empty() || oracle::is_breakdown(one.kind)) return "alone\n" + one.text();
  return fmt::format("shape\n{}\n{}\n{}", name(one.kind), one.clause, one.what);
}

void sort_findings(HuntSummary& summary) {
  for (CampaignFinding& finding : summary.findings) {
    std::ranges::sort(finding.faces, {}, [](const Face& face) {
      return std::tuple(!face.stands, oracle::gravity(face.signature.kind),
                        SIZE_MAX - face.programs, face.signature.text());
    });
  }
  std::ranges::sort(summary.findings, {}, [](const CampaignFinding& finding) {
    const Signature& gravest = finding.faces.front().signature;
    return std::tuple(!finding.stands(), oracle::gravity(gravest.kind),
                      SIZE_MAX - finding.programs(), gravest.text());
  });
}

}  // namespace

bool CampaignFinding::stands() const {
  return std::ranges::any_of(faces, &Face::stands);
}

std::size_t CampaignFinding::programs() const {
  std::size_t sum = 0;
  for (const Face& face : faces) sum += face.programs;
  return sum;
}

std::size_t HuntSummary::faces() const {
  std::size_t sum = 0;
  for (const CampaignFinding& finding : findings) sum += finding.faces.size();
  return sum;
}

std::size_t HuntSummary::standing() const {
  return static_cast<std::size_t>(std::ranges::count_if(findings, &CampaignFinding::stands));
}

HuntSummary summarize_campaign(const std::string& folder) {
  HuntSummary summary;
  std::map<Signature, Face> faces;
  for (const std::string& shard : shards_of(folder)) {
    add_shard(*read_campaign_state(shard), shard, summary, faces);
  }
  for (auto& [signature, face] : faces) summary.findings.push_back({{}, {std::move(face)}});
  sort_findings(summary);
  return summary;
}

void group_findings(HuntSummary& summary, const Causes& causes) {
  std::map<std::string, CampaignFinding> groups;
  for (CampaignFinding& finding : summary.findings) {
    for (Face& face : finding.faces) {
      const auto cause = causes.find(face.signature);
      CampaignFinding& group = groups[group_of(face, causes)];
      if (cause != causes.end()) group.cause = cause->second;
      group.faces.push_back(std::move(face));
    }
  }
  summary.findings.clear();
  for (auto& [key, group] : groups) summary.findings.push_back(std::move(group));
  sort_findings(summary);
}

std::string findings_text(const HuntSummary& summary) {
  const std::size_t mended = summary.findings.size() - summary.standing();
  std::size_t faces = 0;
  for (const CampaignFinding& finding : summary.findings) {
    if (finding.stands()) faces += finding.faces.size();
  }
  std::string text = oracle::counted(summary.standing(), "finding", "findings");
  if (faces > 0) text += ", " + oracle::counted(faces, "face", "faces");
  return mended == 0 ? text : text + fmt::format("; {} mended", mended);
}

std::string cause_text(const CampaignFinding& finding) {
  if (!finding.cause.empty()) return oracle::Cause{finding.cause, {}}.text();
  return "No one mistake that was tried explains it.";
}

std::string clauses_text(const CampaignFinding& finding) {
  std::set<std::string> clauses;
  for (const Face& face : finding.faces) {
    if (!face.signature.clause.empty()) clauses.insert(face.signature.clause);
  }
  return clauses.empty() ? "no clause" : fmt::format("{}", fmt::join(clauses, " "));
}

std::string faces_text(const CampaignFinding& finding) {
  return oracle::counted(finding.faces.size(), "face", "faces");
}

std::string finding_list_text(const HuntSummary& summary) {
  std::string text;
  std::size_t number = 0;
  for (const CampaignFinding& finding : summary.findings) {
    text += fmt::format("{}. {}{}, {}\n   {}\n", ++number,
                        finding.stands() ? "" : "mended: ", faces_text(finding),
                        clauses_text(finding), cause_text(finding));
    for (const Face& face : finding.faces) {
      text += fmt::format("  {:>7} x {}{}  {}\n", face.programs, face.signature.text(),
                          face.stands ? "" : " (mended)", face.folder);
    }
  }
  return text;
}

}  // namespace gonogo::hunt
