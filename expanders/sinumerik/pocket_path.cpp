// SPDX-License-Identifier: GPL-3.0-or-later
// LCYC75: the way of the tool. A level is cleared by lines to and fro along the longer side, which
// keep off the border, and by a pass along the border in the sense of R126.
#include <algorithm>
#include <cmath>

#include "expanders/sinumerik/cycles.hpp"

namespace gonogo::expanders::sinumerik {
namespace {

// In radii of the tool.
constexpr double kStep = 1.6;     // between lines
constexpr double kOff = 0.1;      // of the lines from the border
constexpr double kMostOff = 0.5;  // of a small tool's

// What the lines keep off the border at least, so that none of them is a pass along it: five least
// increments of 0.001 mm.
constexpr double kLeastOff = 5'000'000;

Area inset(Area area, double by) {
  area.half_length = std::max(area.half_length - by, 0.);
  area.half_width = std::max(area.half_width - by, 0.);
  area.corner = std::max(area.corner - by, 0.);
  return area;
}

/// Draws in one pocket. Places are those of the area turned so that its longer side lies along x,
/// from its middle.
class PocketPath {
 public:
  PocketPath(Machine& machine, const Pocket& pocket)
      : machine_(machine),
        pocket_(pocket),
        plane_(plane_of(pocket.plane)),
        upright_(pocket.area.half_width > pocket.area.half_length),
        area_(pocket.area),
        place_(machine.state.position) {
    if (upright_) std::swap(area_.half_length, area_.half_width);
  }

  bool run(const Target& target);

 private:
  bool approach();
  bool level(Fixed depth, bool last);
  bool clear();
  bool lines(const Area& area);
  bool contour(const Area& area);
  bool middle_line(const Area& area);
  bool leave(const Target& target);
  Place at(double x, double y) const;
  bool go(double x, double y);
  bool turn(double centre_x, double centre_y, double x, double y);
  bool plunge(Fixed depth);
  bool rapid(const Place& to, Axes axes);

  Axes in_plane() const { return machine_.frame.to_machine(plane_axes(plane_)); }

