// SPDX-License-Identifier: GPL-3.0-or-later
//
// R8: what a manual leaves open, by the conditions of its clause.
#pragma once

#include <string_view>
#include <vector>

#include "oracle/relation/subject_side.hpp"
#include "reference/outcome.hpp"

namespace gonogo::relation {

// A helical pocket leaves open at which point of its circle the tool comes to the helix; that point
// settles everything. The paths for all points at which the subject, from its event `begin` on, may
// have come to it.
std::vector<std::vector<reference::Record>> paths_of(const reference::HelixPocket& pocket,
                                                     SubjectSide& subject, std::size_t begin,
                                                     const Number& tau);

// What the subject's events from one on are of a step, by those of its conditions that are stated
// here: where the step may be over, or which event breaks one.
struct StepAnswer {
  std::vector<std::size_t> ends;
  std::size_t broken_by = 0;
  std::string_view broken;  // a sentence; empty: none that is stated
};
StepAnswer follow(const reference::PocketLevel& level, SubjectSide& subject, std::size_t begin,
                  const Terms& terms);
StepAnswer follow(const reference::PocketMilling& pocket, SubjectSide& subject, std::size_t begin,
                  const Terms& terms);
StepAnswer follow(const reference::ThreadMilling& thread, SubjectSide& subject, std::size_t begin,
                  const Terms& terms);

// The way round a middle, in quarters of a turn, and how far it has gone back.
class Winding {
 public:
  // `sense` as the sign of rot; nearer to the middle than `blind` nothing goes round it.
  Winding(int sense, Number blind) : sense_(sense), blind_(std::move(blind)) {}
  // From the middle.
  struct Offset {
    Number p;
    Number q;
  };
  void take(const Offset& to);
  // Another stretch begins: the way to it does not count.
  void leave() { last_.reset(); }
  bool goes_back() const { return most_ - quarters_ > 2; }  // by more than half a turn
  std::int64_t quarters() const { return quarters_; }

 private:
  static int quarter_of(const Offset& offset);
  int sense_;
  Number blind_;
  std::optional<Offset> last_;
  std::int64_t quarters_ = 0;
  std::int64_t most_ = 0;
};

// The end of a stretch of one label that stays near where it begins; nothing where it does not.
std::optional<std::size_t> end_of_small_stretch(SubjectSide& subject, std::size_t begin,
                                                const Number& tau);

// How far a piece may go in the plane.
inline Number way_of(const Event& piece, reference::Axis axis) {
  return abs(piece.to[axis] - piece.from[axis]);
}

// Follows the subject from piece `begin` on under conditions that say where the step may be over
// (`may_be_over`) and which sentence a piece breaks (`take`). Behind an end the next block's motions need not
// be of the step.
template <typename Conditions>
StepAnswer follow_under(Conditions& conditions, SubjectSide& subject, std::size_t begin,
                        const Number& tau) {
  StepAnswer answer;
  for (std::size_t i = begin;; ++i) {
    const Event& piece = subject.at(i);
    if (piece.begins && conditions.may_be_over(piece.from)) answer.ends.push_back(i);
    if (!piece.is_motion()) break;
    if (const auto end = end_of_small_stretch(subject, i, tau)) {
      i = *end - 1;
      continue;
    }
    const std::string_view broken = conditions.take(piece);
    if (broken.empty()) continue;
    answer.broken_by = i;
    answer.broken = broken;
    break;
  }
  return answer;
}

}  // namespace gonogo::relation
