// SPDX-License-Identifier: GPL-3.0-or-later
//
// G76, threading: passes at growing depth from a drive line, along which the tool ends.
#include "reference/reading_literal.hpp"
#include "reference/rs274/thread_passes.hpp"

namespace gonogo::reference::rs274 {
// NGC-G76-13: a block that repeats it needs all of its words again; no feed. NGC-G76-14: lengths
// are in the units in force, R, Q, H and L are numbers.
void run_g76(BlockContext& block) {
  std::optional<ThreadWords> words = read_thread_words(block);
  if (!words) return;
  const Position& start = block.machine.position;
  ThreadPasses passes{.line = block.line,
                      .feed_in_force = block.machine.feed,
                      .feed_mode = block.machine.feed_mode,
                      .start = start,
                      .words = *std::move(words)};
  passes.side = passes.words.peak.sign();
  passes.forward = passes.words.end[Axis::z] > start[Axis::z] ? 1 : -1;
  // NGC-G76-08
  if (passes.words.tangent.sign() != 0) {
    passes.equal_lengths = block.readings.is("ngc.g76.slide=end"_reading);
  }
  block.machine.position = passes.words.end;
  block.out.cycle = run_passes(std::move(passes));
}

}  // namespace gonogo::reference::rs274
