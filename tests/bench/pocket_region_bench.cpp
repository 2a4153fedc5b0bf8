// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a level of a pocket with rounded corners costs the region judge alone, all GO.
#include <cstdlib>

#include "pocket_bench.hpp"

int main() {
  using namespace gonogo::oracle::region;
  run_all([](const Job& job) {
    return processor_milliseconds([&] {
      const LevelVerdict verdict = judge(job.pocket);
      if (verdict.kind == LevelVerdict::Kind::go) return;
      std::printf("not go: %s\n", verdict.gap.c_str());
      std::exit(1);
    });
  });
}
