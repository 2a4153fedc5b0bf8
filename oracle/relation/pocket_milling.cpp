// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdlib>

#include "oracle/relation/free_step.hpp"
#include "oracle/relation/near.hpp"

namespace gonogo::relation {

using reference::Levels;
using reference::PocketMilling;
using reference::RecordKind;

namespace {

// SIE-LC75: at every height within what the tool's centre may reach, between the floor and R101;
// level by level; traverses only in what is cleared; along the border as R126 says.
class MillingConditions {
 public:
  MillingConditions(const PocketMilling& pocket, const Followed& way)
      : pocket_(pocket),
        tolerances_(way.tolerances),
        slack_(way.slack),
        axes_(reference::axes_of(pocket.plane)),
        tool_(rational_near(pocket.tool_radius)),
        half_length_(rational_near(pocket.length) / 2),
        half_width_(rational_near(pocket.width) / 2),
        corner_(rational_near(pocket.corner_radius)),
        allowance_(rational_near(pocket.allowance)),
        limit_(tolerances_.tolerance * 17 / 8),
        start_(way.subject.at(way.begin).from),
        raster_((half_length_ + half_width_) * 4 + Number(1)),
        rings_(tool_ / 100 + tolerances_.tolerance, tolerances_.tolerance * 4),
        above_(rational_near(pocket.clearance)),
        deepest_(above_) {
    constexpr int kAsMuch = 10;
    const Number sides = half_length_ + half_width_ - tool_ * 2;
    const Number lines = ((max(half_length_, half_width_) - tool_) / tool_).ceil() * 2 + 4;
    most_way_ = lines * (sides + tool_) * 4 * (pocket.level_count() + 2) * kAsMuch;
    // The tool is on a floor as near as tau without an infeed.
    if (above_ - rational_near(pocket.floor) <= tolerances_.tolerance) levels_ = {{above_, {{}}}};
  }

  std::string_view take(const Event& piece) {
    const Number height = piece.to[axes_.d];
    const Number off = slack_.axis(piece.width);
    if (!is_inside(offset_of(piece.to), slack_.round(piece.width) + chord_of(piece))) {
      return "The tool leaves the pocket.";
    }
    if (moves_another_axis(piece, start_, axes_, off)) return "Another axis moves.";
    if (height < rational_near(pocket_.floor) - off) return "The tool goes below the floor.";
    if (height > rational_near(pocket_.retract) + off) return "The tool goes above R101.";
    if (tolerances_.compare_blocks && piece.block != pocket_.block) {
      return "The motion is of another line.";
    }
    way_ += way_of(piece, axes_.p) + way_of(piece, axes_.q);
    if (way_ > most_way_) return "The way is more than ten times as long as the levels need.";
    width_ = max(width_, piece.width);
    if (may_be_none()) return {};
    if (piece.part == Part::traverse) return take_traverse(piece, off);
    const Label& label = *piece.label;
    if (label.kind != RecordKind::feed && label.kind != RecordKind::arc) {
      return "The motion is of another kind.";
    }
    return take_cut(piece, off);
  }

  bool may_be_over(const Position& place) const {
    return abs(place[axes_.d] - rational_near(pocket_.retract)) <= tolerances_.tolerance &&
           is_at_middle(place, 0);
  }
  bool is_deep() const {
    return rational_near(pocket_.reference_plane) - rational_near(pocket_.floor) >
           tolerances_.tolerance;
  }
  // Whether the cycle may end behind the piece: with a traverse, or a cut up or on from there.
  // Where the last lift is too small to be seen, behind any.
  bool may_end_behind(const Event& piece) {
    const bool is_shallow =
        rational_near(pocket_.retract) - rational_near(pocket_.floor) <= tolerances_.tolerance;
    const Number way = piece.to[axes_.d] - piece.from[axes_.d];
    if (abs(way) > tolerances_.tolerance) has_risen_ = way.sign() > 0;
    return is_shallow || piece.part == Part::traverse || has_risen_;
  }

  // What the levels lack, so far; empty: nothing.
  std::string_view lacks() const {
    if (may_be_none()) return {};
    if (levels_.empty() ||
        abs(levels_.back().depth - rational_near(pocket_.floor)) > slack_.axis(0)) {
      return "The floor is not reached.";
    }
    if (!has_its_depths()) return "The levels are not as deep as R121 says.";
    for (const Level& level : levels_) {
      const bool is_last = &level == &levels_.back();
      if (!is_clean(level, is_last)) return "The level is not clean.";
    }
    const bool mills_floor = pocket_.finishing && pocket_.contour_only && clears_floor();
    return mills_floor ? "The floor is milled where the contour alone is due." : "";
  }

