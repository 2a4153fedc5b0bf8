// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/targets/decision_hooks.hpp"

#include <algorithm>
#include <vector>

#include "fuzz/generate/decision_mutator.hpp"
#include "fuzz/targets/fixed_stream.hpp"
#include "fuzz/targets/target.hpp"

namespace gonogo::fuzz {
namespace {

struct Decided {
  std::vector<std::uint8_t> bytes;
  std::vector<generate::NotedDecision> decisions;
};

Decided& last_decided() {
  static Decided decided;
  return decided;
}

const std::vector<generate::NotedDecision>& decisions_of(const std::uint8_t* data,
                                                         std::size_t size) {
  if (!std::ranges::equal(last_decided().bytes, std::span(data, size))) {
    generate::Choices choices = choices_of(data, size);
    decide(choices);
  }
  return last_decided().decisions;
}

}  // namespace

generate::Choices choices_of(const std::uint8_t* data, std::size_t size) {
  Decided& decided = last_decided();
  decided.bytes.assign(data, data + size);
  decided.decisions.clear();
  generate::Choices choices(decided.bytes);
  choices.note_in(decided.decisions);
  return choices;
}

}  // namespace gonogo::fuzz

// NOLINTNEXTLINE(readability-non-const-parameter): the engine says what it is called with.
extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  gonogo::fuzz::run_stream_if_asked(*argc, *argv);
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned int seed) {
  using namespace gonogo;
  const std::vector<generate::NotedDecision>& decisions = fuzz::decisions_of(data, size);
  if (LLVMFuzzerMutate != nullptr && fuzz::is_turn_of_engine(seed)) {
    return LLVMFuzzerMutate(data, generate::deciding_bytes(decisions), most);
  }
  const std::vector<std::uint8_t> after =
      generate::mutate_decisions({data, size}, decisions, most, seed);
  std::ranges::copy(after, data);
  return after.size();
}
