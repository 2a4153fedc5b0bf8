// SPDX-License-Identifier: GPL-3.0-or-later
//
// One block: its codes, the values of its words from left to right, its modes, its motion.
#include "reference/sinumerik/interpreter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/range.hpp"
#include "reference/reading_literal.hpp"
#include "reference/sinumerik/cycle.hpp"
#include "reference/sinumerik/machine.hpp"
#include "reference/sinumerik/names.hpp"

namespace gonogo::reference::sinumerik {
namespace {

constexpr ClauseId kCommon = "SIE-COM-01"_clause;
constexpr std::int64_t kLastM802s = 99;
// SIE-LC82-01, SIE-LC75-01
constexpr std::uint64_t kFirstCycleParameter = 101;
constexpr std::uint64_t kLastCycleParameter = 127;

class Interpreter : public BlockInterpreter {
 public:
  Interpreter(const Profile& profile, const ReadingsInUse& readings, Control control,
              OpenPaths open_paths);

  void run(std::uint64_t line, const grammar::Block& block, BlockOutput& out) override;
  const Position& position() const override { return machine_.base; }
  void stand_at(const Position& position) override;

 private:
  bool parses(const grammar::Block& block, BlockOutput& out) const;
  bool take_codes(std::uint64_t line, const grammar::Block& block, BlockOutput& out);
  bool take_values(std::uint64_t line, BlockWords& words, BlockOutput& out);
  void take_m(std::uint64_t line, const grammar::NamedWord& word, const Number& value,
              BlockOutput& out);
  void take_modes(BlockContext& block);
  void take_tool(const BlockWords& words);
  void run_once(BlockContext& block);
  void run_cycle(BlockContext& block);
  void run_motion(BlockContext& block);
  Motion motion_in_force() const;

