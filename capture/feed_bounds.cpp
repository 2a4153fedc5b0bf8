// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/feed_bounds.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace gonogo::oracle {
namespace {

constexpr std::size_t kQuarters = 4;
constexpr std::size_t kFewest = 2 * kQuarters;  // samples in the middle half
constexpr std::size_t kMostSamples = 100'000;   // samples of one motion that are kept

}  // namespace

void FeedWatch::add(double time, double low, double high, std::size_t number) {
  // As far as it is known the machine still rests at the start.
  if (places_.size() == 1 && places_.front().low <= 0 && low <= 0) places_.clear();
  if (places_.size() == kMostSamples) {  // every other one says as much of a motion so long
    for (std::size_t i = 0; i < kMostSamples / 2; ++i) places_[i] = places_[2 * i];
    places_.resize(kMostSamples / 2);
  }
  places_.push_back({time, low, high, number});
}

FeedBounds FeedWatch::between(const Place& a, const Place& b) const {
  const double least = b.time - a.time - 2 * clock_;
  const double most = b.time - a.time + 2 * clock_;
  FeedBounds bounds;
  bounds.low = std::max(0.0, b.low - a.high) / most;
  bounds.high = least > 0 ? (b.high - a.low) / least : std::numeric_limits<double>::infinity();
  return bounds;
}

std::optional<FeedWatch::Fault> FeedWatch::too_fast_now() const {
  if (places_.size() < 2) return std::nullopt;
  const FeedBounds bounds = between(places_[places_.size() - 2], places_.back());
  if (!too_fast(bounds)) return std::nullopt;
  return Fault{bounds, places_.back().number};
}

std::optional<FeedWatch::Fault> FeedWatch::fault() const {
  if (places_.size() < 2) return std::nullopt;
  const FeedBounds whole = between(places_.front(), places_.back());
  if (too_fast(whole)) return Fault{whole, places_.back().number};
  const std::size_t count = places_.size();
  const std::size_t first = count / 4;
  const std::size_t last = count - 1 - count / 4;
  if (last < first + kFewest) return std::nullopt;
  const FeedBounds middle = between(places_[first], places_[last]);
  double slowest = std::numeric_limits<double>::infinity();
  double fastest = 0;
  for (std::size_t i = 0; i < kQuarters; ++i) {
    const Place& a = places_[first + (last - first) * i / kQuarters];
    const Place& b = places_[first + (last - first) * (i + 1) / kQuarters];
    const FeedBounds bounds = between(a, b);
    if (too_fast(bounds)) return Fault{bounds, b.number};
    const double mean = ((b.low + b.high) - (a.low + a.high)) / 2 / (b.time - a.time);
    slowest = std::min(slowest, mean);
    fastest = std::max(fastest, mean);
  }
  const bool steady = slowest >= fastest * (1 - granted_);
  if (steady && middle.high < feed_ * (1 - granted_)) return Fault{middle, places_[last].number};
  return std::nullopt;
}

}  // namespace gonogo::oracle
