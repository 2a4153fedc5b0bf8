// SPDX-License-Identifier: GPL-3.0-or-later
//
// One block: its codes change the modal state, then the code in force runs.
#include "reference/gsk988ta/interpreter.hpp"

#include "reference/clause_literal.hpp"
#include "reference/gsk988ta/cutting_cycle.hpp"
#include "reference/gsk988ta/machine.hpp"
#include "reference/gsk988ta/milling.hpp"
#include "reference/gsk988ta/word_use.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::reference::gsk988ta {
namespace {

// What a feed is counted in.
struct FeedBasis {
  Units units = Units::mm;
  FeedMode mode = FeedMode::per_minute;
};

class Interpreter : public BlockInterpreter {
 public:
  Interpreter(const Profile& profile, const ReadingsInUse& readings, OpenPaths open_paths)
      : profile_(profile), readings_(readings), open_paths_(open_paths) {
    machine_.position = profile.initial.at;
    machine_.plane = profile.initial.plane;
    machine_.units = profile.units;
    machine_.feed = profile.initial.feed;
    machine_.motion = profile.initial.motion;
    machine_.motion_before_cut = profile.initial.motion;
  }

  void run(std::uint64_t line, const grammar::Block& block, BlockOutput& out) override;
  void end_text(const grammar::Span& end, BlockOutput& out) override;
  const Position& position() const override { return machine_.position; }
  // Only the plane is open in a path: along the other axes the cycle says where it ends.
  void stand_at(const Position& position) override {
    const PlaneAxes axes = axes_of(machine_.plane);
    machine_.position[axes.p] = position[axes.p];
    machine_.position[axes.q] = position[axes.q];
  }

 private:
  bool takes_each_m(const grammar::Block& block) const;
  bool later_wins(const grammar::Block& block, std::string_view may_repeat) const;
  void take_modes(const BlockCodes& codes);
  void take_motion_code(BlockContext& block);
  void take_cycle_code(BlockContext& block);
  void cancel_cycles(BlockContext& block);
  void take_feed(const BlockWords& words);
  void carry_feed(const FeedBasis& before);
  bool has_stray_word(const BlockContext& block) const;
  void check_words(const BlockContext& block, bool last_wins, std::string_view may_repeat) const;
  void check_cycle_words(const BlockContext& block, bool last_wins) const;
  void latch_entry_words(BlockContext& block) const;
  void run_code(BlockContext& block);
  void run_motion(BlockContext& block) const;
  void leave_milling_mode() { machine_.milling = {}; }
  void enter_cycle(BlockContext& block);
  void put_m_function(const grammar::Word& word, const BlockContext& block) const;
  void put_m_functions(const BlockContext& block, bool each) const;