 private:
  struct Level {
    Number depth;
    std::vector<Stroke> cuts;
    bool is_over = false;  // the tool has travelled: what is cleared by now is all of it
  };

  // In the pocket's own directions, from its middle.
  Offset offset_of(const Position& place) const {
    const Number p = place[axes_.p] - rational_near(pocket_.centre[0]);
    const Number q = place[axes_.q] - rational_near(pocket_.centre[1]);
    const Number cosine = rational_near(pocket_.direction[0]);
    const Number sine = rational_near(pocket_.direction[1]);
    return {p * cosine + q * sine, q * cosine - p * sine};
  }
  // No deeper than tau below R103, so that all or nothing of it is within the tolerance.
  bool may_be_none() const { return slack_.is_generous() && !is_deep(); }
  // R3: a chord that is granted counts as its arc; where it does not have to, it need not.
  Number chord_of(const Event& piece) const {
    const bool may_be = slack_.is_generous() && piece.label->kind == RecordKind::feed;
    return may_be ? tolerances_.chord : Number(0);
  }
  Stroke stroke_of(const Event& piece) const {
    return {raster_.point(offset_of(piece.from)), raster_.point(offset_of(piece.to))};
  }
  bool is_at_middle(const Position& place, const Number& width) const {
    const Offset offset = offset_of(place);
    const Number off = slack_.round(width);
    return abs(offset.p) <= off && abs(offset.q) <= off;
  }

  // Within what the tool's centre may reach, or as far beside it.
  bool is_inside(const Offset& offset, const Number& slack) const {
    const Number p = abs(offset.p) - (half_length_ - tool_);
    const Number q = abs(offset.q) - (half_width_ - tool_);
    if (p > slack || q > slack) return false;
    const Number beyond_p = p + corner_ - tool_;
    const Number beyond_q = q + corner_ - tool_;
    if (beyond_p.sign() <= 0 || beyond_q.sign() <= 0) return true;
    const Number radius = corner_ - tool_ + slack * 3 / 2;  // of two axes: above sqrt(2)
    return radius.sign() >= 0 && beyond_p * beyond_p + beyond_q * beyond_q <= radius * radius;
  }
  // Where roughing has left nothing but the allowance.
  bool is_roughed(const Offset& offset) const {
    return pocket_.finishing && is_inside(offset, tolerances_.tolerance - allowance_);
  }
  bool has_rough() const {
    return pocket_.finishing && min(half_length_, half_width_) - allowance_ >= tool_;
  }
  bool is_along_border(const Offset& offset) const {
    return !is_inside(offset, -limit_ * 2 - tolerances_.chord);
  }

  // Whether the tool may be at a height in any motion: above what is cut, or in what
  // roughing has cleared.
  bool is_free(const Event& piece, const Number& off) const {
    const Number height = min(piece.from[axes_.d], piece.to[axes_.d]);
    if (height >= rational_near(pocket_.reference_plane) - off) return true;
    const bool is_above = !levels_.empty() && height > levels_.back().depth + off;
    const bool is_roughed_there = height >= rational_near(pocket_.rough_floor) - off &&
                                  is_roughed(offset_of(piece.from)) &&
                                  is_roughed(offset_of(piece.to));
    return is_above || (pocket_.finishing && is_roughed_there);
  }

  // SIE-LC75-13: within what the level has been cleared of, so far, and roughing before it.
  bool is_in_cleared(const Event& piece, const Number& off) const {
    const Number height = min(piece.from[axes_.d], piece.to[axes_.d]);
    const bool is_level = !levels_.empty() && height >= levels_.back().depth - off;
    Cover cover = cover_of(is_level ? std::span<const Stroke>(levels_.back().cuts)
                                    : std::span<const Stroke>());
    if (has_rough() && height >= rational_near(pocket_.rough_floor) - off) {
      const Number beside = slack_.is_generous() ? limit_ + width_ : limit_ - width_;
      const Number corner = max(corner_ - allowance_, tool_);
      cover.cleared = box_within(allowance_ - beside, corner + beside);
    }
    return slack_.allows(cover.of(Stadium{stroke_of(piece), raster_.length(tool_)}));
  }

