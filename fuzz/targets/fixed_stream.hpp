// SPDX-License-Identifier: GPL-3.0-or-later
//
// A fixed stream of inputs for a fuzz target. Nothing in it explores: each input follows from the stored
// ones, a seed and its number, so that every machine runs the same, under any load.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gonogo::fuzz {

using Bytes = std::vector<std::uint8_t>;

// Makes the inputs of one stream from stored ones, through the mutator of the target.
class FixedStream {
 public:
  FixedStream(std::vector<Bytes> stored, std::uint64_t seed, std::size_t most_bytes)
      : stored_(std::move(stored)), seed_(seed), most_bytes_(most_bytes) {}

  // The input of that number, of at most so many bytes.
  Bytes input(std::uint64_t number) const;

 private:
  std::vector<Bytes> stored_;
  std::uint64_t seed_;
  std::size_t most_bytes_;
};

// Does nothing unless the environment has GONOGO_FUZZ_STREAM="SEED INPUTS MOST_BYTES". Then the target
// runs the files below the folders that the arguments name, in the order of their names, and so many inputs
// of the stream after them; it says how many it ran, and ends the process. With GONOGO_FUZZ_INPUT=FILE
// the input that is tried now stands in that file.
void run_stream_if_asked(int argc, const char* const* argv);

}  // namespace gonogo::fuzz
