// SPDX-License-Identifier: GPL-3.0-or-later
//
// The milling of a pocket by LCYC75 (SIE-LC75-04 to -13): levels, infeeds, feeds, the direction
// along the border, what is left, and the end above the centre.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "flat_path.hpp"
#include "open_parts.hpp"

namespace gonogo::mutations {
namespace {

using reference::PocketMilling;

bool cuts(RecordKind kind) {
  return kind == RecordKind::feed || kind == RecordKind::arc || kind == RecordKind::arc3;
}

class OpenPocketMilling : public OpenPart {
 public:
  explicit OpenPocketMilling(const PocketMilling& pocket)
      : pocket_(pocket),
        axes_(axes_of(pocket.plane)),
        d_(index(axes_.d)),
        centre_{value_of(pocket.centre[0]), value_of(pocket.centre[1])},
        direction_{value_of(pocket.direction[0]), value_of(pocket.direction[1])},
        top_(value_of(pocket.reference_plane)),
        retract_(value_of(pocket.retract)),
        floor_(value_of(pocket.floor)),
        tool_(value_of(pocket.tool_radius)),
        half_length_(value_of(pocket.length) / 2 - tool_),
        half_width_(value_of(pocket.width) / 2 - tool_),
        corner_(std::max(value_of(pocket.corner_radius) - tool_, 0.0)),
        infeed_(value_of(pocket.infeed)) {}

  std::string broken_by(std::span<const Stroke> strokes, const Margin& margin) const override {
    // Too shallow to be told from what is there already.
    if (top_ - floor_ <= 16 * margin.arc) return "";
    double lowest = top_;
    std::map<std::size_t, std::vector<FlatMotion>> levels;  // cuts by infeed
    std::size_t level = 0;
    bool is_new = false;  // a traverse has led down, and it mills no level
    double inner = 0;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
      const Stroke& motion = strokes[i];
      if (motion.is_nil(margin.nil)) continue;
      std::string broken = anywhere(motion, margin);
      if (!broken.empty()) return broken;
      const double to = motion.to[d_];
      if (traverses_to_floor(motion, lowest, margin)) {
        return "a traverse onto the floor (SIE-LC75-11)";
      }
      if (i + 1 < strokes.size() && dips(motion, strokes[i + 1], margin)) continue;
      if (to < lowest - margin.place) {
        broken = down(motion, lowest, margin);
        if (!broken.empty()) return broken;
        lowest = to;
        is_new = true;
        if (cuts(motion.kind()) && std::exchange(is_new, false)) levels[++level];
      } else if (cuts(motion.kind()) && std::abs(to - lowest) <= margin.place &&
                 std::abs(motion.from[d_] - to) <= margin.place && (level > 0 || is_new)) {
        if (std::exchange(is_new, false)) levels[++level];
        const FlatMotion cut = flat(motion);
        if (!has_named_feed(*motion.record) && !pocket_.finishing &&
            engages(cut, levels[level], margin)) {
          return "another feed (SIE-LC75-01)";
        }
        if (runs_against(cut, margin)) return "along the border the other way (SIE-LC75-12)";
        levels[level].push_back(cut);
        inner += inner_length(cut, margin);
      }
    }
    if (lowest > floor_ + margin.place) return "the floor is not reached";
    if (pocket_.contour_only && inner > 3 * (half_length_ + half_width_) + 4 * tool_ &&
        clears_rest(levels[level])) {
      return "the floor is cleared where only the contour is due (SIE-LC75-07)";
    }
    for (const auto& [number, motions] : levels) {
      if (turns_over_and_over(motions, margin.place)) return "turns over and over (J-CYC-02)";
      const bool whole = !pocket_.finishing || (number == level && !pocket_.contour_only);
      const bool strip = pocket_.finishing && pocket_.allowance.sign() != 0;
      if (!whole && !strip) continue;
      if (leaves_material(motions, whole, margin)) return "material is left (SIE-LC75-10)";
    }
    return end(strokes, margin);
  }

 private:
  Point in_frame(const Place& place) const {
    const double p = place[index(axes_.p)] - centre_[0];
    const double q = place[index(axes_.q)] - centre_[1];
    return {p * direction_[0] + q * direction_[1], q * direction_[0] - p * direction_[1]};
  }

  FlatMotion flat(const Stroke& motion) const {
    FlatMotion flat{in_frame(motion.from), in_frame(motion.to), motion.is_round};
    if (!motion.is_round) return flat;
    Place centre{};
    for (std::size_t i = 0; i < 3; ++i) centre[i] = motion.centre[i];
    flat.centre = in_frame(centre);
    flat.radius = motion.from_radius;
    flat.end_radius = motion.to_radius;
    flat.start = std::atan2(flat.from[1] - flat.centre[1], flat.from[0] - flat.centre[0]);
    flat.sweep = motion.sweep;
    return flat;
  }

