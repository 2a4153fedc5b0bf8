// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/sampled_judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "oracle/steps/step_text.hpp"

namespace gonogo::oracle {
namespace {

using reference::Axis;
using reference::kAllAxes;

constexpr double kTimeNoise = 1e-9;  // s; of sums of doubles
constexpr double kCorner = 20;       // times the allowance for blending: how far a corner reaches

double half_unit(int decimals) {
  return 0.5 * std::pow(10.0, -decimals);
}

}  // namespace

std::string sample_text(const Sample& sample, reference::AxisSet seen) {
  std::string text = "{\"t\":";
  sample.time.append_json(text);
  const std::string point = point_text(sample.at, seen);
  return text + (point.size() > 2 ? "," : "") + point.substr(1);
}

SampledRun::SampledRun(const reference::Profile& profile, const ProgramText& program,
                       const Tolerances& tolerances, const SampledTolerances& sampled,
                       reference::AxisSet seen, bool strict, double way_factor)
    : sampled_(sampled),
      path_(profile, program, tolerances, seen, approximate(sampled.fastest)),
      tube_{tolerances.tolerance, approximate(tolerances.tolerance), strict},
      start_(profile.initial.at),
      seen_(seen),
      way_factor_(way_factor),
      granted_(approximate(sampled.feed_tolerance)),
      clock_(half_unit(sampled.time_decimals)),
      wide_{tolerances.tolerance + sampled.blend, approximate(tolerances.tolerance + sampled.blend),
            strict},
      corner_(kCorner * approximate(sampled.blend)),
      holes_(sampled.usual_interval, sampled.longest_interval),
      last_at_(start_) {}

const std::vector<Stretch>& SampledRun::stretches(std::size_t i, const SamplePoint& point) {
  const auto [found, fresh] = cache_.try_emplace(i);
  if (fresh) path_.piece(i)->stretches(point, tube_, found->second);
  return found->second;
}

const std::vector<Stretch>& SampledRun::wide_stretches(std::size_t i, const SamplePoint& point) {
  const auto [found, fresh] = wide_cache_.try_emplace(i);
  const PathPiece& piece = *path_.piece(i);
  if (fresh && sampled_.blend.sign() > 0 && piece.is_motion()) {
    piece.stretches(point, wide_, found->second);
  }
  return found->second;
}

// The state that admits more holds: it began earlier, and lies no farther along.
void SampledRun::merge(States& states, Spot spot, State state) {
  const auto [found, fresh] = states.try_emplace(spot, state);
  if (fresh) return;
  State& known = found->second;
  bool earlier = true;
  for (std::size_t axis = 0; axis < reference::kAxes; ++axis) {
    earlier = earlier && state.place.low[axis] <= known.place.low[axis];
  }
  if (earlier) known.place = state.place;
  known.since = std::min(known.since, state.since);
  known.open_since = known.open_since || state.open_since;
  known.visit.start = known.visit.start && state.visit.start;
  known.visit.inside = known.visit.inside && state.visit.inside;
  known.visit.end = known.visit.end && state.visit.end;
  known.unseen.insert(state.unseen.begin(), state.unseen.end());
}

// From a place on one piece, seen by the sample before, to one on a later piece: the piece that is
// left and those between count as seen where samples show them, or both their ends.
void SampledRun::enter(std::size_t from, const State& before, Spot spot, const Stretch& place,
                       States& next) {
  const std::size_t i = spot.piece;
  const PathPiece& left = *path_.piece(from);
  const PathPiece& piece = *path_.piece(i);
  State state{place, last_time_, false, {}, before.unseen};
  const bool at_start = !piece.is_motion() || piece.before(place) <= 0;
  const bool from_end = !left.is_motion() || left.after(before.place) <= Tube::kUnsure;
  if (left.is_motion()) {
    Visit visit = before.visit;
    visit.end = visit.end || (i == from + 1 && at_start);
    if (!visit.shows()) state.unseen.insert(from);
  }
  const bool joins_two = i == from + 2 && from_end && at_start;
  for (std::size_t between = from + 1; between < i; ++between) {
    if (path_.piece(between)->is_motion() && !joins_two) state.unseen.insert(between);
  }
  state.visit.start = i == from + 1 && from_end;
  merge(next, spot, std::move(state));
}

// The longest that the machine may have stood at a dwell.
double SampledRun::stood(const State& state, double time) const {
  return time - state.since + 2 * clock_ + (tube_.strict ? -kTimeNoise : kTimeNoise);
}

// s, the least that a piece takes, and what leads to a place on it; what is granted is granted of
// feeds.
double SampledRun::least_time(const PathPiece& piece) const {
  return piece.is_motion() ? piece.time() / feed_factor() : piece.time();
}
double SampledRun::least_time_to(const PathPiece& piece, const Stretch& place) const {
  return piece.is_motion() ? piece.before(place) / (piece.speed() * feed_factor()) : 0;
}

// Off the motion to which a corner led it has to come back first, unless it is a short one.
bool SampledRun::may_pass(Spot spot) const {
  return spot.phase != Phase::arriving || path_.kept(spot.piece).length() <= corner_;
}

// On to later pieces as far as their feeds allow in the time since the last sample.
void SampledRun::go_on(Spot spot, State& state, const SamplePoint& point, double time,
                       States& next) {
  if (!may_pass(spot)) return;
  const std::size_t from = spot.piece;
  const PathPiece& here = *path_.piece(from);
  if (here.kind() == PieceKind::stand || here.kind() == PieceKind::open) return;
  const double noise = tube_.strict ? -kTimeNoise : kTimeNoise;
  double spent = 0;
  if (here.kind() == PieceKind::dwell) {
    if (stood(state, time) < here.time()) {
      // As long as it stands there it may be dwelling still.
      if (!state.open_since || !stretches(from, point).empty()) return;
      state.unseen.insert(from);
    }
  } else {
    spent = here.after(state.place) / (here.speed() * feed_factor());
  }
  const double budget = time - last_time_ + 2 * clock_ + noise;
  for (std::size_t i = from + 1; spent <= budget; ++i) {
    const PathPiece* piece = path_.piece(i);
    if (piece == nullptr) return;
    for (const Stretch& stretch : stretches(i, point)) {
      if (spent + least_time_to(*piece, stretch) > budget) continue;
      enter(from, state, {i}, stretch, next);
      break;
    }
    if (i == from + 1 && here.is_motion() && stretches(i, point).empty()) {
      for (const Stretch& stretch : wide_stretches(i, point)) {
        const bool in_time = spent + least_time_to(*piece, stretch) <= budget;
        if (!in_time || !near_corner({i, Phase::arriving}, stretch)) continue;
        enter(from, state, {i, Phase::arriving}, stretch, next);
        break;
      }
    }
    if (piece->kind() == PieceKind::stand || piece->kind() == PieceKind::open) return;
    spent += least_time(*piece);
  }
}

// Farther along the same piece; false when no place of it lies there.
bool SampledRun::stay(Spot spot, const State& state, const std::vector<Stretch>& places,
                      States& next) {
  for (const Stretch& stretch : places) {
    State stays = state;
    stays.place = stretch;
    if (!stays.place.go_on_from(state.place.low) || !near_corner(spot, stays.place)) continue;
    merge(next, spot, std::move(stays));
    return true;
  }
  return false;
}

// Off the path it may be near the corner that it cuts alone.
bool SampledRun::near_corner(Spot spot, const Stretch& place) const {
  if (spot.phase == Phase::followed) return true;
  const PathPiece& piece = path_.kept(spot.piece);
  const double way = spot.phase == Phase::leaving ? piece.after(place) : piece.before(place);
  return way <= corner_;
}

void SampledRun::step(const SamplePoint& point, double time, States& next) {
  for (auto& [spot, state] : states_) {
    const std::size_t i = spot.piece;
    if (!stay({i}, state, stretches(i, point), next)) {
      const Phase away = spot.phase == Phase::arriving ? Phase::arriving : Phase::leaving;
      stay({i, away}, state, wide_stretches(i, point), next);
    }
    go_on(spot, state, point, time, next);
  }
}

bool SampledRun::stands_on(std::size_t i) const {
  return std::ranges::any_of(states_, [&](const auto& state) { return state.first.piece == i; });
}

// The least tube that the sample lies in, found where it lies outside the worst so far.
void SampledRun::note_worst(const Sample& sample, const SamplePoint& point) {
  constexpr int kMostSteps = 20;
  std::vector<Stretch> found;
  std::optional<WorstSample> least;
  off_ = std::numeric_limits<double>::infinity();
  for (const auto& [spot, state] : states_) {
    const PathPiece& piece = *path_.piece(spot.piece);
    if (piece.kind() == PieceKind::open) return;
    off_ = std::min(off_, piece.off(point));
    const auto lies_within = [&](const Number& tolerance) {
      found.clear();
      piece.stretches(point, Tube{tolerance, approximate(tolerance), true}, found);
      return !found.empty();
    };
    if (lies_within(worst_.deviation)) return;
    Number low = 0;
    Number high = Number::millionths(100);
    for (int i = 0; i < kMostSteps && !lies_within(high); ++i) {
      low = high;
      high = high * 2;
    }
    while (high - low > Number::millionths(100)) {
      const Number half =
          low + Number::millionths(100) * ((high - low) / Number::millionths(200)).floor();
      (lies_within(half) ? high : low) = half;
    }
    if (!least || high < least->deviation) least = {high, {}, piece.block()};
  }
  if (!least || least->deviation <= worst_.deviation) return;
  worst_ = *std::move(least);
  worst_.sample = sample_text(sample, seen_);
}

// The first sample stands at the start; or where the machine comes from there since the last line
// of the header.
bool SampledRun::begin(const SamplePoint& point, double time) {
  double spent = 0;
  const double budget = time - last_time_ + kTimeNoise;
  std::set<std::size_t> passed;
  for (std::size_t i = 0; spent <= budget; ++i) {
    const PathPiece* piece = path_.piece(i);
    if (piece == nullptr) break;
    for (const Stretch& stretch : stretches(i, point)) {
      if (spent + least_time_to(*piece, stretch) > budget) continue;
      merge(states_, {i}, {stretch, time, true, {}, passed});
      break;
    }
    if (piece->kind() == PieceKind::stand || piece->kind() == PieceKind::open) break;
    spent += least_time(*piece);
    passed.insert(i);
  }
  return !states_.empty();
}

bool SampledRun::take(const Sample& given) {
  if (departure_ || open_) return false;
  Sample sample = given;
  for (Axis axis : kAllAxes) {
    if (!seen_.has(axis)) sample.at[axis] = start_[axis];
  }
  if (sampled_.x_scale != Number(1)) sample.at[Axis::x] = sample.at[Axis::x] * sampled_.x_scale;
  const double time = quick(sample.time);
  if (!first_) first_ = sample;
  const bool in_header = sample.block != 0 && sample.block <= sampled_.header_lines;
  const SamplePoint point(sample);
  cache_.clear();
  wide_cache_.clear();
  if (!begun_) {
    const bool approach =
        sampled_.header_lines > 0 && !header_seen_ && !agree(sample.at, start_, tube_.tolerance);
    if (in_header || approach) {
      last_time_ = time;
      header_seen_ = in_header;
      holes_.take(sample, false, 0);
      return true;
    }
    if (!header_seen_) last_time_ = time;
    begun_ = begin(point, time);
    stand_ = {.at = sample.at, .since = time, .is_first = true};
    if (!begun_) depart(sample, point);
  } else {
    States next;
    step(point, time, next);
    if (next.empty()) {
      depart(sample, point);
    } else {
      states_ = std::move(next);
    }
  }
  if (departure_) return false;
  last_time_ = time;
  last_at_ = sample.at;
  moved_ = moved_ || !agree(sample.at, start_, tube_.tolerance);
  last_number_ = sample.number;
  note_worst(sample, point);
  note_visits();
  watch_feeds(time);
  watch_stands(sample.at, time);
  close_pieces(states_.begin()->first.piece);
  const PathPiece& least = *path_.piece(states_.begin()->first.piece);
  holes_.take(sample, true, least.block());
  if (least.kind() == PieceKind::open) open_ = least.gap();
  return !open_;
}

}  // namespace gonogo::oracle
