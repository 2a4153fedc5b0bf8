// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/rules.hpp"

#include <algorithm>
#include <utility>

#include "oracle/region/border_sense.hpp"
#include "oracle/region/chords.hpp"
#include "oracle/region/constants.hpp"
#include "oracle/region/gouge.hpp"
#include "oracle/region/order.hpp"
#include "oracle/region/winding.hpp"

namespace gonogo::oracle::region {
namespace {

LevelVerdict gap(GapReason reason, std::string why) {
  LevelVerdict verdict;
  verdict.kind = LevelVerdict::Kind::gap;
  verdict.reason = reason;
  verdict.gap = std::move(why);
  return verdict;
}

LevelVerdict broken(Rule rule, std::optional<std::size_t> record, PlanePoint witness,
                    Number deviation) {
  LevelVerdict verdict;
  verdict.kind = LevelVerdict::Kind::no_go;
  verdict.finding = Finding{rule, record, std::move(witness), std::move(deviation)};
  return verdict;
}

LevelVerdict against_sense(const LevelMotion& motion) {
  return broken(Rule::sense, motion.record, motion.from, Number());
}

// An arc that moves: not a turn of radius 0.
bool moves(const LevelMotion& motion) {
  if (!motion.is_arc) return false;
  return !(motion.from == motion.to && motion.from == motion.centre);
}

// Ends no farther apart than the tolerance on either axis.
bool ends_agree(const LevelMotion& motion, const Number& tolerance) {
  return exact::abs(motion.from.p - motion.to.p) <= tolerance &&
         exact::abs(motion.from.q - motion.to.q) <= tolerance;
}

// Such ends, but not the same point: rounding may have made this of no motion at all or of a whole
// turn.
bool is_open(const LevelMotion& motion, const Number& within) {
  if (!motion.is_arc || motion.rot == 0 || whole_turns(motion.rot) > 0) return false;
  return !(motion.from == motion.to) && ends_agree(motion, within);
}

class LevelJudge {
 public:
  LevelJudge(const AnyLevel& terms, std::span<const LevelMotion> motions, Method method)
      : terms_(terms),
        motions_(motions),
        method_(method),
        border_(terms.border()),
        surely_(border_, terms.sense, terms.tolerance - terms.slack),
        perhaps_(border_, terms.sense, terms.tolerance + terms.slack),
        nearby_(
            enclose(min(terms.tool_radius, inner_radius(border_)) / Number(kSmallOfTool)).inf()) {
    if (terms.chord.sign() > 0) {
      chords_ = find_chords(motions, terms.chord + terms.tolerance);
      along_chords_.emplace(border_, terms.sense, terms.tolerance + terms.chord);
    }
  }

  LevelVerdict judge();

 private:
  std::optional<LevelVerdict> sense();
  bool turns_wrongly(const LevelMotion& motion) const;
  std::optional<LevelVerdict> sense_along_border();
  std::optional<LevelVerdict> sense_round_middle();
  std::optional<LevelVerdict> sense_of_chords();
  Course course_along(const BorderSense& border, const LevelMotion& motion) const;
  Course course_of_pieces(std::size_t motion, std::optional<PlanePoint>& touch) const;
  Line line_of(const LevelMotion& motion) const {
    return make_line(motion.from - terms_.middle, motion.to - terms_.middle);
  }
  bool is_small(const LevelMotion& motion) const;
  bool is_against(const Arc& arc, bool counterclockwise) const {
    if (terms_.by_border) return surely_.of_arc(arc, counterclockwise).way < 0;
    return counterclockwise != (terms_.sense > 0);
  }
  std::optional<LevelVerdict> gouge();
  std::optional<LevelVerdict> gouge_of_ends(const LevelMotion& motion, const Number& margin);
  std::optional<LevelVerdict> gouge_of_line(const LevelMotion& motion, bool is_chord);
  std::optional<LevelVerdict> gouge_of_arc(const LevelMotion& motion);
  template <class Part>
  Reach reach_of(const Part& part, const Number& margin) const;
  std::optional<LevelVerdict> within(const LevelMotion& motion, const Reach& reach);
  std::optional<LevelVerdict> order();
  bool is_chord(std::size_t motion) const { return !chords_.empty() && chords_[motion]; }
  std::optional<LevelVerdict> covers(Rule rule, const RoundedRectangle& area, const Number& reach);
  void clear_with(Arc arc, bool counterclockwise);
  void clear_with(const Line& line);
  void clear_with_ends(const LevelMotion& motion);
  void leave_undecided(GapReason reason, std::string why) {
    if (!doubt_) doubt_ = gap(reason, std::move(why));
  }

