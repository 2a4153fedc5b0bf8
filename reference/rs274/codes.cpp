// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rs274/codes.hpp"

#include <algorithm>

#include "reference/clause_literal.hpp"
#include "reference/reading_literal.hpp"
#include "reference/rs274/descriptor.hpp"
#include "reference/rs274/whole.hpp"
#include "reference/words.hpp"

namespace gonogo::reference::rs274 {
namespace {

// NGC-COM-01 for codes that are read or have no effect. NGC-CYC-30: one code of a group in a block.
// NGC-G87-01, NGC-G88-01: two cycles whose path the documents leave undefined are not read.
constexpr GCodeTable kTable{table::kCodes, "NGC-COM-01"_clause, "NGC-COM-01"_clause};

// NGC-COM-01: the code whose number the word has, or is near enough to. Null: the language has
// none.
const Code* code_of(const grammar::Word& word, const ReadingsInUse& readings) {
  if (const Code* code = kTable.find(word.value)) return code;
  const NearWhole tenths(to_number(word.value) * 10);
  if (tenths.is_whole()) return nullptr;
  const std::optional<std::int64_t> nearest = tenths.nearest().to_int64();
  if (!nearest || *nearest < 0 || *nearest > kTable.last_tenths()) return nullptr;
  const Code* code = kTable.find_tenths(static_cast<int>(*nearest));
  return code != nullptr && tenths.counts_as_whole(Whole::g_tenths, readings) ? code : nullptr;
}

// As BlockCodes has it.
int motion_of(const Code& code) {
  return code.tenths == kG33Point1 ? kG33Point1 : code.tenths / 10;
}

// Groups whose codes differ in their tenths.
bool has_tenths(Group group) {
  return group == Group::once || group == Group::tool_length || group == Group::offset;
}

constexpr int kG80 = 800;  // tenths

// NGC-COM-03: how the G80 of a block stand beside the other codes of the motion group.
struct BesideG80 {
  int others = 0;
  int g80 = 0;
  bool decides = true;  // nothing else of the block is not read, or no code

  void add(const Code* code) {
    decides = decides && code != nullptr && code->treatment != Treatment::outside;
    if (code == nullptr || code->group != Group::motion) return;
    ++(code->tenths == kG80 ? g80 : others);
  }
  // Whether without a G80 the group would have one code, and nothing else is wrong with the codes.
  bool matters() const { return decides && others <= 1 && g80 >= 1 && others + g80 >= 2; }
};

Alarm g80_beside(const grammar::Word& word) {
  return {AlarmClass::duplicate_word, "NGC-COM-03"_clause, 'G', word.where,
          "G80 and another code of its group stand in the block; under ngc.g80-beside = ignored "
          "the other one holds."};
}

}  // namespace

void read_codes(const grammar::Block& block, const ReadingsInUse& readings, CodeReading& reading) {
  reading.clear();
  BesideG80 beside;
  if (std::ranges::count(block.words, 'G', &grammar::Word::address) > 1) {
    for (const grammar::Word& word : block.words) {
      if (word.address == 'G') beside.add(code_of(word, readings));
    }
  }
  const bool is_beside = beside.matters();
  const bool alarms = is_beside && !readings.is("ngc.g80-beside=ignored"_reading);
  int motions = 0;
  int acting = 0;  // of them
  Letters of_motions = 0;
  for (const grammar::Word& word : block.words) {
    if (word.address != 'G') continue;
    const Code* const code = code_of(word, readings);
    if (is_beside && code->group == Group::motion) {
      if (++motions > 1 && alarms) reading.alarms.push_back(g80_beside(word));
      // One of two G80 is left.
      if (code->tenths == kG80 && (beside.others > 0 || motions > 1)) continue;
    }
    kTable.take(word, code, false, reading);
    if (code != nullptr && has_tenths(code->group)) {
      reading.by_group[static_cast<std::size_t>(code->group)] = code->tenths;
    }
    if (code != nullptr && code->group == Group::motion) {
      ++acting;
      of_motions |= code->letters | code->passed_letters;
      reading.by_group[static_cast<std::size_t>(Group::motion)] = motion_of(*code);
    }
  }
  reading.codes = {.once = reading.of(Group::once),
                   .tool_length = reading.of(Group::tool_length),
                   .offset = reading.of(Group::offset),
                   .motion = reading.of(Group::motion),
                   .plane = reading.of(Group::plane),
                   .units = reading.of(Group::units),
                   .diameter = reading.of(Group::diameter),
                   .feed_mode = reading.of(Group::feed_mode),
                   .speed = reading.of(Group::speed),
                   .path_mode = reading.of(Group::path_mode),
                   .distance = reading.of(Group::distance),
                   .arc_distance = reading.of(Group::arc_distance),
                   .retract = reading.of(Group::retract),
                   .of_motions = acting > 1 ? of_motions : 0};
}

bool is_hole_cycle(int motion) {
  return motion == 73 || motion == 74 || (motion >= 81 && motion <= 89);
}

Letters words_of_motion(int motion) {
  const Code* const code = kTable.find_tenths(motion == kG33Point1 ? kG33Point1 : motion * 10);
  return code == nullptr ? 0 : code->letters | code->passed_letters;
}

const Code* m_function(std::int64_t number) {
  const auto found = std::ranges::find_if(table::kCodes, [&](const Code& code) {
    return code.is_m() && number * 10 >= code.tenths &&
           number * 10 <= std::max(code.tenths, code.last);
  });
  return found == table::kCodes.end() ? nullptr : &*found;
}

}  // namespace gonogo::reference::rs274
