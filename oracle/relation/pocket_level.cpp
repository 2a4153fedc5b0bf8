// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/relation/free_step.hpp"

namespace gonogo::relation {

using reference::PocketLevel;
using reference::RecordKind;

namespace {

// GSK-G110-09, GSK-CYC-02: cuts at the depth of the level and with its feed, within the circle that
// the tool's centre may reach, by arcs that turn as commanded. Measured in multiples of what the
// step needs: rings over and over are no level.
class LevelConditions {
 public:
  LevelConditions(const PocketLevel& level, const Followed& way)
      : level_(level),
        tolerances_(way.tolerances),
        slack_(way.slack),
        axes_(reference::axes_of(level.plane)),
        middle_{rational_near(level.centre[0]), rational_near(level.centre[1])},
        radius_(rational_near(level.pocket_radius)),
        tool_(rational_near(level.tool_radius)),
        step_(rational_near(level.step)),
        reach_(radius_ - tool_),
        raster_(radius_ * 4 + step_ * 4 + Number(1)),
        winding_(level.sense, tolerances_.tolerance * 4) {
    const Number circles = (reach_ / step_).ceil() + 1;
    // Along both axes a circle goes eight times its radius.
    most_way_ = circles * reach_ * 8 * kMostTimes;
  }

  bool leaves_depth(const Event& piece) const {
    const Number off = slack_.axis(piece.width);
    return abs(piece.to[axes_.d] - rational_near(level_.depth)) > off ||
           abs(piece.from[axes_.d] - rational_near(level_.depth)) > off;
  }

  void begin_at(const Position& place) {
    start_ = place;
    last_ = offset_of(place);
    winding_.take(last_);
    plunge_ = raster_.point(last_);
    if (last_.square() > reach_ * reach_) plunge_ = {};
  }

  // What the piece breaks; empty: nothing.
  std::string_view take(const Event& piece) {
    const Offset to = offset_of(piece.to);
    const Number limit = reach_ + slack_.round(piece.width);
    if (to.square() > limit * limit) return "The cut leaves the pocket.";
    if (moves_another_axis(piece, start_, axes_, slack_.axis(piece.width))) {
      return "Another axis moves.";
    }
    if (!has_its_label(*piece.label)) return "The cut has another feed or line.";
    const bool is_arc = piece.source().kind != RecordKind::feed;
    if (sense_of(piece, axes_) * level_.sense < 0) return "The arc turns the other way.";
    const std::int64_t quarters = winding_.quarters();
    if (is_link(piece)) {
      winding_.leave();
    } else {
      winding_.take(to);
    }
    if (winding_.goes_back()) return "The cut goes round the middle the other way.";
    if (winding_.quarters() / 4 != quarters / 4 && turns_on_ring(to)) {
      return "A ring is cut more than ten times.";
    }
    way_ += way_of(piece, axes_.p) + way_of(piece, axes_.q);
    if (way_ > most_way_) return "The cut is more than ten times as long as concentric circles.";
    path_.push_back({{raster_.point(last_), raster_.point(to)}, is_arc});
    width_ = max(width_, piece.width);
    last_ = to;
    return {};
  }

  // Cover, step and order; each with the tolerance of arcs and the chord that is granted.
  std::string_view broken_at_end() const {
    // A granted chord may count as an arc, and need not.
    const bool counts_lines = tolerances_.chord.sign() > 0 && slack_.is_generous();
    const std::vector<Stroke> arcs = arcs_of(counts_lines);
    const Number off = tolerances_.tolerance * 17 / 8 + tolerances_.chord;
    const auto covers = [&](const Number& reach, const Number& of) {
      const std::int64_t radius = raster_.length(of);
      return slack_.allows(Cover{arcs, raster_.length(reach + off), raster_.length(width_) + 2,
                                 raster_.length(tolerances_.tolerance / 8) + 1}
                               .of(Region{{radius, radius, radius}, {}}));
    };
    if (!covers(tool_, radius_)) return "The level is not clean.";
    if (!covers(step_ / 2, reach_)) return "A step is wider than L.";
    return is_in_order(counts_lines) ? std::string_view() : "The cut goes through solid.";
  }

 private:
  static constexpr int kMostTimes = 10;
  struct Part {
    Stroke stroke;
    bool is_arc;
  };

  // Straight and longer than L, or across more than 45 degrees: no text says which way it goes
  // round.
  bool is_link(const Event& piece) const {
    if (piece.source().kind != RecordKind::feed) return false;
    const Offset from = offset_of(rational_near(piece.start));
    const Offset to = offset_of(rational_near(end_of(piece.source(), piece.start)));
    return (to - from).square() > step_ * step_ || abs(across(from, to)) > along(from, to);
  }
  Offset offset_of(const Position& place) const {
    return {place[axes_.p] - middle_.p, place[axes_.q] - middle_.q};
  }
  bool has_its_label(const Label& label) const {
    return (label.kind == RecordKind::feed || label.kind == RecordKind::arc) &&
           (!tolerances_.compare_blocks || label.block == level_.block) &&
           label.feed_mode == level_.feed_mode &&
           agree(level_.feed, label.feed, tolerances_.feed_resolution, tolerances_);
  }

