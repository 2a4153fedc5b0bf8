// SPDX-License-Identifier: GPL-3.0-or-later
//
// A step of the reference whose path the manual leaves open (a thread, a helical pocket, a level of
// a pocket, a pocket of LCYC75). It holds the clauses of its cycle: the path judge knows none.
// Motions of the subject come in one at a time until the path is over.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "oracle/motion/motion.hpp"
#include "oracle/motion/tolerances.hpp"
#include "oracle/records/verdict.hpp"
#include "oracle/region/level.hpp"
#include "oracle/steps/reference_steps.hpp"

namespace gonogo::oracle {

struct FreeStepAnswer {
  enum class Kind {
    taken,   // the motion belongs to the path
    ended,   // the path is over at `here`, which lies on the motion; the rest of it comes after
    decided  // `verdict`
  } kind = Kind::taken;
  Position here;
  Verdict verdict;
  // How a motion that is taken counts for the budget of records (J-CYC-02).
  enum class Cost { counts, free, level_cut } cost = Cost::counts;

  static FreeStepAnswer take(Cost cost = Cost::counts) { return {Kind::taken, {}, {}, cost}; }
  static FreeStepAnswer end(const Position& here) { return {Kind::ended, here, {}}; }
  static FreeStepAnswer decide(Verdict verdict) { return {Kind::decided, {}, std::move(verdict)}; }
  static FreeStepAnswer gap(GapReason reason, std::string message) {
    return decide(gap_verdict(reason, std::move(message)));
  }
  bool is_decided() const { return kind == Kind::decided; }
};

class FreeStep {
 public:
  FreeStep() = default;
  FreeStep(const FreeStep&) = delete;
  virtual ~FreeStep() = default;

  virtual FreeStepAnswer take(const Motion& motion) = 0;
  // The path ends where the subject stands. Nothing: it may; else why not.
  virtual std::optional<Verdict> end(const Position& here) = 0;

  // Where the reference goes on after a path that has ended `here`.
  struct Exit {
    Position at;
    bool moves_machine = false;  // blocks that follow start there, too
  };
  virtual Exit exit(const Position& here) const = 0;

  // For a negligible motion: whether it comes before the path and is no part of it.
  virtual bool is_before(const Motion& /*motion*/) const { return false; }
  // For a motion too small to see: whether it belongs to the path all the same.
  virtual bool sees(const Motion& /*small*/) const { return false; }
  // For such a motion: whether the path may be over where it starts, so that it comes after.
  virtual bool may_be_left_by(const Motion& /*small*/) const { return false; }
  // Whether the motion that leads to the path may go on into it, as `rest`.
  virtual bool may_begin_within(const Motion& /*rest*/) const { return false; }
  // Whether an unfinished path is judged as a whole where it is left, and not only in the end; the
  // same at an alarm, where there is something to judge.
  virtual bool is_judged_when_left() const { return false; }
  virtual bool is_judged_at_alarm(const Position& /*here*/) const { return false; }
  // Whether the path leaves open only where it begins: then R1 to R5 decide it, and not R8.
  virtual bool is_path_known() const { return false; }
};

// What holds for a whole program.
class FreeStepMemory;

// The judge of a step, from where the reference stands before it. Null: the step is not open.
// All that is given must outlive it.
std::unique_ptr<FreeStep> make_free_step(const ReferenceSteps::Step& step,
                                         const Tolerances& tolerances, FreeStepMemory& memory);

bool is_free_step(const ReferenceStep& step);

// Whether the motion cuts: then it must carry the feed of its cycle.
constexpr bool is_cut(RecordKind kind) {
  return kind == RecordKind::feed || kind == RecordKind::arc;
}
// Whether a rotary axis moves from one place to another.
bool turns_rotary_axis(const Position& from, const Position& to, const Number& tolerance);

// A NO-GO of a step of that block, with what both sides say; the witness is where the motion ends.
Verdict departure_from(VerdictKind kind, reference::ClauseId clause, std::uint64_t block,
                       const Motion& motion, std::string want, std::string message);

// " It is 250 mm/min in place of 200 mm/min.", behind a sentence that says what differs. Of a
// motion that turns a rotary axis alone in degrees/min.
std::string feed_in_place_of(const reference::Record& got, const Number& feed,
                             reference::FeedMode mode, bool in_degrees = false);

// A NO-GO of what came before the last motion: it shows at a place.
Verdict fault_of_step(VerdictKind kind, reference::ClauseId clause, std::uint64_t block,
                      std::string want, const Position& at, std::string message);
// Which cut of a level breaks a rule, or which is its last, and by how much; `records` are those of
// the cuts.
void add_finding(Verdict& verdict, const region::Finding& finding,
                 std::span<const region::LevelMotion> cuts, std::span<const Record> records);

// A NO-GO of a motion that has ended elsewhere than at `due`, as what follows shows: its last
// record is named, and the deviation where it is known.
Verdict ended_elsewhere(reference::ClauseId clause, std::uint64_t block, const Motion& last,
                        const Position& due, std::string want, std::string message);

// " It makes 2 of 3 turns.", behind a sentence that says what ends too early: `missing` is an
// estimate. Empty where no whole turn is missing.
std::string turns_that_came(const Number& due, double missing);

// How far apart two numbers are, as the evidence of a verdict.
void set_deviation(Verdict& verdict, const Number& deviation);

}  // namespace gonogo::oracle
