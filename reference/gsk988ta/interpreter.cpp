// SPDX-License-Identifier: GPL-3.0-or-later
//
// One block: its codes change the modal state, then the code in force runs.
#include "reference/gsk988ta/interpreter.hpp"

#include <fmt/format.h>

#include <utility>

#include "reference/gsk988ta/machine.hpp"

namespace gonogo::reference::gsk988ta {
namespace {

class Interpreter : public BlockInterpreter {
 public:
  Interpreter(const Profile& profile, const ReadingsInUse& readings, OpenPaths open_paths)
      : profile_(profile), readings_(readings), open_paths_(open_paths) {
    machine_.position = profile.initial.at;
    machine_.plane = profile.initial.plane;
    machine_.units = profile.units;
    machine_.feed = profile.initial.feed;
    machine_.motion = profile.initial.motion;
  }

  void run(std::uint64_t line, const grammar::Block& block, BlockOutput& out) override;
  const Position& position() const override { return machine_.position; }

 private:
  bool last_wins() const;
  void take_modes(const BlockCodes& codes);
  void take_motion_code(BlockContext& block);
  void take_cycle_code(BlockContext& block);
  void take_feed(const BlockWords& words);
  bool check_words(const BlockWords& words, const BlockCodes& codes, BlockOutput& out) const;
  void run_code(BlockContext& block);
  void leave_pocket_mode() { machine_.pocket = {}; }
  void put_m_functions(const grammar::Block& block, std::uint64_t line, BlockOutput& out) const;

