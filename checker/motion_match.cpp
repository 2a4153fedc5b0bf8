// SPDX-License-Identifier: GPL-3.0-or-later
#include "checker/motion_match.hpp"

#include <algorithm>
#include <cstdlib>

namespace gonogo::checker {
namespace {

StepAnswer departs(std::string why) {
  return {Step::departs, std::move(why)};
}
StepAnswer undecided(std::string why) {
  return {Step::undecided, std::move(why)};
}

Rational floor_of(const Rational& value) {
  mpz_class quotient;
  mpz_fdiv_q(quotient.get_mpz_t(), value.get_num_mpz_t(), value.get_den_mpz_t());
  return Rational(quotient);
}

// The value of a binary64's last place, for a value that is not 0.
Rational ulp_of(const Rational& value) {
  const Rational size = abs(value);
  long exponent = static_cast<long>(mpz_sizeinbase(size.get_num_mpz_t(), 2)) -
                  static_cast<long>(mpz_sizeinbase(size.get_den_mpz_t(), 2));
  const auto two_to = [](long power) {
    mpz_class scale = 1;
    mpz_mul_2exp(scale.get_mpz_t(), scale.get_mpz_t(),
                 static_cast<unsigned long>(power < 0 ? -power : power));
    return power < 0 ? Rational(1, scale) : Rational(scale);
  };
  if (two_to(exponent) > size) --exponent;
  return two_to(exponent - 52);
}

Real absolute(const Real& value) {
  return value.is_negative() == Truth::yes ? -value : value;
}

// The last place of a decimal as a number; nothing where it is no decimal.
std::optional<Rational> last_place(const Real& value) {
  if (!value.is_rational()) return std::nullopt;
  mpz_class rest = value.low().get_den();
  mpz_class scale = 1;
  for (; mpz_divisible_ui_p(rest.get_mpz_t(), 10) != 0; scale *= 10) rest /= 10;
  for (const unsigned prime : {2U, 5U}) {
    for (; mpz_divisible_ui_p(rest.get_mpz_t(), prime) != 0; scale *= 10) rest /= prime;
  }
  if (rest != 1) return std::nullopt;
  return Rational(1, scale);
}

bool plane_near(const Motion& arc, const Real& reach) {
  const Plane& plane = arc.record.plane;
  return (within(*arc.from[plane.first], *arc.to[plane.first], reach) &&
          within(*arc.from[plane.second], *arc.to[plane.second], reach)) != Truth::no;
}

// Whole turns of an arc whose ends are near each other: one that is nearly complete is counted,
// one that has hardly begun is not. Nothing: undecided.
std::optional<long> whole_turns(const Motion& arc) {
  const long size = std::abs(arc.record.rotation);
  const Real side = cross(arc.record.plane, arc.record.centre, arc.from, arc.to);
  const Truth begun = (arc.record.rotation < 0 ? -side : side).is_positive();
  if (begun == Truth::unknown) return std::nullopt;
  return begun == Truth::yes ? size - 1 : size;
}

// Whether the radius at the start may be about the tolerance.
bool is_tiny(const Motion& arc, const Real& tolerance) {
  const Plane& plane = arc.record.plane;
  const Real radius_2 = distance2(plane, arc.from, arc.record.centre);
  return root_at_most(radius_2, 0, Real(3) * tolerance) != Truth::no;
}

// R3: equal, or no farther off than rounding to the resolution makes it; where none is
// declared, than rounding to the number's own last place and no more coarsely than the machine.
Truth rounds_to(const Real& want, const Real& got, const std::optional<Rational>& resolution,
                const Tolerances& tolerances) {
  Truth answer = equal(want, got);
  if (answer == Truth::yes) return answer;
  std::optional<Rational> step = resolution;
  if (!step) step = last_place(got);
  if (step && !resolution) step = std::min(*step, tolerances.increment);
  if (step) answer = answer || within(want, got, Real(Rational(*step / 2)));
  const bool may_be_double = tolerances.is_binary64 || (!tolerances.is_exact && !resolution);
  if (may_be_double && want.low() != 0) {
    answer = answer || within(want, got, Real(Rational(2 * ulp_of(want.low()))));
  }
  return answer;
}

}  // namespace

Truth feed_agrees(const Real& want, const Real& got, const Tolerances& tolerances) {
  return rounds_to(want, got, tolerances.feed_resolution, tolerances);
}

Truth lead_agrees(const Real& want, const Real& got, const Tolerances& tolerances) {
  return rounds_to(want, got, tolerances.resolution, tolerances);
}

// Whole turns apart are the same.
Truth angle_agrees(const Real& want, const Real& got, const Tolerances& tolerances) {
  const Rational turns = floor_of(Rational((got - want).low() / 360 + Rational(1, 2)));
  return rounds_to(want + Real(Rational(turns * 360)), got, tolerances.resolution, tolerances);
}

Truth root_at_most(const Real& x, const Real& y, const Real& t) {
  // Squared: x - y - t^2 <= 2 t sqrt(y).
  const Real rest = x - y - t * t;
  return at_most(rest, 0) || at_most(rest * rest, Real(4) * t * t * y);
}

MotionMatch::MotionMatch(const Motion& want, const Tolerances& tolerances)
    : want_(want), tolerances_(tolerances) {}

StepAnswer MotionMatch::answer(Truth done, const std::string& what) const {
  if (done == Truth::yes) return {Step::done, {}};
  return {done == Truth::no ? Step::departs : Step::undecided, what};
}

StepAnswer MotionMatch::take(const Motion& got) {
  if (StepAnswer words = check_words(got); words.step != Step::done) return words;
  switch (want_.record.kind) {
    case RecordKind::rapid:
      return take_rapid(got);
    case RecordKind::feed:
    case RecordKind::thread:
      return take_line(got);
    case RecordKind::arc:
      return take_arc(got);
    case RecordKind::arc3:
      return take_arc3(got);
    default:
      return {};
  }
}

StepAnswer MotionMatch::check_words(const Motion& got) const {
  const Record& want = want_.record;
  const Record& have = got.record;
  const auto are = [&](RecordKind one, RecordKind other) {
    return (want.kind == one && have.kind == other) || (want.kind == other && have.kind == one);
  };
  if (are(RecordKind::arc, RecordKind::arc3)) {
    if (agree(want_.to, got.to, tolerances_.tolerance) == Truth::no)
      return departs("the ends differ");
    return undecided("an arc comes in another form");
  }
  const bool may_be_flat = are(RecordKind::feed, RecordKind::arc3) &&
                           agree(want_.to, got.to, tolerances_.tolerance) != Truth::no;
  if (may_be_flat) return undecided("an arc that may be as flat as its chord");
  if (want.kind != have.kind) return departs("the kinds differ");
  if (tolerances_.has_blocks && have.block == 0) return undecided("a record names no source line");
  if (tolerances_.has_blocks && want.block != have.block) return departs("the source lines differ");
  if (want.per_revolution != have.per_revolution) return departs("the units of the feeds differ");
  Truth same = feed_agrees(want.feed, have.feed, tolerances_) &&
               lead_agrees(want.lead, have.lead, tolerances_) &&
               angle_agrees(want.start, have.start, tolerances_);
  if (same != Truth::yes) return answer(same, "feed, lead or start angle differ");
  if (equal(want.seconds, have.seconds) == Truth::yes) return {};
  const Truth near = within(want.seconds, have.seconds, tolerances_.tolerance);
  // Rounded to the subject's resolution, which is not looked at here.
  return near == Truth::no ? departs("the times differ") : undecided("a dwell may be rounded");
}

// Each axis runs toward its end, and no farther. It may turn back by the tolerance, in all by
// twice that from the farthest place (R4).
StepAnswer MotionMatch::take_rapid(const Motion& got) {
  Truth allowed = Truth::yes;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!want_.from[axis] || !want_.to[axis] || !got.from[axis] || !got.to[axis]) continue;
    Real way = *want_.to[axis] - *want_.from[axis];
    Real step = *got.to[axis] - *got.from[axis];
    Real beyond = *got.to[axis] - *want_.to[axis];
    if (way.is_zero() == Truth::yes) {
      allowed = allowed && within(beyond, 0, tolerances_.tolerance);
      continue;
    }
    if (way.is_negative() == Truth::yes) {
      step = -step;
      beyond = -beyond;
    }
    for (const Real& place : {beyond - step, beyond}) {
      if (!ahead_[axis] || at_most(*ahead_[axis], place) == Truth::yes) ahead_[axis] = place;
    }
    allowed = allowed && at_most(-step, tolerances_.tolerance) &&
              at_most(beyond, tolerances_.tolerance) &&
              at_most(*ahead_[axis] - beyond, Real(2) * tolerances_.tolerance);
  }
  if (allowed != Truth::yes) return answer(allowed, "a traverse leaves the way to its end");
  const Truth done = agree(want_.to, got.to, tolerances_.tolerance);
  return done == Truth::no ? StepAnswer{Step::part, {}} : answer(done, "the ends may differ");
}

