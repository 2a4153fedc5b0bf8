// SPDX-License-Identifier: GPL-3.0-or-later
//
// One block. NGC-MOD-01, NGC-CYC-01: its words act in this order, not in that of the line:
// feed, M functions, dwell, plane, units, tool length, coordinate system, distance, return of
// cycles, offsets and reference points, motion, and the M functions that stop the program.
#include "reference/rs274/interpreter.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reference/clause_literal.hpp"
#include "reference/reading_literal.hpp"
#include "reference/rs274/calculated_words.hpp"
#include "reference/rs274/m_functions.hpp"
#include "reference/rs274/machine.hpp"
#include "reference/rs274/modes.hpp"
#include "reference/rs274/o_words.hpp"
#include "reference/rs274/other_classes.hpp"
#include "reference/rs274/polar_words.hpp"
#include "reference/rs274/program_text.hpp"
#include "reference/rs274/tool_lengths.hpp"
#include "reference/rs274/unused_words.hpp"

namespace gonogo::reference::rs274 {
namespace {

class Interpreter : public BlockInterpreter {
 public:
  Interpreter(const Profile& profile, const ReadingsInUse& readings);

  void run(std::uint64_t line, const grammar::Block& block, BlockOutput& out) override;
  bool next_line(grammar::LineSource& lines, grammar::Line& line) override;
  bool may_repeat_lines() const override { return o_words_.is_used(); }
  void leave_out() override { text_.leave_out(); }
  // NGC-COM-12
  bool alarms_left_out() const override { return readings_.is("ngc.block-delete=read"_reading); }
  void end_text(const grammar::Span& end, BlockOutput& out) override {
    check_text_end(end, o_words_.skipped_label(), readings_, out);
  }
  const Position& position() const override;
  void stand_at(const Position& position) override;

 private:
  bool refuses_length(BlockOutput& out) const;
  void run_line(std::uint64_t line, const grammar::Block& block, BlockOutput& out);
  bool calculate(std::uint64_t line, const grammar::Block& block, BlockOutput& out);
  bool read_words(std::uint64_t line, const grammar::Block& block, BlockOutput& out);
  void run_words(std::uint64_t line, const grammar::Block& block, const WordValues* values,
                 BlockOutput& out);
  void take_feed_mode(const BlockWords& words, int mode);
  void take_feed(const BlockWords& words, const BlockCodes& codes);
  void run_subprogram(const BlockContext& block);
  void take_spindle(const MFunctions& functions);
  void take_modes(const BlockCodes& codes, std::uint64_t line);
  void take_tool(const BlockContext& block);
  void take_motion(int code);
  void run_block(BlockContext& block) const;

