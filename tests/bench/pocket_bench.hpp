// SPDX-License-Identifier: GPL-3.0-or-later
//
// Levels of pockets by the number of motions: three ways to clear one, in a pocket that stays the
// same while the passes come closer, and in one that grows with the path. The exponent is the slope
// of log(time) over log(motions).
#pragma once

#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include "tests/oracle/region/pockets.hpp"

namespace gonogo::oracle::region {

inline constexpr std::size_t kCounts[] = {1'000, 2'000, 5'000, 10'000, 20'000};

using Clear = void (*)(Pocket&, const Number& step);

struct Strategy {
  const char* name;
  Clear clear;
};

inline constexpr Strategy kStrategies[] = {
    {"zigzag", zigzag},
    {"contour-parallel", contour_parallel},
    {"trochoidal", [](Pocket& pocket, const Number& step) { trochoidal(pocket, Number(2), step); }},
};

// Corners of 8, a tool of radius 5, an allowance of 0.75; counterclockwise.
struct Job {
  std::int64_t length;
  std::int64_t width;
  Pocket pocket;
};

inline Job cleared(const Strategy& strategy, std::int64_t length, std::int64_t width,
                   std::int64_t step_nanometres) {
  Job job{length, width, pocket(std::to_string(length), std::to_string(width), "8", "5", "0.75")};
  strategy.clear(job.pocket, Number(step_nanometres) / Number(1'000'000));
  return job;
}

inline std::size_t motions_of(const Strategy& strategy, std::int64_t size, bool grows) {
  const Job job = grows ? cleared(strategy, 3 * size, 2 * size, 2'000'000)
                        : cleared(strategy, 60, 40, 4'000'000 / size);
  return job.pocket.motions.size();
}

// A level of about `count` motions: in a larger pocket, or with smaller steps.
inline Job with_motions(const Strategy& strategy, std::size_t count, bool grows) {
  std::int64_t low = 10;
  std::int64_t high = 20;
  while (motions_of(strategy, high, grows) < count) {
    low = high;
    high *= 2;
  }
  while (high - low > 1) {
    const std::int64_t middle = (low + high) / 2;
    (motions_of(strategy, middle, grows) < count ? low : high) = middle;
  }
  return grows ? cleared(strategy, 3 * high, 2 * high, 2'000'000)
               : cleared(strategy, 60, 40, 4'000'000 / high);
}

// Time of the processor: what else runs on the machine does not count.
template <typename Work>
double processor_milliseconds(Work work) {
  const std::clock_t start = std::clock();
  work();
  return 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

struct Measured {
  double motions;
  double time;
};

// n log n comes out as 1.12 between 1,000 and 20,000.
inline double exponent(const std::vector<Measured>& all) {
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const Measured& one : all) {
    const double u = std::log(one.motions);
    const double v = std::log(one.time);
    x += u;
    y += v;
    xx += u * u;
    xy += u * v;
  }
  const auto n = static_cast<double>(all.size());
  return (n * xy - x * y) / (n * xx - x * x);
}

inline long peak_mebibytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1'024;
}

// `milliseconds` judges a level that must be GO.
template <typename Milliseconds>
void run(const Strategy& strategy, bool grows, Milliseconds milliseconds) {
  std::printf("%s, %s\n", strategy.name, grows ? "2 mm steps, the pocket grows" : "60 x 40 mm");
  std::vector<Measured> all;
  for (const std::size_t count : kCounts) {
    const Job job = with_motions(strategy, count, grows);
    all.push_back({static_cast<double>(job.pocket.motions.size()), milliseconds(job)});
    std::printf("  %6.0f motions  %9.1f ms  peak %4ld MiB\n", all.back().motions, all.back().time,
                peak_mebibytes());
    std::fflush(stdout);
  }
  std::printf("  exponent %.2f\n", exponent(all));
}

template <typename Milliseconds>
void run_all(Milliseconds milliseconds) {
  for (const bool grows : {false, true}) {
    for (const Strategy& strategy : kStrategies) run(strategy, grows, milliseconds);
  }
}

}  // namespace gonogo::oracle::region