Truth MotionMatch::bounds_of(const Position& point, Bounds& bounds) const {
  const Real& tolerance = tolerances_.tolerance;
  Truth on_line = Truth::yes;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!want_.from[axis] || !want_.to[axis] || !point[axis]) continue;
    const Real way = *want_.to[axis] - *want_.from[axis];
    const Real along = *point[axis] - *want_.from[axis];
    const auto before = (along - tolerance).over(way);
    const auto after = (along + tolerance).over(way);
    if (!before || !after) {  // the axis stands still, or moves less than can be seen
      on_line = on_line && within(along, 0, tolerance);
      continue;
    }
    const bool forward = way.is_positive() == Truth::yes;
    bounds.lower.push_back(forward ? *before : *after);
    bounds.upper.push_back(forward ? *after : *before);
  }
  for (const Real& low : bounds.lower) {
    for (const Real& high : bounds.upper) on_line = on_line && at_most(low, high);
  }
  return on_line;
}

// By more than the tolerance, from the farthest point so far.
Truth MotionMatch::goes_back(const Bounds& bounds) const {
  Truth forward = Truth::yes;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!want_.from[axis] || !want_.to[axis]) continue;
    const Real way = absolute(*want_.to[axis] - *want_.from[axis]);
    for (const Real& low : passed_) {
      for (const Real& high : bounds.upper) {
        forward = forward && at_most((low - high) * way, tolerances_.tolerance);
      }
    }
  }
  return !forward;
}

