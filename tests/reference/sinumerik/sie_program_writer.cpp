// SPDX-License-Identifier: GPL-3.0-or-later
//
// One program as text, in any of its writings.
#include <fmt/format.h>

#include <cstdlib>
#include <optional>
#include <stdexcept>

#include "sie_program.hpp"

namespace gonogo::reference::testing::sie {
namespace {

std::string digits(std::int64_t count, std::int64_t one, int decimals) {
  const std::int64_t value = std::abs(count);
  return fmt::format("{}{}.{:0{}}", count < 0 ? "-" : "", value / one, value % one, decimals);
}

class Writer {
 public:
  Writer(const Program& program, const Writing& writing) : writing_(writing) {
    plane_ = writing.axes.plane(Plane::g17);
    blocks_.push_back({fmt::format("G{}", plane_code(plane_)),
                       writing.lengths == Lengths::inch ? "G70" : "G71",
                       writing.ends == Ends::incremental ? "G91" : "G90", "F100"});
    for (const Step& step : program.steps) put(step);
  }
  Blocks take() { return std::move(blocks_); }

 private:
  void put(const Step& step) {
    block_.clear();
    parameters_.clear();
    enter_plane(step);
    static constexpr const char* kCodes[kKinds] = {"G0", "G1", "", "",    "",  "",
                                                   "",   "G1", "", "CIP", "CT"};
    const std::string code = kCodes[static_cast<std::size_t>(step.kind)];
    if (step.kind == Kind::pole) return put_pole(step);
    block_.push_back(!code.empty() ? code : step.sense * sense_of(step) > 0 ? "G3" : "G2");
    if (step.kind == Kind::polar_line || step.kind == Kind::polar_arc) {
      block_.push_back("AP=" + value(writing_.axes.angle(step.plane, step.angle), false));
      block_.push_back("RP=" + value(step.radius));
      if (step.to[step.third()] != step.from[step.third()]) put_end(step, step.third());
    } else {
      put_ends(step);
    }
    put_form(step);
    if (step.turns != 0) block_.push_back(fmt::format("TURN={}", step.turns));
    flush();
  }

  void flush() {
    // Each assignment acts at once.
    block_.insert(block_.begin(), parameters_.begin(), parameters_.end());
    blocks_.push_back(std::move(block_));
    block_.clear();
  }

  int sense_of(const Step& step) const { return writing_.axes.sense(step.plane); }

  static bool is_flat_arc(const Step& step) {
    return (step.kind == Kind::centre || step.kind == Kind::radius) && !step.is_helix();
  }

  void enter_plane(const Step& step) {
    const Plane plane = writing_.axes.plane(step.plane);
    if (plane == plane_ || (writing_.planes_by_axes && is_flat_arc(step))) return;
    plane_ = plane;
    blocks_.push_back({fmt::format("G{}", plane_code(plane))});
  }

  // A number as it stands behind an '=' or an address.
  std::string number(std::int64_t count, bool is_length) const {
    if (is_length && writing_.lengths == Lengths::inch_in_mm) {
      return digits(count * 254, 10'000, 4);
    }
    return decimal(count);
  }

  std::string value(std::int64_t count, bool is_length = true) {
    if (writing_.values == Values::constants) return number(count, is_length);
    const std::size_t next = parameters_.size();
    if (writing_.values == Values::parameters) {
      parameters_.push_back(fmt::format("R{}={}", next, number(count, is_length)));
      return fmt::format("R{}", next);
    }
    const std::int64_t part = 1'234 * (static_cast<std::int64_t>(next) - 2);
    parameters_.push_back(fmt::format("R{}={}", 100 + next, number(count - part, is_length)));
    return fmt::format("(R{}*2-({})*(-2))/2", 100 + next, number(part, is_length));
  }

  // X10, or X=R1 where the value is no constant.
  std::string word(std::string_view address, std::int64_t count) {
    const bool bare = address.size() == 1 && writing_.values == Values::constants;
    return fmt::format("{}{}{}", address, bare ? "" : "=", value(count));
  }
  std::string called(std::string_view address, std::string_view call, std::int64_t count) {
    return fmt::format("{}={}({})", address, call, value(count));
  }

  // The coordinate of a step's point along one of its axes, and its increment from the start.
  std::string point_word(std::string_view address, const Step& step, const Vector& point,
                         std::size_t axis) {
    const std::size_t to = writing_.axes.axis[axis];
    const std::int64_t place = writing_.axes.point(point)[to];
    const std::int64_t travel = writing_.axes.direction(point - step.from)[to];
    const bool g91 = writing_.ends == Ends::incremental;
    if (step.astray) return g91 ? called(address, "AC", place) : word(address, place);
    switch (writing_.ends) {
      case Ends::absolute:
        return word(address, place);
      case Ends::incremental:
        return word(address, travel);
      case Ends::ac_and_ic:
        return ++words_ % 2 == 0 ? called(address, "AC", place) : called(address, "IC", travel);
      case Ends::mixed:
        return ++words_ % 2 == 0 ? word(address, place) : called(address, "IC", travel);
    }
    return {};
  }

  void put_end(const Step& step, std::size_t axis) {
    const char address = "XYZ"[writing_.axes.axis[axis]];
    block_.push_back(point_word({&address, 1}, step, step.to, axis));
  }

  void put_ends(const Step& step) {
    const bool line = step.kind <= Kind::feed || step.kind == Kind::cip;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool third = axis == step.third();
      if (!line && third && step.to[axis] == step.from[axis]) continue;
      if (!third && step.kind == Kind::angle_centre) continue;
      put_end(step, axis);
    }
  }