  const Profile& profile_;
  const ReadingsInUse& readings_;
  OpenPaths open_paths_;
  Machine machine_;
  bool has_begun_ = false;  // a block with a word has run
  ProgramHead head_;
  CodeReading reading_;
};

// GSK-COM-11: parameter 3404#7 decides on the machine (1: up to three M functions in a block).
bool Interpreter::takes_each_m(const grammar::Block& block) const {
  const auto count = std::ranges::count(block.words, 'M', &grammar::Word::address);
  if (count < 2 || count > 3) return false;
  if (auto parameter = profile_.parameter("3404.7")) return parameter->sign() != 0;
  return readings_.is("gsk.m-functions=three"_reading);
}

// GSK-COM-07: parameter 3403#6 decides on the machine (0: the later one wins).
bool Interpreter::later_wins(const grammar::Block& block, std::string_view may_repeat) const {
  if (!repeats_address(block, may_repeat) && !repeats_group(block)) return false;
  if (auto parameter = profile_.parameter("3403.6")) return parameter->sign() == 0;
  return readings_.is("gsk.duplicate=last"_reading);
}

// Planes, units and feed modes hold from their block on.
void Interpreter::take_modes(const BlockCodes& codes) {
  const Plane plane = machine_.plane;
  const Units units = machine_.units;
  if (codes.units >= 0) machine_.units = codes.units == 20 ? Units::inch : Units::mm;
  if (codes.feed_mode >= 0) {
    machine_.feed_mode = codes.feed_mode == 99 ? FeedMode::per_revolution : FeedMode::per_minute;
  }
  if (codes.plane >= 0) {
    machine_.plane = static_cast<Plane>(codes.plane - 17);
  }
  // GSK-MOD-05: within the mode the initial plane is then that of the new depth axis.
  if (plane != machine_.plane) {
    machine_.milling.initial_plane = machine_.position[axes_of(machine_.plane).d];
  }
  const bool units_change = units != machine_.units;
  if (units_change || plane != machine_.plane) carry_cut(machine_, readings_, units_change);
}

void Interpreter::take_motion_code(BlockContext& block) {
  const int code = block.codes.motion;
  if (code < 0) return;
  // GSK-MOD-06, GSK-G110-15: a code of group 01 ends the mode of the milling cycles.
  leave_milling_mode();
  if (code != machine_.motion) {
    // GSK-G94-07, GSK-G90-07, GSK-G92-11: another code of group 01 clears what a cutting cycle
    // retains.
    machine_.cut.clear();
    block.entered_cut = is_cutting_cycle(code);
  }
  machine_.motion = code;
  if (!is_cutting_cycle(code)) machine_.motion_before_cut = code;
}

// GSK-MOD-01, GSK-MOD-04: entered from outside, or from another mode of the milling cycles. The
// code written again is not an entry, nor is the other one of its pair.
void Interpreter::enter_cycle(BlockContext& block) {
  MillingMode& mode = machine_.milling;
  const int code = block.codes.cycle;
  const CycleFamily family = family_of(code);
  block.entered_cycle = mode.family() != family;
  if (family == CycleFamily::thread && !block.entered_cycle && mode.code / 2 != code / 2) {
    block.entered_cycle = readings_.is("gsk.thread.mode=pairs"_reading);
  }
  block.changed_pair = !block.entered_cycle && mode.code != code;
  if (block.entered_cycle) {
    mode = {};
    mode.initial_plane = machine_.position[axes_of(machine_.plane).d];  // GSK-MOD-05
    // GSK-G94-07: no code of group 01, so what a cutting cycle retains waits.
    if (!machine_.cut.empty() && readings_.is("gsk.g94.in-mode=clear"_reading)) {
      machine_.cut.clear();
    }
  }
  mode.code = code;
}

// GSK-MOD-06: G80 ends the mode and the cutting cycles. As a code of group 01 it positions axis
// words, those of its own block too; else what was in force before the cycle moves them.
void Interpreter::cancel_cycles(BlockContext& block) {
  leave_milling_mode();
  machine_.cut.clear();
  if (block.codes.motion >= 0) return block.out.accept("GSK-MOD-10"_clause);
  const int before =
      is_cutting_cycle(machine_.motion) ? machine_.motion_before_cut : machine_.motion;
  const bool kept = before != 0 && readings_.is("gsk.g80.motion=kept"_reading);
  machine_.motion = kept ? before : 0;
}

void Interpreter::take_cycle_code(BlockContext& block) {
  const int code = block.codes.cycle;
  if (code == 80) {
    cancel_cycles(block);
  } else if (code > 0) {
    enter_cycle(block);
  } else if (machine_.milling.family() == CycleFamily::thread && block.words.any() &&
             readings_.is("gsk.thread.modal=none"_reading)) {
    leave_milling_mode();  // GSK-MOD-04
  }
}

// F of an earlier block where the units change, or the feed between minutes and revolutions.
void Interpreter::carry_feed(const FeedBasis& before) {
  if (machine_.feed.sign() <= 0) return;
  if (machine_.feed_mode != before.mode && readings_.is("gsk.feed-change=deleted"_reading)) {
    machine_.feed = 0;
    machine_.has_feed = false;
    return;
  }
  if (machine_.units == before.units || !machine_.has_feed)
    return;  // one of power-on has no number
  if (readings_.is("gsk.feed-units=length"_reading)) return;
  machine_.feed_in_inch = machine_.units == Units::inch;
  machine_.feed = machine_.feed_in_inch ? inches(machine_.feed) : machine_.feed / inches(1);
}

void Interpreter::take_feed(const BlockWords& words) {
  if (!words.has('F')) return;
  // GSK-G92-06: there F is the lead, apart from the feed unless a reading says that F is one word.
  if (machine_.motion == 92 && machine_.milling.code == 0 &&
      readings_.is("gsk.g92.lead=own"_reading)) {
    machine_.thread_lead = words.length('F').value();
    return;
  }
  machine_.has_feed = true;
  machine_.feed_in_inch = machine_.units == Units::inch;
  machine_.feed = words.written('F');
  if (machine_.feed_in_inch) machine_.feed = inches(machine_.feed);
}

// GSK-WRD-01: what no code of the block uses and no rule ignores ends the program, before what
// is wrong; but beside codes that are wrong it is not known whose a word is.
bool Interpreter::has_stray_word(const BlockContext& block) const {
  BlockOutput& out = block.out;
  if (out.not_covered) return false;
  const StrayWord stray = stray_word(block);
  if (stray.word == nullptr) return false;
  out.alarms.clear();
  out.not_covered =
      word_outside(*stray.word, stray.code == nullptr ? "" : stray.code->text(), block.line);
  return true;
}

void Interpreter::check_words(const BlockContext& block, bool last_wins,
                              std::string_view may_repeat) const {
  const BlockWords& words = block.words;
  std::vector<Alarm>& alarms = block.out.alarms;
  check_pairs(words, last_wins, may_repeat, alarms);
  check_code_groups(words, block.codes, alarms);
  check_feed_word(words, alarms);
  if (block.codes.once != 4 && has_fine_words(words.block(), profile_, machine_.units) &&
      readings_.is("gsk.decimals=alarm"_reading)) {
    check_decimals(words, profile_, machine_.units, alarms);
  }
  // The words of a code of group 00 are its own, except those of a cycle that is entered.
  if (block.codes.once < 0 || is_entry(block)) check_cycle_words(block, last_wins);
}

void Interpreter::check_cycle_words(const BlockContext& block, bool last_wins) const {
  const BlockWords& words = block.words;
  std::vector<Alarm>& alarms = block.out.alarms;
  const CycleFamily family = machine_.milling.family();
  if (family == CycleFamily::none && !is_cutting_cycle(machine_.motion)) return;
  check_ranges(words, *block.code_in_force(), family, last_wins, profile_, machine_.units, alarms);
  if (family == CycleFamily::helix) check_turns(words, alarms);
  if (family == CycleFamily::thread && words.has('K')) {
    check_run_out_angle(words, readings_.is("gsk.thread.k-range=360"_reading), profile_,
                        machine_.units, alarms);
  }
}

// GSK-MOD-02: the entry block gives the words of the mode, milling or not.
void Interpreter::latch_entry_words(BlockContext& block) const {
  if (!is_entry(block)) return;
  if (machine_.milling.family() == CycleFamily::pocket) latch_g110(block, false);
  if (machine_.milling.family() == CycleFamily::helix) latch_g112(block, false);
  if (machine_.milling.family() == CycleFamily::thread) latch_g114(block);
}

void Interpreter::run_code(BlockContext& block) {
  if (block.codes.once >= 0) latch_entry_words(block);
  switch (block.codes.once) {
    case 4:
      run_dwell(block);
      return;
    case 28:
      run_reference_point(block);
      break;
    case 50:
      run_rename_position(block);
      break;
    default:
      break;
  }
  if (block.codes.once >= 0) {
    // GSK-MOD-08 (GSK-G94-07, GSK-G90-07, GSK-G92-11): a code of group 00 other than G04 clears
    // what a cutting cycle retains.
    machine_.cut.clear();
    if (is_cutting_cycle(machine_.motion) && readings_.is("gsk.g94.after-00=cancelled"_reading)) {
      machine_.motion = 0;
    }
    return;
  }
  switch (machine_.milling.family()) {
    case CycleFamily::pocket:
      return run_g110(block);
    case CycleFamily::helix:
      return run_g112(block);
    case CycleFamily::thread:
      return run_g114(block);
    case CycleFamily::none:
      return run_motion(block);
  }
}

// The code of group 01 in force.
void Interpreter::run_motion(BlockContext& block) const {
  switch (machine_.motion) {
    case 0:
      return run_positioning(block);
    case 1:
      return run_straight_feed(block);
    case 2:
      return run_arc(block, -1);
    case 3:
      return run_arc(block, +1);
    case 90:
      return run_g90(block);
    case 92:
      return run_g92(block);
    case 94:
      return run_g94(block);
    default:
      return;
  }
}

// The M function is passed on: one that stops or ends something after the motion, another before
// (GSK-COM-05; M35 of the milling cycles before, GSK-G112-01).
void Interpreter::put_m_function(const grammar::Word& word, const BlockContext& block) const {
  std::optional<Record> record =
      read_m_function(word, block.line, "GSK-COM-05"_clause, "GSK-COM-11"_clause, block.out);
  if (!record) return;
  if (record->m == 35) {
    // The C axis is clamped before the tool cuts.
    record->before_cut = true;
    if (machine_.milling.family() == CycleFamily::helix) record->clause = "GSK-G112-01"_clause;
  }
  reference::put_m_function(*std::move(record), block.out);
}

// Each of them (GSK-COM-11), or the later one of two (GSK-COM-07).
void Interpreter::put_m_functions(const BlockContext& block, bool each) const {
  if (!block.words.has('M')) return;
  if (!each) return put_m_function(*block.words.word('M'), block);
  for (const grammar::Word& word : block.words.block().words) {
    if (word.address == 'M') put_m_function(word, block);
  }
}

void Interpreter::run(std::uint64_t line, const grammar::Block& block, BlockOutput& out) {
  if (leaves_program(block, line, has_begun_, "GSK-COM-13"_clause, out)) return;
  if (head_.repeats(block)) out.accept("GSK-COM-13"_clause);
  if (block.outside) {
    out.not_covered = construct_outside(block, line);
    return;
  }
  if (block.words.empty()) return;
  has_begun_ = true;
  const bool each_m = takes_each_m(block);
  const std::string_view may_repeat = each_m ? "GM" : "G";
  const bool last_wins = later_wins(block, may_repeat);
  read_codes(block, last_wins, reading_);
  if (reading_.not_covered) {
    out.not_covered = std::move(reading_.not_covered);
    out.not_covered->block = line;
    return;
  }
  out.alarms = std::move(reading_.alarms);

  const BlockCodes& codes = reading_.codes;
  const FeedBasis before{machine_.units, machine_.feed_mode};
  take_modes(codes);
  const bool round = codes.once != 4 && has_fine_words(block, profile_, machine_.units) &&
                     readings_.is("gsk.decimals=nearest"_reading);
  BlockWords words(block, profile_, machine_.units, round);
  BlockContext context{
      {machine_, words, profile_, readings_, line, out}, machine_, words, codes, open_paths_};
  take_motion_code(context);
  take_cycle_code(context);
  if (machine_.units != before.units) carry_milling(context);
  const bool has_wrong_codes = !out.alarms.empty();
  put_m_functions(context, each_m);
  if (!has_wrong_codes && has_stray_word(context)) return;
  check_words(context, last_wins, may_repeat);
  carry_feed(before);
  take_feed(words);
  if (out.notes_acceptances) note_unused_words(context);
  run_code(context);
  admit_other_classes(context);
  sort_by_place(out.alarms);
}

// GSK-COM-15
void Interpreter::end_text(const grammar::Span& end, BlockOutput& out) {
  const std::optional<Number> parameter = profile_.parameter("3404.6");
  if (!parameter || parameter->sign() != 0) return;
  out.alarms.push_back({AlarmClass::program_end, "GSK-COM-15"_clause, 0, end,
                        "No M02, M30 or second % ends the program, which parameter 3404#6 of this "
                        "machine wants."});
}

}  // namespace

std::unique_ptr<BlockInterpreter> make_interpreter(const Profile& profile,
                                                   const ReadingsInUse& readings,
                                                   OpenPaths open_paths) {
  return std::make_unique<Interpreter>(profile, readings, open_paths);
}

}  // namespace gonogo::reference::gsk988ta
