// SPDX-License-Identifier: GPL-3.0-or-later
//
// What all shards of a long hunt have found together, grouped by cause: one mistake of
// the subject has often many symptoms.
//   DIR/campaign.json
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "fuzz/hunt/campaign_state.hpp"
#include "fuzz/hunt/round_times.hpp"
#include "oracle/records/finding.hpp"

namespace gonogo::hunt {

// A signature, as one shard or several met it.
struct Symptom {
  Signature signature;
  std::string folder;        // below the campaign's: "shard-1-of-2/findings/ID", of the first shard
  std::size_t programs = 0;  // that showed it
  std::size_t first = 0;     // round of the shard that met it first
  std::size_t last = 0;
  std::optional<std::chrono::system_clock::time_point> first_seen;  // end of the round, if known
  std::optional<std::chrono::system_clock::time_point> last_seen;
  bool stands = true;  // false: its program did not show it any more when it was tried again
};

struct CampaignFinding {
  // The one mistake that explains every symptom. Empty: none that was tried does, and the symptoms
  // are of one kind and one step, by its clause, or have one alarm too many, or motions too many.
  oracle::Cause cause;
  std::vector<Symptom> symptoms;  // by gravity, then that which most programs showed

  bool stands() const;
  std::size_t programs() const;  // a program counts for each symptom
};

struct HuntSummary {
  std::string dialect;
  std::string subject;
  std::size_t shards = 0;
  std::size_t rounds = 0;
  HuntCount count;
  FeatureCounts features;
  std::vector<std::string> left_out;  // what the subject skips, each text of a shard once
  std::size_t inputs = 0;
  double seconds = 0;  // of the rounds whose times are known, shards one after the other
  std::size_t timed_programs = 0;                              // of those rounds
  std::optional<std::chrono::system_clock::time_point> begun;  // end of the first round
  std::optional<std::chrono::system_clock::time_point> ended;
  std::vector<CampaignFinding> findings;  // those that stand first, by gravity, then by programs

  std::size_t standing() const;  // findings
};

// For all shards in the folder, from any machine; with each symptom a finding by itself.
// Throws std::runtime_error where one cannot be read.
HuntSummary summarize_campaign(const std::string& folder);

using Causes = std::map<Signature, oracle::Cause>;
// Symptoms of one cause become one finding; of those without, those of one kind and clause in any
// code, those with one class of alarm that is not due, and those with a surplus motion.
void group_findings(HuntSummary& summary, const Causes& causes);

// "Behaves as if: I J K are taken as absolute. It explains 5 of 5 ...", or that there is none.
std::string cause_text(const CampaignFinding& finding);
// "NGC-ARC-02 NGC-ARC-05"
std::string clauses_text(const CampaignFinding& finding);
// "35 symptoms"
std::string symptoms_text(const CampaignFinding& finding);
// "1 finding, 35 symptoms", of those that stand; "; 2 mended" behind.
std::string findings_text(const HuntSummary& summary);
// "2 rounds of 1 shard".
std::string rounds_text(const HuntSummary& summary);
// Every finding with its cause and its symptoms, for a terminal.
std::string finding_list_text(const HuntSummary& summary);

// Throws std::system_error.
void write_campaign_summary(const std::string& folder, const HuntSummary& summary);
// What the file names; nothing where there is none, or one that is not whole.
struct KnownCauses {
  std::set<Signature> asked;  // with a cause or without
  Causes causes;
};
KnownCauses read_known_causes(const std::string& folder);

}  // namespace gonogo::hunt
