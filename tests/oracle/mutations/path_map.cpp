// SPDX-License-Identifier: GPL-3.0-or-later
#include "path_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <tuple>

namespace gonogo::mutations {

using std::numbers::pi;

namespace {

constexpr double kRounding = 1e-8;  // mm, and radians: far above what doubles lose

// Where a place lies on a stroke: all parts at which it is within the margin.
std::vector<double> parts_of_line(const Stroke& line, const Place& place, double margin) {
  double low = 0;
  double high = 1;
  const auto distance = [&](double part) { return apart(line.at(part), place); };
  constexpr int kSteps = 90;
  for (int i = 0; i < kSteps; ++i) {
    const double third = (high - low) / 3;
    if (distance(low + third) <= distance(high - third)) {
      high -= third;
    } else {
      low += third;
    }
  }
  if (distance(low) <= margin) return {low};
  return {};
}

double angle_at(const Stroke& arc, const Place& place) {
  double along_u = 0;
  double along_v = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    along_u += (place[i] - arc.centre[i]) * arc.u[i];
    along_v += (place[i] - arc.centre[i]) * arc.v[i];
  }
  return std::atan2(along_v, along_u);
}

std::vector<double> parts_of_arc(const Stroke& arc, const Place& place, double margin) {
  std::vector<double> parts;
  const auto note = [&](double part) {
    if (apart(arc.at(part), place) <= margin) parts.push_back(part);
  };
  note(0);
  note(1);
  const double sense = arc.sweep < 0 ? -1 : 1;
  const double sweep = std::abs(arc.sweep);
  if (sweep < kRounding) return parts;
  double angle = sense * (angle_at(arc, place) - arc.start_angle);
  angle -= 2 * pi * std::floor(angle / (2 * pi));
  for (; angle < sweep; angle += 2 * pi) note(angle / sweep);
  return parts;
}

bool same_feed(const Record& a, const Record& b) {
  return a.feed_mode == b.feed_mode && a.feed == b.feed;
}

bool is_cut(RecordKind kind) {
  return kind == RecordKind::feed || kind == RecordKind::arc || kind == RecordKind::arc3;
}

bool same_start_angle(const Number& a, const Number& b) {
  return ((a - b) / 360).to_int64().has_value();
}

// Whether what the records say beside their geometry agrees.
bool same_words(const Record& got, const Record& want) {
  if (got.block != want.block) return false;
  if (is_cut(got.kind) && is_cut(want.kind)) return same_feed(got, want);
  if (got.kind != want.kind) return false;
  if (got.kind == RecordKind::dwell) return got.seconds == want.seconds;
  if (got.kind != RecordKind::thread) return true;
  return got.lead == want.lead && same_start_angle(got.start, want.start);
}

// A traverse as part of another: on every axis towards its end, none beyond.
bool traverse_fits(const Stroke& got, const Stroke& want, double margin) {
  for (std::size_t i = 0; i < got.from.size(); ++i) {
    const double low = std::min(want.from[i], want.to[i]) - margin;
    const double high = std::max(want.from[i], want.to[i]) + margin;
    if (got.from[i] < low || got.from[i] > high || got.to[i] < low || got.to[i] > high)
      return false;
    const double step = (got.to[i] - got.from[i]) * (want.to[i] < want.from[i] ? -1 : 1);
    if (step < -margin) return false;
  }
  return true;
}

bool arc_fits(const Stroke& got, const Stroke& want, double from, double to, const Margin& margin) {
  const double radius = std::max(want.from_radius, want.to_radius);
  if (radius <= 8 * margin.arc) return !margin.strict;  // too small to be told
  const double slack = 4 * margin.arc / std::min(radius, 1.0e3) + 1e-7;
  for (std::size_t i = 0; i < 3; ++i) {
    if (got.u[i] == 0 && got.v[i] == 0) continue;
    if (std::abs(got.centre[i] - want.centre[i]) > margin.place) return false;
  }
  // An arc too small to show its sense does not prove the other sense right: what turns nearly
  // all the way round against it is no piece of it (R2).
  if ((got.sweep < 0) != (want.sweep < 0) &&
      (margin.strict || std::abs(want.sweep) * (to - from) > slack)) {
    return false;
  }
  const double least = std::max(std::min(want.from_radius, want.to_radius), margin.arc);
  const double wide = std::min(1.0, 4 * margin.arc / least) + 1e-7;
  return std::abs(got.sweep - want.sweep * (to - from)) <= wide;
}

// Place by place, in proportion: for curves of two kinds.
bool lies_along(const Stroke& got, const Stroke& want, double from, double to, double margin) {
  constexpr int kPlaces = 8;
  for (int i = 1; i < kPlaces; ++i) {
    const double part = static_cast<double>(i) / kPlaces;
    if (apart(got.at(part), want.at(from + (to - from) * part)) > margin) return false;
  }
  return true;
}

bool piece_fits(const Stroke& got, const Stroke& want, double from, double to,
                const Margin& margin) {
  if (!same_words(*got.record, *want.record)) return false;
  switch (want.kind()) {
    case RecordKind::rapid:
      return traverse_fits(got, want, margin.place);
    case RecordKind::thread:
      return true;
    default:
      break;
  }
  if (got.kind() == RecordKind::arc && want.kind() == RecordKind::arc) {
    return got.record->plane == want.record->plane && arc_fits(got, want, from, to, margin);
  }
  if (!got.is_round && !want.is_round) return true;
  if (margin.strict && got.is_round != want.is_round) return false;
  return lies_along(got, want, from, to, margin.arc);
}

// Along one axis alone; nothing where more than one moves.
std::optional<std::size_t> only_axis(const Stroke& stroke) {
  std::optional<std::size_t> only;
  for (std::size_t i = 0; i < stroke.from.size(); ++i) {
    if (std::abs(stroke.to[i] - stroke.from[i]) <= kRounding / 10) continue;
    if (only) return std::nullopt;
    only = i;
  }
  return only;
}

bool goes_on_straight(const Stroke& first, const Stroke& second) {
  double forward = 0;
  for (std::size_t i = 0; i < first.from.size(); ++i) {
    forward += (first.to[i] - first.from[i]) * (second.to[i] - second.from[i]);
  }
  if (forward <= 0) return false;
  Stroke chord = first;
  chord.to = second.to;
  return !parts_of_line(chord, first.to, kRounding).empty();
}

bool goes_on_round(const Stroke& first, const Stroke& second) {
  if (first.kind() != RecordKind::arc || second.kind() != RecordKind::arc) return false;
  if (first.record->plane != second.record->plane) return false;
  if (first.sweep * second.sweep <= 0) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (first.u[i] == 0 && first.v[i] == 0) continue;
    if (std::abs(first.centre[i] - second.centre[i]) > kRounding / 10) return false;
  }
  // Radius and height as linear in the angle as before.
  const auto steps_alike = [&](double one, double other) {
    return std::abs(one / first.sweep - other / second.sweep) <= kRounding / 10;
  };
  if (!steps_alike(first.to_radius - first.from_radius, second.to_radius - second.from_radius)) {
    return false;
  }
  for (std::size_t i = 0; i < first.from.size(); ++i) {
    if (i < 3 && (first.u[i] != 0 || first.v[i] != 0)) continue;
    if (!steps_alike(first.to[i] - first.from[i], second.to[i] - second.from[i])) return false;
  }
  return true;
}