  const Profile& profile_;
  const ReadingsInUse& readings_;
  Machine machine_;
  CodeReading reading_;
  ProgramText text_;
  Parameters parameters_;
  OWords o_words_;
  CalculatedWords calculated_;
  SavedModes saved_;
  std::size_t line_length_ = 0;
  mutable Position of_machine_;  // what position() gives out
};

Interpreter::Interpreter(const Profile& profile, const ReadingsInUse& readings)
    : profile_(profile),
      readings_(readings),
      machine_(profile),
      o_words_(parameters_, readings, profile.block_skip) {
  stand_at(profile.initial.at);
  machine_.feed = machine_.rotary_feed = profile.initial.feed;
  machine_.plane = profile.initial.plane;
  machine_.motion = profile.initial.motion;
  machine_.spindle = profile.initial.spindle;
  machine_.modes.inch = profile.units == Units::inch;
}

// NGC-OFS-01
const Position& Interpreter::position() const {
  if (!machine_.offsets.frame.is_moved) return machine_.position;
  return of_machine_ = machine_.offsets.frame.to_machine(machine_.position);
}

void Interpreter::stand_at(const Position& position) {
  machine_.position = machine_.offsets.frame.to_program(position);
  machine_.polar.reset();
}

// NGC-COM-13: what a carriage return is has to be known before the first line.
bool Interpreter::next_line(grammar::LineSource& lines, grammar::Line& line) {
  if (profile_.takes_cr_for_blank()) lines.take_cr_for_blank();
  const bool is_there = o_words_.next(lines, line);
  if (lines.has_lone_cr()) readings_.touch("ngc.lone-cr"_key);
  line_length_ = line.text.size();
  return is_there;
}

// NGC-FED-02: a feed is lost with its mode. NGC-MOD-03: the same mode again may keep it.
void Interpreter::take_feed_mode(const BlockWords& words, int mode) {
  const FeedMode coming = mode == 95 ? FeedMode::per_revolution : FeedMode::per_minute;
  const bool changes = machine_.is_inverse_time != (mode == 93) || machine_.feed_mode != coming;
  machine_.is_inverse_time = mode == 93;
  machine_.feed_mode = coming;
  const bool loses = changes || (!words.has('F') && machine_.feed.sign() != 0 &&
                                 readings_.is("ngc.g94-feed=none"_reading));
  if (loses) machine_.feed = machine_.rotary_feed = 0;
}

// NGC-MOD-01: the mode of the feed comes before F, and F before the units of its block.
void Interpreter::take_feed(const BlockWords& words, const BlockCodes& codes) {
  if (codes.feed_mode >= 0) take_feed_mode(words, codes.feed_mode);
  if (!words.has('F') || machine_.is_inverse_time) return;
  WordModes modes = machine_.modes;
  const bool becomes_inch = codes.units == 20;
  const bool changes = codes.units >= 0 && becomes_inch != modes.inch;
  if (changes && readings_.is("ngc.feed-units=after"_reading)) modes.inch = becomes_inch;
  machine_.rotary_feed = words.written('F');
  machine_.is_feed_written = true;
  machine_.feed = modes.length_of(machine_.rotary_feed);
}

// NGC-SPD-03: M6 stops the spindle, before M3 and M4 of its block, wherever they stand. NGC-CYC-28:
// all of them come before the cycle of their block.
void Interpreter::take_spindle(const MFunctions& functions) {
  if (functions[6]) machine_.spindle = 5;
  for (const int number : {3, 4, 5}) {
    if (functions[static_cast<std::size_t>(number)]) machine_.spindle = number;
  }
  if (functions[7]) machine_.has_mist = true;
  if (functions[8]) machine_.has_flood = true;
  if (functions[9]) machine_.has_mist = machine_.has_flood = false;
}

// NGC-OFS-08: T selects a tool, M6 loads it, M61 says which one is loaded; all before G43.
void Interpreter::take_tool(const BlockContext& block) {
  ToolState& tool = machine_.tool;
  if (block.words.has('T')) tool.selected = block.words.written('T');
  if (block.functions[6] && !tool.selected) block.out.accept("NGC-COM-14"_clause);
  if (block.functions[6]) tool.loaded = tool.selected;
  if (block.functions[61] && block.words.has('Q')) tool.loaded = block.words.written('Q');
}

// NGC-CYC-24, NGC-CYC-25: any code of motion but a cycle ends a series of cycles, and no other code
// does.
void Interpreter::take_motion(int code) {
  const int motion = code == 80 ? kNoMotion : code;
  if (motion != machine_.motion) machine_.cycle.forget_words();
  if (!is_hole_cycle(motion)) machine_.cycle.series.reset();
  machine_.motion = motion;
}

void Interpreter::take_modes(const BlockCodes& codes, std::uint64_t line) {
  WordModes& modes = machine_.modes;
  if (codes.plane >= 0) {
    const auto plane = static_cast<Plane>(codes.plane - 17);
    if (plane != machine_.plane) machine_.cycle.leave_plane();
    machine_.plane = plane;
  }
  if (codes.units >= 0) modes.inch = codes.units == 20;  // NGC-UNI-01
  if (codes.diameter >= 0) modes.diameter = codes.diameter == 7;
  if (codes.speed >= 0) machine_.has_surface_speed = codes.speed == 96;
  // NGC-DIS-01
  if (codes.distance >= 0) modes.incremental = codes.distance == 91;
  if (codes.arc_distance >= 0) modes.absolute_centre = codes.arc_distance == 90;
  // NGC-CYC-10
  if (codes.retract == 98) machine_.retract = Retract::initial_level;
  if (codes.retract == 99) machine_.retract = Retract::r_plane;
  if (codes.motion >= 0) take_motion(codes.motion);
  if (codes.motion == 80) machine_.motion_ended = line;
}

// NGC-COM-01, NGC-CYC-17: the axes that the records do not have.
void check_axes(const grammar::Block& block, std::uint64_t line, BlockOutput& out) {
  for (const grammar::Word& word : block.words) {
    const char address = word.address;
    if (address != 'B' && address != 'U' && address != 'V' && address != 'W') continue;
    out.not_covered = NotCovered{
        line, std::string(1, address),
        fmt::format("The axis {} is one that the gauge does not read.", address), word.where};
    return;
  }
}

// A motion is asked for by its code or an axis word; NGC-ARC-06: an arc by I J K alone, too.
bool runs_motion(const Machine& machine, const BlockWords& words, const BlockCodes& codes,
                 const ReadingsInUse& readings) {
  if (machine.motion == kNoMotion || takes_axis_words(codes)) return false;
  if (codes.motion >= 0 || words.has_axis_word()) return true;
  return is_arc(machine.motion) && words.has_offset() &&
         readings.is("ngc.arc-words-alone=arc"_reading);
}

// Rules that ask for no other word but one like it.
void check_each_word(BlockContext& block) {
  const ClauseId clause = "NGC-COM-01"_clause;
  check_repeated_addresses(block.words, clause, block.out.alarms, "GM@^");
  check_m_groups(block.words.block(), block.readings, block.out.alarms);
  check_feed_sign(block.words, clause, block.out.alarms);
  check_spindle_and_tool(block);
}

// NGC-G4-02: whether the motion alone is wrong, and not for want of a word that is looked for when
// the line is read.
bool finds_behind_dwell(const BlockContext& block) {
  return block.out.before_alarm.empty() &&
         std::ranges::none_of(block.out.alarms, [](const Alarm& alarm) {
           const bool is_of_axes = alarm.clause == "NGC-CYC-04"_clause ||
                                   alarm.clause == "NGC-MOD-01"_clause ||
                                   alarm.clause == "NGC-MOD-02"_clause;
           return is_of_axes && alarm.alarm == AlarmClass::missing_word;
         });
}

void Interpreter::run_block(BlockContext& block) const {
  check_unused_words(block);
  check_once(block);
  check_modes(block);
  take_offsets(block);
  if (block.machine.offsets.frame.is_turned) block.start = block.machine.position;
  check_polar_words(block);
  run_once(block);  // NGC-CYC-27: a dwell is before all motion
  const bool is_sound = block.out.alarms.empty() && !block.out.not_covered;
  run_motion(block);
  keep_polar_place(block);
  if (!is_sound || block.out.alarms.empty() || !finds_behind_dwell(block)) return;
  std::vector<Item> dwells = dwells_of(block);
  if (!dwells.empty() && readings_.is("ngc.alarm-dwell=dwells"_reading)) {
    block.out.before_alarm = std::move(dwells);
  }
}

// NGC-SAV-01
NotCovered left_running(std::uint64_t line) {
  return {line, "M73", "The gauge does not stop what a subroutine leaves running.", {}};
}

// Calculates what the block has to be calculated, and runs it where it is an O word. Whether its
// words run.
bool Interpreter::calculate(std::uint64_t line, const grammar::Block& block, BlockOutput& out) {
  Calculator calculator(machine_, parameters_, readings_);
  if (block.control) {
    check_numbers(block, readings_, out);
    o_words_.take(block, calculator, out);
    const bool is_kept = saved_.follow(o_words_.calls(), machine_);
    if (!is_kept) calculator.outside = left_running(line);
  } else if (calculated_.take(block, calculator, out)) {
    calculator.assign(block);
  }
  if (calculator.outside) {
    out.not_covered = std::move(calculator.outside);
    out.not_covered->block = line;
    out.alarms.clear();
  } else if (calculator.alarm) {
    out.alarms.push_back(*std::move(calculator.alarm));
  }
  return !block.control && out.alarms.empty() && !out.not_covered;
}

// NGC-COM-16
bool Interpreter::refuses_length(BlockOutput& out) const {
  constexpr std::size_t kMostCharacters = 256;
  if (line_length_ <= kMostCharacters || readings_.is("ngc.long-line=read"_reading)) return false;
  const grammar::Span behind{kMostCharacters, static_cast<std::uint32_t>(line_length_)};
  out.alarms.push_back({AlarmClass::syntax, "NGC-COM-16"_clause, 0, behind,
                        fmt::format("The line has {} characters, more than 256.", line_length_)});
  return true;
}

void Interpreter::run(std::uint64_t line, const grammar::Block& block, BlockOutput& out) {
  if (refuses_length(out)) return;
  run_line(line, block, out);
  if (out.alarms.empty()) return;
  const bool is_calculated = !block.terms.empty() && !block.control;
  admit_other_classes(is_calculated ? calculated_.block() : block, out.alarms);
}

void Interpreter::run_line(std::uint64_t line, const grammar::Block& block, BlockOutput& out) {
  text_.take(block, out);
  // NGC-OWD-10
  if (o_words_.is_beyond() || (block.tape_mark && o_words_.skips_lines())) {
    out.alarms.clear();
    out.not_covered = NotCovered{
        line,
        "o-word",
        "The gauge remembers a mebibyte of lines, follows a hundred thousand that come again, and "
        "ends no program within what does not run.",
        {}};
    return;
  }
  if (!block.control && !block.program_number) {
    check_abort(block, out);
    if (!out.alarms.empty()) return;
  }
  if (block.outside) {
    out.not_covered = construct_outside(block, line);
    return;
  }
  if (block.terms.empty() && !block.control) return run_words(line, block, nullptr, out);
  if (!calculate(line, block, out)) return;
  run_words(line, calculated_.block(), &calculated_.values(), out);
}

// Whether the words of the block can run, or be checked at least.
bool Interpreter::read_words(std::uint64_t line, const grammar::Block& block, BlockOutput& out) {
  read_codes(block, readings_, reading_);
  if (reading_.not_covered) {
    out.not_covered = std::move(reading_.not_covered);
    out.not_covered->block = line;
    return false;
  }
  check_axes(block, line, out);
  take_m_functions(block, line, readings_, out);
  if (out.not_covered) {
    out.alarms.clear();  // what is not covered goes before what is wrong
    return false;
  }
  check_numbers(block, readings_, out);
  if (!out.alarms.empty() && out.alarms.back().alarm == AlarmClass::syntax) {
    // A block that cannot be read yields the syntax alarm alone.
    out.alarms.erase(out.alarms.begin(), out.alarms.end() - 1);
    return false;
  }
  return true;
}

void Interpreter::run_words(std::uint64_t line, const grammar::Block& block,
                            const WordValues* values, BlockOutput& out) {
  if (block.words.empty()) return check_numbers(block, readings_, out);
  if (!read_words(line, block, out)) return;
  const BlockCodes& codes = reading_.codes;
  out.alarms.insert(out.alarms.end(), reading_.alarms.begin(), reading_.alarms.end());
  const BlockWords words(block, machine_.modes, values);
  BlockContext context{
      {machine_, words, profile_, readings_, line, out}, machine_, words, codes, reading_.letters};
  check_each_word(context);
  check_signals(context);
  const auto is_undefined = [](const Alarm& alarm) {
    return alarm.alarm == AlarmClass::undefined_code;
  };
  if (std::ranges::any_of(reading_.alarms, is_undefined)) {
    // What else is wrong depends on what an unknown code would be.
    sort_by_place(out.alarms);
    return;
  }
  take_feed(words, codes);
  context.functions = m_functions_of(block, readings_);
  take_spindle(context.functions);
  take_tool(context);
  saved_.take(context);
  take_overrides(context);
  const bool has_diameters = machine_.modes.diameter;
  const Plane plane = machine_.plane;
  take_modes(codes, line);
  context.turns_plane = machine_.plane != plane;
  context.turns_diameters = machine_.modes.diameter != has_diameters;
  context.runs_motion = runs_motion(machine_, words, codes, readings_);
  context.p_is_turns = context.runs_motion && is_arc(machine_.motion) && words.has('P') &&
                       !is_taken_beside_motion(context, 'P');
  run_block(context);
  move_out(machine_.offsets.frame, context.start, out);
  if (out.not_covered) out.alarms.clear();  // what is not covered goes before what is wrong
  sort_by_place(out.alarms);
  if (out.alarms.empty() && !out.not_covered) run_subprogram(context);
}

// NGC-OWD-13: M98 and M99 come behind all else of their block; each stands alone in it.
void Interpreter::run_subprogram(const BlockContext& block) {
  if (!block.functions[98] && !block.functions[99]) return;
  BlockOutput& out = block.out;
  const grammar::Span& where = block.words.word('M')->where;
  const std::size_t calls = o_words_.calls();
  bool is_kept = true;
  if (block.functions[98]) {
    o_words_.call_numbered(block.words, where, out);
  } else {
    o_words_.end_numbered(block.line, where, out);
    // NGC-SAV-01: what a pass has saved ends with it, also where another pass follows.
    if (out.alarms.empty() && !out.not_covered) is_kept = saved_.follow(calls - 1, machine_);
  }
  is_kept = saved_.follow(o_words_.calls(), machine_) && is_kept;
  if (!is_kept) out.not_covered = left_running(block.line);
  if (!out.alarms.empty() || out.not_covered) {
    out.items.clear();
    out.cycle = {};
  }
}

}  // namespace

std::unique_ptr<BlockInterpreter> make_interpreter(const Profile& profile,
                                                   const ReadingsInUse& readings,
                                                   OpenPaths open_paths) {
  static_cast<void>(open_paths);  // no path of this dialect is open
  return std::make_unique<Interpreter>(profile, readings);
}

}  // namespace gonogo::reference::rs274
