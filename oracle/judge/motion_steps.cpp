// SPDX-License-Identifier: GPL-3.0-or-later
//
// ProgramJudge's part for one motion of the subject against the steps of the reference, one after
// the other until the motion is used up.
#include <algorithm>
#include <cmath>

#include "oracle/judge/evidence.hpp"
#include "oracle/judge/program_judge.hpp"
#include "oracle/judge/standing.hpp"

namespace gonogo::oracle {

using reference::HelixPocket;
using reference::PocketLevel;
using reference::PocketMilling;
using reference::ThreadMilling;

namespace {

// By estimates, to choose between what may be meant.
double distance(const Position& a, const Position& b) {
  double sum = 0;
  for (Axis axis : reference::kAllAxes) sum += std::abs(estimate(a[axis] - b[axis]));
  return sum;
}

// Whether the motion is rather this one of the reference's than one that was dropped before it, or
// none: by where it ends.
bool is_rather(const Motion& motion, const Motion& want) {
  const double apart = distance(motion.to(), want.to());
  if (distance(motion.to(), want.from) <= apart) return false;
  const auto may_be = [&](const Record& record) {
    return record.kind == motion.record.kind && record.block == motion.record.block &&
           distance(motion.to(), record.to) <= apart;
  };
  return !want.dropped || std::ranges::none_of(want.dropped->motions, may_be);
}

}  // namespace

void ProgramJudge::process(Motion motion) {
  while (!verdict_ && !process_step(motion)) {
  }
}

bool ProgramJudge::process_step(Motion& motion) {
  if (after_alarm_) return true;
  const ReferenceStep& step = reference_.current();
  if (auto* want = std::get_if<Motion>(&step)) return match_motion(motion, *want);
  if (const Record* due = placed_m_function(step)) {
    if (!means_nothing(motion, step)) m_function_is_due(*due, &motion.record, motion.number);
    return true;
  }
  if (is_m_function(step)) {
    take_m_functions();
    return false;
  }
  if (is_unseen(motion, step)) return true;
  if (auto* level = std::get_if<PocketLevel>(&step)) {
    if (collect(motion, *level)) {
      ++property_motions_;
      return true;
    }
    if (!verdict_) finish_level(*level, motion.from);
    return false;
  }
  if (std::optional<OpenPathAnswer> answer = take_in_path(motion, step)) {
    note_properties(*answer, motion);
    return follow_open_path(*answer, motion);
  }
  stop_before(motion, step);
  return true;
}

// J-CMP-09: a motion counts where an open step has taken it, or its first part.
void ProgramJudge::note_properties(const OpenPathAnswer& answer, const Motion& motion) {
  const bool taken = answer.kind == OpenPathAnswer::Kind::taken ||
                     (answer.kind == OpenPathAnswer::Kind::ended &&
                      !agree(answer.here, motion.from, terms_.tolerance));
  if (taken) ++property_motions_;
}

std::optional<OpenPathAnswer> ProgramJudge::take_in_path(const Motion& given,
                                                         const ReferenceStep& step) {
  // A flat `arc3` is an arc by another name.
  std::optional<Motion> arc;
  if (given.record.kind == RecordKind::arc3) arc = as_arc(given);
  const Motion& motion = arc ? *arc : given;
  if (auto* thread = std::get_if<ThreadMilling>(&step)) return thread_judge(*thread).take(motion);
  if (auto* pocket = std::get_if<HelixPocket>(&step)) {
    return helix_pocket_judge(*pocket).take(motion);
  }
  auto* pocket = std::get_if<PocketMilling>(&step);
  if (pocket == nullptr) return std::nullopt;
  OpenPathAnswer answer = pocket_judge(*pocket).take(motion);
  if (pocket_judge(*pocket).is_limited() && is_cut(motion.record.kind)) budget_.forgive();
  return answer;
}

// Before a cycle: of a block before it, or the traverse to where it begins.
bool ProgramJudge::is_unseen(const Motion& motion, const ReferenceStep& step) const {
  bool is_approach = false;
  if (motion.record.kind == RecordKind::rapid) {
    const auto stays_up = [&](reference::Plane plane) {
      const Axis depth = reference::axes_of(plane).d;
      return motion.to()[depth] == motion.from[depth];
    };
    auto* level = std::get_if<PocketLevel>(&step);
    auto* pocket = std::get_if<HelixPocket>(&step);
    is_approach = (level != nullptr && level_motions_.empty() && stays_up(level->plane)) ||
                  (pocket != nullptr && !helix_pocket_ && stays_up(pocket->plane));
  }
  const bool is_earlier = terms_.compare_blocks && motion.record.block < block_of(step);
  return (is_approach || is_earlier) && means_nothing(motion, step);
}

void ProgramJudge::moves_before_renaming(const Motion& motion, const ReferenceStep& step) {
  Verdict verdict;
  verdict.kind = VerdictKind::fail_geometry;
  verdict.message = "The subject moves where the position gets another name, and no motion is due.";
  verdict.block = motion.record.block;
  verdict.record = motion.number;
  verdict.want = step_text(step);
  verdict.got = record_text(motion.record);
  verdict.witness = point_text(motion.to(), moved_axes(motion, 0));
  decide(std::move(verdict));
}

// Before a step where no motion is due.
void ProgramJudge::stop_before(const Motion& motion, const ReferenceStep& step) {
  if (auto* outside = std::get_if<reference::NotCovered>(&step)) {
    return decide_not_covered(*outside);
  }
  if (means_nothing(motion, step)) return;
  if (std::holds_alternative<reference::AlarmReport>(step)) {
    after_alarm_ = motion;
    return;
  }
  if (std::holds_alternative<reference::Renaming>(step)) {
    // With line numbers it is a motion too many: all that are due before the renaming were made.
    if (terms_.compare_blocks) return moves_before_renaming(motion, step);
    return decide_gap("A motion of the subject spans a renaming of the position.");
  }
  const auto& record = std::get<Record>(step);
  Verdict verdict;
  verdict.kind = VerdictKind::fail_overrun;
  verdict.message = "The subject moves after the end of the program.";
  verdict.block = motion.record.block;
  verdict.clause = record.clause;
  verdict.record = motion.number;
  verdict.want = record_text(record);
  verdict.got = record_text(motion.record);
  verdict.witness = point_text(motion.to(), moved_axes(motion, 0));
  if (record.kind == RecordKind::dwell) {
    verdict.message = "The subject moves where a dwell is due.";
    // Goes on in the reference: `record` is gone after it.
    departed_at_ = reference_.items();
    reference_.advance();
    verdict.kind = fits_later(motion) ? VerdictKind::fail_order : VerdictKind::fail_geometry;
  }
  decide(std::move(verdict));
}

MatchResult ProgramJudge::try_motion(const Motion& motion, const Motion& want) {
  if (!match_) {
    want_ = want;
    match_.emplace(*want_, terms_);
    piece_.reset();
  }
  MatchResult result = match_->match(motion);
  if (result.departure != Departure::none) return result;
  const bool is_chord = is_round(want_->record.kind) && motion.record.kind == RecordKind::feed;
  if (is_chord) budget_.forgive();
  if (!result.done) piece_ = motion;
  if (result.done) {
    note_match(motion, *want_);
    match_.reset();
    reference_.advance();
  }
  return result;
}

bool ProgramJudge::is_due(const Motion& motion) {
  if (agree(motion.from, motion.to(), 0)) return false;
  flush_pending();
  while (!verdict_ && is_m_function(reference_.current())) {
    if (placed_m_function(reference_.current()) != nullptr) return false;
    take_m_functions();
  }
  auto* want = std::get_if<Motion>(&reference_.current());
  if (verdict_ || want == nullptr || !is_rather(motion, *want)) return false;
  if (!same_place(motion.from, want->from, terms_) ||
      !same_place(motion.to(), want->to(), terms_)) {
    return false;
  }
  return try_motion(motion, *want).departure == Departure::none;
}

bool ProgramJudge::match_motion(Motion& motion, const Motion& want) {
  if (!match_ && is_same_motion(motion, want)) {
    reference_.advance();
    return true;
  }
  const MatchResult result = try_motion(motion, want);
  if (result.departure == Departure::none) return true;
  // Motions too small to see may be kept on one side and dropped on the other. One of an earlier
  // block passes nothing of this one.
  const bool is_earlier = terms_.compare_blocks && motion.record.block < want_->record.block;
  if (!is_earlier && reached(*want_, motion.from)) {
    match_.reset();
    reference_.advance();
    return false;
  }
  if (may_mean_none(motion, want_->from, want_->dropped.get(), terms_)) return true;
  if (dives_into_pocket(motion)) return false;
  if (!goes_on_outside(motion)) report_departure(result, motion, *want_);
  return true;
}

// Without line numbers a motion may be joined to those of a block that is not covered: then its end
// says nothing. Goes on in the reference where it may be so.
bool ProgramJudge::goes_on_outside(const Motion& motion) {
  if (terms_.compare_blocks || !match_->goes_beyond(motion)) return false;
  reference_.advance();
  auto* outside = std::get_if<reference::NotCovered>(&reference_.current());
  if (outside != nullptr) decide_not_covered(*outside);
  return outside != nullptr;
}

// Whether a motion of the reference is done where the subject stands.
bool ProgramJudge::reached(const Motion& want, const Position& at) const {
  return same_place(at, want.to(), terms_) && !goes_round(want, terms_.tolerance);
}

bool ProgramJudge::means_nothing(const Motion& motion, const ReferenceStep& step) const {
  Position here = reference_.position();
  auto* renaming = std::get_if<reference::Renaming>(&step);
  if (renaming == nullptr) return may_mean_none(motion, here, &reference_.dropped(), terms_);
  Dropped dropped = reference_.dropped();  // the subject has not followed it yet
  Position back;
  for (Axis axis : reference::kAllAxes) back[axis] = -renaming->shift[axis];
  shift(here, back);
  shift(dropped, back);
  return may_mean_none(motion, here, &dropped, terms_);
}

}  // namespace gonogo::oracle
