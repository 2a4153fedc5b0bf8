// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/report/named_points.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <regex>

#include "oracle/report/clauses.hpp"
#include "oracle/report/views.hpp"

namespace gonogo::oracle::report {
namespace {

// A step of a clause: where from, where to, along which axis; empty: not said.
struct Step {
  std::string from;
  std::string to;
};

std::vector<Step> steps_of(const std::string& text) {
  static const std::regex kStep(
      R"re((?:from ([A-D]) )?to (?:the )?([A-D](?![A-Za-z0-9])|R plane|initial plane|R1[0-9][0-9](?: \+ R1[0-9][0-9])?|R(?![A-Za-z0-9])))re");
  std::vector<Step> steps;
  for (std::sregex_iterator it(text.begin(), text.end(), kStep), end; it != end; ++it) {
    steps.push_back({it->str(1), it->str(2)});
  }
  return steps;
}

bool is_point(const std::string& name) {
  return name.size() == 1 && name[0] >= 'A' && name[0] <= 'D';
}

// The one axis along which a motion goes straight.
std::optional<char> only_axis(const Motion& motion) {
  const Point3& from = motion.points.front();
  const Point3& to = motion.points.back();
  const bool x = std::fabs(to.x - from.x) > kStill;
  const bool y = std::fabs(to.y - from.y) > kStill;
  const bool z = std::fabs(to.z - from.z) > kStill;
  if (motion.points.size() != 2 || x + y + z != 1) return std::nullopt;
  return x ? 'X' : y ? 'Y' : 'Z';
}

double along(const Point3& point, char axis) {
  return axis == 'X' ? point.x : axis == 'Y' ? point.y : point.z;
}

// A is where the cycle begins: a text that speaks of going back to it may mean another motion.
void add_point(Names& names, const std::string& name, const Point3& at, const Point3& begin) {
  const bool elsewhere = std::fabs(at.x - begin.x) > kStill || std::fabs(at.y - begin.y) > kStill ||
                         std::fabs(at.z - begin.z) > kStill;
  if (name == "A" && elsewhere) return;
  const auto same = [&](const NamedPoint& known) { return known.name == name; };
  if (std::ranges::none_of(names.points, same)) names.points.push_back({name, at});
}

void add_plane(Names& names, std::string name, char axis, double at) {
  if (name == "R") name = "R plane";
  const auto same = [&](const NamedPlane& known) { return known.name == name; };
  if (std::ranges::none_of(names.planes, same)) names.planes.push_back({name, axis, at});
}

void add_axes(Names& names, const std::string& text, const Motion& motion) {
  static const std::regex kAlone(R"re(along ([pqd]) alone|Traverse (d) to)re");
  std::smatch found;
  const auto axis = only_axis(motion);
  if (!axis || !std::regex_search(text, found, kAlone)) return;
  const std::string name = found[1].matched ? found.str(1) : found.str(2);
  names.axes.emplace(name[0], *axis);
}

// Of a hole cycle: the cut begins at R, whatever traverses lead there.
bool leads_to_cut(const Motion& motion, const Motion* next) {
  const auto axis = only_axis(motion);
  return axis && next != nullptr && !next->rapid && only_axis(*next) == axis;
}

// The motion is the `place`-th in a row of one clause; `next` is the one after it in the block.
void add_motion(Names& names, const Motion& motion, const Motion* next, std::size_t place,
                const Point3& begin) {
  const reference::Clause* clause = find_clause(motion.clause);
  if (clause == nullptr) return;
  const std::string text(clause->text);
  add_axes(names, text, motion);
  const std::vector<Step> steps = steps_of(text);
  if (std::ranges::any_of(steps, [](const Step& step) { return step.to == "R"; })) {
    if (motion.rapid && leads_to_cut(motion, next)) {
      const char axis = *only_axis(motion);
      add_plane(names, "R", axis, along(motion.points.back(), axis));
    }
    return;
  }
  if (place >= steps.size()) return;
  const Step& step = steps[place];
  if (!step.from.empty()) add_point(names, step.from, motion.points.front(), begin);
  if (is_point(step.to)) {
    add_point(names, step.to, motion.points.back(), begin);
  } else if (const auto axis = only_axis(motion)) {
    add_plane(names, step.to, *axis, along(motion.points.back(), *axis));
  }
}

// The one after it in its block; null: there is none.
const Motion* next_moving(const Path& path, std::size_t i) {
  for (std::size_t k = i + 1; k < path.motions.size(); ++k) {
    const Motion& next = path.motions[k];
    if (next.block != path.motions[i].block) return nullptr;
    if (next.moves()) return &next;
  }
  return nullptr;
}

}  // namespace

Names names_in(const Path& path, std::uint64_t block) {
  Names names;
  std::uint64_t here = 0;
  std::string clause;
  std::size_t place = 0;
  Point3 begin;  // of the block
  for (std::size_t i = 0; i < path.motions.size(); ++i) {
    const Motion& motion = path.motions[i];
    if (!motion.moves() || (block != 0 && motion.block != block)) continue;
    if (motion.block != here && !names.points.empty()) break;
    if (motion.block != here && !names.planes.empty()) break;
    place = motion.block == here && motion.clause == clause ? place + 1 : 0;
    if (motion.block != here) begin = motion.points.front();
    here = motion.block;
    clause = motion.clause;
    add_motion(names, motion, next_moving(path, i), place, begin);
  }
  return names;
}

}  // namespace gonogo::oracle::report
