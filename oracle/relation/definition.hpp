// SPDX-License-Identifier: GPL-3.0-or-later
//
// THIS IS THE DEFINITION OF GO AND NO-GO, to be read beside docs/relation.md, sentence by sentence.
// It is naive on purpose: it looks at every correspondence and forgets nothing, and takes the time
// and memory for that. Campaigns run the judge; tests compare it with this.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "oracle/records/subject_outcome.hpp"
#include "oracle/records/verdict.hpp"
#include "reference/profile.hpp"

namespace gonogo::relation {

using exact::Number;

// How the two sides are compared.
struct Tolerances {
  Number tolerance = Number::millionths(1000);  // tau, mm an axis
  Number increment = Number::millionths(1000);  // the profile's resolution
  Number chord;                                 // granted, mm; 0: none
  std::optional<Number> resolution;             // declared, of lengths, leads and times
  std::optional<Number> feed_resolution;
  bool binary64 = false;
  bool exact = false;  // the subject says that it rounds nothing
  bool compare_blocks = true;
  bool compare_m = false;
  bool strict = false;
};

// What is broken: R2 to R8 of docs/relation.md.
enum class Rule : std::uint8_t { none, place, label, traverse, event, alarm, free_step };
std::string_view name(Rule rule);  // "R2"; "" for none

// Why there is no answer (R9).
enum class GapReason : std::uint8_t {
  none,
  not_covered,
  profile_lacks,     // what the program needs of it
  cutting,           // the answer lies within the width to which curves are cut
  comparison,        // two numbers at 4,096 bits
  two_readings,      // of one trace, with different verdicts
  many_assignments,  // of open readings: more than 64
  reading_unfit,     // its run-out leads into the material by itself
};
std::string_view name(GapReason reason);

struct Answer {
  oracle::VerdictKind kind = oracle::VerdictKind::fail_geometry;
  Rule rule = Rule::none;
  GapReason gap = GapReason::none;
  reference::ClauseId clause = reference::kNoClause;
  std::optional<std::size_t> record;  // the subject's, from 0: the farthest that is reached
  std::uint64_t block = 0;            // of the reference's event there; 0: it is the end
  bool runs_on = false;               // R7: over an alarm that no text states
  std::string want;                   // the reference's event there
  std::string got;                    // the subject's
  std::string distance;               // of their ends, mm
  std::string message;
};

// What the subject did: its records, and the alarm that closes them, if one does.
struct Outcome {
  std::span<const reference::Record> records;
  const oracle::SubjectAlarm* alarm = nullptr;
};

// `program` and `outcome` are as the judge gets them.
Answer decide(const reference::Profile& profile, std::string_view program,
              const Tolerances& tolerances, const Outcome& outcome);

}  // namespace gonogo::relation
