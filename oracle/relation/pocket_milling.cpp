// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/relation/free_step.hpp"

namespace gonogo::relation {

using reference::PocketMilling;
using reference::RecordKind;

namespace {

// SIE-LC75, as far as stated here: at every height within what the tool's centre may reach,
// between the floor and R101; traverses only in what has been fed to or is cleared; along the
// border as R126 says; no farther than ten times the way of lines that lie a tool's radius apart.
class MillingConditions {
 public:
  MillingConditions(const PocketMilling& pocket, const Terms& terms)
      : pocket_(pocket),
        terms_(terms),
        axes_(reference::axes_of(pocket.plane)),
        radius_(rational_near(pocket.tool_radius)),
        half_length_(rational_near(pocket.length) / 2 - radius_),
        half_width_(rational_near(pocket.width) / 2 - radius_),
        corner_(rational_near(pocket.corner_radius) - radius_),
        limit_(terms.tolerance * 17 / 8),
        winding_(pocket.sense, terms.tolerance * 4) {
    constexpr int kAsMuch = 10;
    const Number lines = (max(half_length_, half_width_) / radius_).ceil() * 2 + 4;
    const Number level = lines * (half_length_ + half_width_ + radius_) * 4;
    most_way_ = level * (pocket.level_count() + 2) * kAsMuch;
    deepest_ = rational_near(pocket.clearance);
  }

  std::string_view take(const Event& piece) {
    const Number depth = piece.to[axes_.d];
    const Number slack = terms_.tolerance + piece.width;
    if (!is_inside(piece.to, limit_ + piece.width)) return "The tool leaves the pocket.";
    if (depth < rational_near(pocket_.floor) - slack) return "The tool goes below the floor.";
    if (depth > rational_near(pocket_.retract) + slack) return "The tool goes above R101.";
    if (terms_.compare_blocks && piece.block != pocket_.block)
      return "The motion is of another line.";
    if (piece.part == Part::traverse) return take_traverse(depth, slack);
    return take_cut(piece, depth, slack);
  }

  bool may_be_over(const Position& place) const {
    const Winding::Offset offset = offset_of(place);
    return abs(place[axes_.d] - rational_near(pocket_.retract)) <= terms_.tolerance &&
           abs(offset.p) <= limit_ && abs(offset.q) <= limit_;
  }

 private:
  // In the pocket's own directions, from its middle; a place of the base beside it is near enough
  // to a millionth.
  Winding::Offset offset_of(const Position& place) const {
    const Number p = place[axes_.p] - rational_near(pocket_.centre[0]);
    const Number q = place[axes_.q] - rational_near(pocket_.centre[1]);
    const Number cosine = rational_near(pocket_.direction[0]);
    const Number sine = rational_near(pocket_.direction[1]);
    return {p * cosine + q * sine, q * cosine - p * sine};
  }

  bool is_inside(const Position& place, const Number& slack) const {
    const Winding::Offset offset = offset_of(place);
    const Number p = abs(offset.p);
    const Number q = abs(offset.q);
    if (p > half_length_ + slack || q > half_width_ + slack) return false;
    const Number beyond_p = p - (half_length_ - corner_);
    const Number beyond_q = q - (half_width_ - corner_);
    if (beyond_p.sign() <= 0 || beyond_q.sign() <= 0) return true;
    const Number radius = corner_ + slack * 3 / 2;  // of two axes: above sqrt(2)
    return beyond_p * beyond_p + beyond_q * beyond_q <= radius * radius;
  }

  bool is_along_border(const Position& place) const { return !is_inside(place, -limit_ * 2); }

  std::string_view take_traverse(const Number& depth, const Number& slack) {
    winding_.leave();
    if (depth >= deepest_ - slack) return {};
    const bool is_cleared = pocket_.finishing && depth > rational_near(pocket_.rough_floor) + slack;
    return is_cleared ? std::string_view() : "A traverse goes into the material.";
  }

  std::string_view take_cut(const Event& piece, const Number& depth, const Number& slack) {
    const Label& label = *piece.label;
    if (label.kind != RecordKind::feed && label.kind != RecordKind::arc) {
      return "The motion is of another kind.";
    }
    const bool has_feed = label.feed_mode == pocket_.feed_mode &&
                          (agree(pocket_.plane_feed, label.feed, terms_.feed_resolution, terms_) ||
                           agree(pocket_.depth_feed, label.feed, terms_.feed_resolution, terms_));
    const bool is_in_material = depth <= rational_near(pocket_.reference_plane) - slack;
    if (is_in_material && !has_feed) return "The cut has another feed.";
    deepest_ = min(deepest_, depth);
    if (is_in_material && is_along_border(piece.from) && is_along_border(piece.to)) {
      winding_.take(offset_of(piece.from));
      winding_.take(offset_of(piece.to));
      if (winding_.goes_back()) return "The cut goes round the border the other way.";
    } else {
      winding_.leave();
    }
    way_ += way_of(piece, axes_.p) + way_of(piece, axes_.q);
    return way_ > most_way_ ? "The cut is more than ten times as long as the levels need."
                            : std::string_view();
  }

  const PocketMilling& pocket_;
  const Terms& terms_;
  reference::PlaneAxes axes_;
  Number radius_;
  Number half_length_;
  Number half_width_;
  Number corner_;
  Number limit_;
  Winding winding_;
  Number deepest_;  // that a cut has come to
  Number way_;
  Number most_way_;
};

}  // namespace

StepAnswer follow(const PocketMilling& pocket, SubjectSide& subject, std::size_t begin,
                  const Terms& terms) {
  MillingConditions conditions(pocket, terms);
  return follow_under(conditions, subject, begin, terms.tolerance);
}

}  // namespace gonogo::relation
