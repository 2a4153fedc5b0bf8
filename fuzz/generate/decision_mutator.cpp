// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/generate/decision_mutator.hpp"

#include <algorithm>

#include "fuzz/program/mutator/dice.hpp"

namespace gonogo::generate {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Decisions = std::span<const NotedDecision>;
constexpr std::size_t kLongestRun = 12;  // decisions of a word or two

std::uint64_t value_of(const Bytes& bytes, const NotedDecision& decision) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < decision.bytes; ++i) value = value << 8 | bytes[decision.at + i];
  return value % decision.count;
}

void set_value(Bytes& bytes, const NotedDecision& decision, std::uint64_t value) {
  for (std::size_t i = decision.bytes; i-- > 0; value >>= 8) {
    bytes[decision.at + i] = static_cast<std::uint8_t>(value);
  }
}

// Any other one; of many that lie in a row as often one of the two beside it.
void decide_otherwise(program::Dice& dice, Bytes& bytes, const NotedDecision& decision) {
  constexpr std::uint64_t kMany = 256;
  const std::uint64_t before = value_of(bytes, decision);
  const std::uint64_t most = decision.count - 1;
  if (most >= kMany && dice.one_in(2)) {
    const bool up = before == 0 || (before != most && dice.one_in(2));
    set_value(bytes, decision, up ? before + 1 : before - 1);
    return;
  }
  std::uint64_t drawn = 0;
  for (std::size_t i = 0; i < decision.bytes; ++i) drawn = drawn << 8 | dice.byte();
  const std::uint64_t other = drawn % most;
  set_value(bytes, decision, other < before ? other : other + 1);
}

// A run of decisions, by the bytes that it takes.
struct Run {
  std::size_t begin, end;
};

Run draw_run(program::Dice& dice, Decisions decisions) {
  const std::size_t first = dice.below(decisions.size());
  const std::size_t last = std::min(first + dice.below(kLongestRun), decisions.size() - 1);
  return {decisions[first].at, decisions[last].at + decisions[last].bytes};
}

void leave_out(program::Dice& dice, Bytes& bytes, Decisions decisions) {
  const Run run = draw_run(dice, decisions);
  bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(run.begin),
              bytes.begin() + static_cast<std::ptrdiff_t>(run.end));
}

void make_once_more(program::Dice& dice, Bytes& bytes, Decisions decisions) {
  const Run run = draw_run(dice, decisions);
  const Bytes copy(bytes.begin() + static_cast<std::ptrdiff_t>(run.begin),
                   bytes.begin() + static_cast<std::ptrdiff_t>(run.end));
  const std::size_t before = dice.pick(decisions).at;
  bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(before), copy.begin(), copy.end());
}

void change(program::Dice& dice, Bytes& bytes, Decisions decisions) {
  const std::size_t kind = dice.below(8);
  if (kind == 0) {
    leave_out(dice, bytes, decisions);
  } else if (kind == 1) {
    make_once_more(dice, bytes, decisions);
  } else if (kind == 2) {
    bytes.resize(dice.pick(decisions).at);
  } else {
    // One, or several that lie close together, as those of a word or a block.
    std::size_t times = dice.one_in(2) ? 1 : 1 + dice.below(4);
    for (std::size_t i = dice.below(decisions.size()); i < decisions.size() && times > 0; --times) {
      decide_otherwise(dice, bytes, decisions[i]);
      i += 1 + dice.below(8);
    }
  }
}

}  // namespace

std::size_t deciding_bytes(Decisions decisions) {
  return decisions.empty() ? 0 : decisions.back().at + decisions.back().bytes;
}

std::vector<std::uint8_t> mutate_decisions(std::span<const std::uint8_t> bytes, Decisions decisions,
                                           std::size_t most_bytes, std::uint32_t seed) {
  program::Dice dice(seed);
  const auto deciding = bytes.first(deciding_bytes(decisions));
  Bytes after(deciding.begin(), deciding.end());
  if (!decisions.empty()) change(dice, after, decisions);
  const std::size_t kept = std::min(after.size(), most_bytes);
  after.resize(most_bytes);
  std::generate(after.begin() + static_cast<std::ptrdiff_t>(kept), after.end(),
                [&] { return dice.byte(); });
  return after;
}

}  // namespace gonogo::generate