  Machine& machine_;
  const Pocket& pocket_;
  const Plane& plane_;
  bool upright_;
  Area area_;
  Place place_;
};

Place PocketPath::at(double x, double y) const {
  Place point = place_;
  point[plane_.p] = pocket_.centre_p + (upright_ ? -y : x);
  point[plane_.q] = pocket_.centre_q + (upright_ ? x : y);
  return point;
}

bool PocketPath::rapid(const Place& to, Axes axes) {
  place_ = to;
  return machine_.tracer.rapid(machine_.output(to), machine_.frame.to_machine(axes));
}

bool PocketPath::go(double x, double y) {
  place_ = at(x, y);
  const Point to = machine_.output(place_);
  return machine_.tracer.feed(to, in_plane(), pocket_.plane_feed);
}

// A quarter of a circle.
bool PocketPath::turn(double centre_x, double centre_y, double x, double y) {
  if (area_.corner == 0 || machine_.output(at(x, y)) == machine_.output(place_)) return go(x, y);
  const Point centre = machine_.output(at(centre_x, centre_y));
  place_ = at(x, y);
  return machine_.tracer.arc(plane_, centre[plane_.p], centre[plane_.q], pocket_.sense,
                             machine_.output(place_), in_plane(), pocket_.plane_feed);
}

bool PocketPath::plunge(Fixed depth) {
  place_[plane_.d] = static_cast<Real>(depth);
  const Point to = machine_.output(place_);
  return machine_.tracer.feed(to, axis_bit(plane_.d), pocket_.depth_feed);
}

// From the middle of the area to its border, once round, and back.
bool PocketPath::contour(const Area& area) {
  const double a = area.half_length;
  const double b = area.half_width;
  if (b == 0) return middle_line(area);
  const double straight = a - area.corner;
  const double rise = b - area.corner;
  const double s = pocket_.sense;
  return go(0, -b) && go(s * straight, -b) && turn(s * straight, -rise, s * a, -rise) &&
         go(s * a, rise) && turn(s * straight, rise, s * straight, b) && go(-s * straight, b) &&
         turn(-s * straight, rise, -s * a, rise) && go(-s * a, -rise) &&
         turn(-s * straight, -rise, -s * straight, -b) && go(0, -b) && go(0, 0);
}

bool PocketPath::middle_line(const Area& area) {
  return go(area.half_length, 0) && go(-area.half_length, 0) && go(0, 0);
}

// What is deeper than the radius of the tool within the border lies between two lines.
bool PocketPath::lines(const Area& whole) {
  const double radius = pocket_.radius;
  if (whole.half_width <= radius) return true;
  const double off = std::min(std::max(kOff * radius, kLeastOff), kMostOff * radius);
  const Area area = inset(whole, off);
  const double span = 2 * area.half_width;
  const bool islands = machine_.has("pocket-step-too-wide"_fault);
  const double count = islands ? std::max(std::floor(span / (2.4 * radius)), 1.)
                               : std::ceil(span / (kStep * radius));
  double side = 1;
  for (double i = 0; i <= count; ++i, side = -side) {
    const double y = -area.half_width + span * (i / count);
    const double over = std::max(std::fabs(y) - (area.half_width - area.corner), 0.);
    const double square = std::max(area.corner * area.corner - over * over, 0.);
    const double reach = area.half_length - area.corner + std::sqrt(square);
    if (!go(-side * reach, y) || !go(side * reach, y)) return false;
  }
  return go(0, 0);
}

bool PocketPath::clear() {
  return lines(area_) && contour(area_);
}

// SIE-LC75-10
bool PocketPath::level(Fixed depth, bool last) {
  if (!plunge(depth)) return false;
  const bool whole = !pocket_.strip_only || (last && !pocket_.contour_only);
  if (whole) return clear();
  for (int pass = pocket_.inner_passes; pass > 0; --pass) {
    const double off = std::min(pass * kBetweenPasses * pocket_.radius, area_.half_width);
    if (!contour(inset(area_, off))) return false;
  }
  return contour(area_);
}

// SIE-LC75-13
bool PocketPath::approach() {
  Place point = at(0, 0);
  point[plane_.d] = static_cast<Real>(pocket_.retract);
  if (!rapid(point, plane_axes(plane_) | axis_bit(plane_.d))) return false;
  point[plane_.d] = static_cast<Real>(pocket_.start);
  if (!rapid(point, axis_bit(plane_.d))) return false;
  if (!machine_.has("pocket-plunge-off-centre"_fault)) return true;
  return rapid(at(area_.half_length / 2, 0), plane_axes(plane_));
}

bool PocketPath::leave(const Target& target) {
  Place point = target.to;
  point[plane_.d] = place_[plane_.d];
  const Point to = machine_.output(point);
  if (!machine_.tracer.feed(to, in_plane(), pocket_.plane_feed)) return false;
  return rapid(target.to, axis_bit(plane_.d));
}

// SIE-LC75-04
bool PocketPath::run(const Target& target) {
  if (!approach()) return false;
  const Fixed count = pocket_.levels.count;
  for (Fixed k = 1; k <= count; ++k) {
    if (k == count && machine_.has("pocket-last-level-missed"_fault)) break;
    if (!level(pocket_.levels.depth(k), k == count)) return false;
  }
  return leave(target);
}

// SIE-LC75-14, and faults of what the cycle leaves behind.
void leave_modes(Machine& machine, const Pocket& pocket) {
  State& state = machine.state;
  const bool feed_stays = machine.follows("sie.lc75.feed-after=of-cycle"_reading);
  if (feed_stays || machine.has("cycle-feed-stays"_fault)) {
    state.feed = pocket.plane_feed.value;
    state.feed_of_cycle = true;
  }
  if (machine.has("cycle-g0-stays"_fault)) state.motion = Motion::kRapid;
  if (machine.has("cycle-parameter-lost"_fault)) {
    const Fixed step = pocket.levels.from - pocket.levels.depth(1);
    state.parameters[121] = static_cast<double>(step) / static_cast<double>(kOne);
  }
}

}  // namespace

Fixed Levels::depth(Fixed k) const {
  if (k == count) return floor;
  const Wide down = equal ? scaled(from - floor, k, count) : static_cast<Wide>(k) * most;
  return from - static_cast<Fixed>(down);
}

bool mill_pocket(Machine& machine, const Pocket& pocket, const Target& target) {
  const bool goes_on = PocketPath(machine, pocket).run(target);
  leave_modes(machine, pocket);
  return goes_on;
}

}  // namespace gonogo::expanders::sinumerik
