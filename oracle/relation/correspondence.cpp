// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/relation/correspondence.hpp"

#include <algorithm>

#include "oracle/relation/free_step.hpp"

namespace gonogo::relation {

using oracle::VerdictKind;
using reference::Axis;
using reference::kAllAxes;
using reference::Record;
using reference::RecordKind;

namespace {

Position point_at(const Event& piece, const Number& part) {
  Position point;
  for (const Axis axis : kAllAxes) {
    point[axis] = piece.from[axis] + (piece.to[axis] - piece.from[axis]) * part;
  }
  return point;
}

bool is_near(const Position& a, const Position& b, const Number& tolerance) {
  return std::ranges::all_of(kAllAxes, [&](Axis axis) {
    const Number apart = a[axis] - b[axis];
    return apart <= tolerance && -apart <= tolerance;
  });
}

struct Part01 {
  Number low = 0;
  Number high = 1;
};

// R2: the part of a piece that is near a place; nothing where none is. REQUIRES: all rational.
std::optional<Part01> near_part(const Event& piece, const Position& place,
                                const Number& tolerance) {
  Part01 part;
  for (const Axis axis : kAllAxes) {
    const Number& from = piece.from[axis];
    const Number& to = piece.to[axis];
    const Number low = place[axis] - tolerance;
    const Number high = place[axis] + tolerance;
    if (max(from, to) < low || min(from, to) > high || low > high) return std::nullopt;
    const bool rises = from <= to;
    // Where it comes near on this axis, and where it leaves.
    const Number& entry = rises ? low : high;
    const Number& exit = rises ? high : low;
    if (rises ? from < entry : from > entry) part.low = max(part.low, (entry - from) / (to - from));
    if (rises ? to > exit : to < exit) part.high = min(part.high, (exit - from) / (to - from));
  }
  if (part.low > part.high) return std::nullopt;
  return part;
}

template <typename Intervals>
bool begins(const Intervals& parts) {
  return std::ranges::any_of(parts, [](const auto& part) { return part.low.sign() == 0; });
}

template <typename Intervals>
bool ends(const Intervals& parts) {
  return std::ranges::any_of(parts, [](const auto& part) { return part.high == Number(1); });
}

// The lowest of what is reached and near.
template <typename Intervals>
std::optional<Number> lowest(const Intervals& reached, const std::optional<Part01>& near) {
  std::optional<Number> low;
  if (!near) return low;
  for (const auto& part : reached) {
    const Number begin = max(part.low, near->low);
    if (begin > min(part.high, near->high)) continue;
    if (!low || begin < *low) low = begin;
  }
  return low;
}

// What is left of the parts.
template <typename Intervals>
Intervals common(const Intervals& parts, const std::optional<Part01>& near) {
  Intervals left;
  if (!near) return left;
  for (const auto& part : parts) {
    const Number low = max(part.low, near->low);
    const Number high = min(part.high, near->high);
    if (low <= high) left.push_back({low, high});
  }
  return left;
}

}  // namespace

Correspondence::Correspondence(const reference::Profile& profile, std::string_view program,
                               const Terms& terms, const Outcome& outcome, const Manner& manner)
    : profile_(profile), program_(program), terms_(terms), outcome_(outcome), manner_(manner) {
  pairs_.push_back({std::make_shared<ReferenceSide>(profile, program, terms, Settled()),
                    std::make_shared<SubjectSide>(outcome.records, 0, profile.initial.at, terms,
                                                  manner.turn),
                    0, profile.initial.at});
}

std::vector<reference::ReadingKey> Correspondence::touched() const {
  std::vector<reference::ReadingKey> keys;
  for (const Pair& pair : pairs_) {
    for (const reference::ReadingKey key : pair.reference->readings().touched()) {
      if (std::ranges::count(keys, key) == 0) keys.push_back(key);
    }
  }
  return keys;
}

Number Correspondence::tolerance(const Number& tau, const Number& width) {
  if (width.sign() == 0) return tau;
  has_width_ = true;
  // In whole millionths, so that most comparisons are of small numbers.
  constexpr int kMillion = 1'000'000;
  return manner_.bias == Bias::outer ? ((tau + width) * kMillion).ceil() / kMillion
                                     : ((tau - width) * kMillion).floor() / kMillion;
}

// R2: of two arcs 17/8 tau, which is what rounding centre, start and end makes of the points
// between; of a granted chord what is granted.
Number Correspondence::cell_tolerance(const Event& want, const Event& got) {
  const Number width = want.width + got.width;
  const Label& arc = *want.label;
  if (is_granted_chord(arc, *got.label, terms_) && !arc.is_flat) {
    return tolerance(terms_.tolerance + terms_.chord, width);
  }
  if (arc.kind != RecordKind::arc || got.label->kind != RecordKind::arc) {
    return tolerance(terms_.tolerance, width);
  }
  if (arc.finds_centre) finds_centres_ = true;
  const Number rounded = terms_.tolerance * 17 / 8;
  return tolerance(arc.finds_centre && manner_.excuses_centres ? rounded * 2 : rounded, width);
}

void Correspondence::reach(const Place& place, bool of_subject, Interval part) {
  Reached& reached = open_[place];
  Intervals& parts = of_subject ? reached.at_start_of_want : reached.at_start_of_got;
  for (Interval& other : parts) {
    if (part.low > other.high || other.low > part.high) continue;
    other.low = min(other.low, part.low);
    other.high = max(other.high, part.high);
    return;
  }
  parts.push_back(std::move(part));
}

Answer Correspondence::best() {
  if (is_alarm_at_load()) return *best_;
  reach_corner({});
  while (!open_.empty()) {
    const auto [place, reached] = std::move(*open_.begin());
    open_.erase(open_.begin());
    expand(place, reached);
    if (best_ && decision(best_->kind) == oracle::Decision::go) break;
  }
  return best_ ? *best_ : departure();
}

void Correspondence::expand(const Place& place, const Reached& reached) {
  ReferenceSide& sides = reference(place);
  const Event& want = sides.at(place.i);
  const Event& got = subject(place).at(place.j);
  const bool lacks_m =
      place.m < sides.m_functions(place.i) && sides.is_overdue(place.m, place.i);
  const std::size_t record = got.record;
  const bool is_corner = begins(reached.at_start_of_want) || begins(reached.at_start_of_got);
  if (record > farthest_record_ || (record == farthest_record_ && place >= farthest_)) {
    farthest_ = place;
    farthest_record_ = record;
    is_farthest_corner_ = is_corner && want.begins && got.begins;
    lacks_m_ = lacks_m;
  }
  if (lacks_m) return;
  Place next = place;
  ++next.j;
  if (got.is_motion() && ends(reached.at_start_of_want)) reach_corner(next);
  next = place;
  ++next.i;
  if (want.is_motion() && ends(reached.at_start_of_got)) reach_corner(next);

  if (want.part == Part::cut && got.part == Part::cut) match_cuts(place, reached);
  Intervals of_want = want.part == Part::cut ? reached.at_start_of_got : Intervals();
  Intervals of_got = got.is_motion() ? reached.at_start_of_want : Intervals();
  if (is_corner) of_want.push_back({0, 0});
  if (is_corner && !begins(of_got)) of_got.push_back({0, 0});
  pass_over_subject(place, std::move(of_want));
  if (want.part == Part::traverse) {
    for (const Interval& entry : of_got) traverse(place, entry);
  }
  pass_over_reference(place, std::move(of_got));
  if (!is_corner) return;
  if (got.part == Part::stop) match_stop(place);
  if (want.part == Part::renaming) rename(place);
  if (want.part == Part::free_step) take_free_step(place);
  if (want.part == Part::close || got.part == Part::close) close(place);
}

// Two pieces with one label: from the lowest place that is reached, everything beyond it.
void Correspondence::match_cuts(const Place& place, const Reached& reached) {
  const Event& want = reference(place).at(place.i);
  const Event& got = subject(place).at(place.j);
  if (compare(*want.label, *got.label, terms_) != Likeness::same) return;
  const Number tau = cell_tolerance(want, got);
  const auto left = lowest(reached.at_start_of_want, near_part(got, want.from, tau));
  auto below = lowest(reached.at_start_of_got, near_part(want, got.from, tau));
  if (begins(reached.at_start_of_want) && left && left->sign() == 0) below = Number(0);
  if (!left && !below) return;
  Place next = place;
  ++next.i;
  if (const auto right = near_part(got, want.to, tau)) {
    const Number low = below ? right->low : max(right->low, *left);
    if (low <= right->high) reach(next, true, {low, right->high});
  }
  next = place;
  ++next.j;
  if (const auto above = near_part(want, got.to, tau)) {
    const bool from_left = left.has_value();
    const Number low = from_left ? above->low : max(above->low, *below);
    if (low <= above->high) reach(next, false, {low, above->high});
  }
}

// R3: a stretch of one label that stays near one place has none: the other side stands there.
void Correspondence::pass_over_subject(const Place& place, Intervals of_want) {
  SubjectSide& side = subject(place);
  const Event& want = reference(place).at(place.i);
  if (!side.at(place.j).is_motion()) return;
  if (place.j > 0 && goes_on(side.at(place.j - 1), side.at(place.j))) return;
  Place next = place;
  for (std::size_t j = place.j;; ++j) {
    const Event& got = side.at(j);
    const Number tau = tolerance(terms_.tolerance, want.width + got.width);
    for (const Position* point : {&got.from, &got.to}) {
      if (want.part == Part::cut) {
        of_want = common(of_want, near_part(want, *point, tau));
      } else if (!is_near(want.from, *point, tau)) {
        return;
      }
    }
    if (of_want.empty()) return;
    if (goes_on(got, side.at(j + 1))) continue;
    next.j = j + 1;
    break;
  }
  for (Interval& part : of_want) reach(next, false, std::move(part));
}

void Correspondence::pass_over_reference(const Place& place, Intervals of_got) {
  ReferenceSide& side = reference(place);
  const Event& got = subject(place).at(place.j);
  if (!side.at(place.i).is_motion()) return;
  if (place.i > 0 && goes_on(side.at(place.i - 1), side.at(place.i))) return;
  Place next = place;
  for (std::size_t i = place.i;; ++i) {
    const Event& want = side.at(i);
    const Number tau = tolerance(terms_.tolerance, want.width + got.width);
    for (const Position* point : {&want.from, &want.to}) {
      if (got.is_motion()) {
        of_got = common(of_got, near_part(got, *point, tau));
      } else if (!is_near(got.from, *point, tau)) {
        return;
      }
    }
    if (of_got.empty()) return;
    if (goes_on(want, side.at(i + 1))) continue;
    next.i = i + 1;
    break;
  }
  for (Interval& part : of_got) reach(next, true, std::move(part));
}

// The end of a stretch that stays near a place; nothing where it does not, or has begun before.
std::optional<std::size_t> Correspondence::end_of_small_run(SubjectSide& side, std::size_t begin,
                                                            const Position& place,
                                                            const Number& width) {
  if (begin > 0 && goes_on(side.at(begin - 1), side.at(begin))) return std::nullopt;
  for (std::size_t j = begin;; ++j) {
    const Event& got = side.at(j);
    const Number tau = tolerance(terms_.tolerance, width + got.width);
    if (!got.is_motion() || !is_near(got.from, place, tau) || !is_near(got.to, place, tau)) {
      return std::nullopt;
    }
    if (!goes_on(got, side.at(j + 1))) return j + 1;
  }
}

namespace {

// R4: how far the axes have come on their way, none of which turns back.
class Axes {
 public:
  Axes(const Event& want, const Position& at) : want_(want), best_(at) {}
  bool take(const Position& point, const Number& tau) {
    for (const Axis axis : kAllAxes) {
      const Number& from = want_.from[axis];
      const Number& to = want_.to[axis];
      if (point[axis] < min(from, to) - tau || point[axis] > max(from, to) + tau) return false;
      const bool rises = to >= from;
      const Number back = rises ? best_[axis] - point[axis] : point[axis] - best_[axis];
      if (back > tau * 2) return false;
      if (back.sign() < 0) best_[axis] = point[axis];
    }
    return true;
  }

