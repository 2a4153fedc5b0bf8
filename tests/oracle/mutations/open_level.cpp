// SPDX-License-Identifier: GPL-3.0-or-later
//
// A level of a circular pocket, cleared from the centre with the step L (GSK-G110-09, GSK-CYC-02).
// Places are tried on rings about the centre: one that is not clean, or not within the step, proves
// that the level is wrong; that all are is no proof that it is right.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "flat_path.hpp"
#include "open_parts.hpp"

namespace gonogo::mutations {
namespace {

using reference::PocketLevel;
using std::numbers::pi;

class OpenLevel : public OpenPart {
 public:
  explicit OpenLevel(const PocketLevel& level)
      : level_(level),
        axes_(axes_of(level.plane)),
        d_(index(axes_.d)),
        centre_{value_of(level.centre[0]), value_of(level.centre[1])},
        depth_(value_of(level.depth)),
        pocket_(value_of(level.pocket_radius)),
        tool_(value_of(level.tool_radius)),
        step_(value_of(level.step)) {}

  std::string broken_by(std::span<const Stroke> strokes, const Margin& margin) const override {
    const double reach = pocket_ - tool_;
    std::vector<FlatMotion> all;
    for (const Stroke& motion : strokes) {
      if (motion.is_nil(margin.nil)) continue;
      std::string broken = words(motion, margin);
      if (!broken.empty()) return broken;
      if (goes_beyond(motion, reach + 2 * margin.arc)) return "beyond the wall (GSK-G110-09)";
      all.push_back(flat(motion));
    }
    if (reach <= 16 * margin.arc) return "";
    if (turns_over_and_over(all, margin.place)) return "turns over and over (J-CYC-02)";
    if (goes_back(all, margin)) return "a ring the other way round (J-PKT-06)";
    std::string broken = order(all, margin);
    if (!broken.empty()) return broken;
    return coverage(all, reach, margin);
  }

 private:
  Point in_plane(const Place& place) const {
    return {place[index(axes_.p)] - centre_[0], place[index(axes_.q)] - centre_[1]};
  }

  FlatMotion flat(const Stroke& motion) const {
    FlatMotion flat{in_plane(motion.from), in_plane(motion.to), motion.is_round};
    if (!motion.is_round) return flat;
    flat.centre = {motion.centre[index(axes_.p)] - centre_[0],
                   motion.centre[index(axes_.q)] - centre_[1]};
    flat.radius = motion.from_radius;
    flat.end_radius = motion.to_radius;
    flat.start = motion.start_angle;
    flat.sweep = motion.sweep;
    return flat;
  }

  std::string words(const Stroke& motion, const Margin& margin) const {
    const Record& record = *motion.record;
    if (motion.is_dwell()) return "a dwell";
    if (record.kind == RecordKind::rapid) return "a traverse in the depth (GSK-CYC-01)";
    if (record.kind == RecordKind::thread) return "a thread";
    if (record.feed != level_.feed || record.feed_mode != level_.feed_mode) return "another feed";
    for (const Place& place : {motion.from, motion.to, motion.at(0.5)}) {
      if (std::abs(place[d_] - depth_) > margin.place) return "a motion out of the level";
    }
    if (record.kind != RecordKind::arc) return "";
    if (record.plane != level_.plane) return "another plane";
    return (record.rot < 0) == (level_.sense < 0) ? "" : "the other sense (GSK-G110-09)";
  }

  bool goes_beyond(const Stroke& motion, double radius) const {
    constexpr int kPlaces = 16;
    for (int i = 0; i <= kPlaces; ++i) {
      const Point at = in_plane(motion.at(static_cast<double>(i) / kPlaces));
      if (std::hypot(at[0], at[1]) > radius) return true;
    }
    return false;
  }

  // Whether the path has gone back round the middle by four fifths of a turn, seen from place to
  // place. A link counts where it leads on.
  bool goes_back(const std::vector<FlatMotion>& all, const Margin& margin) const {
    constexpr int kPlaces = 64;
    constexpr double kMostBack = 1.6 * pi;
    double back = 0;
    for (const FlatMotion& motion : all) {
      double on = 0;
      bool meets_middle = std::abs(motion.sweep) > 2 * pi + 1;
      for (int i = 0; i < kPlaces; ++i) {
        const Point a = motion.at(static_cast<double>(i) / kPlaces);
        const Point b = motion.at(static_cast<double>(i + 1) / kPlaces);
        meets_middle = meets_middle || std::hypot(a[0], a[1]) < 16 * margin.arc;
        on += level_.sense * std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
      }
      if (meets_middle) continue;
      const bool travels = !motion.is_round &&
                           (std::abs(on) > 0.7 || distance(motion.from, motion.to) > 0.9 * step_);
      back = std::max(0.0, back - (travels ? std::max(on, 0.0) : on));
      if (back > kMostBack) return true;
    }
    return false;
  }

  // Each motion within the step of what was cut before it.
  std::string order(const std::vector<FlatMotion>& all, const Margin& margin) const {
    std::vector<FlatMotion> before = {FlatMotion{}};  // the plunge
    if (!all.empty() && distance(all.front().from, {0, 0}) > 2 * margin.arc) {
      return "the level does not begin at the centre (GSK-CYC-02)";
    }
    for (const FlatMotion& motion : all) {
      constexpr int kPlaces = 12;
      for (int i = 1; i <= kPlaces; ++i) {
        const Point at = motion.at(static_cast<double>(i) / kPlaces);
        const bool near = std::ranges::any_of(before, [&](const FlatMotion& cut) {
          return distance_to(at, cut) <= step_ * kMoreThanStep + 2 * margin.arc;
        });
        if (!near) return "through solid for more than the step (GSK-CYC-02)";
      }
      before.push_back(motion);
    }
    return "";
  }

  std::string coverage(const std::vector<FlatMotion>& all, double reach,
                       const Margin& margin) const {
    constexpr int kRings = 24;
    constexpr int kAngles = 24;
    for (int ring = 0; ring <= kRings; ++ring) {
      const double part = static_cast<double>(ring) / kRings;
      for (int i = 0; i < kAngles; ++i) {
        const double angle = 2 * pi * (i + 0.37) / kAngles;
        const Point unit = {std::cos(angle), std::sin(angle)};
        const Point wall = {unit[0] * pocket_ * part, unit[1] * pocket_ * part};
        const Point middle = {unit[0] * reach * part, unit[1] * reach * part};
        double from_wall = std::hypot(wall[0], wall[1]);  // the plunge
        double from_middle = std::hypot(middle[0], middle[1]);
        for (const FlatMotion& motion : all) {
          if (!motion.is_round) continue;  // links
          from_wall = std::min(from_wall, distance_to(wall, motion));
          from_middle = std::min(from_middle, distance_to(middle, motion));
        }
        if (from_wall > tool_ + 2 * margin.arc) return "material is left (GSK-G110-09)";
        if (from_middle > step_ / 2 + 2 * margin.arc) return "a step above L (GSK-G110-09)";
      }
    }
    return "";
  }

  static constexpr double kMoreThanStep = 1.05;
  const PocketLevel level_;
  reference::PlaneAxes axes_;
  std::size_t d_;
  Point centre_;
  double depth_;
  double pocket_;
  double tool_;
  double step_;
};

}  // namespace

std::shared_ptr<const OpenPart> open_level(const PocketLevel& level) {
  return std::make_shared<OpenLevel>(level);
}

}  // namespace gonogo::mutations