  const AnyLevel& terms_;
  std::span<const LevelMotion> motions_;
  Method method_;
  RoundedRectangle border_;
  BorderSense surely_;
  BorderSense perhaps_;
  double nearby_;  // how far small motions lead from the border
  std::optional<BorderSense> along_chords_;
  std::vector<bool> chords_;  // of the motions, where they are granted
  Path path_;
  // Where the order counts: of the least reach, and of the widest, where there is a slack.
  std::vector<CutSequence> sequences_;
  std::optional<PlanePoint> line_end_;  // where the last motion ended, if it was a line that clears
  std::optional<LevelVerdict> doubt_;   // the first thing that stayed undecided
  bool by_filter_ = true;
};

LevelVerdict LevelJudge::judge() {
  if (auto verdict = sense()) return *verdict;
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

Course LevelJudge::course_along(const BorderSense& border, const LevelMotion& motion) const {
  if (!motion.is_arc) return border.of_line(line_of(motion));
  const bool about_end = motion.from == motion.centre || motion.to == motion.centre;
  if (motion.rot == 0 || about_end) return {};
  return border.of_arc(make_arc(motion, terms_.middle), motion.rot > 0);
}

// A negligible motion has none.
bool has_sense(const LevelMotion& motion, const Number& within) {
  return !motion.is_arc || (moves(motion) && !is_open(motion, within));
}

std::optional<LevelVerdict> LevelJudge::sense() {
  if (!terms_.by_border) {
    for (const LevelMotion& motion : motions_) {
      if (turns_wrongly(motion)) return against_sense(motion);
    }
  }
  if (auto verdict = sense_along_border()) return verdict;
  if (terms_.by_border) return std::nullopt;
  if (auto verdict = sense_round_middle()) return verdict;
  return terms_.chord.sign() > 0 ? sense_of_chords() : std::nullopt;
}

// GSK-G110-09: by arcs turning the commanded way.
bool LevelJudge::turns_wrongly(const LevelMotion& motion) const {
  if (!motion.is_arc || !has_sense(motion, terms_.turns.within)) return false;
  if (motion.rot == 0) return !(motion.from == motion.to);
  return (motion.rot > 0) != (terms_.sense > 0);
}

// J-PKT-06: rings round the middle, in pieces of any kind.
std::optional<LevelVerdict> LevelJudge::sense_round_middle() {
  Winding winding(terms_.middle, terms_.sense, terms_.step.value_or(0),
                  Number(kBlur) * terms_.tolerance);
  for (const LevelMotion& motion : motions_) {
    if (!has_sense(motion, terms_.turns.within)) continue;
    const Against answer = winding.add(motion);
    if (answer == Against::yes) return against_sense(motion);
    if (answer == Against::undecided) {
      leave_undecided(GapReason::comparison, "Which way the path goes round is undecided.");
    }
  }
  return std::nullopt;
}

// Whether the motion stays near where it begins.
bool LevelJudge::is_small(const LevelMotion& motion) const {
  const IntervalVector way = enclose(motion.to) - enclose(motion.from);
  if (!(norm(way).sup() <= nearby_)) return false;
  if (!motion.is_arc || motion.rot == 0) return true;
  if (motion.from == motion.centre || motion.to == motion.centre) return true;
  const Arc arc = make_arc(motion, terms_.middle);
  return 2 * std::max(arc.ra.sup(), arc.rb.sup()) <= nearby_ || (arc.turns == 0 && !arc.sweep.wide);
}

// J-PKT-06, SIE-LC75-12: nowhere back along the border by more than a quarter of the tool's radius,
// or of the half width of E. Places of the path may be off by the tolerance.
std::optional<LevelVerdict> LevelJudge::sense_along_border() {
  const Number quarter = min(terms_.tool_radius, inner_radius(border_)) / Number(kSmallOfTool);
  WayBack way(quarter + terms_.tolerance - terms_.slack, quarter + terms_.tolerance + terms_.slack);
  std::optional<PlanePoint> touch;
  for (std::size_t i = 0; i < motions_.size(); ++i) {
    const LevelMotion& motion = motions_[i];
    if (!motion.is_arc && motion.from == motion.to) continue;
    Course narrow;
    Course wide;
    if (has_sense(motion, terms_.turns.within)) {
      narrow = wide = course_along(surely_, motion);
      if (terms_.slack.sign() != 0) wide = course_along(perhaps_, motion);
    }
    if (narrow.way == 0 && wide.way == 0) {
      narrow = wide = course_of_pieces(i, touch);
    } else {
      touch.reset();
      if (surely_.touches(motion.to - terms_.middle)) touch = motion.to - terms_.middle;
    }
    const Against answer = way.add(narrow, wide);
    if (answer == Against::yes) return against_sense(motion);
    if (answer == Against::undecided) {
      leave_undecided(GapReason::comparison, "How far the path goes back is undecided.");
    }
  }
  return std::nullopt;
}

// Small motions in a row that touch the border again and again, as one along it; straight chords
// that run along it likewise. `touch`: where they did, and how far they have been counted.
Course LevelJudge::course_of_pieces(std::size_t number, std::optional<PlanePoint>& touch) const {
  const LevelMotion& motion = motions_[number];
  const BorderSense& border = is_chord(number) ? *along_chords_ : surely_;
  const BorderSense& length = is_chord(number) ? *along_chords_ : perhaps_;
  const PlanePoint to = motion.to - terms_.middle;
  const bool follows = is_chord(number) && border.runs_along(line_of(motion));
  const bool is_near =
      is_small(motion) && touch && norm(enclose(to) - enclose(*touch)).sup() <= nearby_;
  if (!follows && !is_near) touch.reset();
  if (!border.touches(to)) return {};
  if (!touch) touch = follows ? motion.from - terms_.middle : to;
  if (!length.is_long_enough(*touch, to)) return {};
  return length.between(*std::exchange(touch, to), to);
}

// J-PKT-06
std::optional<LevelVerdict> LevelJudge::sense_of_chords() {
  const ChordTurning turning =
      turning_of(motions_, chords_, terms_.sense, Number(kBlur) * terms_.tolerance);
  if (turning.kind == Turning::undecided)
    leave_undecided(GapReason::comparison, "Whether chords turn the wrong way is undecided.");
  if (turning.kind != Turning::against) return std::nullopt;
  return against_sense(motions_[turning.motion]);
}

// J-PKT-02
std::optional<LevelVerdict> LevelJudge::gouge() {
  for (std::size_t i = 0; i < motions_.size(); ++i) {
    const LevelMotion& motion = motions_[i];
    const bool is_curve = moves(motion) && motion.rot != 0;
    if (auto verdict = is_curve ? gouge_of_arc(motion) : gouge_of_line(motion, is_chord(i))) {
      return verdict;
    }
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
    const Line line = line_of(motion);
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
  if (open && is_against(arc, counterclockwise)) {
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
  return gap(GapReason::two_readings,
             "Rounding decides whether an arc makes a turn more or less than its record says.");
}

}  // namespace

LevelVerdict judge_by_rules(const AnyLevel& terms, std::span<const LevelMotion> motions,
                            Method method) {
  const Rounding outward;
  if (motions.size() > kMostMotions)
    return gap(GapReason::cap_level, "The level has more than 50,000 motions.");
  try {
    return judge_turns(terms, motions, method);
  } catch (const exact::Undecided& error) {
    return gap(GapReason::comparison, error.what());
  }
}

}  // namespace gonogo::oracle::region
