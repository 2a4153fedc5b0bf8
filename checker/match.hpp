// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a subject did against what must come: the rules of path, alarm and end, exactly.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "checker/corpus.hpp"

namespace gonogo::checker {

// How a trace ends. `unknown`: a results file keeps records, but not how they ended.
enum class TraceEnd { end, alarm, unknown };

struct Trace {
  std::vector<Record> records;  // without the record `end`
  std::optional<Position> end;  // of the record `end`, which a subject may leave out
  TraceEnd ending = TraceEnd::end;
  Alarm alarm;
};

// What the subject declared, and the certifier set.
struct Tolerances {
  Real tolerance;                           // mm
  std::optional<Rational> resolution;       // lengths are rounded to it
  std::optional<Rational> feed_resolution;  // feeds are rounded to it
  Rational increment = Rational(1, 1000);   // of the machine: the coarsest rounding
  bool is_binary64 = false;                 // feeds may be off by 2 ulp
  bool is_exact = false;                    // it says that no number is rounded
  bool has_blocks = true;                   // the records name source lines
  bool has_functions = true;                // M functions are sent
};

enum class Answer { fits, departs, undecided };

struct Judgement {
  Answer answer = Answer::fits;
  std::string why;  // a sentence, with the exact numbers; of `undecided`: the reason
  // Motions about as short as the tolerance were left out, which the program may distinguish.
  bool is_doubtful = false;
};

// `why` of an undecided finding in a path that the manual leaves open.
inline constexpr const char* kOpenPath = "the path is open: judged by what it clears";

Judgement match(const Vector& vector, const Expectation& expectation, const Trace& trace,
                const Tolerances& tolerances);

}  // namespace gonogo::checker
