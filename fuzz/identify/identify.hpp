// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which readings a black box follows, found with few programs: each step runs the program whose
// outcomes divide the remaining combinations most evenly, and removes what its outcome rules
// out.
#pragma once

#include <string>
#include <vector>

#include "fuzz/identify/probe.hpp"
#include "oracle/motion/tolerances.hpp"
#include "oracle/records/rounding_census.hpp"

namespace gonogo::identify {

// One program that the subject ran.
struct ProbeRun {
  const Probe* probe = nullptr;
  KeptOutcome outcome;
  std::vector<std::string> learnt;  // sentences; none: nothing new
};

// What is known of one reading.
struct ReadingFound {
  ReadingKey key{};
  std::vector<std::string> values;  // one: it is found; more: they look the same
  std::string why;                  // why they cannot
};

struct Identification {
  std::vector<ProbeRun> runs;
  std::vector<ReadingFound> readings;  // of the dialect, in the order of the catalog
  // No combination explains these runs together: the last one and what it contradicts, if any one
  // does. Empty: the subject follows what `readings` says.
  std::vector<std::size_t> contradiction;  // places in `runs`
  // Departures under every reading: faults, which say nothing of the readings.
  std::vector<std::size_t> aside;  // places in `runs`
  // How its coordinates are rounded in the runs that are GO under what was found.
  oracle::RoundingCensus coordinates;
  double bits = 0;  // log2 of the number of combinations at the beginning

  // Programs that the subject answered.
  std::size_t answered() const;
  // Whether less than half of the programs that ran support the result.
  bool is_thin() const { return answered() * 2 <= runs.size(); }
};

// `pool` must outlive the result. The subject is configured with each program's machine and is not
// given any reading. Throws SubjectUnusable.
Identification identify_readings(oracle::Subject& subject, const ProbePool& pool,
                                 const oracle::Grants& grants);

// For people: each program with what was learnt, then the readings.
std::string identification_text(const Identification& found, std::string_view subject,
                                std::string_view dialect);
// The profile of what was found, for --profile; what was not found stands in comments.
std::string identification_toml(const Identification& found, const Profile& machine);

}  // namespace gonogo::identify