  const Profile& profile_;
  const ReadingsInUse& readings_;
  OpenPaths open_paths_;
  Machine machine_;
  bool has_begun_ = false;  // a block with a word has run
  Calculator calculator_;
  CodeReading reading_;
};

Interpreter::Interpreter(const Profile& profile, const ReadingsInUse& readings, Control control,
                         OpenPaths open_paths)
    : profile_(profile),
      readings_(readings),
      open_paths_(open_paths),
      calculator_(control == Control::sinumerik802s ? kParameters802s : kParameters) {
  machine_.control = control;
  machine_.position = machine_.base = profile.initial.at;
  machine_.feed = profile.initial.feed;
  machine_.plane = profile.initial.plane;
  if (profile.initial.motion != kNoMotion) {
    machine_.motion = static_cast<Motion>(profile.initial.motion);
  }
  machine_.spindle = profile.initial.spindle;
  machine_.speed_given = machine_.spindle != 5;
  machine_.modes.inch = profile.units == Units::inch;
  machine_.modes.diameter = profile.x_diameter;
}

void Interpreter::stand_at(const Position& position) {
  machine_.base = position;
  machine_.position = machine_.frame.to_workpiece(position);
}

// SIE-FRM-03: a block with RPL45 is no block where the sign is required.
bool Interpreter::parses(const grammar::Block& block, BlockOutput& out) const {
  if (machine_.control != Control::sinumerik802s) return true;
  const auto is_bare = [](const grammar::NamedWord& word) {
    return address_of(word) == Address::rpl && !word.has_equals;
  };
  const auto bare = std::ranges::find_if(block.named, is_bare);
  if (bare == block.named.end() || !readings_.is("sie.rpl-equals=required"_reading)) {
    return true;
  }
  out.alarms.push_back({AlarmClass::syntax, "SIE-FRM-03"_clause, WordName("RPL"), bare->where,
                        "RPL and its angle need an '=' between them."});
  return false;
}

// Whether the block is read on: what is not covered goes before what is wrong, and a block with an
// unknown code is not checked further.
bool Interpreter::take_codes(std::uint64_t line, const grammar::Block& block, BlockOutput& out) {
  read_codes(machine_.control, block, reading_);
  if (reading_.not_covered) {
    out.not_covered = std::move(reading_.not_covered);
    out.not_covered->block = line;
    return false;
  }
  const auto is_undefined = [](const Alarm& alarm) {
    return alarm.alarm == AlarmClass::undefined_code;
  };
  const bool has_undefined = std::ranges::any_of(reading_.alarms, is_undefined);
  // Beside a code that the control lacks a block has no meaning, but it may be misspelt, too.
  for (const Alarm& alarm : reading_.alarms) {
    const bool stands = is_undefined(alarm) || alarm.alarm == AlarmClass::syntax;
    if (!has_undefined || stands) out.alarms.push_back(alarm);
  }
  out.warnings.insert(out.warnings.end(), reading_.warnings.begin(), reading_.warnings.end());
  return !has_undefined;
}

// SIE-MOD-02: the M functions that stop or end something come after the motion.
void Interpreter::take_m(std::uint64_t line, const grammar::NamedWord& word, const Number& value,
                         BlockOutput& out) {
  const ClauseId clause = "SIE-MOD-02"_clause;
  if (value != value.floor()) {
    out.alarms.push_back(
        {AlarmClass::not_an_integer, clause, 'M', word.where,
         with_values("The number of an M function is whole, and not {}.", {value})});
    return;
  }
  if (value.sign() < 0 || value > Number(kLargestM)) {
    out.alarms.push_back(
        {AlarmClass::value_out_of_range, clause, 'M', word.where,
         with_values("An M function is from 0 to {}, and not {}.", {kLargestM, value})});
    return;
  }
  if (machine_.control == Control::sinumerik802s && value > Number(kLastM802s)) {
    out.not_covered = m_function_too_large(*value.to_int64(), word.where, line);
    return;
  }
  Record record;
  record.kind = RecordKind::m;
  record.clause = clause;
  record.block = line;
  record.m = static_cast<std::int32_t>(*value.to_int64());
  const std::int32_t m = record.m;
  const bool ends_program = m == 2 || m == 17 || m == 30;
  const bool after = ends_program || m == 0 || m == 1;
  if (after && out.program_end) return;  // nothing runs after the end
  (after ? out.after : out.items).emplace_back(std::move(record));
  if (ends_program) out.program_end = true;
  if (m >= 3 && m <= 5) {
    machine_.spindle = m;
    machine_.spindle_is_placed = false;
  }
  if (m == 6) machine_.last_m6.emplace();
  if (m == 6 || m == 19 || m == 70) machine_.spindle_is_placed = true;
}

// Lengths, angles, feeds and speeds; tools and turns are numbers.
bool is_measured(Address address) {
  return address != Address::t && address != Address::d && address != Address::turn;
}

// The name that an alarm gives the word.
WordName word_name(const grammar::NamedWord& word, const std::optional<Address>& address) {
  if (!address) return WordName(word.name);
  return address == Address::r ? WordName(fmt::format("R{}", *word.index)) : name_of(*address);
}

// SIE-PAR-01: from left to right, each assignment at once; what is ignored has a value, too.
// SIE-COM-01: no address twice. Whether all words have values.
bool Interpreter::take_values(std::uint64_t line, BlockWords& words, BlockOutput& out) {
  const grammar::Block& block = words.block();
  bool complete = true;
  bool has_m = false;
  for (const grammar::NamedWord& word : block.named) {
    const std::optional<Address> address = address_of(word);
    const bool is_ignored =
        !address && word.terms != 0 && find_name(machine_.control, word) != nullptr;
    if (address ? *address == Address::g : !is_ignored) continue;
    const bool repeats =
        is_ignored || *address == Address::r || *address == Address::m || *address == Address::h;
    const WordName name = word_name(word, address);
    if (!repeats && words.has(*address)) {
      out.alarms.push_back({AlarmClass::duplicate_word, kCommon, name, word.where,
                            fmt::format("The address {} stands twice in the block.", name.text())});
    }
    NoValue problem;
    ClauseId clause = "SIE-PAR-01"_clause;
    std::optional<Number> value = calculator_.value(block, word, problem);
    if (value && address == Address::r && *word.index >= calculator_.count()) {
      problem = {word.where,
                 fmt::format("The R parameters are R0 to R{}, and this is number {}.",
                             calculator_.count() - 1, *word.index),
                 false};
      // The 802S's are printed; those of the 840D a machine data says.
      if (machine_.control == Control::sinumerik840d) clause = "SIE-PAR-02"_clause;
      value.reset();
    }
    if (!value && problem.is_too_long) {
      out.not_covered = NotCovered{line, "expression", problem.message, problem.where};
      return false;
    }
    if (!value) {
      complete = false;
      out.alarms.push_back(
          {AlarmClass::value_out_of_range, clause, name, word.where, problem.message});
    } else if (is_ignored) {
      if (word.name == "SPOS" || word.name == "SPOSA") machine_.spindle_is_placed = true;
    } else if (*address == Address::r) {
      calculator_.assign(*word.index, *std::move(value));
    } else if (*address == Address::m) {
      if (std::exchange(has_m, true)) out.accept("SIE-COM-04"_clause);
      take_m(line, word, *value, out);
    } else {
      if (*address == Address::h && words.has(*address)) out.accept("SIE-COM-04"_clause);
      if (is_measured(*address) && is_beyond_range(*value)) out.beyond_range = word.where;
      words.take(*address, word, *std::move(value));
    }
  }
  return complete;
}

// SIE-LC75-03: T0 and D0 are no tool.
void Interpreter::take_tool(const BlockWords& words) {
  if (words.has(Address::t)) {
    const Number& tool = words.written(Address::t);
    machine_.tool = tool.sign() == 0 ? std::nullopt : std::optional(tool);
    machine_.edge = 1;
  }
  if (words.has(Address::d)) machine_.edge = words.written(Address::d);
  if (machine_.last_m6 && !machine_.last_m6->is_done) {
    machine_.last_m6 = ToolChange{machine_.tool, true};
  }
}

// F and S of a dwell are its own. G90, G70 and the plane hold for their own block.
void Interpreter::take_modes(BlockContext& block) {
  const BlockCodes& codes = block.codes;
  const BlockWords& words = block.words;
  if (codes.once != 4) take_feed_and_speed(block);
  if (codes.units >= 0) machine_.modes.inch = codes.units == 70;
  if (codes.dimension >= 0) machine_.modes.incremental = codes.dimension == 91;
  take_feed_mode(block);
  if (codes.plane >= 0) {
    const auto plane = static_cast<Plane>(codes.plane - 17);
    admits_plane(block, plane, 'G');
    take_plane(machine_, plane);  // refused or not: its words are meant in it
  }
  take_tool(words);
  accept_odd_numbers(block);
  if (codes.motion) machine_.motion = codes.motion;
}

// The texts have no diameters. A machine that is set so takes X of an end as one; what else it
// takes as one they do not say.
void leave_out_diameters(BlockContext& block) {
  const BlockWords& words = block.words;
  const auto leave_out = [&](Address address, std::string_view what) {
    if (block.out.not_covered) return;
    const WordName name = name_of(address);
    block.out.not_covered =
        NotCovered{block.line, std::string(name.text()),
                   fmt::format("No text says whether {} is a diameter, as X of an end is.", what),
                   words.place_of(name).value_or(words.behind())};
  };
  const BlockCodes& codes = block.codes;
  const bool is_offset = codes.once >= 0 && codes.once != 4;
  if (is_offset && words.has(Address::x)) leave_out(Address::x, "X of a frame or a pole");
  if (words.is_polar()) leave_out(Address::rp, "a polar radius");
  if (words.has(Address::i1)) leave_out(Address::i1, "I1");
  if (words.has(Address::i) && words.dimension(Address::i) == grammar::Dimension::absolute) {
    leave_out(Address::i, "I of a place");
  }
  const bool goes_along_x = codes.cycle == Cycle::lcyc75 || block.machine.plane == Plane::g19;
  if (codes.cycle != Cycle::none && goes_along_x) leave_out(Address::r, "a parameter along X");
}

// SIE-MOD-02
Motion Interpreter::motion_in_force() const {
  if (machine_.motion) return *machine_.motion;
  return readings_.is("sie.initial-motion=g0"_reading) ? Motion::traverse : Motion::line;
}

// Whether words of the block ask for a motion. Those of an arc do, so that they are checked.
bool asks_for_motion(const BlockWords& words) {
  constexpr auto kLast = index(Address::turn);
  for (std::size_t i = 0; i <= kLast; ++i) {
    if (words.has(static_cast<Address>(i))) return true;
  }
  return false;
}

void Interpreter::run_motion(BlockContext& block) {
  if (block.words.has(Address::rpl)) {
    block.alarm(AlarmClass::conflicting_words, "SIE-COM-02"_clause, WordName("RPL"),
                "RPL is the angle of G258 and G259.");
  }
  if (!asks_for_motion(block.words)) return;
  switch (motion_in_force()) {
    case Motion::traverse:
      return run_line(block, RecordKind::rapid);
    case Motion::line:
      return run_line(block, RecordKind::feed);
    case Motion::clockwise:
      return run_arc(block, -1);
    case Motion::counterclockwise:
      return run_arc(block, +1);
    case Motion::intermediate:
      return run_intermediate(block);
    case Motion::tangent:
      return run_tangent(block);
  }
}

void Interpreter::run_once(BlockContext& block) {
  // Which of them is meant is not known.
  if (block.codes.several_once) return refuse_beside_frame(block);
  const PlaneAxes axes = block.plane_axes();
  switch (block.codes.once) {
    case 4:
      refuse_all_but(block, {Address::f, Address::s});
      return run_dwell(block);
    case 158:
    case 258:
    case 259:
      refuse_all_but(block,
                     {Address::x, Address::y, Address::z, Address::a, Address::c, Address::rpl});
      return block.codes.once == 158 ? run_translation(block) : run_rotation(block);
    default:
      refuse_all_but(block, {address_of(axes.p), address_of(axes.q), Address::ap, Address::rp});
      run_pole(block);
  }
}

void Interpreter::run_cycle(BlockContext& block) {
  if (!cycle_stands_alone(block)) return;  // no call, whose parameters could be wrong
  for (std::uint64_t number = kFirstCycleParameter; number <= kLastCycleParameter; ++number) {
    if (is_beyond_range(calculator_.parameter(number))) block.out.beyond_range.emplace();
  }
  const CycleCall call{block, calculator_, open_paths_};
  block.codes.cycle == Cycle::lcyc82 ? run_lcyc82(call) : run_lcyc75(call);
}

void Interpreter::run(std::uint64_t line, const grammar::Block& block, BlockOutput& out) {
  if (leaves_program(block, line, has_begun_, "SIE-LEX-04"_clause, out)) return;
  if (block.outside) {
    out.not_covered = construct_outside(block, line);
    return;
  }
  const bool has_other_blank = block.other_blank.span.end != 0;
  if (has_other_blank && machine_.control == Control::sinumerik802s) {
    out.accept("SIE-LEX-03"_clause);
  }
  if (block.named.empty()) return;
  has_begun_ = true;
  if (!parses(block, out) || !take_codes(line, block, out)) return;
  BlockWords words(block, machine_.modes);
  BlockContext context{
      {machine_, words, profile_, readings_, line, out}, machine_, words, reading_.codes};
  const bool complete = take_values(line, words, out);
  if (out.not_covered) {
    out.alarms.clear();
    return;
  }
  if (complete) {
    take_modes(context);
    settle_pole(context);
    if (machine_.modes.diameter) leave_out_diameters(context);
    leave_out_frames(context);
    if (out.not_covered) {
      out.alarms.clear();
      return;
    }
    if (reading_.codes.cycle != Cycle::none) {
      run_cycle(context);
    } else if (reading_.codes.once >= 0) {
      run_once(context);
    } else {
      run_motion(context);
    }
  }
  admit_other_classes(context);
  sort_by_place(out.alarms);
}

}  // namespace

std::unique_ptr<BlockInterpreter> make_interpreter_840d(const Profile& profile,
                                                        const ReadingsInUse& readings,
                                                        OpenPaths open_paths) {
  return std::make_unique<Interpreter>(profile, readings, Control::sinumerik840d, open_paths);
}

std::unique_ptr<BlockInterpreter> make_interpreter_802s(const Profile& profile,
                                                        const ReadingsInUse& readings,
                                                        OpenPaths open_paths) {
  return std::make_unique<Interpreter>(profile, readings, Control::sinumerik802s, open_paths);
}

}  // namespace gonogo::reference::sinumerik