StepAnswer MotionMatch::take_line(const Motion& got) {
  // Whole for whole is what is nearly always there.
  const Truth ends = agree(want_.from, got.from, tolerances_.tolerance) &&
                     agree(want_.to, got.to, tolerances_.tolerance);
  if (passed_.empty() && ends == Truth::yes) return {};
  for (const Position* point : {&got.from, &got.to}) {
    Bounds bounds;
    const Truth on_line = bounds_of(*point, bounds);
    if (on_line != Truth::yes) return answer(on_line, "a point is beside the line");
    const Truth back = goes_back(bounds);
    if (back != Truth::no) return answer(!back, "it goes back along the line");
    passed_.insert(passed_.end(), bounds.lower.begin(), bounds.lower.end());
  }
  const Truth done = agree(want_.to, got.to, tolerances_.tolerance);
  return done == Truth::no ? StepAnswer{Step::part, {}} : answer(done, "the ends may differ");
}

StepAnswer MotionMatch::take_arc(const Motion& got) {
  const Record& want = want_.record;
  const Record& have = got.record;
  if (want.plane != have.plane) return departs("the planes differ");
  if ((want.rotation < 0) != (have.rotation < 0)) return departs("the senses differ");
  const Truth centres = agree(want.centre, have.centre, tolerances_.tolerance);
  if (centres != Truth::yes) return answer(centres, "the centres differ");
  // Where the radius is about the tolerance, a centre off by that makes another arc of it.
  if (want_.from[want.plane.first] && want_.from[want.plane.second] &&
      agree(want.centre, have.centre, 0) != Truth::yes && is_tiny(want_, tolerances_.tolerance)) {
    return undecided("an arc about as small as the tolerance");
  }
  const std::size_t first = want.plane.first;
  const std::size_t second = want.plane.second;
  const bool all_known =
      want_.from[first] && want_.from[second] && got.from[first] && got.from[second];
  if (!all_known) {
    const Truth whole = agree(want_.to, got.to, tolerances_.tolerance);
    if (whole == Truth::yes && want.rotation == have.rotation) return {};
    return undecided("an arc begins at a place that is not known");
  }
  Motion so_far = got;
  so_far.record.centre = want.centre;
  if (piece_) {
    const auto rotation = joined_rotation(*piece_, so_far);
    if (!rotation) return undecided("an arc in pieces");
    so_far.from = piece_->from;
    so_far.record.rotation = *rotation;
  }
  StepAnswer so_far_answer = arc_so_far(so_far);
  if (so_far_answer.step == Step::part) piece_ = std::move(so_far);
  return so_far_answer;
}