  // How far outside the border of what the tool's centre may reach, below zero inside.
  double outside(const Point& at) const {
    const double u = std::abs(at[0]) - (half_length_ - corner_);
    const double v = std::abs(at[1]) - (half_width_ - corner_);
    const double beyond = std::hypot(std::max(u, 0.0), std::max(v, 0.0));
    return beyond + std::min(std::max(u, v), 0.0) - corner_;
  }

  bool at_centre(const Place& place, const Margin& margin) const {
    return distance(in_frame(place), {0, 0}) <= 2 * margin.arc;
  }

  std::string anywhere(const Stroke& motion, const Margin& margin) const {
    if (motion.is_dwell()) return "a dwell";
    const Record& record = *motion.record;
    if (motion.kind() == RecordKind::thread) return "a thread";
    for (const std::size_t rotary : {std::size_t{3}, std::size_t{4}}) {
      if (std::abs(motion.to[rotary] - motion.from[rotary]) > margin.place) return "a rotary axis";
    }
    constexpr int kPlaces = 8;
    for (int i = 0; i <= kPlaces; ++i) {
      const Place place = motion.at(static_cast<double>(i) / kPlaces);
      if (outside(in_frame(place)) > 2 * margin.arc) return "beyond the border (SIE-LC75-08)";
      if (place[d_] > retract_ + margin.place) return "above R101 (SIE-LC75-04)";
      if (place[d_] < floor_ - margin.place) return "below the floor (SIE-LC75-05)";
    }
    if (!cuts(motion.kind())) return "";
    if (motion.kind() == RecordKind::arc && record.plane != pocket_.plane) return "another plane";
    return "";
  }

  bool has_named_feed(const Record& record) const {
    const bool named = record.feed == pocket_.depth_feed || record.feed == pocket_.plane_feed;
    return named && record.feed_mode == pocket_.feed_mode;
  }

  // Whether the tool cuts what none of these has cut: else it travels (SIE-LC75-13).
  bool engages(const FlatMotion& cut, const std::vector<FlatMotion>& before,
               const Margin& margin) const {
    constexpr int kPlaces = 8;
    constexpr int kAngles = 12;
    for (int i = 1; i <= kPlaces; ++i) {
      const Point at = cut.at(static_cast<double>(i) / kPlaces);
      for (int k = 0; k < kAngles; ++k) {
        const double angle = 2 * std::numbers::pi * k / kAngles;
        const Point edge = {at[0] + tool_ * std::cos(angle), at[1] + tool_ * std::sin(angle)};
        if (nearest(edge, before) > tool_ + 4 * margin.arc) return true;
      }
    }
    return false;
  }

  // In finishing: down to what roughing left or to the lowest level so far.
  bool traverses_to_floor(const Stroke& motion, double lowest, const Margin& margin) const {
    const double floor = std::min(value_of(pocket_.rough_floor), lowest);
    return pocket_.finishing && motion.kind() == RecordKind::rapid &&
           motion.from[d_] > motion.to[d_] + margin.place && motion.to[d_] <= floor &&
           floor < top_ - 16 * margin.place;
  }

  // Whether most of the floor that neither the contour nor the infeed reaches lies under the tool.
  bool clears_rest(const std::vector<FlatMotion>& cuts) const {
    constexpr int kPlaces = 12;
    constexpr double kMost = 0.7;
    constexpr int kFewest = 20;  // fewer are on the edge of what the contour mills
    int all = 0;
    int cleared = 0;
    for (int i = -kPlaces; i <= kPlaces; ++i) {
      for (int j = -kPlaces; j <= kPlaces; ++j) {
        const Point at = {half_length_ * i / kPlaces, half_width_ * j / kPlaces};
        if (outside(at) > -tool_ || distance(at, {0, 0}) < tool_) continue;
        ++all;
        if (nearest(at, cuts) <= tool_) ++cleared;
      }
    }
    return all >= kFewest && cleared > kMost * all;
  }

  // Down and up again where roughing has left nothing: the tool travels there (J-PKT-09).
  bool dips(const Stroke& down, const Stroke& up, const Margin& margin) const {
    const double strip = value_of(pocket_.allowance) + 2 * margin.arc;
    return pocket_.finishing && down.to[d_] < down.from[d_] && up.to[d_] > up.from[d_] &&
           down.to[d_] > value_of(pocket_.rough_floor) + margin.place &&
           outside(in_frame(down.from)) < -strip && outside(in_frame(down.to)) < -strip;
  }

