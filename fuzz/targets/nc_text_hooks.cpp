// SPDX-License-Identifier: GPL-3.0-or-later
//
// The structured mutator in the fuzz targets whose input is NC text, as the engines call it.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "fuzz/program/mutator/program_mutator.hpp"
#include "fuzz/targets/fixed_stream.hpp"
#include "fuzz/targets/target.hpp"

namespace {

using namespace gonogo;
using namespace gonogo::fuzz;

// The dialect that the target reads; of a target that reads all of them none.
const program::Dictionary* dictionary() {
  static const program::Dictionary* const kDictionary =
      program::find_dictionary(GONOGO_FUZZ_DIALECT);
  return kDictionary;
}

}  // namespace

// With GONOGO_FUZZ_DICTIONARY set the target only prints the dictionary of its dialect.
// NOLINTNEXTLINE(readability-non-const-parameter): the engine says what it is called with.
extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  run_stream_if_asked(*argc, *argv);
  if (std::getenv("GONOGO_FUZZ_DICTIONARY") == nullptr) return 0;
  const std::string text = program::dictionary_text(GONOGO_FUZZ_DIALECT);
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::exit(0);
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned int seed) {
  if (LLVMFuzzerMutate != nullptr && is_turn_of_engine(seed))
    return LLVMFuzzerMutate(data, size, most);
  const std::string text = program::mutate_program(text_of(data, size), most, seed, dictionary());
  std::ranges::copy(text, data);
  return text.size();
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* one, std::size_t one_size,
                                                 const std::uint8_t* other, std::size_t other_size,
                                                 std::uint8_t* out, std::size_t most,
                                                 unsigned int seed) {
  const std::string text =
      program::cross_programs(text_of(one, one_size), text_of(other, other_size), most, seed);
  std::ranges::copy(text, out);
  return text.size();
}
