// SPDX-License-Identifier: GPL-3.0-or-later
//
// Traverses (R4), events without length (R5), renamings and free steps (R8).
#include <algorithm>

#include "oracle/relation/correspondence.hpp"
#include "oracle/relation/free_step.hpp"
#include "oracle/relation/near.hpp"

namespace gonogo::relation {

using oracle::VerdictKind;
using reference::Axis;
using reference::kAllAxes;
using reference::Record;
using reference::RecordKind;

// The end of a stretch that stays near a place; nothing where it does not, or has begun before.
std::optional<std::size_t> Correspondence::end_of_small_run(SubjectSide& side, std::size_t begin,
                                                            const Position& place,
                                                            const Number& width) {
  if (begin > 0 && goes_on(side.at(begin - 1), side.at(begin))) return std::nullopt;
  for (std::size_t j = begin;; ++j) {
    const Event& got = side.at(j);
    const Number tau = tolerance(tolerances_.tolerance, width + got.width);
    if (!got.is_motion() || !is_near(got.from, place, tau) || !is_near(got.to, place, tau)) {
      return std::nullopt;
    }
    if (manner_.only_rounded && std::ranges::count(manner_.turned, got.record) > 0) {
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
  SubjectSide& side = subject(place);
  const Event& want = reference(place).at(place.i);
  const Event& first = side.at(place.j);
  Place next = place;
  ++next.i;
  // No traverse at all is one that leads no farther than tau.
  const Number still = tolerance(tolerances_.tolerance, want.width + first.width);
  if (const auto near = near_part(first, want.to, still)) {
    const Number low = max(entry.low, near->low);
    const Number high = min(entry.high, near->high);
    if (low <= high) reach(next, true, {low, high});
  }
  if (is_partner(want, first) && !first.one_axis && entry.high.sign() > 0) return;
  Position here = first.is_motion() ? point_at(first, entry.high) : first.from;
  Axes axes(want, here);
  // With next.j behind what has been taken.
  while (true) {
    const Event& got = side.at(next.j);
    const Number tau = tolerance(tolerances_.tolerance, want.width + got.width);
    if (is_partner(want, got)) {
      const Number begin = next.j == place.j ? entry.low : Number(0);
      if (const auto near = near_part(got, want.to, tau); near && got.one_axis) {
        const Number low = max(begin, near->low);
        if (low <= near->high) reach(next, true, {low, near->high});
      }
      if (!axes.take(got.to, tau)) return;
      here = got.to;
      ++next.j;
    } else if (const auto behind = behind_m({next.pair, place.i, next.j, next.m}, true)) {
      next = {behind->pair, next.i, behind->j, behind->m};
    } else {
      const auto end = end_of_small_run(side, next.j, here, want.width);
      if (!end || !axes.take(side.at(*end).from, tau)) return;
      here = side.at(*end).from;
      next.j = *end;
    }
    if (is_near(here, want.to, tau)) reach_corner(next);
  }
}

bool Correspondence::is_partner(const Event& want, const Event& got) const {
  return got.part == Part::traverse &&
         compare(*want.label, *got.label, tolerances_) == Likeness::same;
}

// R5: which M function that holds no place among the motions the subject's event is: the next one,
// or another of its block. It may stand before the reference's event, or within it: among the parts
// of the only motion of a block.
std::optional<std::size_t> Correspondence::fitting_m(const Place& place, bool is_within) {
  ReferenceSide& sides = reference(place);
  const Event& got = subject(place).at(place.j);
  if (got.part != Part::stop || got.source().kind != RecordKind::m) return std::nullopt;
  const std::size_t known = sides.m_functions(place.i);
  for (std::size_t number = place.m; number < known; ++number) {
    if (number > place.m && !sides.may_change_places(number - 1, number)) break;
    const Record& due = sides.m_function(number);
    if (due.m != got.source().m || (tolerances_.compare_blocks && due.block != got.block)) continue;
    const bool stands =
        sides.may_stand(number, place.i) && (!is_within || sides.may_stand(number, place.i + 1));
    if (stands) return number;
  }
  return std::nullopt;
}

// Where both sides are behind it. What comes out of turn makes another side of the reference.
std::optional<Correspondence::Place> Correspondence::behind_m(const Place& place, bool is_within) {
  const auto number = fitting_m(place, is_within);
  if (!number) return std::nullopt;
  Place next = {place.pair, place.i, place.j + 1, place.m + 1};
  if (*number == place.m) return next;
  Pair pair = pairs_[place.pair];
  pair.reference = another_reference(place, reference(place).settled());
  pair.reference->bring_forward({place.i, place.m, *number});
  pairs_.push_back(std::move(pair));
  next.pair = pairs_.size() - 1;
  return next;
}

// A reference side that is equal so far, except for what is settled.
std::shared_ptr<ReferenceSide> Correspondence::another_reference(const Place& place,
                                                                 Settled settled) {
  auto another = std::make_shared<ReferenceSide>(profile_, program_, tolerances_,
                                                 std::move(settled), manner_.passes_end);
  for (const ReferenceSide::Move& move : reference(place).moves()) another->bring_forward(move);
  return another;
}

// R3: a dwell that is none when it is rounded need not come.
void Correspondence::leave_out_dwell(const Place& place) {
  const Record& due = reference(place).at(place.i).source();
  if (due.kind != RecordKind::dwell) return;
  if (!agree(due.seconds, 0, tolerances_.resolution, tolerances_)) return;
  reach_corner({place.pair, place.i + 1, place.j, place.m});
}

// R5.
void Correspondence::match_stop(const Place& place) {
  const Event& want = reference(place).at(place.i);
  const Event& stop = subject(place).at(place.j);
  const Record& got = stop.source();
  Place next = place;
  ++next.j;
  const bool is_same_block = !tolerances_.compare_blocks || want.block == got.block;
  if (want.part == Part::stop && is_same_block && want.source().kind == got.kind) {
    const Record& due = want.source();
    const bool is_m = got.kind == RecordKind::m;
    if (is_m ? due.m == got.m
             : agree(due.seconds, got.seconds, tolerances_.resolution, tolerances_)) {
      reach_corner({next.pair, next.i + 1, next.j, next.m});
    }
  }
  if (const auto behind = behind_m(place, false)) reach_corner(*behind);
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
  // What leads to the new name from elsewhere is a motion, and none that is nil behind it, but
  // where one is due there.
  const Number& tau = tolerances_.tolerance;
  const Event& due = reference(place).at(place.i + 1);
  const bool is_nil_due = due.is_motion() && is_near(due.from, due.to, tau);
  const bool leads_there = got.is_motion() && !is_near(got.from, got.to, tau) &&
                           is_near(got.to, rational_near(pair.start), tau);
  const bool is_before = !tolerances_.compare_blocks || got.block <= renaming.block;
  if (leads_there && is_before && !is_nil_due) return;
  reach_corner({pair_for(pair), place.i + 1, 0, place.m});
}

// R8. What decides a step makes another side of the reference, equal up to it.
void Correspondence::settle(const Place& place, std::vector<Record> path, const Place& next,
                            bool is_unfit) {
  Settled settled = reference(place).settled();
  settled.insert_or_assign(reference(place).item_of(place.i), std::move(path));
  Pair pair = pairs_[place.pair];
  pair.reference = another_reference(place, std::move(settled));
  pair.is_unfit = pair.is_unfit || is_unfit;
  pairs_.push_back(std::move(pair));
  reach_corner({pairs_.size() - 1, next.i, next.j, next.m});
}

void Correspondence::take_free_step(const Place& place) {
  const auto step = reference(place).at(place.i).item;
  SubjectSide& side = subject(place);
  if (const auto* pocket = std::get_if<reference::HelixPocket>(&*step)) {
    for (auto& path : paths_of(*pocket, side, place.j, tolerances_.tolerance)) {
      settle(place, std::move(path), place, false);
    }
    return;
  }
  has_width_ = true;
  const Followed followed{side, place.j, tolerances_,
                          Slack(tolerances_, manner_.bias == Bias::outer)};
  StepAnswer answer;
  bool has_unfit = false;
  if (const auto* level = std::get_if<reference::PocketLevel>(&*step)) {
    answer = follow(*level, followed);
  } else if (const auto* pocket = std::get_if<reference::PocketMilling>(&*step)) {
    answer = follow(*pocket, followed);
  } else {
    const auto& thread = std::get<reference::ThreadMilling>(*step);
    const std::size_t most = outcome_.records.size();
    has_unfit = is_unfit(thread, followed, most);
    if (!thread.arc_path) answer = follow(thread, followed);
    for (auto& path : paths_of(thread, reference(place).at(place.i).from, followed, most)) {
      settle(place, std::move(path), place, has_unfit);
    }
  }
  // One motion to where the subject left it stands for the step.
  for (const std::size_t end : answer.ends) {
    const bool has_turned = std::ranges::any_of(manner_.turned, [&](std::size_t record) {
      return record >= side.at(place.j).record && record < side.at(end).record;
    });
    if (manner_.only_rounded && has_turned) continue;
    Record way;
    way.kind = RecordKind::feed;
    way.block = reference(place).at(place.i).block;
    way.axes = reference::kEveryAxis;
    way.to = side.place(end);
    settle(place, {way}, {place.pair, place.i + 1, end, place.m}, has_unfit);
  }
  if (!answer.broken.empty() && side.at(answer.broken_by).record >= broken_record_) {
    broken_record_ = side.at(answer.broken_by).record;
    broken_ = answer.broken;
    broken_at_ = {place.pair, place.i, answer.broken_by, place.m};
  }
}

}  // namespace gonogo::relation