  // Where an infeed has been.
  bool is_in_its_hole(const Event& piece, const Number& off) const {
    return is_at_middle(piece.from, piece.width) && is_at_middle(piece.to, piece.width) &&
           min(piece.from[axes_.d], piece.to[axes_.d]) >= deepest_ - off;
  }

  // In roughing nothing but the infeed at the centre comes before the first level.
  static constexpr std::string_view kEarly = "The motion comes before the first infeed.";
  bool is_early(const Event& piece) const {
    const bool sinks = piece.to[axes_.d] <= piece.from[axes_.d] + slack_.axis(piece.width);
    const bool stays = sinks && is_at_middle(piece.to, piece.width);
    return !pocket_.finishing && levels_.empty() && !stays;
  }

  std::string_view take_traverse(const Event& piece, const Number& off) {
    // SIE-LC75-04: at R103 + R102 the first infeed begins, and no traverse leads on.
    const bool comes_down = piece.to[axes_.d] < piece.from[axes_.d] - off;
    const bool leads_on = !pocket_.finishing && levels_.empty() && comes_down;
    if (leads_on || is_early(piece)) return kEarly;
    if (!levels_.empty()) levels_.back().is_over = true;
    const bool is_straight_up = piece.to[axes_.d] > piece.from[axes_.d] &&
                                way_of(piece, axes_.p) + way_of(piece, axes_.q) <= off;
    // SIE-LC75-11: in finishing it ends above the floor that roughing left.
    const Number floor = rational_near(pocket_.finishing ? pocket_.rough_floor : pocket_.floor);
    const bool is_in_air = piece.to[axes_.d] >= rational_near(pocket_.reference_plane) - off;
    if ((pocket_.finishing || comes_down) && !is_straight_up && !is_in_air &&
        piece.to[axes_.d] <= floor + off) {
      return "A traverse ends on a floor.";
    }
    if (is_straight_up || is_free(piece, off)) return {};
    return is_in_cleared(piece, off) ? std::string_view() : "A traverse goes into the material.";
  }

  bool has_feed(const Event& piece, const Number& feed) const {
    return piece.label->feed_mode == pocket_.feed_mode &&
           agree(feed, piece.label->feed, tolerances_.feed_resolution, tolerances_);
  }

  std::string_view take_cut(const Event& piece, const Number& off) {
    const bool is_in_material =
        min(piece.from[axes_.d], piece.to[axes_.d]) <= rational_near(pocket_.reference_plane) - off;
    if (turns_again(piece)) return "A ring is cut more than ten times.";
    const bool is_level = abs(piece.to[axes_.d] - piece.from[axes_.d]) <= off;
    const Number& lowest = levels_.empty() ? above_ : levels_.back().depth;
    const bool is_new = piece.to[axes_.d] < lowest - off;
    if (is_new && !is_level) return take_infeed(piece);
    // An infeed, or the last piece of one, that leads no farther than the limit.
    if (is_level && piece.to[axes_.d] <= lowest && is_infeed(piece)) {
      return piece.to[axes_.d] < piece.from[axes_.d] ? take_infeed(piece) : std::string_view();
    }
    if (is_new && pocket_.finishing) begin_level({piece.to[axes_.d], {}});
    const bool is_at_level =
        !levels_.empty() && is_level && abs(piece.to[axes_.d] - levels_.back().depth) <= off;
    if (is_at_level && !levels_.back().is_over && has_feed(piece, pocket_.plane_feed)) {
      if (is_in_material && runs_back(piece)) return "The cut goes round the border the other way.";
      levels_.back().cuts.push_back(stroke_of(piece));
      return {};
    }
    if (is_early(piece)) return kEarly;
    if (!levels_.empty()) levels_.back().is_over = true;
    return is_free(piece, off) || is_in_cleared(piece, off) || is_in_its_hole(piece, off)
               ? ""
               : "The cut has another feed, or is beside its level.";
  }

  void begin_level(Level level) {
    levels_.push_back(std::move(level));
    back_ = 0;
    rings_.clear();
  }

