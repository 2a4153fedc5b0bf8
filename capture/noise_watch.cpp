// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/noise_watch.hpp"

#include <algorithm>
#include <cmath>

namespace gonogo::oracle {
namespace {

constexpr std::size_t kMostSets = 1'000'000;
constexpr std::size_t kFewestSets = 4;  // sets: of fewer one sample would be the noise
constexpr double kNothing = 1e-9;  // mm; of sums of doubles

// What is left over of an axis when a uniform motion is taken away.
struct Rest {
  double scatter = 0;
  double way = 0;  // of the uniform motion
  bool like_noise = true;
};

template <std::size_t N>
Rest rest_of(const std::array<double, N>& times,
             const std::array<std::array<double, reference::kAxes>, N>& at, std::size_t axis) {
  double mean_time = 0;
  double mean = 0;
  for (std::size_t i = 0; i < N; ++i) {
    mean_time += (times[i] - times[0]) / N;
    mean += (at[i][axis] - at[0][axis]) / N;
  }
  double along = 0;
  double spread = 0;
  for (std::size_t i = 0; i < N; ++i) {
    const double time = times[i] - times[0] - mean_time;
    along += time * (at[i][axis] - at[0][axis] - mean);
    spread += time * time;
  }
  const double speed = spread > 0 ? along / spread : 0;
  Rest rest;
  rest.way = std::abs(speed) * (times[N - 1] - times[0]);
  double squares = 0;
  double steps = 0;
  double before = 0;
  for (std::size_t i = 0; i < N; ++i) {
    const double left =
        at[i][axis] - at[0][axis] - mean - speed * (times[i] - times[0] - mean_time);
    rest.scatter = std::max(rest.scatter, std::abs(left));
    squares += left * left;
    if (i > 0) steps += (left - before) * (left - before);
    before = left;
  }
  rest.like_noise = rest.scatter < kNothing || steps > squares;
  return rest;
}

}  // namespace

void NoiseWatch::add(const SamplePoint& sample, double time, double off) {
  at_[filled_] = sample.near;
  times_[filled_] = time;
  least_off_ = filled_ == 0 ? off : std::min(least_off_, off);
  if (++filled_ == kSet) close();
}

void NoiseWatch::close() {
  filled_ = 0;
  if (sets_.size() == kMostSets) return;
  Set set{0, static_cast<float>(least_off_), false};
  double way = 0;
  for (std::size_t axis = 0; axis < reference::kAxes; ++axis) {
    const Rest rest = rest_of(times_, at_, axis);
    if (!rest.like_noise) return;
    set.scatter = std::max(set.scatter, static_cast<float>(rest.scatter));
    way = std::max(way, rest.way);
  }
  set.moving = way > 2 * static_cast<double>(set.scatter) + kNothing;
  sets_.push_back(set);
}

NoiseFigures NoiseWatch::figures() const {
  NoiseFigures figures;
  for (const bool moving : {false, true}) {
    std::vector<float> scatter;
    for (const Set& set : sets_) {
      if (set.moving == moving) scatter.push_back(set.scatter);
    }
    if (scatter.size() < kFewestSets) continue;
    const auto middle = scatter.begin() + static_cast<std::ptrdiff_t>(scatter.size() / 2);
    std::ranges::nth_element(scatter, middle);
    figures.noise = std::max(figures.noise, static_cast<double>(*middle));
  }
  for (const Set& set : sets_) {
    if (!set.moving || static_cast<double>(set.scatter) > 2 * figures.noise + kNothing) continue;
    figures.following = std::max(figures.following, static_cast<double>(set.least_off));
  }
  return figures;
}

}  // namespace gonogo::oracle
