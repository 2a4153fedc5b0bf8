// SPDX-License-Identifier: GPL-3.0-or-later
#include "cycle_program.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <ostream>
#include <random>

namespace gonogo::reference::testing::ngc {
namespace {

constexpr std::array kCycles = {73, 74, 81, 82, 83, 84, 85, 86, 89};

bool is_pecking(int code) {
  return code == 73 || code == 83;
}
bool has_dwell(int code) {
  return code == 74 || code == 82 || code == 84 || code == 86 || code == 89;
}

HoleStep any_step(const HoleStep* before) {
  HoleStep step = before != nullptr ? *before : HoleStep{};
  const auto often = [&] { return before == nullptr || any_between(1, 3) == 1; };
  if (often()) step.code = kCycles[static_cast<std::size_t>(any_between(0, 8))];
  if (before != nullptr && any_between(1, 6) == 1) step.code = 0;
  if (often()) step.place[0] = any_between(-9, 9) * 1'000;
  if (often()) step.place[1] = any_between(-9'000, 9'000);
  if (often()) step.r_plane = any_between(-4, 8) * 500;
  if (often()) step.bottom = step.r_plane - any_between(0, 8) * 700;
  step.bottom = std::min(step.bottom, step.r_plane);
  if (often()) step.peck = *rc::gen::element<std::int64_t>(250, 300, 700, 1'000, 1'400, 9'000);
  if (often()) step.dwell = any_between(0, 3) * 250;
  if (often()) step.to_initial_level = any_between(0, 1) == 1;
  return step;
}

HoleProgram any_program() {
  HoleProgram program;
  for (std::int64_t& place : program.start) place = any_between(-4, 8) * 500;
  const HoleStep* before = nullptr;
  for (std::int64_t count = any_between(1, 6); count > 0; --count) {
    program.steps.push_back(any_step(before));
    before = &program.steps.back();
  }
  return program;
}

class Writer {
 public:
  Writer(const HoleProgram& program, const HoleWriting& writing,
         const std::vector<std::array<Number, 3>>& ends)
      : program_(program), writing_(writing), ends_(ends), axes_(axes_of(writing.plane)) {}

  std::string write() {
    std::string text =
        fmt::format("G{} {} {}\nF100\n", plane_code(writing_.plane), writing_.inch ? "G20" : "G21",
                    writing_.incremental ? "G91" : "G90");
    for (std::size_t i = 0; i < program_.steps.size(); ++i) {
      std::vector<std::string> words = words_of(i);
      if (writing_.shuffled != 0) {
        std::mt19937_64 random(writing_.shuffled + i);
        std::shuffle(words.begin(), words.end(), random);
      }
      text += fmt::format("{}\n", fmt::join(words, " "));
    }
    return text + "M2\n";
  }

 private:
  std::string length(char address, const Number& thousandths) const {
    const Number value = writing_.inch_in_mm ? thousandths * num("25.4") : thousandths;
    return address + (value / 1'000).text();
  }
  static char address(Axis axis) { return "XYZ"[index(axis)]; }
  // A word of a coordinate, or of its increment from `from`.
  std::string place(Axis axis, std::int64_t to, const Number& from) const {
    return length(address(axis), writing_.incremental ? to - from : to);
  }
  std::array<Number, 3> before(std::size_t i) const {
    if (i > 0 && writing_.incremental) return ends_[i - 1];
    return {program_.start[0], program_.start[1], program_.start[2]};
  }

  std::vector<std::string> words_of(std::size_t i) const {
    const HoleStep& step = program_.steps[i];
    const std::array<Number, 3> from = before(i);
    std::vector<std::string> words = {place(axes_.p, step.place[0], from[0]),
                                      place(axes_.q, step.place[1], from[1])};
    if (!step.is_cycle()) {
      words.insert(words.end(), {"G0", place(axes_.d, step.r_plane, from[2])});
      return words;
    }
    words.push_back(step.to_initial_level ? "G98" : "G99");
    words.push_back(step.code == 74 ? "M4" : "M3");
    const HoleStep* last = i > 0 ? &program_.steps[i - 1] : nullptr;
    const bool repeats = writing_.without_known && last != nullptr && last->code == step.code;
    if (!repeats) words.push_back(fmt::format("G{}", step.code));
    if (!repeats || last->r_plane != step.r_plane) {
      words.push_back(length('R', writing_.incremental ? step.r_plane - from[2] : step.r_plane));
    }
    if (!repeats || last->bottom != step.bottom) {
      words.push_back(place(axes_.d, step.bottom, step.r_plane));
    }
    if (is_pecking(step.code) && (!repeats || last->peck != step.peck)) {
      words.push_back(length('Q', step.peck));
    }
    if (has_dwell(step.code) && (!repeats || last->dwell != step.dwell)) {
      words.push_back("P" + (Number(step.dwell) / 1'000).text());
    }
    return words;
  }

  const HoleProgram& program_;
  const HoleWriting& writing_;
  const std::vector<std::array<Number, 3>>& ends_;
  const PlaneAxes axes_;
};

}  // namespace

rc::Gen<HoleProgram> hole_programs() {
  return rc::gen::resize(rc::kNominalSize, rc::gen::exec(any_program));
}

std::string write(const HoleProgram& program, const HoleWriting& writing,
                  const std::vector<std::array<Number, 3>>& ends) {
  return Writer(program, writing, ends).write();
}

Profile machine(const HoleProgram& program, const HoleWriting& writing) {
  Profile profile = ngc();
  const PlaneAxes axes = axes_of(writing.plane);
  const Number unit = writing.inch || writing.inch_in_mm ? num("25.4") / 1'000 : num("0.001");
  profile.initial.at[axes.p] = program.start[0] * unit;
  profile.initial.at[axes.q] = program.start[1] * unit;
  profile.initial.at[axes.d] = program.start[2] * unit;
  return profile;
}

void operator<<(std::ostream& out, const HoleProgram& program) {
  out << "from " << fmt::format("{}", fmt::join(program.start, ",")) << "\n" << write(program, {});
}

}  // namespace gonogo::reference::testing::ngc