  // SIE-LC75-12: along the border back for more than a quarter of the tool's radius, or of where
  // the tool may go. A line has no way round it.
  bool runs_back(const Event& piece) {
    const Number half = min(half_length_, half_width_) - tool_;
    if (half <= tolerances_.tolerance * 4) return false;
    const Offset from = offset_of(piece.from);
    const Offset to = offset_of(piece.to);
    const Offset middle{(from.p + to.p) / 2, (from.q + to.q) / 2};
    if (!is_along_border(from) || !is_along_border(middle) || !is_along_border(to)) return false;
    const Number way = rational_near(sqrt((to - from).square()));
    const bool is_back = across(from, to).sign() * pocket_.sense < 0;
    back_ = is_back ? back_ + way : max(back_ - way, 0);
    return back_ > min(tool_, half) / 4 + slack_.round(piece.width);
  }

  bool turns_again(const Event& piece) {
    const reference::Record& motion = piece.source();
    if (motion.kind != RecordKind::arc) return false;
    Position centre = piece.from;
    centre[axes_.p] = rational_near(motion.centre[0]);
    centre[axes_.q] = rational_near(motion.centre[1]);
    const Offset middle = offset_of(centre);
    return rings_.turns_again(middle, offset_of(piece.from) - middle, offset_of(piece.to) - middle,
                              motion.rot);
  }

  bool is_infeed(const Event& piece) const {
    return is_at_middle(piece.from, piece.width) && is_at_middle(piece.to, piece.width) &&
           has_feed(piece, pocket_.depth_feed);
  }

  // SIE-LC75-04, SIE-LC75-11: at the centre with R122; in finishing the last alone.
  std::string_view take_infeed(const Event& piece) {
    const Number height = piece.to[axes_.d];
    if (!is_infeed(piece)) {
      const bool is_early = pocket_.finishing && is_free(piece, slack_.axis(piece.width)) &&
                            height > rational_near(pocket_.rough_floor) + slack_.axis(0);
      return is_early ? std::string_view()
                      : "The infeed is beside the centre, or has another feed.";
    }
    deepest_ = min(deepest_, height);
    if (pocket_.finishing && height > rational_near(pocket_.rough_floor) + slack_.axis(0))
      return {};
    const bool goes_on =
        !levels_.empty() && levels_.back().cuts.size() == 1 && !levels_.back().is_over;
    if (goes_on) {
      levels_.back().depth = height;
    } else {
      begin_level({height, {{}}});
    }
    return {};
  }

  // SIE-LC75-05, SIE-LC75-06.
  bool has_its_depths() const {
    const Number off = slack_.axis(0);
    // Where the tool's centre has nowhere to go, nothing shows where a level is.
    const bool is_point = max(half_length_, half_width_) - tool_ <= tolerances_.tolerance;
    if (is_point) return true;
    // SIE-LC75-10: nor where roughing left no strip, which each level but the last would clear.
    if (pocket_.finishing && allowance_.sign() == 0) return true;
    if (pocket_.finishing && pocket_.one_level && levels_.size() == 1) return true;
    if (pocket_.levels == Levels::open || pocket_.finishing) {
      Number above = rational_near(pocket_.reference_plane);
      for (const Level& level : levels_) {
        if (above - level.depth > rational_near(pocket_.infeed) + off) return false;
        above = level.depth;
      }
      return true;
    }
    // A level no farther down than the limit leaves no trace of its own.
    auto level = levels_.begin();
    Number above = rational_near(pocket_.reference_plane);
    for (Number number = 1; number <= pocket_.level_count(); number += 1) {
      const Number depth = rational_near(pocket_.depth_of_level(number));
      if (level != levels_.end() && abs(level->depth - depth) <= off) {
        ++level;
      } else if (above - depth > off) {
        return false;
      }
      above = depth;
    }
    return level == levels_.end();
  }

  Cover cover_of(std::span<const Stroke> cuts) const {
    Cover cover;
    cover.path = cuts;
    cover.reach = raster_.length(tool_ + limit_ + tolerances_.chord);
    cover.slack = raster_.length(width_) + 3;
    cover.raster = raster_.length(tolerances_.tolerance / 8) + 1;
    return cover;
  }
  Box box_within(const Number& inset, const Number& corner) const {
    return {raster_.length(half_length_ - inset), raster_.length(half_width_ - inset),
            raster_.length(corner)};
  }

