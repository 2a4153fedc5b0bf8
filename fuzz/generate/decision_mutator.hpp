// SPDX-License-Identifier: GPL-3.0-or-later
//
// The structured mutator of fuzzers whose input is a generator's decisions: it changes decisions
// where a fuzzer of its own changes bytes, most of which decide the same as before or nothing at
// all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "fuzz/generate/choices.hpp"

namespace gonogo::generate {

// Other decisions: some are made anew, left out, made once more elsewhere, or all from one of them
// on. `decisions` is what `bytes` decide (Choices::note_in).
//
// (1) `most_bytes` bytes come back; behind those that decide something they are random.
// (2) It follows from the arguments alone.
// (3) Nearly always at least one decision is another one.
std::vector<std::uint8_t> mutate_decisions(std::span<const std::uint8_t> bytes,
                                           std::span<const NotedDecision> decisions,
                                           std::size_t most_bytes, std::uint32_t seed);

// How many of the bytes decide something.
std::size_t deciding_bytes(std::span<const NotedDecision> decisions);

}  // namespace gonogo::generate