StepAnswer MotionMatch::arc_so_far(const Motion& so_far) const {
  const Record& want = want_.record;
  const Truth starts = agree(want_.from, so_far.from, tolerances_.tolerance);
  if (starts != Truth::yes) return answer(starts, "the starts differ");
  const Truth ends = agree(want_.to, so_far.to, tolerances_.tolerance);
  if (ends == Truth::no) return part_of_arc(so_far);
  if (ends == Truth::unknown) return undecided("the ends may differ");
  const long wanted = std::abs(want.rotation);
  const long made = std::abs(so_far.record.rotation);
  if (!plane_near(want_, Real(3) * tolerances_.tolerance)) {
    if (wanted == made) return {};
    return made < wanted ? undecided("a helix in pieces") : departs("the turns differ");
  }
  // J-PATH-06. The ends are so near that it depends on the last digits what the last turn is.
  if (is_tiny(want_, tolerances_.tolerance)) return undecided("how many turns a small arc makes");
  const auto due = whole_turns(want_);
  const auto told = whole_turns(so_far);
  if (!due || !told) return undecided("how many turns an arc makes");
  if (*due == *told) return {};
  // Rounded, one that has hardly begun may be whole, and a whole one alone may be none.
  const bool may_be_meant = *told == made ? made == 1 && *due == 0 : *due == made;
  if (!tolerances_.is_exact && may_be_meant) {
    return undecided("rounding may decide how many turns an arc makes");
  }
  if (*told > *due) return departs("the turns differ");
  const std::size_t third = want.plane.third;
  const bool is_flat = want_.from[third] && want_.to[third] &&
                       equal(*want_.from[third], *want_.to[third]) == Truth::yes;
  return is_flat ? StepAnswer{Step::part, "turns are missing"} : undecided("a helix in pieces");
}

// The end differs: it may be a piece of the arc.
StepAnswer MotionMatch::part_of_arc(const Motion& so_far) const {
  const Record& want = want_.record;
  const Plane& plane = want.plane;
  const Real& tolerance = tolerances_.tolerance;
  const Real there = distance2(plane, so_far.to, want.centre);
  const Real radii[] = {distance2(plane, want_.from, want.centre),
                        distance2(plane, want_.to, want.centre)};
  // A box of the tolerance reaches no farther than twice it.
  const Real far = Real(2) * tolerance;
  const Truth outside = !root_at_most(there, radii[0], far) && !root_at_most(there, radii[1], far);
  const Truth inside = !root_at_most(radii[0], there, far) && !root_at_most(radii[1], there, far);
  if (outside == Truth::yes || inside == Truth::yes) return departs("the end is beside the arc");
  Truth is_flat = Truth::yes;
  for (const std::size_t axis : {plane.third, std::size_t{3}, std::size_t{4}}) {
    if (!want_.from[axis] || !want_.to[axis]) continue;
    is_flat = is_flat && equal(*want_.from[axis], *want_.to[axis]);
    const Truth still = within(*so_far.to[axis], *want_.to[axis], tolerance);
    if (is_flat == Truth::yes && still == Truth::no) return departs("the end is beside the arc");
  }
  const Truth plane_end = within(*so_far.to[plane.first], *want_.to[plane.first], tolerance) &&
                          within(*so_far.to[plane.second], *want_.to[plane.second], tolerance);
  if (plane_end == Truth::yes && so_far.record.rotation == want.rotation) {
    return departs("the ends differ across the plane");
  }
  if (is_flat != Truth::yes) return undecided("a helix in pieces");
  const Truth near =
      (root_at_most(there, radii[0], tolerance) && root_at_most(radii[0], there, tolerance)) ||
      (root_at_most(there, radii[1], tolerance) && root_at_most(radii[1], there, tolerance));
  if (near != Truth::yes) return undecided("an arc in pieces, near the limit of the tolerance");
  return {Step::part, "the ends differ"};
}

StepAnswer MotionMatch::take_arc3(const Motion& got) const {
  const Truth ends = agree(want_.from, got.from, tolerances_.tolerance) &&
                     agree(want_.to, got.to, tolerances_.tolerance);
  if (ends != Truth::yes) return answer(ends, "the ends differ");
  const Truth middle = agree(want_.record.via, got.record.via, tolerances_.tolerance);
  if (middle == Truth::yes) return {};
  return undecided("a circle in space through another point");
}

}  // namespace gonogo::checker
