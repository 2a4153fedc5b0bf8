// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/differential/domain.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "oracle/motion/approximate.hpp"
#include "oracle/steps/program_input.hpp"
#include "reference/expander.hpp"
#include "reference/predicate.hpp"

namespace gonogo::oracle {
namespace {

using reference::Axis;
using reference::kAllAxes;
using reference::kLinearAxes;
using reference::Number;
using reference::Position;
using reference::Record;
using reference::RecordKind;

constexpr std::size_t kMostWhole = 9;
constexpr std::size_t kMostDecimals = 7;
constexpr double kFarthest = 10'000;           // mm, degrees
constexpr double kLargestRadius = 10'000'000;  // mm
constexpr double kLeastWay = 1e-6;             // mm
constexpr double kLeastTurn = 1.7e-5;          // rad: just below 0.001 degrees
constexpr std::int64_t kMostTurns = 100'000;
constexpr double kToldRoom = 0.02;  // mm
constexpr double kNoRoom = 0.003;   // mm

bool is_number_digit(char c) {
  return c >= '0' && c <= '9';
}

// The digits that the text begins with, which are taken from it.
std::string_view take_digits(std::string_view& text) {
  const auto end = std::find_if_not(text.begin(), text.end(), is_number_digit);
  const std::string_view taken = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(taken.size());
  return taken;
}

// D-DOM-10: whether a decision of a clause misses its limit by less than the least increment.
class LimitWatch final : public reference::DecisionWatch {
 public:
  explicit LimitWatch(const reference::Profile& profile)
      : increment_(approximate(profile.resolution())) {}

  void note(const reference::Decision& decision) override {
    if (decision.sign == 0) return;
    const double distance =
        std::fabs(approximate(decision.value) +
                  std::fabs(root(decision.roots[0]) + root(decision.roots[1])) +
                  root(decision.roots[2]));
    // A whole increment stays one where doubles lose its last digits.
    is_near_ = is_near_ || distance < increment_ * (1 - 1e-6);
  }
  bool is_near() const { return is_near_; }

 private:
  static double root(const reference::Decision::Root& root) {  // mm
    return root.factor == 0 ? 0 : root.factor * std::sqrt(approximate(root.square)) / 1000;
  }

  double increment_;
  bool is_near_ = false;
};

// Follows a program, item by item.
class DomainCheck {
 public:
  explicit DomainCheck(const reference::Profile& profile)
      : at_(profile.initial.at), least_circle_(4 * approximate(profile.resolution())) {}

  // The rule that the item breaks; empty: none.
  std::string_view take(const Record& record) {
    if (!reference::is_motion(record.kind)) return {};
    if (is_far(record.to)) return "D-DOM-02";
    if (at_ && is_trace_between(*at_, record.to, kAllAxes)) return "D-DOM-04";
    std::string_view broken;
    if (record.kind == RecordKind::arc) broken = take_arc(record);
    if (record.kind == RecordKind::arc3) broken = take_space_arc(record);
    at_ = record.to;
    return broken;
  }
  std::string_view take(const reference::PocketLevel& level) {
    at_.reset();
    return reaches_far(level.centre, level.pocket_radius - level.tool_radius) ? "D-DOM-02" : "";
  }
  std::string_view take(const reference::PocketMilling& pocket) {
    at_.reset();
    const Number tool = pocket.tool_radius + pocket.tool_radius;
    const bool unclear =
        is_unclear_room(pocket.length - tool) || is_unclear_room(pocket.width - tool);
    return unclear ? "D-DOM-07" : "";
  }
  std::string_view take(const reference::ThreadMilling& thread) {
    at_.reset();
    const bool is_deep = is_far(thread.r_plane) || is_far(thread.bottom);
    if (is_deep || reaches_far(thread.centre, thread.start_radius)) return "D-DOM-02";
    return Number(kMostTurns) * thread.lead < abs(thread.travel) ? "D-DOM-06" : "";
  }
  std::string_view take(const reference::HelixPocket& helix) {
    at_.reset();
    const bool is_deep = is_far(helix.r_plane) || is_far(helix.bottom);
    return is_deep || reaches_far(helix.centre, helix.radius) ? "D-DOM-02" : "";
  }
  std::string_view take(const reference::Renaming& renaming) {
    if (!at_) return {};
    for (const Axis axis : kAllAxes) (*at_)[axis] += renaming.shift[axis];
    return {};
  }
  std::string_view take(const reference::AlarmReport&) { return {}; }
  std::string_view take(const reference::NotCovered&) { return {}; }

