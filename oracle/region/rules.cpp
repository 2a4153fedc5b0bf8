// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/rules.hpp"

#include <algorithm>
#include <utility>

#include "oracle/region/constants.hpp"
#include "oracle/region/gouge.hpp"
#include "oracle/region/level_sense.hpp"
#include "oracle/region/order.hpp"

namespace gonogo::oracle::region {
namespace {

LevelVerdict broken(Rule rule, std::optional<std::size_t> record, PlanePoint witness,
                    Number deviation) {
  return {LevelVerdict::Kind::no_go,
          Finding{rule, record, std::move(witness), std::move(deviation)},
          {}};
}

class LevelJudge {
 public:
  LevelJudge(const AnyLevel& terms, std::span<const LevelMotion> motions, Method method)
      : terms_(terms),
        motions_(motions),
        method_(method),
        border_(terms.border()),
        sense_(terms, motions) {}

  LevelVerdict judge();

 private:
  std::optional<LevelVerdict> gouge();
  std::optional<LevelVerdict> gouge_of_ends(const LevelMotion& motion, const Number& margin);
  std::optional<LevelVerdict> gouge_of_line(const LevelMotion& motion, bool is_chord);
  std::optional<LevelVerdict> gouge_of_arc(const LevelMotion& motion);
  template <class Part>
  Reach reach_of(const Part& part, const Number& margin) const;
  std::optional<LevelVerdict> within(const LevelMotion& motion, const Reach& reach);
  std::optional<LevelVerdict> order();
  std::optional<LevelVerdict> covers(Rule rule, const RoundedRectangle& area, const Number& reach);
  void clear_with(Arc arc, bool counterclockwise);
  void clear_with(const Line& line);
  void clear_with_ends(const LevelMotion& motion);
  void leave_undecided(GapReason reason, std::string why) {
    if (!doubt_) doubt_ = LevelVerdict::undecided(reason, std::move(why));
  }

