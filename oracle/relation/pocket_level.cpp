// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/relation/free_step.hpp"

namespace gonogo::relation {

using reference::PocketLevel;
using reference::RecordKind;

namespace {

// GSK-G110-09, as far as stated here: cuts at the depth of the level and with its feed, within
// the circle that the tool's centre may reach, by arcs that turn as commanded and never go round
// the middle the other way, no farther than ten times the way of concentric circles.
class LevelConditions {
 public:
  LevelConditions(const PocketLevel& level, const Terms& terms)
      : level_(level),
        terms_(terms),
        axes_(reference::axes_of(level.plane)),
        middle_{rational_near(level.centre[0]), rational_near(level.centre[1])},
        reach_(rational_near(level.pocket_radius - level.tool_radius)),
        winding_(level.sense, terms.tolerance * 4) {
    const Number circles = (reach_ / rational_near(level.step)).ceil() + 1;
    // Along both axes a circle goes eight times its radius.
    constexpr int kAsMuch = 10;
    most_way_ = circles * reach_ * 8 * kAsMuch;
  }

  bool leaves_depth(const Event& piece) const {
    return abs(piece.to[axes_.d] - rational_near(level_.depth)) > terms_.tolerance + piece.width;
  }
  void begin_at(const Position& place) { winding_.take(offset_of(place)); }

  // What the piece breaks; empty: nothing.
  std::string_view take(const Event& piece) {
    const Winding::Offset to = offset_of(piece.to);
    const Number limit = reach_ + terms_.tolerance * 17 / 8 + piece.width;
    if (to.p * to.p + to.q * to.q > limit * limit) return "The cut leaves the pocket.";
    if (!has_its_label(*piece.label)) return "The cut has another feed or line.";
    const reference::Record& motion = piece.source();
    const bool turns_back = motion.kind == RecordKind::arc && !piece.label->is_flat &&
                            (motion.rot < 0) != (level_.sense < 0);
    if (turns_back) return "The arc turns the other way.";
    winding_.take(to);
    if (winding_.goes_back()) return "The cut goes round the middle the other way.";
    way_ += way_of(piece, axes_.p) + way_of(piece, axes_.q);
    if (way_ > most_way_) return "The cut is more than ten times as long as concentric circles.";
    return {};
  }

 private:
  Winding::Offset offset_of(const Position& place) const {
    return {place[axes_.p] - middle_.p, place[axes_.q] - middle_.q};
  }
  bool has_its_label(const Label& label) const {
    return (label.kind == RecordKind::feed || label.kind == RecordKind::arc) &&
           (!terms_.compare_blocks || label.block == level_.block) &&
           label.feed_mode == level_.feed_mode &&
           agree(level_.feed, label.feed, terms_.feed_resolution, terms_);
  }

  const PocketLevel& level_;
  const Terms& terms_;
  reference::PlaneAxes axes_;
  Winding::Offset middle_;
  Number reach_;
  Winding winding_;
  Number way_;
  Number most_way_;
};

}  // namespace

StepAnswer follow(const PocketLevel& level, SubjectSide& subject, std::size_t begin,
                  const Terms& terms) {
  LevelConditions conditions(level, terms);
  conditions.begin_at(subject.at(begin).from);
  std::size_t i = begin;
  for (; subject.at(i).is_motion(); ++i) {
    const Event& piece = subject.at(i);
    if (const auto end = end_of_small_stretch(subject, i, terms.tolerance)) {
      i = *end - 1;
      continue;
    }
    if (piece.part != Part::cut || conditions.leaves_depth(piece)) break;
    const std::string_view broken = conditions.take(piece);
    if (!broken.empty()) return {{}, i, broken};
  }
  return {{i}, 0, {}};
}

}  // namespace gonogo::relation
