// SPDX-License-Identifier: GPL-3.0-or-later
// A program in other axes (mirrored, turned by 90 degrees, its planes renamed) or moved gives the
// motions in those axes: all 48 symmetries of the axes, and translations.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "expanders/common/axes.hpp"
#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

using Vector = std::array<long, 3>;  // thousandths

/// Axis i becomes axis axis[i], times sign[i], plus shift[axis[i]].
struct Transform {
  std::array<std::size_t, 3> axis{0, 1, 2};
  std::array<long, 3> sign{1, 1, 1};
  Vector shift{};

  Vector direction(const Vector& v) const {
    Vector result{};
    for (std::size_t i = 0; i < 3; ++i) result[axis[i]] = sign[i] * v[i];
    return result;
  }
  Vector point(const Vector& v) const {
    Vector result = direction(v);
    for (std::size_t i = 0; i < 3; ++i) result[i] += shift[i];
    return result;
  }
  const Plane& plane(const Plane& old) const {
    for (const Plane& candidate : kPlanes) {
      if (candidate.d == axis[old.d]) return candidate;
    }
    throw std::logic_error("no such plane");
  }
  /// -1: arcs in the plane change their sense.
  int sense(const Plane& old) const {
    const bool in_order = axis[old.p] == plane(old).p;
    return static_cast<int>(sign[old.p] * sign[old.q]) * (in_order ? 1 : -1);
  }
};

struct Step {
  enum class Kind { kRapid, kFeed, kCentre, kRadius } kind = Kind::kRapid;
  bool incremental = false;
  bool absolute_centre = false;
  const Plane* plane = &kPlanes[0];
  int sense = 1;
  long turns = 1;
  Vector from{};
  Vector to{};
  Vector centre{};  ///< the third axis as that of from
  long radius = 0;
};
using Program = std::vector<Step>;

long between(long lowest, long highest) {
  return *rc::gen::inRange(lowest, highest + 1);
}
long length() {
  return between(-200'000, 200'000);
}

