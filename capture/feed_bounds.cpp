// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/feed_bounds.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "oracle/region/constants.hpp"

namespace gonogo::oracle {
namespace {

constexpr std::size_t kQuarters = 4;
constexpr std::size_t kFewest = 2 * kQuarters;  // samples in the middle half
constexpr std::size_t kMostSamples = 100'000;   // samples of one motion that are kept

// Whether speeds rise and then fall, but for changes within that part of them.
bool is_ramp(const std::array<double, kQuarters>& speeds, double part) {
  bool falls = false;
  for (std::size_t i = 1; i < speeds.size(); ++i) {
    if (falls && speeds[i - 1] < speeds[i] * part) return false;
    falls = falls || speeds[i] < speeds[i - 1] * part;
  }
  return true;
}

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

FeedWatch::Finding FeedWatch::finding() const {
  if (places_.size() < 2) return {};
  const FeedBounds whole = between(places_.front(), places_.back());
  if (too_fast(whole)) return {Fault{whole, places_.back().number}, true};
  const std::size_t count = places_.size();
  const std::size_t first = count / 4;
  const std::size_t last = count - 1 - count / 4;
  if (last < first + kFewest) return {};
  return slowness(first, last);
}

// In the middle half of the motion, from one place to another.
FeedWatch::Finding FeedWatch::slowness(std::size_t first, std::size_t last) const {
  std::array<double, kQuarters> means{};
  Fault fastest;
  for (std::size_t i = 0; i < kQuarters; ++i) {
    const Place& a = places_[first + (last - first) * i / kQuarters];
    const Place& b = places_[first + (last - first) * (i + 1) / kQuarters];
    const FeedBounds bounds = between(a, b);
    if (too_fast(bounds)) return {Fault{bounds, b.number}, true};
    means[i] = ((b.low + b.high) - (a.low + a.high)) / 2 / (b.time - a.time);
    if (bounds.high > fastest.bounds.high) fastest = {bounds, b.number};
  }
  const double part = 1 - granted_;
  const auto [slow, fast] = std::ranges::minmax(means);
  if (slow >= fast * part) {
    const FeedBounds middle = between(places_[first], places_[last]);
    if (middle.high < feed_ * part) return {Fault{middle, places_[last].number}, true};
    return {std::nullopt, true};
  }
  const bool is_short = places_.back().time - places_.front().time <= kLongestRamp;
  if (is_short && is_ramp(means, part)) return {};
  if (fastest.bounds.high < feed_ * part) return {fastest, true};
  return {};
}

}  // namespace gonogo::oracle