  const AnyLevel& terms_;
  std::span<const LevelMotion> motions_;
  Method method_;
  RoundedRectangle border_;
  LevelSense sense_;
  Path path_;
  // Where the order counts: of the least reach, and of the widest, where there is a slack.
  std::vector<CutSequence> sequences_;
  std::optional<PlanePoint> line_end_;  // where the last motion ended, if it was a line that clears
  std::optional<LevelVerdict> doubt_;   // the first thing that stayed undecided
  bool by_filter_ = true;
};

LevelVerdict LevelJudge::judge() {
  if (const LevelMotion* motion = sense_.motion_against()) {
    return broken(Rule::sense, motion->record, motion->from, Number());
  }
  if (sense_.doubt() != nullptr) leave_undecided(GapReason::comparison, sense_.doubt());
  if (terms_.step) {
    // J-PKT-05: two places, each off by the tolerance on both axes, are 2 sqrt(2) of it farther
    // apart than they should be, and chords each run so far inside of their arcs.
    const Number reach =
        *terms_.step + Number(kTwoPlaces) * terms_.tolerance + Number(2) * terms_.chord;
    const auto begin = [&](const Number& far) {
      sequences_.emplace_back(terms_.plunge - terms_.middle, *terms_.step, far,
                              enclose(terms_.tolerance).inf() / kBlur);
    };
    // Each of two places may be as far off as the slack.
    begin(reach - Number(2) * terms_.slack);
    if (terms_.slack.sign() != 0) begin(reach + Number(2) * terms_.slack);
  }
  if (auto verdict = gouge()) return *verdict;
  path_.points.push_back(terms_.plunge - terms_.middle);
  // A strip of no width needs nothing.
  if (!terms_.cleared || !(*terms_.cleared == terms_.area)) {
    if (auto verdict = covers(Rule::cover, terms_.area, terms_.tool_radius)) return *verdict;
  }
  if (terms_.step) {
    if (auto verdict = covers(Rule::step, border_, *terms_.step / Number(2))) return *verdict;
    if (auto verdict = order()) return *verdict;
  }
  if (doubt_) return *doubt_;
  LevelVerdict verdict;
  verdict.by_filter = by_filter_;
  return verdict;
}

// J-PKT-02
std::optional<LevelVerdict> LevelJudge::gouge() {
  for (std::size_t i = 0; i < motions_.size(); ++i) {
    const LevelMotion& motion = motions_[i];
    const bool is_curve = moves(motion) && motion.rot != 0;
    auto verdict = is_curve ? gouge_of_arc(motion) : gouge_of_line(motion, sense_.is_chord(i));
    if (verdict) return verdict;
  }
  return std::nullopt;
}

std::optional<LevelVerdict> LevelJudge::gouge_of_ends(const LevelMotion& motion,
                                                      const Number& margin) {
  for (const PlanePoint& end : {motion.from, motion.to}) {
    if (auto verdict = within(motion, reach_of(end - terms_.middle, margin))) return verdict;
  }
  return std::nullopt;
}

// A line, or an arc that goes nowhere: the border is convex.
std::optional<LevelVerdict> LevelJudge::gouge_of_line(const LevelMotion& motion, bool is_chord) {
  const Number margin = is_chord ? terms_.tolerance + terms_.chord : terms_.tolerance;
  if (auto verdict = gouge_of_ends(motion, margin)) return verdict;
  const bool is_line = !motion.is_arc && !(motion.from == motion.to);
  if (is_line) {
    const Line line = make_line(motion.from - terms_.middle, motion.to - terms_.middle);
    for (CutSequence& one : sequences_) one.add_line(line, is_chord, motion.record);
    if (is_chord || terms_.by_border) clear_with(line);
  } else if (terms_.by_border) {
    if (motion.rot == 0 && !(motion.from == motion.to)) {
      leave_undecided(GapReason::unjudged_form, "An arc has no direction.");
    }
    clear_with_ends(motion);
  }
  return std::nullopt;
}

std::optional<LevelVerdict> LevelJudge::gouge_of_arc(const LevelMotion& motion) {
  const bool counterclockwise = motion.rot > 0;
  const bool open = is_open(motion, terms_.turns.within);
  if (motion.from == motion.centre || motion.to == motion.centre) {
    // One that is as small as the tolerance came to it by rounding.
    if (!ends_agree(motion, terms_.tolerance)) {
      leave_undecided(GapReason::unjudged_form, "An arc begins or ends on its own centre.");
    } else if (auto verdict = gouge_of_ends(motion, terms_.tolerance)) {
      return verdict;
    }
    clear_with_ends(motion);
    return std::nullopt;
  }
  Arc arc = make_arc(motion, terms_.middle);
  if (open && !arc.sweep.wide) {
    arc.turns = 1;  // the end is just past the start
    arc.full = arc.round;
  }
  if (open && sense_.is_against(arc, counterclockwise)) {
    clear_with_ends(motion);  // it can only be meant as no motion
    return std::nullopt;
  }
  const Reach reach = reach_of(arc, terms_.tolerance);
  if (open && reach.kind != Reach::Kind::inside) {
    for (const PlanePoint& end : {arc.end_a(), arc.end_b()}) {
      if (auto verdict = within(motion, reach_of(end, terms_.tolerance))) return verdict;
    }
    clear_with_ends(motion);
    return std::nullopt;
  }
  if (auto verdict = within(motion, reach)) return verdict;
  for (CutSequence& one : sequences_) one.add(arc, counterclockwise);
  clear_with(arc, counterclockwise);
  return std::nullopt;
}

// Inside the border and a margin, or outside of it, whichever way the slack falls. How far outside
// is counted from the border itself.
template <class Part>
Reach LevelJudge::reach_of(const Part& part, const Number& margin) const {
  const auto within_margin = [&](const Number& wide) {
    Reach reach = region::reach_of(part, with_radius(border_, border_.radius + wide));
    if (reach.kind == Reach::Kind::outside) reach.beyond += wide;
    return reach;
  };
  if (terms_.slack.sign() == 0) return within_margin(margin);
  Reach reach = within_margin(margin - terms_.slack);
  if (reach.kind != Reach::Kind::outside) return reach;
  reach = within_margin(margin + terms_.slack);
  if (reach.kind == Reach::Kind::inside) reach.kind = Reach::Kind::undecided;
  return reach;
}

std::optional<LevelVerdict> LevelJudge::within(const LevelMotion& motion, const Reach& reach) {
  if (reach.kind == Reach::Kind::undecided) {
    leave_undecided(GapReason::comparison,
                    "Whether a motion stays within the pocket could not be decided.");
  }
  if (reach.kind != Reach::Kind::outside) return std::nullopt;
  return broken(Rule::gouge, motion.record, reach.witness + terms_.middle, reach.beyond);
}

// GSK-CYC-02, J-PKT-05
std::optional<LevelVerdict> LevelJudge::order() {
  const Number half_side = border_.radius + terms_.tolerance + terms_.chord;
  CutOrder order = sequences_.front().check(enclose(half_side).sup());
  if (order.kind == CutOrder::Kind::broken && sequences_.size() > 1) {
    order = sequences_.back().check(enclose(half_side).sup());
    if (order.kind == CutOrder::Kind::fine) order.kind = CutOrder::Kind::undecided;
  }
  if (order.kind == CutOrder::Kind::undecided) {
    leave_undecided(GapReason::comparison,
                    "Whether the level is cut from the centre outwards could not be decided.");
  }
  if (order.kind != CutOrder::Kind::broken) return std::nullopt;
  return broken(Rule::order, order.record, order.witness + terms_.middle,
                order.distance - *terms_.step);
}

// Pieces of one circle, one after the other, count as one arc.
void LevelJudge::clear_with(Arc arc, bool counterclockwise) {
  if (line_end_) {
    const bool begins = *line_end_ == (counterclockwise ? arc.end_a() : arc.end_b());
    (counterclockwise ? arc.capped_a : arc.capped_b) = begins;
  }
  line_end_.reset();
  if (!path_.arcs.empty()) {
    if (const auto both = joined(path_.arcs.back(), arc, counterclockwise)) {
      path_.arcs.back() = *both;
      return;
    }
  }
  path_.arcs.push_back(arc);
}

// Pieces of one straight line likewise.
void LevelJudge::clear_with(const Line& line) {
  if (!path_.arcs.empty()) {
    Arc& arc = path_.arcs.back();
    if (arc.end_a() == line.from) arc.capped_a = true;
    if (arc.end_b() == line.from) arc.capped_b = true;
  }
  line_end_ = line.to;
  if (!path_.lines.empty()) {
    if (const auto both = joined(path_.lines.back(), line)) {
      path_.lines.back() = *both;
      return;
    }
  }
  path_.lines.push_back(line);
}

void LevelJudge::clear_with_ends(const LevelMotion& motion) {
  path_.points.push_back(motion.from - terms_.middle);
  path_.points.push_back(motion.to - terms_.middle);
}

// J-PKT-02, by the arcs and the plunge that J-PKT-02 leaves of the path.
std::optional<LevelVerdict> LevelJudge::covers(Rule rule, const RoundedRectangle& area,
                                               const Number& reach) {
  const std::optional<RoundedRectangle> none;
  // J-PKT-07: chords run so far inside of their arcs.
  const Number tolerance = terms_.tolerance + terms_.chord;
  const Target target{area, rule == Rule::cover ? terms_.cleared : none,
                      reach + tolerance - terms_.slack, Number(2) * terms_.slack};
  const Coverage coverage = check_coverage(path_, target, terms_.tolerance, method_);
  by_filter_ = by_filter_ && coverage.by_filter;
  if (coverage.kind == Coverage::Kind::covered) return std::nullopt;
  if (coverage.kind == Coverage::Kind::undecided) {
    leave_undecided(coverage.reason, coverage.why);
    return std::nullopt;
  }
  // J-CMP-12
  const Number apart = coverage.excess + tolerance + terms_.slack;  // of the tool's own reach
  auto verdict = broken(rule, std::nullopt, coverage.witness + terms_.middle, apart);
  verdict.by_filter = coverage.by_filter;
  return verdict;
}

// J-PATH-06: as the records say; else as rounding may have meant them.
LevelVerdict judge_turns(const AnyLevel& terms, std::span<const LevelMotion> motions,
                         Method method) {
  AnyLevel as_stated = terms;
  as_stated.turns.within = 0;
  LevelVerdict stated = LevelJudge(as_stated, motions, method).judge();
  const bool any_open = std::ranges::any_of(
      motions, [&](const LevelMotion& motion) { return is_open(motion, terms.turns.within); });
  if (stated.kind == LevelVerdict::Kind::go || !any_open) return stated;
  LevelVerdict meant = LevelJudge(terms, motions, method).judge();
  if (meant.kind == LevelVerdict::Kind::no_go) return stated;
  if (!terms.turns.is_ambiguous) return meant;
  return LevelVerdict::undecided(
      GapReason::two_readings,
      "Rounding decides whether an arc makes a turn more or less than its record says.");
}

}  // namespace

LevelVerdict judge_by_rules(const AnyLevel& terms, std::span<const LevelMotion> motions,
                            Method method) {
  const Rounding outward;
  if (motions.size() > kMostMotions) {
    return LevelVerdict::undecided(GapReason::cap_level, "The level has more than 50,000 motions.");
  }
  try {
    return judge_turns(terms, motions, method);
  } catch (const exact::Undecided& error) {
    return LevelVerdict::undecided(GapReason::comparison, error.what());
  }
}

}  // namespace gonogo::oracle::region
