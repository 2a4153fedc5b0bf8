// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/open/thread_run_out.hpp"

#include <algorithm>
#include <cstdlib>

#include "oracle/motion/chords.hpp"
#include "oracle/region/constants.hpp"

namespace gonogo::oracle {
namespace {

Similarity after(const Similarity& second, const Similarity& first) {
  return {second.a * first.a - second.b * first.b, second.a * first.b + second.b * first.a};
}

// GSK-G114-11 from the start of the helix: first to its end, then J over K degrees as read.
Similarity run_out_map(const reference::ThreadMilling& item, const Number& radius,
                       const Similarity& to_end, ThreadRunOut run_out) {
  const Number& j = item.runout_length;
  const Number& k = item.runout_angle;
  if (run_out == ThreadRunOut::polar) {
    const Number end = (item.external ? radius + j : radius - j) / radius;
    const Similarity turn = turn_by(k * item.sense);
    return after({end * turn.a, end * turn.b}, to_end);
  }
  const Number from_normal = run_out == ThreadRunOut::radial ? k : Number(90) - k;
  const Number angle = item.external ? from_normal : Number(180) - from_normal;
  const Similarity turn = turn_by(angle * item.sense);
  const Number length = j / radius;
  return after({Number(1) + length * turn.a, length * turn.b}, to_end);
}

// How far from the axis the arc of GSK-G114-11 goes that leaves the thread tangentially: to its
// end, or beyond half a turn to the point across from where it begins.
Number farthest_of_polar(const reference::ThreadMilling& item, const Number& radius) {
  const Number end = radius + item.runout_length;
  const Number k = run_out_degrees(item);
  if (k <= 180) return end;
  const Number cosine = turn_by(k).a;
  const Number a = end * cosine - radius;
  if (a.sign() == 0) return end;
  const Number w = (radius * radius + end * end - radius * end * cosine * 2) / (a * 2);
  return max(end, abs(radius + w * 2));
}

}  // namespace

ThreadRunOutJudge::ThreadRunOutJudge(const ThreadGeometry& geometry, const Number& pass,
                                     const OpenHelix& helix, const Similarity& to_end,
                                     const Position& from, const RunOutSet& allowed,
                                     const RunOutSet& named)
    : geometry_(geometry),
      helix_(helix),
      to_end_(to_end),
      radius_(geometry.item().radius_of_pass(pass)),
      from_(from),
      allowed_(allowed),
      named_(named),
      left_(allowed) {}

Similarity ThreadRunOutJudge::map_of(ThreadRunOut run_out) const {
  return run_out_map(geometry_.item(), radius_, to_end_, run_out);
}

Position ThreadRunOutJudge::end_of(ThreadRunOut run_out) const {
  const PlaneVector start = geometry_.from_axis(helix_.want().from);
  return geometry_.place(apply(map_of(run_out), start), from_);
}

bool ThreadRunOutJudge::take(const Motion& flat) {
  if (!begun_) chords_ = {near_rational(geometry_.from_axis(flat.from))};
  begun_ = true;
  if (leaves_region(flat)) return false;
  for (const ThreadRunOut each : kRunOuts) {
    if (!left_.has(each)) continue;
    const bool follows = each == ThreadRunOut::polar ? take_polar(flat) : take_line(each, flat);
    if (!follows) left_.remove(each);
  }
  return !left_.empty();
}

bool ThreadRunOutJudge::take_chord(const Motion& flat) {
  left_.remove(ThreadRunOut::radial);
  left_.remove(ThreadRunOut::tangent);
  off_line_[place_of(ThreadRunOut::polar)] = true;
  return take(flat);
}

bool ThreadRunOutJudge::take_line(ThreadRunOut run_out, const Motion& flat) {
  const std::size_t place = place_of(run_out);
  if (off_line_[place] || flat.record.kind != RecordKind::feed) return false;
  std::optional<Line>& line = lines_[place];
  if (!line) {
    Motion want = helix_.want();
    want.record.kind = RecordKind::feed;
    want.record.block = flat.record.block;
    want.from = from_;
    want.record.to = end_of(run_out);
    line.emplace(std::move(want), geometry_.loose_terms());
  }
  const MatchResult result = line->match.match(flat);
  // The feed is held to the text by the judge of the thread.
  off_line_[place] = result.departure != Departure::none && result.departure != Departure::feed;
  return !off_line_[place];
}

// One arc in pieces, chords of one, or a straight line.
bool ThreadRunOutJudge::take_polar(const Motion& flat) {
  if (flat.record.kind == RecordKind::arc) return take_arc(flat);
  const bool chord =
      geometry_.tolerances().chord.sign() > 0 && !arc_ && chords_.size() < kMostMotions;
  if (chord) chords_.push_back(near_rational(geometry_.from_axis(flat.to())));
  arc_departed_ = arc_departed_ || !chord;
  return take_line(ThreadRunOut::polar, flat) || chord;
}

bool ThreadRunOutJudge::take_arc(const Motion& arc) {
  const Record& record = arc.record;
  off_line_[place_of(ThreadRunOut::polar)] = true;
  if (chords_.size() > 1 || record.plane != geometry_.item().plane) arc_departed_ = true;
  if (turns_with_helix_ && (record.rot < 0) != (geometry_.item().sense < 0)) arc_departed_ = true;
  if (!arc_) arc_ = record;
  swept_.add(approximate_turns(arc));
  const Number& apart = geometry_.loose_terms().tolerance;
  const double radius = estimate_length(from_centre(record, arc.to()));
  const bool goes_on = std::abs(record.rot) == 1 && (record.rot < 0) == (arc_->rot < 0) &&
                       agree(record.centre[0], arc_->centre[0], apart) &&
                       agree(record.centre[1], arc_->centre[1], apart);
  if (!goes_on || swept_.exceed_a_turn(estimate(apart), radius)) arc_departed_ = true;
  return !arc_departed_;
}

// The wall of a bore leaves no room: `take` gets what is free of the pass.
bool ThreadRunOutJudge::leaves_region(const Motion& flat) const {
  if (!geometry_.item().external) return false;
  const Number farthest = farthest_of_polar(geometry_.item(), radius_);
  return geometry_.within(flat, farthest).kind == Clearance::Kind::touches;
}

bool ThreadRunOutJudge::ends_at(ThreadRunOut run_out, const Position& here) const {
  return helix_.starts().admits(map_of(run_out), geometry_.from_axis(here));
}

RunOutSet ThreadRunOutJudge::ending_at(const Position& here) const {
  RunOutSet ending = RunOutSet::none();
  std::optional<exact::Undecided> undecided;
  for (const ThreadRunOut each : kRunOuts) {
    if (!left_.has(each)) continue;
    const bool by_chords =
        each == ThreadRunOut::polar && begun_ && !arc_ && off_line_[place_of(each)];
    if (by_chords &&
        !are_chords_of_an_arc(chords_, geometry_.tolerances().tolerance * 2,
                              geometry_.tolerances().tolerance + geometry_.tolerances().chord)) {
      continue;
    }
    try {
      if (ends_at(each, here)) ending.add(each);
    } catch (const exact::Undecided& error) {
      undecided = error;
    }
  }
  if (ending.empty() && undecided) throw exact::Undecided(*undecided);
  return ending;
}

bool ThreadRunOutJudge::surely_ends_at(ThreadRunOut run_out, const Position& here) const {
  try {
    return ends_at(run_out, here);
  } catch (const exact::Undecided&) {
    return false;
  }
}

bool ThreadRunOutJudge::is_end(const Position& here) const {
  return std::ranges::any_of(kRunOuts, [&](ThreadRunOut each) {
    return allowed_.has(each) && surely_ends_at(each, here);
  });
}

bool ThreadRunOutJudge::is_end_of_another(const Position& here) const {
  return std::ranges::any_of(kRunOuts, [&](ThreadRunOut each) {
    return named_.has(each) && !allowed_.has(each) && surely_ends_at(each, here);
  });
}

Number ThreadRunOutJudge::distance_from_end(const Position& here) const {
  std::optional<Number> least;
  for (const ThreadRunOut each : kRunOuts) {
    if (!allowed_.has(each)) continue;
    Position end = end_of(each);
    end[geometry_.axes().d] = here[geometry_.axes().d];
    const Number away = largest_difference(here, end);
    if (!least || estimate(away) < estimate(*least)) least = away;
  }
  return least.value_or(0);
}

bool ThreadRunOutJudge::is_unfit() const {
  const reference::ThreadMilling& item = geometry_.item();
  const bool is_straight =
      item.runout == ThreadRunOut::radial || item.runout == ThreadRunOut::tangent;
  const ThreadRunOut run_out = is_straight ? item.runout : ThreadRunOut::polar;
  // Wherever on its circle the helix ends.
  const auto at = [&](const PlaneVector& v) { return geometry_.place(v, from_); };
  Motion line;
  line.record.kind = RecordKind::feed;
  line.record.to = at(apply(run_out_map(item, radius_, {1, 0}, run_out), {radius_, 0}));
  // The arc of the polar one keeps off the pass where its end does.
  line.from = is_straight ? at({radius_, 0}) : line.to();
  const bool keeps_off = item.runout_length >= abs(item.start_radius - radius_);
  return geometry_.clearance(line, radius_).kind != Clearance::Kind::clear ||
         (keeps_off && !geometry_.is_free(line.to(), item.start_radius));
}

}  // namespace gonogo::oracle
