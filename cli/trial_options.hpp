// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the commands that try generated programs on a subject have in common.
#pragma once

#include <string>

#include "cli/options.hpp"
#include "fuzz/hunt/hunt.hpp"

namespace gonogo::cli {

struct TrialWords {
  std::string subject;
  std::string alarm_map;
  std::string out;
  LimitOptions limits;
};
// --subject and --alarm-map
void add_tried_subject(Command& command, TrialWords& words);
// Those, --out, and the limits of a run
void add_trial_options(Command& command, TrialWords& words);

// Throws UsageError for what is no subject to be tried on, or no alarm map.
hunt::SubjectMaker trial_subject(const TrialWords& words);
hunt::TrialOptions trial_options(const TrialWords& words);
// Throws UsageError where the subject does not name the dialect.
void check_dialect(const oracle::SubjectInfo& info, const std::string& dialect);

// Writes the finding below --out, if there is one: its id, else "".
std::string keep_finding(const TrialWords& words, std::uint64_t seed, hunt::Trial& trial,
                         const hunt::Finding& finding);

// The finding for people: signature, verdict, the program line by line.
std::string finding_text(const hunt::Finding& finding, std::string next);

}  // namespace gonogo::cli