void make_centre_arc(Step& step) {
  const Plane& plane = *step.plane;
  std::array<long, 2> spoke{between(1, 90'000), length()};
  step.centre = step.from;
  step.centre[plane.p] -= spoke[0];
  step.centre[plane.q] -= spoke[1];
  for (long quarters = between(0, 3); quarters > 0; --quarters) spoke = {-spoke[1], spoke[0]};
  step.to[plane.p] = step.centre[plane.p] + spoke[0];
  step.to[plane.q] = step.centre[plane.q] + spoke[1];
}

void make_radius_arc(Step& step) {
  const std::array<long, 2> chord{between(1, 90'000), length()};
  step.to[step.plane->p] += chord[0];
  step.to[step.plane->q] += chord[1];
  // At least half the chord, which is shorter than the sum of its parts.
  step.radius = chord[0] + std::labs(chord[1]) + between(0, 90'000);
  if (between(0, 1) == 1) step.radius = -step.radius;
}

Step some_step(const Vector& from) {
  Step step;
  step.kind = static_cast<Step::Kind>(between(0, 3));
  step.incremental = between(0, 1) == 1;
  step.absolute_centre = between(0, 1) == 1;
  step.plane = &kPlanes[between(0, 2)];
  step.sense = between(0, 1) == 1 ? 1 : -1;
  step.turns = between(1, 3);
  step.from = from;
  step.to = from;
  if (step.kind == Step::Kind::kRapid || step.kind == Step::Kind::kFeed) {
    step.to = {length(), length(), length()};
    return step;
  }
  step.to[step.plane->d] = between(0, 1) == 1 ? length() : from[step.plane->d];
  step.kind == Step::Kind::kCentre ? make_centre_arc(step) : make_radius_arc(step);
  return step;
}

Program some_program() {
  Program program;
  Vector at{};
  for (long steps = between(1, 8); steps > 0; --steps) {
    program.push_back(some_step(at));
    at = program.back().to;
  }
  return program;
}

std::string decimal(long thousandths) {
  char text[32];
  std::snprintf(text, sizeof text, "%s%ld.%03ld", thousandths < 0 ? "-" : "",
                std::labs(thousandths) / 1000, std::labs(thousandths) % 1000);
  return text;
}

std::string words(const char* addresses, const Vector& values) {
  std::string text;
  for (std::size_t i = 0; i < 3; ++i) text += std::string(" ") + addresses[i] + decimal(values[i]);
  return text;
}

Vector difference(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

std::string written(const Step& step, const Transform& transform) {
  const Vector from = transform.point(step.from);
  const Vector to = transform.point(step.to);
  const Plane& plane = transform.plane(*step.plane);
  std::string text = step.incremental ? "G91" : "G90";
  text += words("XYZ", step.incremental ? difference(to, from) : to) + " F60";
  if (step.kind == Step::Kind::kRapid) return text + " G0\n";
  if (step.kind == Step::Kind::kFeed) return text + " G1\n";
  text += step.sense * transform.sense(*step.plane) > 0 ? " G3" : " G2";
  text += " G" + std::to_string(plane.number) + " P" + std::to_string(step.turns);
  if (step.kind == Step::Kind::kRadius) return text + " R" + decimal(step.radius) + "\n";
  Vector centre = transform.point(step.centre);
  if (!step.absolute_centre) centre = difference(centre, from);
  text += step.absolute_centre ? " G90.1" : " G91.1";
  for (const std::size_t axis : {plane.p, plane.q}) {
    text += std::string(" ") + "IJK"[axis] + decimal(centre[axis]);
  }
  return text + "\n";
}

std::string written(const Program& program, const Transform& transform) {
  std::string text;
  for (const Step& step : program) text += written(step, transform);
  return text;
}

std::string profile_at(const Transform& transform) {
  const Vector at = transform.point({});
  return R"({"initial":{"x":")" + decimal(at[0]) + R"(","y":")" + decimal(at[1]) + R"(","z":")" +
         decimal(at[2]) + R"("}})";
}

Fixed number(const std::string& text) {
  const char* cursor = text.data();
  Decimal result;
  if (!read_decimal(cursor, text.data() + text.size(), result)) throw std::logic_error(text);
  return result.value;
}

/// A coordinate of the old axes in the new ones.
Fixed moved(const Transform& transform, std::size_t old_axis, Fixed value) {
  return transform.sign[old_axis] * value +
         transform.shift[transform.axis[old_axis]] * (kOne / 1000);
}

std::string shown(Fixed value) {
  char text[kTextSize];
  return {text, write_decimal(value, text)};
}

// "c=1,2" of an arc in `plane`.
std::string centre_in_new_axes(const std::string& text, const Plane& plane,
                               const Transform& transform) {
  const std::size_t comma = text.find(',');
  std::array<Fixed, 3> centre{};
  centre[transform.axis[plane.p]] = moved(transform, plane.p, number(text.substr(2, comma - 2)));
  centre[transform.axis[plane.q]] = moved(transform, plane.q, number(text.substr(comma + 1)));
  const Plane& coming = transform.plane(plane);
  return "c=" + shown(centre[coming.p]) + "," + shown(centre[coming.q]);
}

/// The record in the new axes; its parts are sorted, for the order of axes changes.
std::string in_new_axes(const std::string& record, const Transform& transform) {
  std::istringstream in(record);
  std::vector<std::string> parts;
  const Plane* plane = &kPlanes[0];
  for (std::string part; in >> part;) {
    if (part.starts_with("arc")) {
      plane = &plane_of(std::stoi(part.substr(3)));
      part = "arc" + std::to_string(transform.plane(*plane).number);
    } else if (part.starts_with("c=") && part.find(',') != std::string::npos) {
      part = centre_in_new_axes(part, *plane, transform);
    } else if (part.starts_with("rot=")) {
      part = "rot=" + std::to_string(std::stoi(part.substr(4)) * transform.sense(*plane));
    } else if (part[0] >= 'x' && part[0] <= 'z') {
      const auto axis = static_cast<std::size_t>(part[0] - 'x');
      const Fixed value = moved(transform, axis, number(part.substr(2)));
      part = std::string(1, "xyz"[transform.axis[axis]]) + "=" + shown(value);
    }
    parts.push_back(part);
  }
  std::sort(parts.begin(), parts.end());
  std::string text;
  for (const std::string& part : parts) text += part + " ";
  return text;
}

std::string in_new_axes(const Outcome& outcome, const Transform& transform) {
  std::string text = outcome.alarm + "\n";
  for (const std::string& record : outcome.records) text += in_new_axes(record, transform) + "\n";
  return text;
}

Transform some_transform() {
  Transform transform;
  for (long swaps = between(0, 5); swaps > 0; --swaps) {
    std::next_permutation(transform.axis.begin(), transform.axis.end());
  }
  for (long& sign : transform.sign) sign = between(0, 1) == 1 ? 1 : -1;
  transform.shift = {length(), length(), length()};
  return transform;
}

void compare(const Program& program, const Transform& transform) {
  const Outcome plain = run_ngc(written(program, {}));
  RC_ASSERT(plain.alarm.empty());
  RC_ASSERT(plain.answer == GONOGO_OK);
  const std::string want = in_new_axes(plain, transform);
  const std::string text = written(program, transform);
  RC_LOG() << text;
  RC_ASSERT(in_new_axes(run_ngc(text, profile_at(transform)), {}) == want);
}

// (X, Y; Z) of G17 becomes (Z, X; Y) of G18 and (Y, Z; X) of G19.
RC_GTEST_PROP(NgcSymmetry, PlanesAreRenamed, ()) {
  const Program program = some_program();
  compare(program, {{2, 0, 1}, {1, 1, 1}, {}});
  compare(program, {{1, 2, 0}, {1, 1, 1}, {}});
}

// In G17: X becomes Y, Y becomes -X.
RC_GTEST_PROP(NgcSymmetry, QuarterTurn, ()) {
  compare(some_program(), {{1, 0, 2}, {1, -1, 1}, {}});
}

RC_GTEST_PROP(NgcSymmetry, Translation, ()) {
  compare(some_program(), {{0, 1, 2}, {1, 1, 1}, {length(), length(), length()}});
}

RC_GTEST_PROP(NgcSymmetry, AnySymmetryOfTheAxes, ()) {
  compare(some_program(), some_transform());
}

// The distance modes are two ways to write one path.
RC_GTEST_PROP(NgcSymmetry, DistanceModesAgree, ()) {
  Program program = some_program();
  const Outcome one = run_ngc(written(program, {}));
  for (Step& step : program) {
    step.incremental = !step.incremental;
    step.absolute_centre = !step.absolute_centre;
  }
  RC_ASSERT(run_ngc(written(program, {})).all() == one.all());
}

}  // namespace
}  // namespace gonogo::expanders::testing