bool goes_on(const Stroke& first, const Stroke& second) {
  if (first.is_dwell() || first.kind() != second.kind()) return false;
  if (!same_words(*first.record, *second.record)) return false;
  if (first.kind() == RecordKind::rapid) {
    const auto axis = only_axis(first);
    if (!axis || only_axis(second) != axis) return false;
  }
  if (first.is_round != second.is_round) return false;
  return first.is_round ? goes_on_round(first, second) : goes_on_straight(first, second);
}

struct State {
  std::size_t element = 0;
  double part = 0;
  bool opened = false;  // an open part was read otherwise than it is shown
  friend bool operator<(const State& a, const State& b) {
    return std::tie(a.element, a.part, a.opened) < std::tie(b.element, b.part, b.opened);
  }
};

using States = std::set<State>;

class Mapping {
 public:
  Mapping(std::span<const PathElement> path, std::span<const Stroke> got, const Margin& margin)
      : margin_(margin), path_(path), got_(got), states_(got.size() + 1) {
    for (std::size_t i = 0; i < path.size(); ++i) {
      first_.push_back(all_.size());
      for (const Stroke& stroke : path[i].strokes) {
        all_.push_back(&stroke);
        element_of_.push_back(i);
      }
    }
  }

  MapResult run() {
    states_[0].insert(State{});
    // Where the tool stands, in the names of the start.
    Place here{};
    if (!all_.empty()) here = all_[0]->unnamed(all_[0]->from);
    for (std::size_t j = 0; j <= got_.size(); ++j) {
      if (j > 0) here = got_[j - 1].unnamed(got_[j - 1].to);
      pass_on(j, here);
      if (states_[j].empty()) continue;
      result_.reached = j;
      if (j == got_.size()) break;
      for (const State& state : states_[j]) read_stroke(state, j);
    }
    for (const State& state : states_[got_.size()]) {
      if (state.element != all_.size()) continue;
      if (!state.opened) {
        result_.fit = Fit::along;
        break;
      }
      result_.fit = Fit::open;
    }
    return result_;
  }