  // SIE-LC75-10: the whole; in finishing the strip that roughing left, on the floor all.
  bool is_clean(const Level& level, bool is_last) const {
    Region region{box_within(0, corner_), {}};
    if (pocket_.finishing && (!is_last || pocket_.contour_only)) {
      if (allowance_.sign() == 0) return true;
      region.inner = box_within(allowance_, max(corner_ - allowance_, tool_));
    }
    return slack_.allows(cover_of(level.cuts).of(region));
  }

  // SIE-LC75-07: inside of the strip the cuts are longer than a way out and back, and mill more
  // than half of a raster of 40 by 40 places.
  bool clears_floor() const {
    constexpr int kPlaces = 20;
    const std::vector<Stroke>& cuts = levels_.back().cuts;
    const Box inner = box_within(tool_ + allowance_, max(corner_ - tool_ - allowance_, 0));
    const Box rest = box_within(tool_ * 2, max(corner_ - tool_ * 2, 0));
    std::int64_t way = 0;
    for (const Stroke& cut : cuts) {
      if (!inner.has(cut.from, 0) || !inner.has(cut.to, 0)) continue;
      way += std::max(std::abs(cut.to.p - cut.from.p), std::abs(cut.to.q - cut.from.q));
    }
    if (way <= 2 * raster_.length(half_length_ + half_width_ - tool_ * 2)) return false;
    const std::int64_t reach = raster_.length(tool_);
    int all = 0;
    int milled = 0;
    for (int i = -kPlaces; i <= kPlaces; ++i) {
      for (int j = -kPlaces; j <= kPlaces; ++j) {
        const Point at{rest.half_p * i / kPlaces, rest.half_q * j / kPlaces};
        if (!rest.has(at, 0) || is_within({}, {at, at}, reach)) continue;
        ++all;
        milled +=
            std::ranges::any_of(cuts, [&](const Stroke& cut) { return is_within(at, cut, reach); });
      }
    }
    return 2 * milled > all;
  }

  const PocketMilling& pocket_;
  const Tolerances& tolerances_;
  Slack slack_;
  reference::PlaneAxes axes_;
  Number tool_;
  Number half_length_;  // of what the tool may touch
  Number half_width_;
  Number corner_;
  Number allowance_;
  Number limit_;
  Position start_;
  Raster raster_;
  Rings rings_;     // of the level
  Number back_;     // how far the last cuts have run back along the border
  Number above_;    // where it begins
  Number deepest_;  // of the infeeds
  std::vector<Level> levels_;
  bool has_risen_ = false;  // the last motion along the depth axis led up
  Number width_;
  Number way_;
  Number most_way_;
};

// R4: behind a traverse that stays near a place, also where another one follows.
std::optional<std::size_t> end_of_small_traverse(SubjectSide& side, std::size_t begin,
                                                 const Position& place, const Number& tau) {
  const Event& first = side.at(begin);
  if (first.part != Part::traverse || !first.begins) return std::nullopt;
  std::size_t end = begin + 1;
  while (!side.at(end).begins) ++end;
  return is_near(side.at(end - 1).to, place, tau) ? std::optional(end) : std::nullopt;
}

}  // namespace

StepAnswer follow(const PocketMilling& pocket, const Followed& way) {
  MillingConditions conditions(pocket, way);
  StepAnswer answer;
  bool may_end = true;
  Position place = way.subject.at(way.begin).from;
  for (std::size_t i = way.begin;; ++i) {
    const Event& piece = way.subject.at(i);
    if (piece.begins && may_end && conditions.may_be_over(piece.from)) {
      const std::string_view lacks = conditions.lacks();
      if (lacks.empty()) answer.ends.push_back(i);
      // SIE-LC75-13: the way to R101 is the last motion.
      if (lacks.empty() && conditions.is_deep()) return answer;
      answer.broken_by = i;
      answer.broken = lacks;
    }
    if (!piece.is_motion()) return answer;
    const Number& tau = way.tolerances.tolerance;
    auto end = end_of_small_stretch(way.subject, i, place, tau);
    if (!end) end = end_of_small_traverse(way.subject, i, place, tau);
    if (end) {
      i = *end - 1;
      continue;
    }
    may_end = conditions.may_end_behind(piece);
    const std::string_view broken = conditions.take(piece);
    place = piece.to;
    if (broken.empty()) continue;
    answer.broken_by = i;
    answer.broken = broken;
    return answer;
  }
}

}  // namespace gonogo::relation
