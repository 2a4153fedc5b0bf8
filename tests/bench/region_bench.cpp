// SPDX-License-Identifier: GPL-3.0-or-later
//
// What one pocket level costs the region judge: semicircle spirals of a growing number of motions.
#include <benchmark/benchmark.h>

#include "oracle/region/level.hpp"

namespace gonogo::oracle::region {
namespace {

struct Spiral {
  CircularLevel level;
  std::vector<LevelMotion> motions;
};

// `count` semicircles and the closing circle: tool radius 5 mm, step 0.302 mm.
Spiral spiral(std::int64_t count) {
  Spiral job;
  job.level.tool_radius = 5;
  job.level.step = Number::millionths(302'000);
  const Number half = job.level.step / Number(2);
  job.level.pocket_radius = job.level.tool_radius + Number(count) * half;
  job.level.tolerance = Number::millionths(1'000);
  Number s;
  for (std::int64_t k = 1; k <= count + 1; ++k) {
    LevelMotion motion;
    motion.is_arc = true;
    motion.rot = -1;
    motion.record = job.motions.size();
    motion.from = {s, Number()};
    if (k <= count) {
      const Number next = k % 2 != 0 ? Number(k) * half : -(Number(k) * half);
      motion.centre = {(s + next) / Number(2), Number()};
      s = next;
    }
    motion.to = {s, Number()};
    job.motions.push_back(motion);
  }
  return job;
}

void judge_spiral(benchmark::State& state) {
  const Spiral job = spiral(state.range(0));
  for (auto _ : state) {
    const LevelVerdict verdict = judge_level(job.level, job.motions);
    if (verdict.kind != LevelVerdict::Kind::go) {
      state.SkipWithError(("not go: " + verdict.gap).c_str());
      break;
    }
    benchmark::DoNotOptimize(verdict);
  }
  state.SetComplexityN(state.range(0));
}
BENCHMARK(judge_spiral)
    ->Arg(25)
    ->Arg(1'000)
    ->Arg(20'000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();

}  // namespace
}  // namespace gonogo::oracle::region

BENCHMARK_MAIN();
