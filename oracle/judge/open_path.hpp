// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the judges of open paths (threads, helical pockets) have in common: motions of the subject
// come in one at a time until the path is over.
#pragma once

#include "oracle/judge/clearance.hpp"
#include "oracle/judge/motion.hpp"
#include "oracle/judge/terms.hpp"
#include "oracle/verdict.hpp"

namespace gonogo::oracle {

struct OpenPathAnswer {
  enum class Kind {
    taken,   // the motion belongs to the path
    ended,   // the path is over at `here`, which lies on the motion; the rest of it comes after
    decided  // `verdict`
  } kind = Kind::taken;
  Position here;
  Verdict verdict;
  bool progress = true;  // of a motion taken: it brings the path nearer to its end

  static OpenPathAnswer take() { return {}; }
  // Taken, but it moves nothing that is seen.
  static OpenPathAnswer wait() { return {Kind::taken, {}, {}, false}; }
  static OpenPathAnswer end(const Position& here) { return {Kind::ended, here, {}, true}; }
  static OpenPathAnswer decide(Verdict verdict) {
    return {Kind::decided, {}, std::move(verdict), true};
  }
  static OpenPathAnswer gap(std::string message);
};

// Whether the motion cuts: then it must carry the feed of its cycle.
constexpr bool is_cut(RecordKind kind) {
  return kind == RecordKind::feed || kind == RecordKind::arc;
}
// Whether a rotary axis moves.
bool turns_rotary_axis(const Motion& motion, const Number& tolerance);

// A NO-GO with what both sides say; the witness is where the motion ends.
Verdict departure_from(VerdictKind kind, reference::ClauseId clause, const Motion& motion,
                       std::string want, std::string message);

// How far apart two numbers are, as the evidence of a verdict.
void set_deviation(Verdict& verdict, const Number& deviation);

}  // namespace gonogo::oracle
