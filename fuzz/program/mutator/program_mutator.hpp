// SPDX-License-Identifier: GPL-3.0-or-later
//
// The structured mutator of fuzzers whose input is NC text: it changes blocks, words and numbers
// where a fuzzer of its own changes bytes, most of which no longer parse.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "fuzz/program/mutator/dictionary.hpp"

namespace gonogo::program {

// Another text.
// (1) It has at most `most_bytes` bytes.
// (2) It follows from the arguments alone.
// (3) It differs from `text`, unless most_bytes is 0.
// (4) `text` may be any bytes; a program of more than 24 blocks may come back shorter.
// Words come from `dictionary`; null: of one of the built-in ones, chosen by the seed.
std::string mutate_program(std::string_view text, std::size_t most_bytes, std::uint32_t seed,
                           const Dictionary* dictionary);

// A program of blocks of two: the beginning of one with the end of the other, a run of blocks of
// one within the other, or the blocks of both by turns. (1), (2) and (4) hold.
std::string cross_programs(std::string_view one, std::string_view other, std::size_t most_bytes,
                           std::uint32_t seed);

}  // namespace gonogo::program
