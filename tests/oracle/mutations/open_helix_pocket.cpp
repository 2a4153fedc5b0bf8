// SPDX-License-Identifier: GPL-3.0-or-later
//
// A helical pocket: semicircle out, the helix of L turns, perhaps a flat turn, semicircle back; the
// side on which the helix begins is open (GSK-G112-04 to -06).
#include <algorithm>
#include <cmath>
#include <numbers>

#include "open_parts.hpp"

namespace gonogo::mutations {
namespace {

using reference::HelixPocket;
using std::numbers::pi;

class OpenHelixPocket : public OpenPart {
 public:
  explicit OpenHelixPocket(const HelixPocket& pocket)
      : pocket_(pocket),
        axes_(axes_of(pocket.plane)),
        d_(index(axes_.d)),
        centre_{value_of(pocket.centre[0]), value_of(pocket.centre[1])},
        top_(value_of(pocket.r_plane)),
        bottom_(value_of(pocket.bottom)),
        radius_(value_of(pocket.radius)) {}

  std::string broken_by(std::span<const Stroke> strokes, const Margin& margin) const override {
    const bool small = radius_ <= 16 * margin.arc || std::abs(top_ - bottom_) <= 16 * margin.arc;
    double turned = 0;
    for (const Stroke& motion : strokes) {
      if (motion.is_nil(margin.nil)) continue;
      if (motion.kind() != RecordKind::arc) return "a motion that is no arc (GSK-CYC-01)";
      const Record& record = *motion.record;
      if (record.feed != pocket_.feed || record.feed_mode != pocket_.feed_mode) {
        return "another feed";
      }
      if (record.plane != pocket_.plane) return "another plane";
      if ((record.rot < 0) != (pocket_.sense < 0)) return "the other sense (GSK-G112-09)";
      turned += sweep_of(motion, margin);
      if (small) continue;
      std::string broken = shape(motion, margin);
      if (!broken.empty()) return broken;
    }
    if (small) return "";
    const double due = 2 * pi * (pocket_.turns + (pocket_.flat ? 1 : 0) + 1);
    const double slack = 0.3 + 16 * margin.arc / radius_;
    if (std::abs(turned - due) >
        slack * (1 + std::floor(static_cast<double>(strokes.size()) / 8))) {
      return "more turns, or fewer, than L and the two semicircles (GSK-G112-05)";
    }
    return "";
  }

 private:
  double along_p(const Place& place) const { return place[index(axes_.p)] - centre_[0]; }
  double along_q(const Place& place) const { return place[index(axes_.q)] - centre_[1]; }

  std::string shape(const Stroke& motion, const Margin& margin) const {
    const double p = value_of(motion.record->centre[0]) - centre_[0];
    const double q = value_of(motion.record->centre[1]) - centre_[1];
    const double off = std::hypot(p, q);
    const double wide = 3 * margin.arc;
    const bool level_motion = std::abs(motion.from[d_] - motion.to[d_]) <= margin.place;
    if (off <= wide) {
      // The helix, or the flat turn.
      for (const double radius : {motion.from_radius, motion.to_radius}) {
        if (std::abs(radius - radius_) > wide) return "a turn of another radius than I - D";
      }
      if (level_motion) {
        return pocket_.flat && std::abs(motion.to[d_] - bottom_) <= margin.place
                   ? ""
                   : "a level turn (GSK-G112-05)";
      }
      const double lead = (bottom_ - top_) / pocket_.turns;
      const double fall = sweep_of(motion, margin) / (2 * pi) * lead;
      if (std::abs(motion.to[d_] - motion.from[d_] - fall) >
          wide + std::abs(lead) * wide / radius_) {
        return "another lead (GSK-G112-05)";
      }
      return "";
    }
    if (std::abs(off - radius_ / 2) > wide) return "a semicircle about another centre";
    if (!level_motion) return "a semicircle that is not level (GSK-G112-04)";
    for (const double radius : {motion.from_radius, motion.to_radius}) {
      if (std::abs(radius - radius_ / 2) > wide) return "a semicircle of another radius";
    }
    const double depth = motion.to[d_];
    if (std::abs(depth - top_) > margin.place && std::abs(depth - bottom_) > margin.place) {
      return "a semicircle at another height";
    }
    return "";
  }

  // Where both ends of a turn agree with one place, either of them off by the tolerance (R2),
  // the last turn may be nil or a full one, and the one that fits is meant: of the helix that of
  // its height. A full one after other turns is what its record says (J-PATH-06).
  double sweep_of(const Stroke& motion, const Margin& margin) const {
    const double sweep = std::abs(motion.sweep);
    if (motion.meets_itself || !ends_agree(motion, margin)) return sweep;
    const bool nil = std::remainder(sweep, 2 * pi) >= 0;
    if (!nil && sweep > 2 * pi) return sweep;
    const double other = nil ? sweep + 2 * pi : sweep - 2 * pi;
    const double height = std::abs(motion.to[d_] - motion.from[d_]);
    const double due = height <= margin.place
                           ? 2 * pi
                           : 2 * pi * pocket_.turns * height / std::abs(bottom_ - top_);
    return std::abs(other - due) < std::abs(sweep - due) ? other : sweep;
  }

  bool ends_agree(const Stroke& motion, const Margin& margin) const {
    return std::abs(along_p(motion.from) - along_p(motion.to)) <= 2 * margin.place &&
           std::abs(along_q(motion.from) - along_q(motion.to)) <= 2 * margin.place;
  }

  const HelixPocket pocket_;
  reference::PlaneAxes axes_;
  std::size_t d_;
  std::array<double, 2> centre_;
  double top_;
  double bottom_;
  double radius_;
};

}  // namespace

std::shared_ptr<const OpenPart> open_helix_pocket(const HelixPocket& pocket) {
  return std::make_shared<OpenHelixPocket>(pocket);
}

}  // namespace gonogo::mutations
