// SPDX-License-Identifier: GPL-3.0-or-later
#include "ngc_program.hpp"
#include "reference/reading_literal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ostream>
#include <stdexcept>

namespace gonogo::reference::testing::ngc {
namespace {

using Pair = std::array<std::int64_t, 2>;

bool seldom(int often) {
  return any_between(1, often) == 1;
}
Vector any_place() {
  return {any_between(-50'000, 50'000), any_between(-50'000, 50'000), any_between(-50'000, 50'000)};
}

// Writes the steps of one program.
class Maker {
 public:
  Program make(bool two_way) {
    two_way_ = two_way;
    program_.start = at_ = any_place();
    if (!two_way && seldom(3)) program_.readings.push_back({"ngc.arc-tolerance", "linuxcnc"});
    for (std::int64_t count = any_between(1, 8); count > 0; --count) {
      program_.steps.push_back(step());
      at_ = program_.steps.back().to;
    }
    return std::move(program_);
  }

 private:
  Step step() {
    Step step;
    step.kind = static_cast<Kind>(any_between(0, 3));
    step.plane = static_cast<Plane>(any_between(0, 2));
    step.sense = seldom(2) ? 1 : -1;
    step.from = step.to = step.centre = at_;
    if (step.kind == Kind::centre) {
      centre(step);
    } else if (step.kind == Kind::radius) {
      radius(step);
    } else {
      step.to = any_place();
      return step;
    }
    if (seldom(3)) step.to[index(axes_of(step.plane).d)] += any_between(-20'000, 20'000);
    if (seldom(4)) step.turns = any_between(1, 4);
    return step;
  }

  static void move(Vector& place, Plane plane, Pair by) {
    place[index(axes_of(plane).p)] += by[0];
    place[index(axes_of(plane).q)] += by[1];
  }

  // By quarter turns, so that the end lies on the circle; sometimes a little beside it. The radius
  // may be a decimal.
  void centre(Step& step) const {
    const std::int64_t k = any_between(1, 5'000);
    const bool pythagorean = seldom(2);
    const Pair spoke = pythagorean ? Pair{3 * k, -4 * k}
                                   : Pair{any_between(1, 20'000), any_between(-20'000, 20'000)};
    Pair end = spoke;
    for (std::int64_t quarters = any_between(0, 3); quarters > 0; --quarters) {
      end = {-end[1], end[0]};
    }
    move(step.centre, step.plane, {-spoke[0], -spoke[1]});
    step.to = step.centre;
    move(step.to, step.plane, end);
    if (pythagorean && end != spoke) {
      // More than half a turn: below zero.
      const std::int64_t cross = (spoke[0] * end[1] - spoke[1] * end[0]) * step.sense;
      step.radius = cross < 0 ? -5 * k : 5 * k;
    } else if (!two_way_ && seldom(3)) {
      move(step.to, step.plane, {any_between(-30, 30), 0});
    }
  }

  // Sometimes about half the chord.
  void radius(Step& step) const {
    const std::int64_t k = any_between(1, 5'000);
    const bool pythagorean = seldom(3);
    const Pair by = pythagorean ? Pair{6 * k, 8 * k} : Pair{2 * k, any_between(-20'000, 20'000)};
    move(step.to, step.plane, by);
    step.radius = std::abs(by[0]) + std::abs(by[1]) + any_between(0, 5'000);
    if (pythagorean)
      step.radius = std::max<std::int64_t>(1, 5 * k + (two_way_ ? 0 : any_between(-2, 2)));
    if (seldom(3)) step.radius = -step.radius;
  }

  Program program_;
  bool two_way_ = false;
  Vector at_ = {0, 0, 0};
};

std::string number(std::int64_t count, bool inch_in_mm) {
  const std::int64_t value = std::abs(inch_in_mm ? count * 254 : count);
  const std::int64_t one = inch_in_mm ? 10'000 : 1'000;
  return fmt::format("{}{}.{:0{}}", count < 0 ? "-" : "", value / one, value % one,
                     inch_in_mm ? 4 : 3);
}

std::vector<std::string> write(const Step& step, const Writing& writing) {
  const auto length = [&](char address, std::int64_t count) {
    return address + number(count, writing.inch_in_mm);
  };
  const Vector to = writing.axes.point(step.to);
  const Vector from = writing.axes.point(step.from);
  const Plane plane = writing.axes.plane(step.plane);
  const PlaneAxes axes = axes_of(plane);
  const bool is_arc = step.kind >= Kind::centre;
  const int sense = step.sense * writing.axes.sense(step.plane);
  std::vector<std::string> words = {fmt::format("G{}", plane_code(plane)),
                                    !is_arc     ? fmt::format("G{}", static_cast<int>(step.kind))
                                    : sense > 0 ? "G3"
                                                : "G2"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (is_arc && axis == index(axes.d) && to[axis] == from[axis]) continue;
    words.push_back(length("XYZ"[axis], writing.incremental ? to[axis] - from[axis] : to[axis]));
  }
  if (!is_arc) return words;
  if (step.turns != 1) words.push_back(fmt::format("P{}", step.turns));
  if (step.kind == Kind::radius || (writing.centres_by_r && step.radius != 0)) {
    words.push_back(length('R', step.radius));
    return words;
  }
  const Vector centre = writing.axes.point(step.centre);
  for (const Axis axis : {axes.p, axes.q}) {
    const std::size_t i = index(axis);
    words.push_back(length("IJK"[i], writing.absolute_centres ? centre[i] : centre[i] - from[i]));
  }
  return words;
}

}  // namespace

rc::Gen<Program> programs() {
  return rc::gen::resize(rc::kNominalSize, rc::gen::exec([] { return Maker().make(false); }));
}

rc::Gen<Program> two_way_programs() {
  return rc::gen::resize(rc::kNominalSize, rc::gen::exec([] { return Maker().make(true); }));
}

Program reversed(Program program) {
  if (!program.steps.empty()) program.start = program.steps.back().to;
  std::reverse(program.steps.begin(), program.steps.end());
  for (Step& step : program.steps) {
    std::swap(step.from, step.to);
    step.sense = -step.sense;
  }
  return program;
}

Blocks write(const Program& program, const Writing& writing) {
  // F acts before the units of its block.
  Blocks blocks = {{writing.inch ? "G20" : "G21", writing.incremental ? "G91" : "G90",
                    writing.absolute_centres ? "G90.1" : "G91.1"},
                   {"F100"}};
  for (const Step& step : program.steps) blocks.push_back(write(step, writing));
  return blocks;
}

std::string text(const Blocks& blocks) {
  std::string text;
  for (const auto& words : blocks) text += fmt::format("{}\n", fmt::join(words, " "));
  return text;
}

Profile machine(const Program& program, const Writing& writing) {
  Profile profile = std::get<Profile>(default_profile("rs274"));
  profile.readings.set("ngc.program-end=free"_reading);
  const Vector start = writing.axes.point(program.start);
  for (std::size_t i = 0; i < 3; ++i) {
    const bool inches = writing.inch || writing.inch_in_mm;
    profile.initial.at[kLinearAxes[i]] =
        Number::millionths(start[i] * 1'000) * (inches ? Number::decimal(false, 254, 1) : 1);
  }
  for (const auto& [name, value] : program.readings) {
    if (auto error = set_reading(profile, name, value)) throw std::invalid_argument(error->message);
  }
  return profile;
}

void operator<<(std::ostream& out, const Program& program) {
  out << text(write(program, {}));
}

}  // namespace gonogo::reference::testing::ngc
