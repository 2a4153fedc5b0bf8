// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/sample_rhythm.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

namespace gonogo::oracle {
namespace {

constexpr std::size_t kMostIntervals = 1'000'000;  // the first ones; they tell the rhythm of all
constexpr std::size_t kNamedHoles = 10;
constexpr double kSumNoise = 1e-9;  // s; of differences of doubles

}  // namespace

void SampleRhythm::add(double time) {
  if (begun_ && intervals_.size() < kMostIntervals) intervals_.push_back(time - last_);
  begun_ = true;
  last_ = time;
}

double SampleRhythm::quantile(std::size_t parts) const {
  if (intervals_.empty()) return 0;
  std::vector<double> sorted = intervals_;
  const auto at = sorted.begin() + static_cast<std::ptrdiff_t>((sorted.size() - 1) / parts);
  std::ranges::nth_element(sorted, at);
  return *at;
}

// J-RUN-11. In an even rhythm a missing sample makes an interval twice as long: half of one
// is let pass. Times that are off by up to half an interval each way make none that exceeds this.
// The quarter of the intervals that is shortest stands for the rhythm, or many holes would.
double SampleRhythm::limit(double clock) const {
  constexpr double kEven = 1.5;
  constexpr double kSpread = 4;
  constexpr double kMost = 4;
  if (intervals_.empty()) return std::numeric_limits<double>::infinity();
  const double quarter = quantile(4);
  const double half = quantile(2);
  return std::min(kEven * quarter + kSpread * (half - quarter), kMost * quarter) + 2 * clock +
         kSumNoise;
}

void HoleWatch::note(std::string hole) {
  if (++count_ <= kNamedHoles) named_.push_back(std::move(hole));
}

void HoleWatch::take(const Sample& sample, bool counts, std::uint64_t block) {
  const std::optional<Number> before = std::exchange(before_, sample.time);
  if (!counts) return;
  const Number interval = before ? sample.time - *before : Number(0);
  longest_ = max(longest_, interval);
  if (!sample.after_hole && quick(interval) <= limit_) return;
  note(fmt::format("{} s to {} s{}", before ? before->text() : "before", sample.time.text(),
                   block != 0 ? fmt::format(" (line {})", block) : ""));
}

std::string HoleWatch::holes_text() const {
  std::string text = fmt::format(
      " The samples have {}, in which the machine may have been anywhere: {}",
      count_ == 1 ? "a hole" : fmt::format("{} holes", count_), fmt::join(named_, ", "));
  if (count_ > named_.size()) text += fmt::format(" and {} more", count_ - named_.size());
  return text + fmt::format("; as a rule {:.6g} s pass between two.", usual_);
}

std::string HoleWatch::rate_text(double fastest) const {
  return fmt::format(
      " Up to {} s pass between two samples: {:.4g} mm away from the path and back, at {:.6g} "
      "mm/s, "
      "would not be seen.",
      longest_.text(), fastest * quick(longest_) / 2, fastest);
}

}  // namespace gonogo::oracle