 private:
  static bool is_far(const Number& place) { return std::fabs(approximate(place)) > kFarthest; }
  static bool is_far(const Position& place) {
    return std::ranges::any_of(kAllAxes, [&](Axis axis) { return is_far(place[axis]); });
  }
  // Whether a circle does, which stands for a path that is open.
  static bool reaches_far(const std::array<Number, 2>& centre, const Number& radius) {
    const double reach = std::fabs(approximate(radius));
    return std::ranges::any_of(centre, [&](const Number& place) {
      return std::fabs(approximate(place)) + reach > kFarthest;
    });
  }
  // Whether two numbers are all but equal. Those that no bits tell apart are equal.
  static bool is_trace(const Number& a, const Number& b) {
    try {
      return a != b && std::fabs(approximate(a - b)) < kLeastWay;
    } catch (const exact::Undecided&) {
      return false;
    }
  }
  template <typename Axes>
  static bool is_trace_between(const Position& a, const Position& b, const Axes& axes) {
    return std::ranges::any_of(axes, [&](Axis axis) { return is_trace(a[axis], b[axis]); });
  }
  static bool is_unclear_room(const Number& room) {
    const double width = approximate(room);
    return width > kNoRoom && width < kToldRoom;
  }

  std::string_view take_arc(const Record& record) const {
    if (record.rot > kMostTurns || record.rot < -kMostTurns) return "D-DOM-06";
    const reference::PlaneAxes axes = axes_of(record.plane);
    const double p = approximate(record.to[axes.p] - record.centre[0]);
    const double q = approximate(record.to[axes.q] - record.centre[1]);
    const double radius = std::hypot(p, q);
    if (radius > kLargestRadius) return "D-DOM-03";
    if (!at_) return {};
    const double chord = std::hypot(approximate(record.to[axes.p] - (*at_)[axes.p]),
                                    approximate(record.to[axes.q] - (*at_)[axes.q]));
    const bool goes_round = chord < radius || record.rot > 1 || record.rot < -1;
    if (goes_round && radius < least_circle_) return "D-DOM-08";
    return flat(radius, chord);
  }

  // For the circle through start, intermediate point and end.
  std::string_view take_space_arc(const Record& record) const {
    if (!at_) return {};
    if (is_trace_between(*at_, record.via, kLinearAxes) ||
        is_trace_between(record.via, record.to, kLinearAxes)) {
      return "D-DOM-04";
    }
    std::array<double, 3> via{};
    std::array<double, 3> end{};
    for (const Axis axis : kLinearAxes) {
      via[index(axis)] = approximate(record.via[axis] - (*at_)[axis]);
      end[index(axis)] = approximate(record.to[axis] - (*at_)[axis]);
    }
    const double area =
        std::hypot(via[1] * end[2] - via[2] * end[1], via[2] * end[0] - via[0] * end[2],
                   via[0] * end[1] - via[1] * end[0]);
    const double first = std::hypot(via[0], via[1], via[2]);
    const double whole = std::hypot(end[0], end[1], end[2]);
    const double second = std::hypot(end[0] - via[0], end[1] - via[1], end[2] - via[2]);
    // The radius is that part of twice the area.
    if (first * second * whole > 2 * kLargestRadius * area) return "D-DOM-03";
    return flat(first * second * whole / (2 * area), whole);
  }

  static std::string_view flat(double radius, double chord) {
    return chord != 0 && chord < kLeastTurn * radius ? "D-DOM-05" : "";
  }

  std::optional<Position> at_;  // nothing: behind a path that is open
  double least_circle_;         // its radius, mm
};

}  // namespace

bool has_short_numbers(std::string_view text) {
  while (!text.empty()) {
    const std::string_view whole = take_digits(text);
    const std::size_t first = std::min(whole.find_first_not_of('0'), whole.size());
    if (whole.size() - first > kMostWhole) return false;
    if (text.empty()) break;
    const bool at_point = text.front() == '.';
    text.remove_prefix(1);
    if (!at_point) continue;
    const std::string_view decimals = take_digits(text);
    // npos + 1 is 0: nothing but zeros.
    if (decimals.find_last_not_of('0') + 1 > kMostDecimals) return false;
  }
  return true;
}

std::string_view outside_domain(const reference::Profile& profile, std::string_view program,
                                std::size_t most_items) {
  if (!has_short_numbers(program)) return "D-DOM-01";
  oracle::ProgramInput input(program);
  reference::Expander expander(profile, input.lines, reference::OpenPaths::judged);
  DomainCheck check(profile);
  const LimitWatch limits(profile);
  try {
    while (const reference::Item* item = expander.next()) {
      if (limits.is_near()) return "D-DOM-10";
      const auto broken = std::visit([&](const auto& each) { return check.take(each); }, *item);
      if (!broken.empty()) return broken;
      if (most_items-- == 0) break;
    }
  } catch (const exact::Undecided&) {
    return "D-DOM-09";
  }
  return {};
}

std::string_view outside_domain(const reference::Profile& profile, std::string_view program,
                                const oracle::Verdict& verdict) {
  const bool undecided = verdict.gap == GapReason::comparison;
  return undecided ? "D-DOM-09" : outside_domain(profile, program);
}

}  // namespace gonogo::oracle