 private:
  const Event& want_;
  Position best_;
};

}  // namespace

void Correspondence::traverse(const Place& place, const Interval& entry) {
  ReferenceSide& sides = reference(place);
  SubjectSide& side = subject(place);
  const Event& want = sides.at(place.i);
  const auto is_partner = [&](const Event& got) {
    return got.part == Part::traverse &&
           compare(*want.label, *got.label, terms_) == Likeness::same;
  };
  Place next = place;
  ++next.i;
  const Event& first = side.at(place.j);
  // No traverse at all is one that leads no farther than tau.
  const Number still = tolerance(terms_.tolerance, want.width + first.width);
  for (Interval& part : common(Intervals{entry}, near_part(first, want.to, still))) {
    reach(next, true, std::move(part));
  }
  if (is_partner(first) && !first.one_axis && entry.high.sign() > 0) return;
  Position here = first.is_motion() ? point_at(first, entry.high) : first.from;
  Axes axes(want, here);
  for (std::size_t j = place.j;;) {
    const Event& got = side.at(j);
    const Number tau = tolerance(terms_.tolerance, want.width + got.width);
    next.j = j;
    if (is_partner(got)) {
      const Number begin = j == place.j ? entry.low : Number(0);
      if (const auto near = near_part(got, want.to, tau); near && got.one_axis) {
        const Number low = max(begin, near->low);
        if (low <= near->high) reach(next, true, {low, near->high});
      }
      if (!axes.take(got.to, tau)) return;
      here = got.to;
      ++next.j;
      if (is_near(got.to, want.to, tau)) reach_corner(next);
      j = next.j;
    } else if (got.part == Part::stop && got.source().kind == RecordKind::m) {
      // R5: between the parts of the only motion of its block.
      const bool is_next = next.m < sides.m_functions(place.i) &&
                           sides.m_function(next.m).m == got.source().m &&
                           sides.may_stand(next.m, place.i) && sides.may_stand(next.m, place.i + 1);
      if (!is_next || (terms_.compare_blocks && sides.m_block(next.m) != got.block)) return;
      ++next.m;
      ++next.j;
      j = next.j;
      if (is_near(here, want.to, tau)) reach_corner(next);
    } else {
      const auto end = end_of_small_run(side, j, here, want.width);
      if (!end || !axes.take(side.at(*end).from, tau)) return;
      next.j = j = *end;
      if (is_near(side.at(j).from, want.to, tau)) reach_corner(next);
    }
  }
}

// R5.
void Correspondence::match_stop(const Place& place) {
  ReferenceSide& sides = reference(place);
  const Event& want = sides.at(place.i);
  const Event& stop = subject(place).at(place.j);
  const Record& got = stop.source();
  Place next = place;
  ++next.j;
  const auto is_same_block = [&](std::uint64_t block) {
    return !terms_.compare_blocks || block == got.block;
  };
  if (want.part == Part::stop && is_same_block(want.block)) {
    const Record& due = want.source();
    const bool is_partner =
        due.kind == got.kind &&
        (got.kind == RecordKind::m ? due.m == got.m
                                   : agree(due.seconds, got.seconds, terms_.resolution, terms_));
    if (is_partner) {
      ++next.i;
      reach_corner(next);
      --next.i;
    }
  }
  if (got.kind != RecordKind::m || place.m >= sides.m_functions(place.i)) return;
  if (sides.m_function(place.m).m != got.m || !is_same_block(sides.m_block(place.m))) return;
  if (!sides.may_stand(place.m, place.i)) return;
  ++next.m;
  reach_corner(next);
}

// The position gets another name where the subject stands.
void Correspondence::rename(const Place& place) {
  const auto& item = *reference(place).at(place.i).item;
  const auto& renaming = std::get<reference::Renaming>(item);
  const Event& got = subject(place).at(place.j);
  if (!got.begins) return;
  Pair pair = pairs_[place.pair];
  pair.start = subject(place).place(place.j);
  pair.first_record = got.record;
  for (const Axis axis : kAllAxes) pair.start[axis] += renaming.shift[axis];
  reach_corner({pair_for(pair), place.i + 1, 0, place.m});
}

// R8. What settles a step makes another side of the reference, equal up to it.
void Correspondence::settle(const Place& place, std::vector<Record> path, const Place& next,
                            bool is_open) {
  Settled settled = reference(place).settled();
  settled.insert_or_assign(reference(place).item_of(place.i), std::move(path));
  Pair pair = pairs_[place.pair];
  pair.reference = std::make_shared<ReferenceSide>(profile_, program_, terms_, std::move(settled));
  pair.is_open = pair.is_open || is_open;
  pairs_.push_back(std::move(pair));
  reach_corner({pairs_.size() - 1, next.i, next.j, next.m});
}

void Correspondence::take_free_step(const Place& place) {
  const auto step = reference(place).at(place.i).item;
  SubjectSide& side = subject(place);
  if (const auto* pocket = std::get_if<reference::HelixPocket>(&*step)) {
    for (auto& path : paths_of(*pocket, side, place.j, terms_.tolerance)) {
      settle(place, std::move(path), place, false);
    }
    return;
  }
  StepAnswer answer;
  if (const auto* level = std::get_if<reference::PocketLevel>(&*step)) {
    answer = follow(*level, side, place.j, terms_);
  } else if (const auto* pocket = std::get_if<reference::PocketMilling>(&*step)) {
    answer = follow(*pocket, side, place.j, terms_);
  } else {
    answer = follow(std::get<reference::ThreadMilling>(*step), side, place.j, terms_);
  }
  // One motion to where the subject left it stands for the step.
  for (const std::size_t end : answer.ends) {
    Record way;
    way.kind = RecordKind::feed;
    way.block = reference(place).at(place.i).block;
    way.axes = reference::kEveryAxis;
    way.to = side.place(end);
    settle(place, {way}, {place.pair, place.i + 1, end, place.m}, true);
  }
  if (!answer.broken.empty() && side.at(answer.broken_by).record >= broken_record_) {
    broken_record_ = side.at(answer.broken_by).record;
    broken_ = answer.broken;
    broken_at_ = {place.pair, place.i, answer.broken_by, place.m};
  }
}

std::size_t Correspondence::pair_for(const Pair& pair) {
  for (std::size_t number = 0; number < pairs_.size(); ++number) {
    const Pair& other = pairs_[number];
    if (other.reference == pair.reference && other.first_record == pair.first_record &&
        other.start == pair.start) {
      return number;
    }
  }
  pairs_.push_back(pair);
  pairs_.back().subject = std::make_shared<SubjectSide>(outcome_.records, pair.first_record,
                                                        pair.start, terms_, manner_.turn);
  return pairs_.size() - 1;
}

}  // namespace gonogo::relation
