// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/sample_thinner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oracle/steps/step_text.hpp"

namespace gonogo::oracle {
namespace {

constexpr double kSeen = 1e-3;            // mm
constexpr std::size_t kMostHeld = 200;    // samples that are left out in a row
constexpr std::size_t kMostKept = 20'000;

}  // namespace

// Whether those that are held lie on the line from the last one kept to the next.
bool SampleThinner::on_the_way(const Sample& next) const {
  const SamplePoint from(*last_);
  const SamplePoint to(next);
  std::size_t longest = 0;
  for (std::size_t i = 0; i < reference::kAxes; ++i) {
    if (std::abs(to.near[i] - from.near[i]) > std::abs(to.near[longest] - from.near[longest])) {
      longest = i;
    }
  }
  const double whole = to.near[longest] - from.near[longest];
  return std::ranges::all_of(held_, [&](const Sample& sample) {
    const SamplePoint at(sample);
    const double part = whole == 0 ? 0 : (at.near[longest] - from.near[longest]) / whole;
    for (std::size_t i = 0; i < reference::kAxes; ++i) {
      const double there = from.near[i] + part * (to.near[i] - from.near[i]);
      if (std::abs(at.near[i] - there) > kSeen) return false;
    }
    return part >= 0 && part <= 1;
  });
}

void SampleThinner::put(const Sample& sample) {
  if (kept_.size() == kMostKept) return;
  std::string line = fmt::format("{{\"k\":\"rapid\",\"to\":{}", point_text(sample.at, seen_));
  if (sample.block > header_lines_) {
    line += fmt::format(",\"b\":{}", sample.block - header_lines_);
  }
  line += fmt::format(",\"x-sample\":{},\"x-t\":", sample.number);
  sample.time.append_json(line);
  kept_.push_back(line + "}");
  last_ = sample;
  held_.clear();
}

void SampleThinner::add(const Sample& sample) {
  begun_ = begun_ || header_lines_ == 0 || sample.block > header_lines_;
  const bool is_marked = marked_ && *marked_ == sample.number;
  if (!begun_ && !is_marked) return;
  if (!last_ || is_marked) {
    if (!held_.empty()) put(Sample(held_.back()));
    return put(sample);
  }
  const bool is_other = sample.block != last_->block;
  if (!held_.empty() && (is_other || held_.size() == kMostHeld || !on_the_way(sample))) {
    put(Sample(held_.back()));
  }
  held_.push_back(sample);
}

std::vector<std::string> SampleThinner::finish() {
  if (!held_.empty()) put(Sample(held_.back()));
  return std::move(kept_);
}

}  // namespace gonogo::oracle