 private:
  // What can be passed without a motion of the subject's.
  void pass_on(std::size_t j, const Place& here) {
    std::vector<State> ahead(states_[j].begin(), states_[j].end());
    while (!ahead.empty()) {
      const State state = ahead.back();
      ahead.pop_back();
      if (state.element == all_.size()) continue;
      const Stroke& want = *all_[state.element];
      const auto move_to = [&](State next) {
        if (states_[j].insert(next).second) ahead.push_back(next);
      };
      if (is_first_of_open(state)) {
        if (const auto empty = read_open_part(state, j)) move_to(*empty);
      }
      if (is_nil(want) || (!want.is_dwell() && is_at_end(state, want, here))) {
        move_to({state.element + 1, 0, state.opened});
      }
    }
  }

  bool is_at_end(const State& state, const Stroke& want, const Place& here) const {
    if (apart(want.unnamed(want.to), here) > margin_.place) return false;
    if (!want.is_round) return true;
    const double radius = std::max(want.from_radius, want.to_radius);
    const double slack = (4 * margin_.arc + kRounding) / std::max(radius, margin_.arc);
    return std::abs(want.sweep) * (1 - state.part) <= slack;
  }

  bool is_first_of_open(const State& state) const {
    const std::size_t element = element_of_[state.element];
    return path_[element].open != nullptr && first_[element] == state.element && state.part == 0;
  }

  // Any run of motions of its block may be the open part. Where it ends elsewhere than the path
  // that is shown, what follows is no longer followed. Gives what comes after no motion at all.
  std::optional<State> read_open_part(const State& state, std::size_t j) {
    const std::size_t element = element_of_[state.element];
    const PathElement& part = path_[element];
    const std::uint64_t block = part.strokes.front().record->block;
    const std::size_t after = first_[element] + part.strokes.size();
    std::optional<State> nothing;
    for (std::size_t k = j; k <= got_.size(); ++k) {
      if (k > j && got_[k - 1].record->block != block) break;
      // What is left in the block afterwards is as much as in the right path, or nearly.
      const std::size_t left = rest_of_block(k, block);
      const std::size_t due = rest_of_path(after, block);
      if (left > due + kMoreAfter) continue;
      const std::string broken = part.open->broken_by(got_.subspan(j, k - j), margin_);
      if (!broken.empty()) {
        if (left == due) result_.broken = broken;
        continue;
      }
      const Place& here = k > 0 ? got_[k - 1].to : part.strokes.front().from;
      if (apart(here, part.strokes.back().to) > margin_.place) {
        states_[got_.size()].insert({all_.size(), 0, true});
      } else if (k > j) {
        states_[k].insert({after, 0, true});
      } else {
        nothing = State{after, 0, true};
      }
    }
    return nothing;
  }

