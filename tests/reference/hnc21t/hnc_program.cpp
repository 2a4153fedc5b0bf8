// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs at random.
#include "hnc_program.hpp"

#include <algorithm>
#include <cstdlib>

namespace gonogo::reference::testing::hnc {
namespace {

std::int64_t between(std::int64_t low, std::int64_t high) {
  return *rc::gen::inRange(low, high + 1);
}
// True once in `often` times.
bool seldom(int often) {
  return between(1, often) == 1;
}
std::int64_t any_sense() {
  return seldom(2) ? 1 : -1;
}
Place any_place() {
  return {between(-50'000, 50'000), between(-50'000, 50'000)};
}
Given feed_word() {
  return {'F', between(1, 900'000), Measure::length};
}

// Writes the steps of one program.
class Maker {
 public:
  Program make() {
    program_.start = any_place();
    for (Place& offset : program_.offsets) offset = any_place();
    add_readings();
    stand_ = stand_at_start(program_);
    for (std::int64_t count = between(1, 8); count > 0; --count) add_step();
    return std::move(program_);
  }

 private:
  // Each choice that is not the default, in one of five programs.
  void add_readings() {
    static const std::vector<std::pair<std::string_view, std::string_view>> kReadings = {
        {"hnc.missing-axis", "keep"},   {"hnc.missing-axis", "none"},
        {"hnc.peck.from", "withdrawn"}, {"hnc.peck.withdraw", "feed"},
        {"hnc.peck.clamp", "start"},    {"hnc.g75.i", "P"},
        {"hnc.g75.steps", "i"},         {"hnc.g75.end", "last"},
        {"hnc.g75.mode3", "on"},        {"hnc.g75.depth-scale", "diameter"},
        {"hnc.g82.exit", "feed"},       {"hnc.g82.e-scale", "diameter"},
        {"hnc.g82.starts", "one"},      {"hnc.modal.f", "forgotten"},
        {"hnc.lead.unit", "units"},     {"hnc.arc.zero-radius", "none"},
        {"hnc.offset.initial", "none"}};
    for (const auto& reading : kReadings) {
      if (seldom(5) && !program_.reads_any(reading.first)) program_.readings.push_back(reading);
    }
  }

  void add(Block block) {
    stand_ = after(program_, block, stand_);
    program_.blocks.push_back(std::move(block));
  }

  // One kind of step; of cycles up to three blocks, some after a block that moves nothing.
  void add_step() {
    static constexpr std::array<int, 14> kCodes = {0,  1,  2,  3,  32, 74, 75,
                                                   80, 81, 82, 82, 54, 92, 4};
    const int code = kCodes[static_cast<std::size_t>(between(0, 13))];
    if (code < 32 || !is_motion(code)) return add_block(code, true);
    const std::int64_t count = between(1, 3);
    for (std::int64_t i = 0; i < count; ++i) {
      if (i > 0 && seldom(4)) add_block(seldom(2) ? 4 : seldom(2) ? 54 : 92, true);
      add_block(code, i == 0);
    }
  }

  void add_block(int code, bool first) {
    Block block;
    block.code = code;
    block.code_stands = seldom(5);
    switch (code) {
      case 4:
        block.words.push_back({'P', 1'000 * between(1, 5'000), Measure::number});
        break;
      case 54:
        block.code = static_cast<int>(between(54, 59));
        break;
      case 2:
      case 3:
        arc(block);
        break;
      case 74:
        drill(block, first);
        break;
      case 75:
        groove(block, first);
        break;
      default:
        block.end = any_place();
        for (bool& named : block.named) named = !seldom(code >= 80 && code != 92 ? 30 : 4);
        turning_words(block, first);
        break;
    }
    add(std::move(block));
  }

  void turning_words(Block& block, bool first) {
    switch (block.code) {
      case 1:
        if (!seldom(3)) block.words.push_back(feed_word());
        break;
      case 32:
        lead(block, first);
        break;
      case 80:
      case 81: {
        const bool along_x = block.code == 80;
        if (seldom(2)) {
          block.words.push_back({along_x ? 'I' : 'K', between(-9'000, 9'000),
                                 along_x ? Measure::along_x : Measure::along_z});
        }
        if (!seldom(first ? 12 : 3)) block.words.push_back(feed_word());
        break;
      }
      case 82:
        thread(block, first);
        break;
      default:
        break;
    }
  }

  void lead(Block& block, bool first) {
    if (seldom(first ? 20 : 2)) return;
    if (seldom(3)) {
      block.words.push_back({'J', between(1, 400), Measure::number});
    } else {
      block.words.push_back({'F', between(1, 9'000), Measure::lead});
    }
  }

  // The run-out near the ratio of 20, or anything; the starts.
  void thread(Block& block, bool first) {
    if (seldom(2)) block.words.push_back({'I', between(-60'000, 60'000), Measure::along_x});
    if (seldom(2)) {
      const std::int64_t small = between(1, 200);
      const std::int64_t large = seldom(2) ? 20 * small + between(-1, 1) : between(1, 5'000);
      const bool swap = seldom(3);
      block.words.push_back({'R', any_sense() * (swap ? large : small), Measure::along_z});
      if (!seldom(30)) {
        block.words.push_back({'E', any_sense() * (swap ? small : large), Measure::along_x});
      }
    }
    if (seldom(3)) block.words.push_back({'C', 1'000 * between(0, 4), Measure::number});
    if (!seldom(3)) block.words.push_back({'P', between(0, 800'000), Measure::number});
    if (seldom(8)) block.words.push_back({'Q', 1'000 * between(0, 50), Measure::number});
    lead(block, first);
  }

  // About a centre by quarter turns, so that the end lies on the circle; sometimes a little beside
  // it.
  void arc(Block& block) {
    const Place at = stand_.work();
    block.named = {true, true};
    if (!seldom(4)) block.words.push_back(feed_word());
    if (seldom(2)) {
      const std::int64_t dz = between(-20'000, 20'000);
      const std::int64_t dx = between(-20'000, 20'000);
      block.end = {at[0] + dx, at[1] + dz};
      const std::int64_t least = (std::abs(dx) + std::abs(dz)) / (seldom(15) ? 4 : 1);
      block.words.push_back({'R', (least + between(1, 5'000)) * any_sense(), Measure::length});
      return;
    }
    const std::int64_t k = between(1, 20'000) * any_sense();
    const std::int64_t i = between(-20'000, 20'000);
    std::int64_t z = -k;
    std::int64_t x = -i;
    for (std::int64_t turns = between(1, 4); turns > 0; --turns) {
      z = std::exchange(x, z);
      x = -x;
    }
    block.end = {at[0] + i + x, at[1] + k + z + (seldom(4) ? between(0, 30) : 0)};
    block.words.push_back({'K', k, Measure::along_z});
    block.words.push_back({'I', i, Measure::along_x});
  }

  // R and Q; R no more than half of Q but seldom, and never where it counts from there.
  std::int64_t pecks(Block& block, bool first) {
    if (first || seldom(2)) {
      peck_ = between(500, 8'000);
      const bool any_withdrawal = seldom(6) && !program_.reads("hnc.peck.from", "withdrawn");
      const std::int64_t e = any_withdrawal ? between(0, 2 * peck_) : between(0, peck_ / 2);
      if (!seldom(first ? 6 : 20) || !first) block.words.push_back({'R', seldom(4) ? 0 : e});
      if (!seldom(30)) block.words.push_back({'Q', peck_});
    }
    if (!seldom(first ? 12 : 3)) block.words.push_back(feed_word());
    const std::int64_t depth = peck_ * between(0, 6) + (seldom(2) ? between(0, peck_) : 0);
    return any_sense() * depth;
  }

  void drill(Block& block, bool first) {
    const Place at = stand_.work();
    block.end = {at[0] + between(-20'000, 20'000), at[1] + pecks(block, first)};
    block.named = {seldom(8), !seldom(40)};
  }

  void groove(Block& block, bool first) {
    const Place at = stand_.work();
    block.end[0] = at[0] + pecks(block, first);
    block.named = {!seldom(40), seldom(2)};
    block.end[1] = at[1] + between(-20'000, 20'000);
    if (first) counted_ = false;
    const bool counts = block.named[1] && (!counted_ || seldom(3));
    if (counts == seldom(30)) return;
    const char address = program_.reads("hnc.g75.i", "P") ? 'P' : 'I';
    block.words.push_back({address, 1'000 * between(1, 6), Measure::number});
    counted_ = true;
  }

  Program program_;
  Stand stand_;
  std::int64_t peck_ = 0;
  bool counted_ = false;
};

template <typename Move>
Program moved(Program program, Move move) {
  move(program.start);
  for (Place& offset : program.offsets) move(offset);
  return program;
}

}  // namespace

bool Program::reads(std::string_view reading, std::string_view value) const {
  return std::find(readings.begin(), readings.end(), std::pair(reading, value)) != readings.end();
}

bool Program::reads_any(std::string_view reading) const {
  return std::any_of(readings.begin(), readings.end(),
                     [&](const auto& choice) { return choice.first == reading; });
}

Stand stand_at_start(const Program& program) {
  return {program.start, program.offsets[0]};
}

Stand after(const Program& program, const Block& block, Stand stand) {
  if (block.code >= 54 && block.code <= 59) {
    stand.offset = program.offsets[static_cast<std::size_t>(block.code - 54)];
    return stand;
  }
  const bool moves = block.code < 74 && block.code != 4;
  const bool stays_wide = block.code == 75 && program.reads("hnc.g75.end", "last");
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const bool leads = moves || block.code == 92 || (stays_wide && axis == 1);
    if (leads && block.named[axis]) stand.at[axis] = block.end[axis] + stand.offset[axis];
  }
  return stand;
}

rc::Gen<Program> programs() {
  // At the full size in each case: a range of size 0 is its lower end.
  return rc::gen::resize(rc::kNominalSize, rc::gen::exec([] { return Maker().make(); }));
}

Program translated(Program program, const Place& shift) {
  return moved(std::move(program), [&](Place& place) {
    place[0] += shift[0];
    place[1] += shift[1];
  });
}

Program mirrored(Program program, std::size_t axis) {
  const Measure along = axis == 0 ? Measure::along_x : Measure::along_z;
  for (Block& block : program.blocks) {
    block.end[axis] = -block.end[axis];
    if (block.code == 2 || block.code == 3) block.code ^= 1;
    for (Given& word : block.words) {
      if (word.measure == along) word.count = -word.count;
    }
  }
  return moved(std::move(program), [&](Place& place) { place[axis] = -place[axis]; });
}

}  // namespace gonogo::reference::testing::hnc
