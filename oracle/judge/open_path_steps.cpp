// SPDX-License-Identifier: GPL-3.0-or-later
//
// ProgramJudge's part for open paths: threads, helical pockets and pockets of LCYC75, each with a
// judge of its own.
#include "oracle/judge/program_judge.hpp"
#include "reference/gsk988ta/thread_path.hpp"

namespace gonogo::oracle {

using reference::HelixPocket;
using reference::PocketMilling;
using reference::ThreadMilling;
using reference::operator""_clause;

ThreadJudge& ProgramJudge::thread_judge(const ThreadMilling& thread) {
  if (!thread_) thread_.emplace(thread, reference_.position(), terms_, run_outs_);
  return *thread_;
}

HelixPocketJudge& ProgramJudge::helix_pocket_judge(const HelixPocket& pocket) {
  if (!helix_pocket_) helix_pocket_.emplace(pocket, terms_);
  return *helix_pocket_;
}

PocketMillingJudge& ProgramJudge::pocket_judge(const PocketMilling& pocket) {
  if (!pocket_) pocket_.emplace(pocket, terms_);
  return *pocket_;
}

bool ProgramJudge::mills_pocket(const Motion& motion) {
  auto* approach = std::get_if<Motion>(&reference_.behind_m_functions());
  if (approach != nullptr && approach->record.clause == "SIE-LC75-04"_clause &&
      approach->record.block == motion.record.block) {
    flush_pending();
    if (verdict_) return false;
  }
  auto* pocket = std::get_if<PocketMilling>(&reference_.behind_m_functions());
  if (pocket == nullptr || (terms_.compare_blocks && motion.record.block != pocket->block)) {
    return false;
  }
  // A traverse is no part of a level; only of a pocket as deep as the tolerance it may be the end.
  const Number& tau = terms_.tolerance;
  const bool is_shallow = pocket->retract - pocket->floor <= tau;
  if (motion.record.kind == RecordKind::rapid && !is_shallow) return false;
  return !agree(motion.from, motion.to(), tau / 1000);
}

// SIE-LC75-11: infeeds of finishing may be fast. Whether this one may is the pocket's to judge.
bool ProgramJudge::dives_into_pocket(Motion& motion) {
  const bool is_approach = want_->record.clause == "SIE-LC75-04"_clause;
  const bool same_block = !terms_.compare_blocks || motion.record.block == want_->record.block;
  if (!is_approach || !same_block || motion.record.kind != RecordKind::rapid ||
      !match_->goes_beyond(motion)) {
    return false;
  }
  reference_.advance();
  if (!std::holds_alternative<PocketMilling>(reference_.current())) return false;
  for (const Axis axis : reference::kLinearAxes) {
    if (moved_axes(motion, 0).has(axis)) motion.from[axis] = want_->to()[axis];
  }
  match_.reset();
  return true;
}

bool ProgramJudge::follow_open_path(const OpenPathAnswer& answer, Motion& motion) {
  switch (answer.kind) {
    case OpenPathAnswer::Kind::taken:
      // J-THR-10: steps of a thread are bounded by its geometry, not by the number of pieces.
      if (answer.progress && thread_) budget_.forgive();
      return true;
    case OpenPathAnswer::Kind::decided:
      decide(answer.verdict);
      return true;
    case OpenPathAnswer::Kind::ended:
      break;
  }
  end_open_path(answer.here);
  motion.from = answer.here;
  return false;
}

bool ProgramJudge::end_open_path(const Position& here) {
  const ReferenceStep& step = reference_.current();
  Position at = reference_.position();
  if (auto* thread = std::get_if<ThreadMilling>(&step)) {
    if (!thread_judge(*thread).complete()) return false;
    const reference::PlaneAxes axes = reference::axes_of(thread->plane);
    // Where the subject stands, or where the reference would where that agrees.
    const std::array<Number, 2> shown = reference::gsk988ta::end_of_passes(*thread);
    at[axes.p] = here[axes.p];
    at[axes.q] = here[axes.q];
    at[axes.d] = here[axes.d];
    // Half the tolerance: as far as a correctly rounded position may lie.
    const Number near = terms_.tolerance / 2;
    if (agree(here[axes.p], shown[0], near) && agree(here[axes.q], shown[1], near)) {
      at[axes.p] = shown[0];
      at[axes.q] = shown[1];
    }
    if (agree(here[axes.d], thread->r_plane, terms_.tolerance)) at[axes.d] = thread->r_plane;
    thread_.reset();
    reference_.stand_at(at);
  } else if (auto* pocket = std::get_if<HelixPocket>(&step)) {
    if (!helix_pocket_judge(*pocket).complete()) return false;
    const reference::PlaneAxes axes = reference::axes_of(pocket->plane);
    at[axes.d] = pocket->bottom;  // above the centre, as before it
    helix_pocket_.reset();
    reference_.go_on_from(at);
  } else if (auto* milling = std::get_if<PocketMilling>(&step)) {
    if (!pocket_judge(*milling).complete()) return false;
    const reference::PlaneAxes axes = reference::axes_of(milling->plane);
    at[axes.p] = milling->centre[0];
    at[axes.q] = milling->centre[1];
    at[axes.d] = milling->retract;  // SIE-LC75-13
    pocket_.reset();
    reference_.go_on_from(at);
  } else {
    return false;
  }
  reference_.advance();
  return true;
}

void ProgramJudge::end_open_path_before(std::uint64_t block) {
  if (block == 0) return;
  if (pending_ && pending_->record.block < block) flush_pending();
  if (verdict_) return;
  const ReferenceStep& step = reference_.current();
  // A pocket no deeper than the tolerance: to leave it takes no motion that is seen.
  if (auto* level = std::get_if<reference::PocketLevel>(&step)) {
    if (block > level->block) finish_level(*level, position_);
    return;
  }
  auto* thread = std::get_if<ThreadMilling>(&step);
  auto* pocket = std::get_if<HelixPocket>(&step);
  auto* milling = std::get_if<PocketMilling>(&step);
  const bool later = (thread != nullptr && block > thread->block) ||
                     (pocket != nullptr && block > pocket->block) ||
                     (milling != nullptr && block > milling->block);
  if (later) end_open_path(position_);
}

std::optional<Verdict> ProgramJudge::unfinished_open_path() {
  const ReferenceStep& step = reference_.current();
  std::optional<Verdict> verdict;
  if (auto* thread = std::get_if<ThreadMilling>(&step)) {
    verdict = thread_judge(*thread).incomplete(position_);
  } else if (auto* pocket = std::get_if<HelixPocket>(&step)) {
    verdict = helix_pocket_judge(*pocket).incomplete(position_);
  } else if (auto* milling = std::get_if<PocketMilling>(&step)) {
    verdict = pocket_judge(*milling).incomplete(position_);
  }
  if (verdict) verdict->record = records_;
  return verdict;
}

}  // namespace gonogo::oracle