  std::size_t rest_of_block(std::size_t from, std::uint64_t block) const {
    std::size_t end = from;
    while (end < got_.size() && got_[end].record->block == block) ++end;
    return end - from;
  }

  std::size_t rest_of_path(std::size_t from, std::uint64_t block) const {
    std::size_t end = from;
    while (end < all_.size() && all_[end]->record->block == block) ++end;
    return end - from;
  }

  void read_stroke(const State& state, std::size_t j) {
    const Stroke& got = got_[j];
    if (is_nil(got)) {
      states_[j + 1].insert(state);
    }
    if (state.element == all_.size()) return;
    const Stroke& want = *all_[state.element];
    if (want.is_dwell() || got.is_dwell()) {
      if (want.is_dwell() && got.is_dwell() && same_words(*got.record, *want.record)) {
        states_[j + 1].insert({state.element + 1, 0, state.opened});
      }
      return;
    }
    if (want.kind() == RecordKind::rapid) {
      if (piece_fits(got, want, 0, 0, margin_)) states_[j + 1].insert(state);
      return;
    }
    const auto parts = want.is_round ? parts_of_arc(want, got.to, margin_.place)
                                     : parts_of_line(want, got.to, margin_.place);
    const double back = slack_of(want);
    for (const double part : parts) {
      if (part < state.part - back) continue;
      if (!piece_fits(got, want, state.part, part, margin_)) continue;
      states_[j + 1].insert({state.element, part, state.opened});
    }
  }

  bool is_nil(const Stroke& stroke) const {
    return margin_.strict ? stroke.is_surely_nil(margin_.nil) : stroke.is_nil(margin_.nil);
  }

  // How far back along a stroke is still the same place.
  double slack_of(const Stroke& want) const {
    double length = apart(want.from, want.to);
    if (want.is_round) {
      length = std::max(length, std::abs(want.sweep) * std::max(want.from_radius, want.to_radius));
    }
    const double back = margin_.strict ? margin_.place / 2 : 2 * margin_.place;
    return std::min(1.0, back / std::max(length, margin_.place));
  }

  static constexpr std::size_t kMoreAfter = 2;
  const Margin& margin_;
  std::span<const PathElement> path_;
  std::span<const Stroke> got_;
  std::vector<States> states_;  // after so many motions
  std::vector<const Stroke*> all_;
  std::vector<std::size_t> element_of_;
  std::vector<std::size_t> first_;
  MapResult result_;
};

}  // namespace

std::vector<Stroke> joined(std::span<const Stroke> strokes) {
  std::vector<Stroke> all;
  for (const Stroke& stroke : strokes) {
    if (stroke.is_nil(kRounding / 100)) continue;
    if (!all.empty() && goes_on(all.back(), stroke)) {
      all.back().to = stroke.to;
      all.back().to_radius = stroke.to_radius;
      if (stroke.is_round) all.back().sweep += stroke.sweep;
      // In pieces it is known whether it is a turn.
      all.back().meets_itself = stroke.is_round;
    } else {
      all.push_back(stroke);
    }
  }
  return all;
}

MapResult map_onto(std::span<const PathElement> path, std::span<const Stroke> got,
                   const Margin& margin) {
  return Mapping(path, got, margin).run();
}

}  // namespace gonogo::mutations
