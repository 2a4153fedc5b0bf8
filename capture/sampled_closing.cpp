// SPDX-License-Identifier: GPL-3.0-or-later
//
// SampledRun's part for what is behind the machine: what the samples showed of the pieces that it
// has left, their feeds, and what is said at the end.
#include <fmt/format.h>

#include <algorithm>

#include "capture/sampled_judge.hpp"
#include "oracle/region/constants.hpp"
#include "oracle/steps/step_text.hpp"

namespace gonogo::oracle {
namespace {

constexpr std::size_t kNamedUnseen = 10;

}  // namespace

void SampledRun::note_visits() {
  for (auto& [spot, state] : states_) {
    const PathPiece& piece = *path_.piece(spot.piece);
    if (!piece.is_motion()) continue;
    Visit& visit = state.visit;
    const bool start = piece.before(state.place) <= 0;
    const bool end = piece.after(state.place) <= Tube::kUnsure;
    visit.start = visit.start || start;
    visit.end = visit.end || end;
    visit.inside = visit.inside || (!start && !end);
  }
}

// Pieces that every way passes unseen are; those that only some do wait for what becomes of them.
void SampledRun::note_unseen(std::size_t before) {
  std::set<std::size_t> some;
  for (auto& [spot, state] : states_) some.insert(state.unseen.begin(), state.unseen.end());
  std::erase_if(named_, [&](const auto& name) { return !some.contains(name.first); });
  for (const std::size_t i : some) {
    if (i >= before) break;
    if (i >= path_.first_kept()) {
      const PathPiece& piece = *path_.piece(i);
      named_[i] = piece.block() != 0 ? fmt::format("line {}", piece.block()) : piece.text();
    }
    const bool every = std::ranges::all_of(
        states_, [&](const auto& state) { return state.second.unseen.contains(i); });
    if (!every) continue;
    unseen_.push_back(named_[i]);
    named_.erase(i);
    for (auto& [at, state] : states_) state.unseen.erase(i);
  }
}

void SampledRun::watch_feeds(double time) {
  if (states_.size() != 1) return;
  const auto& [spot, state] = *states_.begin();
  const std::size_t i = spot.piece;
  const PathPiece& piece = *path_.piece(i);
  if (!piece.is_motion() || !piece.has_feed()) return;
  FeedWatch& watch = watches_.try_emplace(i, piece.speed(), granted_, clock_).first->second;
  watch.add(time, piece.along(state.place.low[0]), piece.along(state.place.high[0]), last_number_);
  note_feed(i, watch.too_fast_now());
}

void SampledRun::note_feed(std::size_t i, const std::optional<FeedWatch::Fault>& fault) {
  if (fault && !feed_fault_) feed_fault_ = feed_verdict(*path_.piece(i), *fault);
}

void SampledRun::close_pieces(std::size_t before) {
  note_unseen(before);
  for (; progress_ < before; ++progress_) {
    const PathPiece& piece = *path_.piece(progress_);
    if (!piece.is_motion()) continue;
    ++motions_;
    const auto watch = watches_.find(progress_);
    const FeedWatch::Finding feed =
        watch != watches_.end() ? watch->second.finding() : FeedWatch::Finding{};
    note_feed(progress_, feed.fault);
    if (piece.kind() != PieceKind::traverse) ++(feed.is_bounded ? feeds_ : feeds_open_);
    watches_.erase(progress_);
  }
  path_.drop_before(before);
}

// A stand is over when a sample lies elsewhere. How long the machine stood before the samples, or
// stands after the program, is of no dwell.
void SampledRun::watch_stands(const Position& at, double time) {
  if (!agree(at, stand_.at, tube_.tolerance * 2)) {
    const double beyond = stand_.until - stand_.since - stand_.due;
    if (!stand_.dwells.empty() && !stand_.is_first && beyond > kLongestStand) {
      long_stands_.push_back(fmt::format("{:.1f} s at the dwell of line {}, where {:g} s are due",
                                         stand_.until - stand_.since, stand_.block, stand_.due));
    }
    stand_ = {.at = at, .since = time};
  }
  stand_.until = time;
  for (const auto& [spot, state] : states_) {
    const PathPiece& piece = *path_.piece(spot.piece);
    if (piece.kind() != PieceKind::dwell || !stand_.dwells.insert(spot.piece).second) continue;
    stand_.due += piece.time();
    stand_.block = piece.block();
  }
}

void SampledRun::finish(bool in_hole) {
  if (in_hole) holes_.end_in_hole();
  if (departure_ || open_) return;
  if (!begun_) {
    Verdict verdict;
    verdict.kind = VerdictKind::fail_geometry;
    verdict.want = point_text(start_, seen_);
    verdict.record = 0;
    verdict.message = "No sample lies at the start position of the program.";
    if (first_) {
      verdict.got = sample_text(*first_, seen_);
      verdict.witness = point_text(first_->at, seen_);
    }
    departure_ = std::move(verdict);
    return;
  }
  const std::size_t farthest = states_.rbegin()->first.piece;
  State& state = states_.rbegin()->second;
  const PathPiece& piece = *path_.piece(farthest);
  at_end_ = piece.kind() == PieceKind::stand;
  if (piece.kind() == PieceKind::open) open_ = piece.gap();
  if (piece.kind() == PieceKind::dwell) {
    open_ = gap_verdict(
        GapReason::samples_end,
        fmt::format("The samples end before the dwell of line {} does.", piece.block()));
  }
  const bool complete = piece.is_motion() && piece.after(state.place) <= Tube::kUnsure;
  if (complete && !state.visit.shows()) state.unseen.insert(farthest);
  states_.erase(states_.begin(), std::prev(states_.end()));
  close_pieces(complete ? farthest + 1 : farthest);
}

std::string SampledRun::summary() const {
  std::string text = fmt::format(
      "From samples: {} motions followed; the feed of {} of them is bounded only, to within {} %, "
      "of {} not compared. Dwells may last {:g} s longer, and other stands are not compared.",
      motions_, feeds_, (sampled_.feed_tolerance * 100).text(), feeds_open_, kLongestStand);
  for (const std::string& stand : long_stands_) text += fmt::format(" It stands for {}.", stand);
  if (holes_.any()) text += holes_.holes_text();
  text += holes_.rate_text(approximate(sampled_.fastest));
  if (unseen_.empty()) return text;
  text += " Not checked, because no sample shows them:";
  for (std::size_t i = 0; i < unseen_.size() && i < kNamedUnseen; ++i) {
    text += fmt::format("{} {}", i == 0 ? "" : ",", unseen_[i]);
  }
  if (unseen_.size() > kNamedUnseen) {
    text += fmt::format(" and {} more", unseen_.size() - kNamedUnseen);
  }
  return text + ". Sample more often.";
}

}  // namespace gonogo::oracle