  // A turn is done at a place: whether as many as allowed have been, no farther from the middle
  // by a hundredth of L.
  bool turns_on_ring(const Offset& at) {
    const Number radius = rational_near(sqrt(at.square()));
    turns_.push_back(radius);
    const Number wide = step_ / 100 + tolerances_.tolerance;
    int times = 0;
    for (const Number& other : turns_) times += abs(other - radius) <= wide ? 1 : 0;
    return times > kMostTimes;
  }

  // The text says arcs; straight feeds are links.
  std::vector<Stroke> arcs_of(bool counts_lines) const {
    std::vector<Stroke> arcs = {{plunge_, plunge_}};
    for (const Part& part : path_) {
      if (part.is_arc || counts_lines) arcs.push_back(part.stroke);
    }
    return arcs;
  }

  // GSK-CYC-02: every place is within R of the plunge, or of an arc from which the path has been
  // away, so that the groove behind the tool supports nothing. On a link the arc is one before it.
  bool is_in_order(bool counts_lines) const {
    const Number most = step_ + tolerances_.tolerance * 3 + tolerances_.chord * 2;
    const std::int64_t width = raster_.length(width_ * 2) + 2;
    const std::int64_t reach = raster_.length(most) + (slack_.is_generous() ? width : -width);
    const std::int64_t away = raster_.length(step_) + (slack_.is_generous() ? -width : width);
    for (std::size_t i = 0; i < path_.size(); ++i) {
      if (!is_supported(i, path_[i].stroke, reach, away, counts_lines)) return false;
    }
    return true;
  }

  bool is_supported(std::size_t number, const Stroke& stroke, std::int64_t reach, std::int64_t away,
                    bool counts_lines) const {
    const auto supports = [&](const Stroke& by) {
      return is_within(stroke.from, by, reach) && is_within(stroke.to, by, reach);
    };
    if (supports({plunge_, plunge_})) return true;
    bool has_been_away = !path_[number].is_arc && !counts_lines;
    for (std::size_t i = number; i-- > 0;) {
      const Part& before = path_[i];
      // The end of the part is away from all of the stroke.
      has_been_away = has_been_away || !is_within(before.stroke.to, stroke, away);
      if (has_been_away && (before.is_arc || counts_lines) && supports(before.stroke)) return true;
    }
    const Point middle = {(stroke.from.p + stroke.to.p) / 2, (stroke.from.q + stroke.to.q) / 2};
    const std::int64_t small = raster_.length(tolerances_.tolerance);
    const auto is_small = [&](std::int64_t way) { return std::abs(way) <= small; };
    if (is_small(stroke.to.p - stroke.from.p) && is_small(stroke.to.q - stroke.from.q)) {
      return false;
    }
    return is_supported(number, {stroke.from, middle}, reach, away, counts_lines) &&
           is_supported(number, {middle, stroke.to}, reach, away, counts_lines);
  }

  const PocketLevel& level_;
  const Tolerances& tolerances_;
  Slack slack_;
  reference::PlaneAxes axes_;
  Offset middle_;
  Number radius_;
  Number tool_;
  Number step_;
  Number reach_;
  Raster raster_;
  Winding winding_;
  Position start_;
  Point plunge_;
  Offset last_;
  std::vector<Part> path_;
  std::vector<Number> turns_;  // how far from the middle each was done
  Number width_;
  Number way_;
  Number most_way_;
};

}  // namespace

StepAnswer follow(const PocketLevel& level, const Followed& way) {
  LevelConditions conditions(level, way);
  SubjectSide& subject = way.subject;
  conditions.begin_at(subject.at(way.begin).from);
  std::size_t i = way.begin;
  Position place = subject.at(i).from;
  for (; subject.at(i).is_motion(); ++i) {
    const Event& piece = subject.at(i);
    if (const auto end = end_of_small_stretch(subject, i, place, way.tolerances.tolerance)) {
      i = *end - 1;
      continue;
    }
    if (piece.part != Part::cut || conditions.leaves_depth(piece)) break;
    const std::string_view broken = conditions.take(piece);
    if (!broken.empty()) return {{}, i, broken};
    place = piece.to;
  }
  const std::string_view broken = conditions.broken_at_end();
  if (!broken.empty()) return {{}, i, broken};
  return {{i}, 0, {}};
}

}  // namespace gonogo::relation
