// SPDX-License-Identifier: GPL-3.0-or-later
//
// ThreadJudge's part for the evidence: what keeps clear of the part, and which word of a helix is
// wrong.
#include <cmath>

#include "oracle/approximate.hpp"
#include "oracle/judge/evidence.hpp"
#include "oracle/judge/thread_judge.hpp"

namespace gonogo::oracle {

using region::PlanePoint;
using reference::operator""_clause;

OpenPathAnswer ThreadJudge::fault(VerdictKind kind, reference::ClauseId clause,
                                  const Motion& motion, std::string message) const {
  Verdict verdict = departure_from(kind, clause, motion, want_text(), std::move(message));
  verdict.block = item_.block;
  return OpenPathAnswer::decide(std::move(verdict));
}

std::string ThreadJudge::want_text() const {
  const bool over = pass_ > passes_;
  return thread_text(item_, over ? passes_ : pass_);
}

Verdict ThreadJudge::incomplete(const Position& position) const {
  Verdict verdict;
  verdict.kind = VerdictKind::fail_geometry;
  verdict.clause = "GSK-G114-06"_clause;
  verdict.block = item_.block;
  verdict.want = want_text();
  verdict.witness = point_text(position, {Axis::x, Axis::y, Axis::z});
  if (phase_ == Phase::helix) {
    verdict.message = "The helix ends before the bottom of the thread.";
  } else if (phase_ == Phase::run_out || phase_ == Phase::way_back) {
    verdict.message = "The tool does not return to the R plane after a pass.";
  } else if (pass_ > passes_) {
    verdict.message = "The tool does not go to the safe position after the last pass.";
  } else {
    verdict.clause = "GSK-G114-04"_clause;
    verdict.message = "A pass of the thread is missing.";
  }
  return verdict;
}

namespace {

// The part of a straight cut that lies below the R plane, as parameters of the line.
std::array<Number, 2> part_below(const Number& from, const Number& to) {
  if (from.sign() <= 0 && to.sign() <= 0) return {0, 1};
  const Number crossing = from / (from - to);
  return from.sign() > 0 ? std::array<Number, 2>{crossing, 1} : std::array<Number, 2>{0, crossing};
}

// The value, or a rational within 2^-80 of it: whether two points are one, or an arc is round, is
// not to be decided for values that are only enclosed.
Number near(const Number& value) {
  constexpr int kBits = 80;
  return value.is_rational() ? value : value.bounds(kBits)[0];
}
PlaneVector near(const PlaneVector& v) {
  return {near(v.p), near(v.q)};
}

PlanePoint along(const PlaneVector& from, const PlaneVector& to, const Number& part) {
  return {from.p + part * (to.p - from.p), from.q + part * (to.q - from.q)};
}

}  // namespace

// `only_below`: a straight cut that crosses the R plane counts below it alone. A traverse may go
// anywhere within its box.
Clearance ThreadJudge::clearance(const Motion& motion, const Number& radius,
                                 bool only_below) const {
  // A point that agrees on each axis lies up to sqrt(2) tau beyond the limit; 1.41422 is more.
  const Keep keep{item_.external, radius, Number::millionths(1'414'220) * terms_.tolerance};
  const PlaneVector from = near(from_axis(motion.from));
  const PlaneVector to = near(from_axis(motion.to()));
  const Record& record = motion.record;
  if (record.kind == RecordKind::rapid) {
    return clearance_of_box({from.p, from.q}, {to.p, to.q}, keep);
  }
  if (record.kind == RecordKind::feed) {
    std::array<Number, 2> part = {0, 1};
    if (only_below) part = part_below(near(height(motion.from)), near(height(motion.to())));
    return clearance_of_line(along(from, to, part[0]), along(from, to, part[1]), keep);
  }
  if (record.plane != item_.plane) return {Clearance::Kind::undecided, {}, {}};
  region::LevelMotion arc;
  arc.is_arc = true;
  arc.from = {from.p, from.q};
  arc.to = {to.p, to.q};
  arc.centre = {near(record.centre[0] - item_.centre[0]), near(record.centre[1] - item_.centre[1])};
  arc.rot = record.rot;
  Clearance clear = clearance_of_arc(arc, keep);
  const bool crosses = only_below && !is_below(motion.to());
  if (crosses && clear.kind == Clearance::Kind::touches) clear.kind = Clearance::Kind::undecided;
  return clear;
}

OpenPathAnswer ThreadJudge::touching(const Clearance& clear, reference::ClauseId clause,
                                     const Motion& motion, std::string message) const {
  if (clear.kind == Clearance::Kind::undecided) {
    return OpenPathAnswer::gap("Whether an arc below the R plane clears the part is not decided.");
  }
  OpenPathAnswer answer = fault(VerdictKind::fail_geometry, clause, motion, std::move(message));
  Position witness = motion.from;
  witness[axes_.p] = item_.centre[0] + clear.witness.p;
  witness[axes_.q] = item_.centre[1] + clear.witness.q;
  // On a sloping line the depth goes with the way in the plane.
  const PlaneVector from = near(from_axis(motion.from));
  const PlaneVector to = near(from_axis(motion.to()));
  const Number length_2 = (to.p - from.p) * (to.p - from.p) + (to.q - from.q) * (to.q - from.q);
  if (motion.record.kind == RecordKind::feed && length_2.sign() != 0) {
    const Number part = ((clear.witness.p - from.p) * (to.p - from.p) +
                         (clear.witness.q - from.q) * (to.q - from.q)) /
                        length_2;
    witness[axes_.d] += part * (motion.to()[axes_.d] - motion.from[axes_.d]);
  }
  answer.verdict.witness = point_text(witness, {Axis::x, Axis::y, Axis::z});
  set_deviation(answer.verdict, clear.deviation);
  return answer;
}

// A motion below the R plane where the helix of the pass is due, or one that leaves it. The first
// of radius, plane, centre, sense, start, lead, turns, depth and feed that is wrong gives the name.
OpenPathAnswer ThreadJudge::no_helix(const Motion& motion, const MatchResult& result) const {
  constexpr VerdictKind kGeometry = VerdictKind::fail_geometry;
  const reference::ClauseId clause = "GSK-G114-06"_clause;
  if (result.departure == Departure::undecided) return OpenPathAnswer::gap(result.reason);
  if (result.departure == Departure::feed) {
    return fault(VerdictKind::fail_feed, "GSK-G114-08"_clause, motion,
                 "The feed of the thread differs.");
  }
  const Record& record = motion.record;
  const bool on_the_way = phase_ == Phase::helix;
  const bool goes_on = is_cut(record.kind) && height(motion.to()) < height(motion.from);
  if (on_the_way && !goes_on) {
    return fault(kGeometry, clause, motion, "The helix ends before the bottom of the thread.");
  }
  if (record.kind == RecordKind::rapid) {
    return fault(kGeometry, "GSK-G114-10"_clause, motion,
                 "A traverse goes below the R plane before the helix.");
  }
  if (record.kind != RecordKind::arc && terms_.chord.sign() == 0) {
    return fault(kGeometry, clause, motion, "The tool goes below the R plane off the helix.");
  }
  if (!on_the_way && !on_circle(motion.from, radius())) return wrong_radius(motion);
  if (record.kind != RecordKind::arc) return fault(kGeometry, clause, motion, result.reason);
  if (record.plane != item_.plane) {
    return fault(kGeometry, clause, motion, "The helix lies in another plane.");
  }
  for (std::size_t i : {0U, 1U}) {
    if (agree(record.centre[i], item_.centre[i], terms_.tolerance)) continue;
    OpenPathAnswer answer =
        fault(kGeometry, clause, motion, "The helix turns about another centre.");
    set_deviation(answer.verdict, abs(record.centre[i] - item_.centre[i]));
    return answer;
  }
  if ((record.rot < 0) != (item_.sense < 0)) {
    return fault(kGeometry, "GSK-G114-09"_clause, motion, "The helix turns the wrong way.");
  }
  if (!on_the_way && !agree(motion.from[axes_.d], item_.r_plane, terms_.tolerance)) {
    OpenPathAnswer answer =
        fault(kGeometry, clause, motion, "The helix does not begin at the R plane.");
    set_deviation(answer.verdict, abs(motion.from[axes_.d] - item_.r_plane));
    return answer;
  }
  if (!on_circle(motion.to(), radius())) return wrong_radius(motion);
  return wrong_way_down(motion);
}

// Another radius than that of the pass; that of a neighbouring pass says more.
OpenPathAnswer ThreadJudge::wrong_radius(const Motion& motion) const {
  const Position& at = on_circle(motion.from, radius()) ? motion.to() : motion.from;
  const PlaneVector v = from_axis(at);
  const Number got = exact::sqrt(v.p * v.p + v.q * v.q);
  const Number beyond = item_.external ? radius() - got : got - radius();
  reference::ClauseId clause = "GSK-G114-04"_clause;
  std::string message = "The helix has another radius than its pass.";
  if (pass_ < passes_ && on_circle(at, item_.radius_of_pass(pass_ + 1))) {
    message = "A pass of the thread is missing before this one.";
  } else if (pass_ > 1 && on_circle(at, item_.radius_of_pass(pass_ - 1))) {
    message = "A pass of the thread is cut again.";
  } else if (pass_ == passes_ && beyond.sign() > 0) {
    message = "The last pass is deeper than the thread.";
  } else {
    clause = "GSK-G114-06"_clause;
  }
  OpenPathAnswer answer = fault(VerdictKind::fail_geometry, clause, motion, std::move(message));
  answer.verdict.witness = point_text(at, {Axis::x, Axis::y, Axis::z});
  set_deviation(answer.verdict, abs(beyond));
  return answer;
}

// Lead, turns or depth: estimates only choose the name here.
OpenPathAnswer ThreadJudge::wrong_way_down(const Motion& motion) const {
  const double tau = approximate(terms_.tolerance);
  const double lead = approximate(item_.lead);
  const double turns = approximate_turns(motion);
  const double down = approximate(height(motion.from) - height(motion.to()));
  const double slope = std::abs(down - turns * lead);
  const bool at_bottom = agree(motion.to()[axes_.d], item_.bottom, terms_.tolerance);
  std::string message = "The helix ends at another point.";
  const double turns_off = slope / lead;
  if (slope > 3 * tau) {
    const bool whole =
        std::round(turns_off) >= 1 && std::abs(turns_off - std::round(turns_off)) * lead < 3 * tau;
    message = at_bottom && whole ? "The helix makes another number of turns."
                                 : "The lead of the helix differs.";
  } else if (!at_bottom) {
    message = "The helix ends at another depth.";
  }
  OpenPathAnswer answer =
      fault(VerdictKind::fail_geometry, "GSK-G114-06"_clause, motion, std::move(message));
  set_deviation(answer.verdict, abs(motion.to()[axes_.d] - item_.bottom));
  return answer;
}

}  // namespace gonogo::oracle
