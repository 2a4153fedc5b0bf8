// SPDX-License-Identifier: GPL-3.0-or-later
//
// SampledRun's part for what departs: why no place of the path fits a sample, as a verdict.
#include <fmt/format.h>

#include <algorithm>

#include "capture/sampled_judge.hpp"
#include "oracle/steps/step_text.hpp"

namespace gonogo::oracle {
namespace {

constexpr std::size_t kSamplesAhead = 500;

bool is_cut(const PathPiece& piece) {
  return piece.kind() == PieceKind::line || piece.kind() == PieceKind::round;
}

void measure(Verdict& verdict, const Number& deviation) {
  if (deviation.sign() == 0) return;
  verdict.deviation_exact = exact_text(deviation);
  verdict.deviation_mm = millimetres_text(deviation);
}

}  // namespace

Verdict SampledRun::verdict_at(VerdictKind kind, const PathPiece& piece,
                               const std::string& message) const {
  Verdict verdict;
  verdict.kind = kind;
  verdict.clause = piece.clause();
  verdict.block = piece.block();
  verdict.want = piece.text();
  verdict.message = message;
  return verdict;
}

Verdict SampledRun::feed_verdict(const PathPiece& piece, const FeedWatch::Fault& fault) const {
  const double programmed = piece.speed() * kSecondsAMinute;
  const bool in_degrees = turns_alone(piece.motion().record, piece.motion().from);
  Verdict verdict = verdict_at(
      VerdictKind::fail_feed, piece,
      fmt::format("The samples bound the feed to {:.3f} .. {:.3f} {}, {:.3f} are programmed.",
                  fault.bounds.low * kSecondsAMinute, fault.bounds.high * kSecondsAMinute,
                  reference::feed_unit(reference::FeedMode::per_minute, in_degrees), programmed));
  verdict.word = 'F';
  verdict.record = fault.number;
  return verdict;
}

std::optional<std::size_t> SampledRun::fits(const SamplePoint& point, std::size_t first,
                                            std::size_t count) {
  for (std::size_t i = first; i < first + count; ++i) {
    const PathPiece* piece = path_.piece(i);
    if (piece == nullptr) break;
    const bool counts = is_cut(*piece) || stands_on(i);
    if (counts && !stretches(i, point).empty()) return i;
  }
  return std::nullopt;
}

void SampledRun::depart(const Sample& sample, const SamplePoint& point) {
  Verdict verdict = states_.empty() ? departure_at_start(sample) : departure_of(sample, point);
  verdict.record = sample.number;
  verdict.got = sample_text(sample, seen_);
  if (verdict.witness.empty()) verdict.witness = point_text(sample.at, seen_);
  departure_ = std::move(verdict);
}

Verdict SampledRun::departure_at_start(const Sample& sample) const {
  Verdict verdict;
  verdict.kind = VerdictKind::fail_geometry;
  verdict.want = point_text(start_, seen_);
  verdict.message = "The samples do not begin at the start position of the program.";
  measure(verdict, largest_difference(sample.at, start_));
  return verdict;
}

Verdict SampledRun::departure_of(const Sample& sample, const SamplePoint& point) {
  const std::size_t first = states_.begin()->first.piece;
  const PathPiece& piece = *path_.piece(states_.rbegin()->first.piece);
  if (piece.kind() == PieceKind::stand) {
    left_end_ = true;
    last_at_ = sample.at;
    Verdict verdict = verdict_at(VerdictKind::fail_overrun, piece,
                                 "The machine moves after the end of the program.");
    measure(verdict, largest_difference(sample.at, piece.motion().from));
    return verdict;
  }
  if (piece.kind() == PieceKind::dwell) {
    return verdict_at(VerdictKind::fail_geometry, piece,
                      "The machine does not stand still for as long as the dwell lasts.");
  }
  if (const auto later = fits(point, first, kSamplesAhead)) return departure_towards(*later, sample);
  const std::size_t kept = path_.first_kept();
  if (fits(point, kept, first - kept)) {
    return verdict_at(VerdictKind::fail_order, piece,
                      "The machine goes back to an earlier motion.");
  }
  return departure_from_path(sample);
}

Verdict SampledRun::departure_towards(std::size_t later, const Sample& sample) {
  const std::size_t frontier = states_.rbegin()->first.piece;
  const PathPiece& piece = *path_.piece(frontier);
  if (stands_on(later)) {
    Verdict verdict = verdict_at(VerdictKind::fail_geometry, *path_.piece(later),
                                 "The machine goes back along the motion.");
    measure(verdict, largest_difference(sample.at, last_at_));
    return verdict;
  }
  if (later == frontier + 1) {
    const Position& corner = piece.motion().to();
    Verdict verdict = verdict_at(VerdictKind::fail_geometry, piece,
                                 "The machine does not come to the end of the motion.");
    measure(verdict,
            min(largest_difference(corner, last_at_), largest_difference(corner, sample.at)));
    verdict.witness = point_text(corner, seen_);
    return verdict;
  }
  return verdict_at(VerdictKind::fail_order, *path_.piece(frontier + 1),
                    "The machine leaves out this motion and goes on to a later one.");
}

Verdict SampledRun::departure_from_path(const Sample& sample) {
  const std::size_t frontier = states_.rbegin()->first.piece;
  const PathPiece* nearest = path_.piece(frontier);
  std::optional<Number> least;
  for (std::size_t i = states_.begin()->first.piece; i <= frontier + 1; ++i) {
    const PathPiece* each = path_.piece(i);
    if (each == nullptr) break;
    if (each->kind() == PieceKind::open) continue;
    const Number deviation = each->deviation(sample.at);
    if (least && *least <= deviation) continue;
    least = deviation;
    nearest = each;
  }
  Verdict verdict =
      verdict_at(VerdictKind::fail_geometry, *nearest, "The machine leaves the path.");
  if (least) measure(verdict, *least);
  return verdict;
}

}  // namespace gonogo::oracle