  const Profile& profile_;
  const ReadingsInUse& readings_;
  OpenPaths open_paths_;
  Machine machine_;
  CodeReading reading_;
};

// GSK-COM-07: parameter 3403#6 decides on the machine (0: the later one wins).
bool Interpreter::last_wins() const {
  if (auto parameter = profile_.parameter("3403.6")) return parameter->sign() == 0;
  return readings_.is(ReadingKey::duplicate, "last");
}

// Planes, units and feed modes hold from their block on.
void Interpreter::take_modes(const BlockCodes& codes) {
  if (codes.units >= 0) machine_.units = codes.units == 20 ? Units::inch : Units::mm;
  if (codes.feed_mode >= 0) {
    machine_.feed_mode = codes.feed_mode == 99 ? FeedMode::per_revolution : FeedMode::per_minute;
  }
  if (codes.plane >= 0) {
    machine_.plane = static_cast<Plane>(codes.plane - 17);
    // GSK-MOD-05: within the mode the initial plane is then that of the new depth axis.
    machine_.pocket.initial_plane = machine_.position[axes_of(machine_.plane).d];
  }
}

void Interpreter::take_motion_code(BlockContext& block) {
  const int code = block.codes.motion;
  if (code < 0) return;
  // GSK-MOD-06, GSK-G110-15: a code of group 01 ends the mode of the milling cycles.
  leave_pocket_mode();
  if (code != machine_.motion) {
    // GSK-G94-07: another code of group 01 clears what G94 retains.
    machine_.g94.clear();
    block.entered_g94 = code == 94;
  }
  machine_.motion = code;
}

void Interpreter::take_cycle_code(BlockContext& block) {
  const int code = block.codes.cycle;
  if (code < 0) return;
  if (code == 80) {
    // GSK-MOD-06: G80 ends the mode and G94; axis words are positioned, in its own block too.
    leave_pocket_mode();
    machine_.g94.clear();
    if (block.codes.motion < 0) machine_.motion = 0;
    return;
  }
  PocketMode& pocket = machine_.pocket;
  // GSK-MOD-01: entered from outside; G110 and G111 are one mode.
  block.entered_cycle = pocket.code == 0;
  block.changed_pair = pocket.code != 0 && pocket.code != code;
  pocket.code = code;
  // GSK-MOD-05
  if (block.entered_cycle) {
    pocket.initial_plane = machine_.position[axes_of(machine_.plane).d];
  }
}

void Interpreter::take_feed(const BlockWords& words) {
  if (!words.has('F')) return;
  Number feed = words.written('F');
  if (machine_.units == Units::inch) feed = feed * Number::millionths(25'400'000);
  machine_.feed = feed;
}

bool Interpreter::check_words(const BlockWords& words, const BlockCodes& codes,
                              BlockOutput& out) const {
  std::vector<Alarm>& alarms = out.alarms;
  const bool dwell = codes.once == 4;
  check_pairs(words, last_wins(), !dwell, alarms);
  check_code_groups(words, codes, alarms);
  check_feed_word(words, alarms);
  if (!dwell && readings_.is(ReadingKey::decimals, "alarm")) {
    check_decimals(words, profile_, machine_.units, alarms);
  }
  const bool in_cycle = machine_.pocket.code != 0 || machine_.motion == 94;
  if (in_cycle && codes.once < 0) check_ranges(words, profile_, machine_.units, alarms);
  return alarms.empty();
}

void Interpreter::run_code(BlockContext& block) {
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
    // GSK-G94-07, GSK-MOD-08: a code of group 00 other than G04 clears what G94 retains.
    machine_.g94.clear();
    if (machine_.motion == 94 && readings_.is(ReadingKey::g94_after_00, "cancelled")) {
      machine_.motion = 0;
    }
    return;
  }
  if (machine_.pocket.code != 0) {
    run_g110(block);
    return;
  }
  switch (machine_.motion) {
    case 0:
      run_positioning(block);
      break;
    case 1:
      run_straight_feed(block);
      break;
    case 2:
      run_arc(block, -1);
      break;
    case 3:
      run_arc(block, +1);
      break;
    case 94:
      run_g94(block);
      break;
    default:
      break;
  }
}

// M functions are passed on: those that stop or end something after the motion, the others before
// (GSK-COM-05; M35 of the milling cycles before).
void Interpreter::put_m_functions(const grammar::Block& block, std::uint64_t line,
                                  BlockOutput& out) const {
  for (const grammar::Word& word : block.words) {
    if (word.address != 'M') continue;
    std::optional<std::int64_t> number = to_number(word.value).to_int64();
    if (!number || *number < 0 || *number > 9999) {
      out.alarms.push_back({number ? AlarmClass::value_out_of_range : AlarmClass::not_an_integer,
                            "GSK-COM-05"_clause, 'M', word.where,
                            "An M function is a whole number from 0 to 9999."});
      continue;
    }
    if (*number == 98 || *number == 99) {
      out.not_covered = NotCovered{line, fmt::format("M{}", *number),
                                   fmt::format("M{} (subprogram) is a code of the control that the "
                                               "gauge does not read.",
                                               *number),
                                   word.where};
      continue;
    }
    Record record;
    record.kind = RecordKind::m;
    record.clause = "GSK-COM-05"_clause;
    record.block = line;
    record.m = static_cast<std::int32_t>(*number);
    const bool ends_program = *number == 2 || *number == 17 || *number == 30;
    const bool after = ends_program || *number == 0 || *number == 1 || *number == 5 || *number == 9;
    (after ? out.after : out.items).emplace_back(std::move(record));
    if (ends_program) out.program_end = true;
  }
}

void Interpreter::run(std::uint64_t line, const grammar::Block& block, BlockOutput& out) {
  if (block.outside) {
    out.not_covered =
        NotCovered{line, block.outside->name,
                   fmt::format("The block has a construct of the control that the gauge does not "
                               "read: {}.",
                               block.outside->name),
                   block.outside->where};
    return;
  }
  if (block.words.empty() && !readings_.is(ReadingKey::g94_empty_block, "repeat")) return;
  reading_.codes = {};
  reading_.alarms.clear();
  reading_.not_covered.reset();
  read_codes(block, last_wins(), reading_);
  if (reading_.not_covered) {
    out.not_covered = std::move(reading_.not_covered);
    out.not_covered->block = line;
    return;
  }
  out.alarms = std::move(reading_.alarms);

  const BlockCodes& codes = reading_.codes;
  take_modes(codes);
  const bool round = readings_.is(ReadingKey::decimals, "nearest");
  BlockWords words(block, profile_, machine_.units, round && codes.once != 4);
  BlockContext context{machine_, words, codes, profile_, readings_, open_paths_, line, out};
  put_m_functions(block, line, out);
  take_motion_code(context);
  take_cycle_code(context);
  check_words(words, codes, out);
  take_feed(words);
  run_code(context);
  // In the order of their words; few of them, and std::stable_sort warns under clang-19.
  for (std::size_t i = 1; i < out.alarms.size(); ++i) {
    for (std::size_t k = i; k > 0 && out.alarms[k].where.begin < out.alarms[k - 1].where.begin;
         --k) {
      std::swap(out.alarms[k], out.alarms[k - 1]);
    }
  }
}

}  // namespace

std::unique_ptr<BlockInterpreter> make_interpreter(const Profile& profile,
                                                   const ReadingsInUse& readings,
                                                   OpenPaths open_paths) {
  return std::make_unique<Interpreter>(profile, readings, open_paths);
}

}  // namespace gonogo::reference::gsk988ta
