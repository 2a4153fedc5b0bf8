// SPDX-License-Identifier: GPL-3.0-or-later
//
// G43 to G43.2 and G49, and the entries of the tool table that G10 L1, L10 and L11 change.
#include "reference/rs274/tool_lengths.hpp"

#include <fmt/format.h>

#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/reading_literal.hpp"
#include "reference/rs274/whole.hpp"

namespace gonogo::reference::rs274 {

std::optional<Number> whole_word(BlockContext& block, ClauseId clause, char address) {
  const NearWhole value(block.words.written(address));
  if (value.counts_as_whole(Whole::repeats, block.readings)) return value.nearest();
  block.alarm(AlarmClass::not_an_integer, clause, address,
              with_values(fmt::format("{} is {{}} and not whole.", address),
                          {block.words.written(address)}));
  return std::nullopt;
}

namespace {

// What a tool moves the axes by; nothing where the table has no such tool.
std::optional<Position> entry_of(const BlockContext& block, const std::string& tool) {
  const auto& changed = block.machine.tool.changed;
  if (const auto found = changed.find(tool); found != changed.end()) return found->second;
  const auto found = block.profile.tools.find(tool);
  if (found == block.profile.tools.end()) return std::nullopt;
  Position entry;
  entry[Axis::z] = found->second.length;
  return entry;
}

// NGC-OFS-08: the tool that H names, or the one in the spindle; nothing after an alarm, or where it
// is not known.
std::optional<Number> tool_named(BlockContext& block, ClauseId clause) {
  if (!block.words.has('H')) {
    if (block.machine.tool.loaded) return block.machine.tool.loaded;
  } else {
    const std::optional<Number> tool = whole_word(block, clause, 'H');
    if (!tool || tool->sign() > 0) return tool;
    if (tool->sign() < 0) {
      block.alarm(AlarmClass::value_sign, clause, 'H',
                  with_values("The number of the tool, {}, is below zero.", {*tool}));
      return std::nullopt;
    }
  }
  return 0;
}

// What the tool of the block moves the axes by. Nothing where it is not known.
std::optional<Position> offset_of_tool(BlockContext& block, ClauseId clause) {
  const std::optional<Number> tool = tool_named(block, clause);
  if (!tool) return std::nullopt;
  if (tool->sign() == 0) {
    block.not_covered(43, 'H', "Which tool G43 means here depends on the tool changer.");
    return std::nullopt;
  }
  const std::string number = tool->text();
  std::optional<Position> entry = entry_of(block, number);
  if (entry) return entry;
  block.out.not_covered = lacking_in_profile(
      fmt::format("The length of tool {}", number),
      fmt::format("tools = {{ \"{}\" = {{ length = \"50\" }} }}", number),
      block.places.place_of(block.words.has('H') ? 'H' : 'G').value_or(grammar::Span{}),
      block.line);
  return std::nullopt;
}

void refuse_motion(BlockContext& block, ClauseId clause) {
  if (block.codes.motion < 0 || block.machine.motion == kNoMotion) return;
  block.alarm(AlarmClass::conflicting_words, clause, 'G',
              "No motion stands beside a code that takes the axis words for the tool.");
}

// NGC-OFS-19: G43.2, what comes beside the offset that is in force. Nothing as above.
std::optional<Position> additional_offset(BlockContext& block) {
  const ClauseId clause = "NGC-OFS-19"_clause;
  refuse_motion(block, clause);
  const bool has_axis = block.words.has_axis_word();
  if (block.words.has('H')) {
    if (!has_axis) return offset_of_tool(block, clause);
    block.alarm(AlarmClass::conflicting_words, clause, 'H',
                "G43.2 takes H or axis words, and not both.");
    return std::nullopt;
  }
  if (!has_axis) {
    block.missing(clause, 'H');
    return std::nullopt;
  }
  Position added;
  each_axis_word(block, [&](Axis axis, const Number& value) { added[axis] = value; });
  return added;
}

// NGC-OFS-17: the tool whose entry P changes, and that entry; nothing after an alarm.
std::optional<std::string> tool_to_set(BlockContext& block) {
  const ClauseId clause = "NGC-OFS-17"_clause;
  if (!block.words.has('P')) {
    block.missing(clause, 'P');
    return std::nullopt;
  }
  const std::optional<Number> tool = whole_word(block, clause, 'P');
  if (!tool) return std::nullopt;
  const std::string number = tool->text();
  if (tool->sign() > 0 && entry_of(block, number)) return number;
  block.alarm(tool->sign() > 0 ? AlarmClass::no_tool : AlarmClass::value_out_of_range, clause, 'P',
              fmt::format("The tool table has no tool {}.", number));
  return std::nullopt;
}

}  // namespace

void set_tool(BlockContext& block, std::int64_t what) {
  const std::optional<std::string> tool = tool_to_set(block);
  if (!tool) return;
  Machine& machine = block.machine;
  const Offsets& offsets = machine.offsets;
  Position entry = entry_of(block, *tool).value_or(Position{});
  if (what == 1) {
    each_axis_word(block, [&](Axis axis, const Number& value) { entry[axis] = value; });
  } else {
    // L11: in G59.3, without an offset of G92.
    const std::size_t system = what == 10 ? offsets.system : kSystems.size() - 1;
    const Position& base = offsets.systems[system];
    entry = difference(origin_by_words(block, sum(base, entry), offsets.angles[system],
                                       what == 10 ? offsets.shift : Position{}),
                       base);
  }
  machine.tool.changed[*tool] = entry;
}

// NGC-OFS-08, NGC-OFS-09, NGC-OFS-10
void take_tool_length(BlockContext& block) {
  Position tool = block.machine.offsets.tool;
  switch (block.codes.tool_length) {
    case 490:
      tool = {};
      break;
    case 431:
      refuse_motion(block, "NGC-OFS-09"_clause);
      each_axis_word(block, [&](Axis axis, const Number& value) { tool[axis] = value; });
      break;
    case 430: {
      // NGC-OFS-23
      if (!block.words.has('H') && block.readings.is("ngc.g43-without-h=missing-word"_reading)) {
        return block.missing("NGC-OFS-23"_clause, 'H');
      }
      const std::optional<Position> offset = offset_of_tool(block, "NGC-OFS-08"_clause);
      if (!offset) return;
      tool = *offset;
      break;
    }
    case 432: {
      const std::optional<Position> added = additional_offset(block);
      if (!added) return;
      tool = sum(tool, *added);
      break;
    }
    default:
      return;
  }
  change_offsets(block.machine, [&](Offsets& offsets) { offsets.tool = tool; });
}

}  // namespace gonogo::reference::rs274