  void put_form(const Step& step) {
    switch (step.kind) {
      case Kind::centre:
        return put_centre(step);
      case Kind::radius:
        block_.push_back("CR=" + value(step.radius));
        return;
      case Kind::angle_centre:
        put_centre(step);
        [[fallthrough]];
      case Kind::angle_end:
        block_.push_back("AR=" + value(step.angle, false));
        return;
      case Kind::cip:
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const std::size_t to = writing_.axes.axis[axis];
          block_.push_back(point_word(std::string(1, "IJK"[to]) + "1", step, step.via, axis));
        }
        return;
      default:
        return;
    }
  }

  void put_centre(const Step& step) {
    const PlaneAxes axes = axes_of(step.plane);
    for (const Axis old : {axes.p, axes.q}) {
      const std::size_t to = writing_.axes.axis[index(old)];
      const char address = "IJK"[to];
      const std::string_view name(&address, 1);
      const Vector offset = writing_.axes.direction(step.centre - step.from);
      block_.push_back(writing_.absolute_centres
                           ? called(name, "AC", writing_.axes.point(step.centre)[to])
                           : word(name, offset[to]));
    }
  }

  void put_pole(const Step& step) {
    const int base = writing_.poles_from_zero ? 111 : step.base;
    block_.push_back(fmt::format("G{}", base));
    const Vector by = base == 111 ? writing_.axes.point(step.centre)
                                  : writing_.axes.direction(step.centre - step.base_at);
    const PlaneAxes axes = axes_of(step.plane);
    for (const Axis old : {axes.p, axes.q}) {
      const std::size_t to = writing_.axes.axis[index(old)];
      block_.push_back(word(std::string_view("XYZ").substr(to, 1), by[to]));
    }
    // A block of a pole holds nothing else.
    if (!parameters_.empty()) blocks_.push_back(std::exchange(parameters_, {}));
    flush();
  }

  const Writing& writing_;
  Blocks blocks_;
  std::vector<std::string> block_;
  std::vector<std::string> parameters_;
  Plane plane_ = Plane::g17;
  int words_ = 0;
};

}  // namespace

std::string decimal(std::int64_t thousandths) {
  return digits(thousandths, 1'000, 3);
}

Blocks write(const Program& program, const Writing& writing) {
  return Writer(program, writing).take();
}

std::string text(const Blocks& blocks) {
  std::string text;
  for (const auto& words : blocks) text += fmt::format("{}\n", fmt::join(words, " "));
  return text;
}

Profile machine(const Program& program, const Writing& writing) {
  Profile profile = std::get<Profile>(default_profile("sinumerik840d"));
  const Vector start = writing.axes.point(program.start);
  for (std::size_t i = 0; i < 3; ++i) {
    const bool inches = writing.lengths != Lengths::mm;
    profile.initial.at[kLinearAxes[i]] =
        Number::millionths(start[i] * 1'000) * (inches ? Number::decimal(false, 254, 1) : 1);
  }
  for (const auto& [name, value] : program.readings) {
    if (auto error = set_reading(profile, name, value)) throw std::invalid_argument(error->message);
  }
  return profile;
}

}  // namespace gonogo::reference::testing::sie
