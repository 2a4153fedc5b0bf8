// SPDX-License-Identifier: GPL-3.0-or-later
//
// ThreadJudge's part for the run-out at the bottom of a pass: open, or where a reading says that it
// ends (GSK-G114-11).
#include "oracle/judge/evidence.hpp"
#include "oracle/judge/thread_judge.hpp"

namespace gonogo::oracle {

using reference::ThreadRunOut;
using reference::operator""_clause;

namespace {

Similarity after(const Similarity& second, const Similarity& first) {
  return {second.a * first.a - second.b * first.b, second.a * first.b + second.b * first.a};
}

}  // namespace

OpenPathAnswer ThreadJudge::take_run_out(const Motion& motion) {
  const Number rise = (motion.to()[axes_.d] - item_.bottom) * up_;
  if (!is_cut(motion.record.kind) || rise > terms_.tolerance) {
    if (std::optional<Verdict> verdict = finish_run_out(motion)) {
      return OpenPathAnswer::decide(*std::move(verdict));
    }
    OpenPathAnswer answer = take_way_back(motion);
    if (phase_ == Phase::run_out) phase_ = Phase::way_back;
    return answer;
  }
  if (rise < -terms_.tolerance) {
    return fault(VerdictKind::fail_geometry, "GSK-G114-06"_clause, motion,
                 "The tool cuts below the bottom of the thread.");
  }
  const Clearance clear = clearance(motion, radius(), false);
  if (clear.kind != Clearance::Kind::clear) {
    if (clear.kind == Clearance::Kind::touches && reading_cuts_deeper()) {
      return OpenPathAnswer::gap("The run-out of the reading cuts deeper than its pass itself.");
    }
    return touching(clear, "GSK-G114-10"_clause, motion, "The run-out cuts deeper than its pass.");
  }
  // What is left of a helix that ended within the tolerance of its end.
  const bool remainder = !ran_out_ && !nearly_full_turn(motion) &&
                         helix_.front().starts().admits(to_end_, from_axis(motion.to()));
  if (remainder) return {};
  ran_out_ = true;
  if (!is_straight_run_out(motion)) {
    return fault(VerdictKind::fail_geometry, "GSK-G114-11"_clause, motion,
                 "The run-out is not the straight line of its reading.");
  }
  return {};
}

bool ThreadJudge::has_run_out_end() const {
  return item_.runout != ThreadRunOut::open && item_.runout_length.sign() != 0;
}

Position ThreadJudge::at_run_out_end(Position at) const {
  const PlaneVector end = apply(run_out_map(), from_axis(helix_.front().want().from));
  at[axes_.p] = item_.centre[0] + end.p;
  at[axes_.q] = item_.centre[1] + end.q;
  return at;
}

bool ThreadJudge::runs_out_straight() const {
  return has_run_out_end() && item_.runout != ThreadRunOut::polar;
}

Motion ThreadJudge::straight_run_out() const {
  Motion line = helix_.front().want();
  line.record.kind = RecordKind::feed;
  line.from = helix_end_;
  line.record.to = at_run_out_end(line.to());
  return line;
}

// Through the axis and into the far wall, or round and back into the thread: then no path is right.
bool ThreadJudge::reading_cuts_deeper() const {
  if (item_.runout == ThreadRunOut::polar) {
    return !item_.external && item_.runout_length > radius() * 2;
  }
  return runs_out_straight() &&
         clearance(straight_run_out(), radius(), false).kind != Clearance::Kind::clear;
}

// Through the axis and beyond where the passes begin: then no way back keeps off the material,
// which GSK-G114-10 asks of a J as long as the thread is deep.
bool ThreadJudge::reading_ends_in_material() const {
  if (!has_run_out_end()) return false;
  Motion up = helix_.front().want();
  up.record.kind = RecordKind::rapid;
  up.from = up.record.to = at_run_out_end(helix_end_);
  up.record.to[axes_.d] = item_.r_plane;
  return clearance(up, item_.start_radius, true).kind != Clearance::Kind::clear;
}

// Under the readings radial and tangent the run-out is one straight line.
bool ThreadJudge::is_straight_run_out(const Motion& motion) {
  if (!runs_out_straight()) return true;
  if (!line_) {
    line_want_ = straight_run_out();
    line_.emplace(line_want_, loose_);
  }
  const MatchResult result = line_->match(motion);
  return result.departure == Departure::none || result.departure == Departure::feed;
}

// GSK-G114-11 from the start of the helix: first to its end, then J over K degrees as read.
Similarity ThreadJudge::run_out_map() const {
  const Number r = radius();
  const Number& k = item_.runout_angle;
  if (item_.runout == ThreadRunOut::polar) {
    const Number end = (item_.external ? r + item_.runout_length : r - item_.runout_length) / r;
    const Similarity turn = turn_by(k * item_.sense);
    return after({end * turn.a, end * turn.b}, to_end_);
  }
  const Number from_normal = item_.runout == ThreadRunOut::radial ? k : Number(90) - k;
  const Number angle = item_.external ? from_normal : Number(180) - from_normal;
  const Similarity turn = turn_by(angle * item_.sense);
  const Number length = item_.runout_length / r;
  return after({Number(1) + length * turn.a, length * turn.b}, to_end_);
}

std::optional<Verdict> ThreadJudge::finish_run_out(const Motion& motion) {
  if (!has_run_out_end()) return std::nullopt;
  const Similarity map = run_out_map();
  if (helix_.front().starts().admits(map, from_axis(motion.from))) return std::nullopt;
  Motion at = motion;
  at.record.to = motion.from;
  OpenPathAnswer answer =
      fault(VerdictKind::fail_geometry, "GSK-G114-11"_clause, at,
            ran_out_ ? "The run-out ends at another point." : "The run-out is missing.");
  const PlaneVector want = apply(map, from_axis(helix_.front().want().from));
  const PlaneVector got = from_axis(motion.from);
  set_deviation(answer.verdict, max(abs(want.p - got.p), abs(want.q - got.q)));
  return std::move(answer.verdict);
}

}  // namespace gonogo::oracle
