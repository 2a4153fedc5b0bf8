// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cycles of SINUMERIK 802S: LCYC82 and LCYC75 with their R parameters, valid, on the boundary of a
// rule, and with one thing wrong.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "fuzz/generate/sinumerik_writer.hpp"

namespace gonogo::generate {
namespace {

using Values = std::map<int, std::int64_t>;

constexpr int kTools = 4;
// In a turned frame nearly all coordinates are only enclosed: whether a motion is within the
// tolerance of a border that lies as far as that from the other one, thousandths, stays open. And
// of a pocket as small as the tolerance in depth and in the plane nothing is known.
constexpr std::int64_t kTold = 20;

bool is_shallow(const Values& values) {
  return values.at(103) - values.at(104) < kTold;
}

// D-DOM-07: hardly more than none, or clearly more than the tolerance.
std::int64_t told_apart(std::int64_t room, const Values& values, const SinumerikFrame& frame) {
  constexpr std::int64_t kNone = 3;
  const bool turned = frame.angle % 90'000 != 0;
  const std::int64_t most = turned || is_shallow(values) ? 0 : kNone;
  return room > most ? std::max(room, kTold) : room;
}

}  // namespace

// Small ones, so that a pocket has few passes.
void SinumerikWriter::make_tools() {
  for (int tool = 1; tool <= kTools; ++tool) {
    const std::int64_t radius = settings_.machine.tools
                                    ? choices_.pick({0, 1'000, 2'000, 2'500, 3'000, 5'000})
                                    : tool * 1'000;
    const std::int64_t own = radius != 0 ? radius : 800 + choices_.between(0, 6'000);
    // Whether a pass runs along the border is known to within the tolerance.
    tools_.push_back(std::max(kTold, length_of(own)));
    profile_.tools[std::to_string(tool)].radius =
        reference::Number::millionths(tools_.back() * 1'000);
  }
}

// Some to a block, in any order; an expression may read what stands before it.
void SinumerikWriter::assign(const Values& values) {
  std::vector<std::pair<int, std::int64_t>> open(values.begin(), values.end());
  for (std::size_t i = open.size(); i > 1; --i) {
    if (choices_.one_in(3)) {
      std::swap(open[i - 1], open[choices_.below(static_cast<std::uint32_t>(i))]);
    }
  }
  may_assign_ = false;
  Words words;
  for (const auto& [number, value] : open) {
    const auto old = state_.parameters.find(number);
    const bool holds = old != state_.parameters.end() && old->second == value;
    if (holds && choices_.below(4) != 0) continue;
    const std::string text = choices_.one_in(5) ? expression(value) : constant(value);
    words.push_back(fmt::format("R{}={}", number, text));
    state_.parameters[number] = value;
    if (words.size() < 3 || choices_.below(3) != 0) continue;
    write(std::move(words), Kind::other);
    words.clear();
  }
  if (!words.empty()) write(std::move(words), Kind::other);
  may_assign_ = true;
}

// R101 to R104: on the boundary of a rule as often as beside it.
void SinumerikWriter::choose_planes(Values& values) {
  const std::int64_t reference = choices_.one_in(2) ? 0 : any_sign(length(20));
  const std::int64_t clearance = length_of(choices_.pick({0, 500, 1'000, 2'000, 2'500}));
  const std::int64_t depth =
      choices_.one_in(8) ? choices_.between(1, 4) : length_of(1'000) + length(12);
  values[101] = reference + clearance + (choices_.one_in(3) ? 0 : length(20));
  values[102] = clearance;
  values[103] = reference;
  values[104] = reference - depth;
  if (is_shallow(values)) values[101] += kTold;
  if (!puts_wrong(24)) return;
  count("fault: planes of a cycle");
  switch (choices_.below(4)) {
    case 0:
      values[101] = reference + clearance - 1;
      break;
    case 1:
      values[104] = reference;
      break;
    case 2:
      values[104] = reference + 1;
      break;
    default:
      values[102] = -1;
  }
  faulted_ = true;
}

// R116 to R120 and the allowance R124, for a tool of this radius: little more than it needs.
void SinumerikWriter::choose_pocket(Values& values, std::int64_t radius) {
  std::int64_t allowance = choices_.pick({0, 0, 100, 750});
  if (choices_.one_in(10))
    allowance = 2 * radius - std::min<std::int64_t>(radius, choices_.pick({1, 1, 500}));
  const bool finishes = values[127] == 2'000;
  // The allowance has no say in how large a finished pocket must be.
  const std::int64_t least = 2 * (radius + (finishes ? 0 : allowance));
  std::int64_t room = choices_.one_in(4) ? choices_.between(0, 3) : length(2 * radius / 1'000);
  if (!faulted_ && puts_wrong(30)) {
    count("fault: pocket too small for the tool");
    room = -1;
    faulted_ = true;
  }
  const std::int64_t width = least + told_apart(room, values, state_.frame);
  std::int64_t longer = choices_.one_in(4)   ? 0
                        : choices_.one_in(6) ? choices_.between(1, 3)
                                             : length(25);
  const std::int64_t longest = least + told_apart(width + longer - least, values, state_.frame);
  std::int64_t corner = 0;
  switch (choices_.below(8)) {
    case 0:
    case 1:
      break;
    case 2:
    case 3:
      // A slot, or a circle; half of an odd width is no parameter.
      corner = width / 2;
      break;
    case 4:
      // As large as fits under one reading, an alarm under the other.
      corner = width / 2 + choices_.between(1, 3);
      if (choices_.one_in(2)) corner = width;
      break;
    case 5:
      corner = std::min(width / 2, radius + allowance + choices_.between(-1, 1));
      break;
    default:
      corner = choices_.between(0, width / 2);
  }
  const bool upright = choices_.one_in(3);
  values[116] = any_sign(length(40));
  values[117] = any_sign(length(40));
  values[118] = upright ? width : longest;
  values[119] = upright ? longest : width;
  values[120] = corner;
  values[124] = allowance;
  count(longest == width && 2 * corner == width ? "pocket: circle"
        : 2 * corner == width                   ? "pocket: slot"
                                                : "pocket: rectangle");
}

// R121 and R125: few levels, and the boundaries between one number and the next.
void SinumerikWriter::choose_depths(Values& values) {
  const std::int64_t depth = std::max<std::int64_t>(1, values[103] - values[104]);
  std::int64_t left = choices_.pick({0, 0, 100, 500});
  if (choices_.one_in(12)) left = depth - kTold;
  if (left < 0 || left >= depth) left = 0;
  values[125] = left;
  const std::array<std::int64_t, 4> ways = {depth, depth + values[102], depth - left,
                                            depth - left + values[102]};
  const std::int64_t way = ways[choices_.below(4)];
  std::int64_t infeed = way / choices_.pick({1, 1, 2, 3, 4});
  infeed += choices_.one_in(4) ? choices_.pick<std::int64_t>({-1, 0, 1}) : length(3);
  // Not thousands of levels in the air.
  values[121] = std::max<std::int64_t>({infeed, depth / 6, values[102] / 50, 1});
}

// One rule broken; most of them by as little as a parameter can say.
void SinumerikWriter::break_pocket(Values& values) {
  count("fault: parameter of a pocket");
  faulted_ = true;
  const std::int64_t depth = values[103] - values[104];
  const auto set = [&](int number, std::initializer_list<std::int64_t> wrong) {
    values[number] = wrong.begin()[choices_.below(static_cast<std::uint32_t>(wrong.size()))];
  };
  switch (choices_.below(10)) {
    case 0:
      return set(126, {0, 1'000, 4'000, 2'500, -2'000});
    case 1:
      return set(127, {0, 3'000, 1'500, -1'000});
    case 2:
      return set(121, {0, -1'000});
    case 3:
      return set(118, {0, -20'000});
    case 4:
      return set(119, {0, -1});
    case 5:
      return set(120, {-1, -5'000});
    case 6:
      return set(122, {0, -100'000});
    case 7:
      return set(123, {0, -1});
    case 8:
      return set(125, {-1, depth, depth + 1});
    default:
      return set(124, {-1, 2 * *std::ranges::max_element(tools_), 40'000});
  }
}

// A tool, its offset and the spindle. False: without what a pocket must have.
bool SinumerikWriter::tool_block(int tool) {
  Words words = {fmt::format("T{}", tool)};
  // The profile says nothing of other edges.
  if (choices_.one_in(2)) words.push_back(choices_.pick({"D1", "D1", "D01"}));
  words.push_back(choices_.pick({"S300", "S600", "S1200"}));
  words.push_back(choices_.pick({"M3", "M3", "M4"}));
  state_.speed = std::stoll(words[words.size() - 2].substr(1));
  const bool lacks = puts_wrong(24);
  if (lacks) {
    count("fault: tool or spindle");
    switch (choices_.below(5)) {
      case 0:
        words[0] = "T0";
        break;
      case 1:
        words[0] = "T77";
        break;
      case 2:
        words.back() = "M5";
        break;
      case 3:
        words[words.size() - 2] = "S0";
        break;
      default:
        words.push_back("D0");
        if (words[1][0] == 'D') words.erase(words.begin() + 1);
    }
  }
  if (state_.has_m6) words.insert(words.begin() + 1, "M6");
  write(std::move(words), Kind::other);
  return !lacks;
}

// Alone in its block; the tool is then over the place where it was or over the pocket's centre.
void SinumerikWriter::call(const char* name) {
  const PlaneOf axes = plane_of(state_.plane);
  const bool was_faulted = faulted_;
  Words words = {name};
  if (puts_wrong(30)) {
    count("fault: word beside a cycle");
    words.push_back(choices_.pick({"F100", "X5", "G90", "M8", "R105=1", "G1", "S500"}));
    faulted_ = true;
  }
  Place after = state_.at;
  after[axes.d] = Coordinate::exactly(state_.parameters[101] * 10);
  if (words[0] == "LCYC75") {
    after[axes.p] = Coordinate::exactly(state_.parameters[116] * 10);
    after[axes.q] = Coordinate::exactly(state_.parameters[117] * 10);
  }
  target_ = after;
  state_.at = after;
  state_.moved = true;
  // What a CT after it goes on from is undecided.
  state_.tangent.reset();
  state_.way.reset();
  state_.spoke.reset();
  state_.helix_in = 0;
  state_.at_polar = false;
  faulted_ = faulted_ || was_faulted;
  write(std::move(words), Kind::cycle);
}

// In inches what a parameter of a cycle says is undecided.
void SinumerikWriter::leave_inches() {
  if (!state_.inch) return;
  state_.inch = false;
  state_.radius.reset();
  text_ += "G71\n";
}

void SinumerikWriter::drilling_block() {
  kind_ = Kind::other;
  if (state_.astray) resync();
  leave_inches();
  count("LCYC82");
  Values values;
  choose_planes(values);
  const bool broken = faulted_;
  faulted_ = false;
  values[105] = choices_.pick({0, 0, 500, 1'000, 2'250});
  const bool negative = !broken && puts_wrong(30);
  if (negative) values[105] = -1;
  assign(values);
  faulted_ = broken || negative;
  call("LCYC82");
}

void SinumerikWriter::pocket_block() {
  kind_ = Kind::other;
  if (state_.astray) resync();
  leave_inches();
  const auto tool = static_cast<int>(choices_.below(kTools)) + 1;
  faulted_ = false;
  const bool lacks = !tool_block(tool);
  if (state_.astray) return;
  Values values;
  values[126] = choices_.pick({2'000, 3'000});
  values[127] = choices_.one_in(3) ? 2'000 : 1'000;
  count(values[127] == 1'000 ? "LCYC75 roughing" : "LCYC75 finishing");
  choose_planes(values);
  choose_pocket(values, tools_[static_cast<std::size_t>(tool - 1)]);
  choose_depths(values);
  values[122] = (20 + choices_.below(200)) * 1'000L;
  values[123] = (20 + choices_.below(200)) * 1'000L;
  if (!faulted_ && !lacks && puts_wrong(12)) break_pocket(values);
  const bool broken = faulted_ || lacks;
  faulted_ = false;
  assign(values);
  faulted_ = broken;
  call("LCYC75");
  // Roughed, then finished: only the machining type changes.
  if (!state_.astray && values[127] == 1'000 && choices_.one_in(4)) {
    assign({{127, 2'000}});
    call("LCYC75");
  }
}

}  // namespace gonogo::generate