  // To a new depth.
  std::string down(const Stroke& motion, double lowest, const Margin& margin) const {
    const double to = motion.to[d_];
    if (pocket_.finishing) {
      const double roughed = value_of(pocket_.rough_floor);
      const bool traverse = motion.kind() == RecordKind::rapid;
      if (traverse && to < std::min(roughed, lowest) - margin.place) {
        return "a traverse into the floor (SIE-LC75-11)";
      }
      return "";
    }
    if (motion.kind() == RecordKind::rapid) return "a traverse into solid (SIE-LC75-04)";
    if (!at_centre(motion.from, margin) || !at_centre(motion.to, margin) || motion.is_round) {
      return "a plunge beside the centre (SIE-LC75-04)";
    }
    if (motion.record->feed != pocket_.depth_feed) return "another feed in depth";
    // Nothing shows that a level was cleared that is the centre alone.
    if (std::max(half_length_, half_width_) <= 16 * margin.arc) return "";
    return lowest - to > infeed_ + margin.place ? "an infeed above R121 (SIE-LC75-05)" : "";
  }

  // A motion that lies on the border, seen from the middle the wrong way round, for more than a
  // quarter of the tool's radius or of half the width. On a border that is a line or a point no
  // motion has a direction.
  bool runs_against(const FlatMotion& cut, const Margin& margin) const {
    const double width = 64 * margin.arc;
    if (std::min(half_length_, half_width_) <= width) return false;
    const double length =
        cut.is_round ? std::abs(cut.sweep) * cut.radius : distance(cut.from, cut.to);
    const double quarter = std::min({tool_, half_length_, half_width_}) / 4;
    if (length <= quarter + width) return false;
    // At places that no number of turns makes one.
    for (const double part : {0.0, 0.137, 0.311, 0.5, 0.733, 0.917, 1.0}) {
      if (std::abs(outside(cut.at(part))) > margin.arc) return false;
    }
    const Point middle = cut.at(0.5);
    const Point ahead = cut.at(0.5 + 1.0 / 64);
    const double turn = middle[0] * ahead[1] - middle[1] * ahead[0];
    return turn * pocket_.sense < 0;
  }

  // How much of a cut lies where only the floor is: farther from the border than the strip that
  // roughing left, and than the tool.
  double inner_length(const FlatMotion& cut, const Margin& margin) const {
    const double strip = value_of(pocket_.allowance) + 2 * margin.arc;
    constexpr int kPieces = 16;
    double length = 0;
    for (int i = 0; i < kPieces; ++i) {
      const Point from = cut.at(static_cast<double>(i) / kPieces);
      const Point to = cut.at(static_cast<double>(i + 1) / kPieces);
      if (outside(from) < -strip && outside(to) < -strip) length += distance(from, to);
    }
    return length;
  }

  static double nearest(const Point& at, const std::vector<FlatMotion>& cuts) {
    double least = distance(at, {0, 0});  // the plunge
    for (const FlatMotion& cut : cuts) least = std::min(least, distance_to(at, cut));
    return least;
  }

  // Along the border the tool has to touch the wall; inside, each place has to lie under the tool.
  bool leaves_material(const std::vector<FlatMotion>& cuts, bool whole,
                       const Margin& margin) const {
    constexpr int kPlaces = 12;
    const double reach = tool_ + 2 * margin.arc;
    const double straight_u = half_length_ - corner_;
    const double straight_v = half_width_ - corner_;
    for (int i = -kPlaces; i <= kPlaces; ++i) {
      const double part = static_cast<double>(i) / kPlaces;
      for (const double side : {-1.0, 1.0}) {
        const Point lengthwise = {straight_u * part, side * (half_width_ + tool_)};
        const Point across = {side * (half_length_ + tool_), straight_v * part};
        if (nearest(lengthwise, cuts) > reach || nearest(across, cuts) > reach) return true;
      }
      if (!whole) continue;
      for (int j = -kPlaces; j <= kPlaces; ++j) {
        const Point at = {half_length_ * part, half_width_ * j / kPlaces};
        if (outside(at) < 0 && nearest(at, cuts) > reach) return true;
      }
    }
    return false;
  }

  std::string end(std::span<const Stroke> strokes, const Margin& margin) const {
    if (strokes.empty()) return "nothing is milled";
    const Place& last = strokes.back().to;
    if (std::abs(last[d_] - retract_) > margin.place || !at_centre(last, margin)) {
      return "the cycle does not end at R101 above the centre (SIE-LC75-13)";
    }
    return "";
  }

  const PocketMilling pocket_;
  reference::PlaneAxes axes_;
  std::size_t d_;
  Point centre_;
  Point direction_;
  double top_;
  double retract_;
  double floor_;
  double tool_;
  double half_length_;
  double half_width_;
  double corner_;
  double infeed_;
};

}  // namespace

std::shared_ptr<const OpenPart> open_pocket_milling(const PocketMilling& pocket) {
  return std::make_shared<OpenPocketMilling>(pocket);
}

}  // namespace gonogo::mutations
