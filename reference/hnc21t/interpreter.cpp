// SPDX-License-Identifier: GPL-3.0-or-later
//
// One block: its codes change the modal state, then the code in force runs. HNC-WRD-01: a word that
// no code uses and no rule ignores is not covered.
#include "reference/hnc21t/interpreter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "reference/clause_literal.hpp"
#include "reference/hnc21t/cycle.hpp"
#include "reference/hnc21t/other_classes.hpp"
#include "reference/hnc21t/word_use.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::reference::hnc21t {
namespace {

// What a feed is counted in.
struct FeedBasis {
  bool inch = false;
  FeedMode mode = FeedMode::per_minute;
};

class Interpreter : public BlockInterpreter {
 public:
  Interpreter(const Profile& profile, const ReadingsInUse& readings);

  void run(std::uint64_t line, const grammar::Block& block, BlockOutput& out) override;
  const Position& position() const override { return machine_.position; }
  void stand_at(const Position& position) override { machine_.position = position; }

 private:
  void take_modes(const BlockCodes& codes);
  void take_motion_code(const BlockCodes& codes);
  void take_feed(const BlockWords& words, BlockOutput& out);
  void take_lead(const BlockWords& words, BlockOutput& out);
  void carry_feed(const FeedBasis& before);
  bool in_cycle(const BlockCodes& codes) const {
    return codes.once < 0 && is_cycle(machine_.motion);
  }
  void check_mill_words(const BlockWords& words, const BlockCodes& codes, std::uint64_t line,
                        BlockOutput& out) const;
  void check_stray_words(const BlockWords& words, const BlockCodes& codes, std::uint64_t line,
                         BlockOutput& out) const;
  void check_words(const BlockWords& words, const BlockCodes& codes, BlockOutput& out) const;
  void check_lead_words(const BlockWords& words, std::vector<Alarm>& alarms) const;
  void run_code(BlockContext& block) const;

  const Profile& profile_;
  const ReadingsInUse& readings_;
  Machine machine_;
  bool has_begun_ = false;  // a block with a word has run
  ProgramHead head_;
  CodeReading reading_;
};

Interpreter::Interpreter(const Profile& profile, const ReadingsInUse& readings)
    : profile_(profile), readings_(readings) {
  machine_.position = profile.initial.at;
  if (profile.initial.feed.sign() > 0) {
    machine_.feeds.latest = machine_.feeds.plain = profile.initial.feed;
    machine_.any_f = machine_.feeds;
  }
  machine_.motion = profile.initial.motion;
  machine_.modes = {profile.units == Units::inch, profile.x_diameter, false};
  for (std::size_t i = 0; i < machine_.offsets.size(); ++i) {
    const auto found = profile.offsets.find(fmt::format("G{}", 54 + i));
    if (found != profile.offsets.end()) machine_.offsets[i] = found->second;
  }
}

// Units, scales and offsets hold from their block on.
void Interpreter::take_modes(const BlockCodes& codes) {
  WordModes& modes = machine_.modes;
  if (codes.units >= 0) modes.inch = codes.units == 20;
  if (codes.diameter >= 0) modes.diameter = codes.diameter == 36;
  if (codes.distance >= 0) modes.incremental = codes.distance == 91;
  if (codes.offset >= 0) machine_.offset = codes.offset - 54;
  if (codes.feed_mode >= 0) {
    machine_.feed_mode = codes.feed_mode == 95 ? FeedMode::per_revolution : FeedMode::per_minute;
  }
}

// HNC-MOD-02: without a code the one in force goes on, and any other motion code ends a cycle.
void Interpreter::take_motion_code(const BlockCodes& codes) {
  if (codes.motion < 0) return;
  // HNC-MOD-01, HNC-MOD-05: its words are forgotten; whether the same code again does so is open.
  const bool is_same = codes.motion == machine_.motion;
  const bool holds_none = machine_.command.empty() && machine_.ended == 0;
  const bool may_keep = is_same && (!is_cycle(codes.motion) || holds_none);
  if (may_keep || (is_same && readings_.is("hnc.rewrite=keep"_reading))) return;
  change_command(machine_, codes.motion);
}

// F of an earlier block where the units change, or the feed between minutes and revolutions.
void Interpreter::carry_feed(const FeedBasis& before) {
  std::optional<Number>& of_cycle = machine_.command.feed;
  const std::array words = {&machine_.feeds, &machine_.any_f};
  if (!machine_.any_f.latest) return;  // nor any other
  if (machine_.feed_mode != before.mode && readings_.is("hnc.feed-change=deleted"_reading)) {
    for (FeedWords* given : words) *given = {};
    of_cycle.reset();
    return;
  }
  const bool inch = machine_.modes.inch;
  if (inch == before.inch || !machine_.any_f.is_written) return;
  if (readings_.is("hnc.feed-units=length"_reading)) return;
  const auto take_number = [&](std::optional<Number>& feed) {
    if (feed) *feed = inch ? inches(*feed) : *feed / inches(1);
  };
  for (FeedWords* given : words) {
    if (!given->is_written) continue;  // one of power-on has no number
    take_number(given->latest);
    take_number(given->plain);
  }
  take_number(of_cycle);
}

// HNC-MOD-04
void Interpreter::take_feed(const BlockWords& words, BlockOutput& out) {
  if (cuts_thread(machine_.motion)) return take_lead(words, out);
  const std::optional<Number> feed = words.length('F');
  if (!feed) return;
  const bool in_cycle = is_cycle(machine_.motion);
  machine_.feeds.give(*feed, in_cycle);
  machine_.any_f.give(*feed, in_cycle);
  if (in_cycle) machine_.command.feed = feed;
}

// HNC-G82-08: a later one replaces the one in force.
void Interpreter::take_lead(const BlockWords& words, BlockOutput& out) {
  using enum Lead::Kind;
  std::optional<Lead>& lead = machine_.command.lead;
  if (lead && words.has(lead->kind == j ? 'F' : 'J')) out.accept("HNC-G82-08"_clause);
  if (words.has('F')) {
    lead = Lead{words.written('F'), machine_.modes.inch ? f_under_g20 : millimetres};
    machine_.any_f.give(words.length('F').value(), is_cycle(machine_.motion));
  }
  if (words.has('J')) lead = Lead{words.written('J'), j};
  if (lead && machine_.motion == 32) machine_.line_lead = lead;
}

// HNC-MOD-05: Y and V are no words of the cycles; anywhere else they are those of a mill program.
void Interpreter::check_mill_words(const BlockWords& words, const BlockCodes& codes,
                                   std::uint64_t line, BlockOutput& out) const {
  for (const grammar::Word& word : words.block().words) {
    if (word.address != 'Y' && word.address != 'V') continue;
    if (in_cycle(codes)) {
      out.alarms.push_back({AlarmClass::undefined_code, "HNC-MOD-05"_clause, word.address,
                            word.where, fmt::format("A lathe has no address {}.", word.address)});
    } else if (!out.not_covered) {
      out.not_covered = NotCovered{
          line, std::string(1, word.address),
          fmt::format("The word {} belongs to a program for a mill, which the gauge does not read.",
                      word.address),
          word.where};
    }
  }
}

// HNC-WRD-01: what no code of the block uses and no rule ignores.
void Interpreter::check_stray_words(const BlockWords& words, const BlockCodes& codes,
                                    std::uint64_t line, BlockOutput& out) const {
  if (out.not_covered) return;
  const Code* const code = code_that_runs(codes, machine_.motion);
  for (const grammar::Word& word : words.block().words) {
    const bool of_mill = word.address == 'Y' || word.address == 'V';  // check_mill_words
    if (of_mill || reads_word(code, word.address)) continue;
    out.not_covered = word_outside(word, code == nullptr ? "" : code->text(), line);
    return;
  }
}

// HNC-G82-07, HNC-G82-08
void Interpreter::check_lead_words(const BlockWords& words, std::vector<Alarm>& alarms) const {
  for (char address : {'F', 'J'}) {
    const grammar::Word* word = words.word(address);
    if (word == nullptr || to_number(word->value).sign() > 0) continue;
    alarms.push_back({AlarmClass::value_sign, "HNC-G82-08"_clause, address, word->where,
                      fmt::format("The lead {} is not above zero.", text_of(*word))});
  }
  if (!words.has('F') || !words.has('J')) return;
  const bool f_first = words.word('F')->where.begin < words.word('J')->where.begin;
  const grammar::Word& later = *words.word(f_first ? 'J' : 'F');
  alarms.push_back({AlarmClass::conflicting_words, "HNC-G82-07"_clause, later.address, later.where,
                    "F and J exclude each other as the lead of a thread."});
}

// HNC-COM-02, HNC-COM-03, HNC-COM-04
void Interpreter::check_words(const BlockWords& words, const BlockCodes& codes,
                              BlockOutput& out) const {
  check_repeated_addresses(words, "HNC-COM-02"_clause, out.alarms);
  check_axis_letters(words, kAxisAddresses, "HNC-COM-03"_clause, out.alarms);
  if (cuts_thread(machine_.motion)) {
    check_lead_words(words, out.alarms);
  } else {
    check_feed_sign(words, "HNC-COM-04"_clause, out.alarms);
  }
  if (codes.plane < 0) return;
  // Not of the last code alone: another may stand before it.
  for (const grammar::Word& word : words.block().words) {
    if (word.address != 'G') continue;
    const Number code = to_number(word.value);
    if (code != Number(17) && code != Number(19)) continue;
    out.alarms.push_back({AlarmClass::plane_not_allowed, "HNC-MOD-05"_clause, 'G', word.where,
                          fmt::format("A lathe has no plane G{}.", code.text())});
  }
}

void Interpreter::run_code(BlockContext& block) const {
  if (block.codes.once == 4) return run_dwell(block);
  if (block.codes.once == 92) return run_rename_position(block);
  if (is_cycle(machine_.motion)) take_command_words(block);
  switch (machine_.motion) {
    case 0:
      return run_positioning(block);
    case 1:
      return run_straight_feed(block);
    case 2:
      return run_arc(block, -1);
    case 3:
      return run_arc(block, +1);
    case 32:
      return run_thread(block);
    case 74:
      return run_g74(block);
    case 75:
      return run_g75(block);
    case 80:
      return run_g80(block);
    case 81:
      return run_g81(block);
    case 82:
      return run_g82(block);
    default:
      return;
  }
}

void Interpreter::run(std::uint64_t line, const grammar::Block& block, BlockOutput& out) {
  if (leaves_program(block, line, has_begun_, "HNC-COM-06"_clause, out)) return;
  if (head_.repeats(block)) out.accept("HNC-COM-06"_clause);
  if (block.outside) {
    out.not_covered = construct_outside(block, line);
    return;
  }
  if (block.words.empty()) return;
  has_begun_ = true;
  read_codes(block, reading_);
  if (reading_.not_covered) {
    out.not_covered = std::move(reading_.not_covered);
    out.not_covered->block = line;
    return;
  }
  const BlockCodes& codes = reading_.codes;
  out.alarms = std::move(reading_.alarms);
  const bool has_wrong_codes = !out.alarms.empty();
  const FeedBasis before{machine_.modes.inch, machine_.feed_mode};
  take_modes(codes);
  take_motion_code(codes);
  const BlockWords words(block, machine_.modes);
  check_mill_words(words, codes, line, out);
  for (const grammar::Word& word : block.words) {
    if (word.address != 'M') continue;
    if (auto record = read_m_function(word, line, "HNC-COM-01"_clause, "HNC-COM-04"_clause, out)) {
      put_m_function(*std::move(record), out);
    }
  }
  auto is_undefined = [](const Alarm& alarm) {
    return alarm.alarm == AlarmClass::undefined_code && alarm.word == 'G';
  };
  const bool has_undefined = std::ranges::any_of(out.alarms, is_undefined);
  // Beside codes that are wrong it is not known whose a word is.
  if (!has_wrong_codes) check_stray_words(words, codes, line, out);
  if (has_undefined) {
    // HNC-COM-01: a block with an unknown code is not checked further.
    std::erase_if(out.alarms, [&](const Alarm& alarm) { return !is_undefined(alarm); });
  } else if (!out.not_covered) {
    BlockContext context{{machine_, words, profile_, readings_, line, out}, machine_, words, codes};
    check_words(words, codes, out);
    if (machine_.modes.inch != before.inch) carry_lengths(machine_, readings_);
    carry_feed(before);
    take_feed(words, out);
    if (out.notes_acceptances) note_unused_words(context);
    run_code(context);
  }
  // What is not covered goes before what is wrong.
  if (out.not_covered) out.alarms.clear();
  admit_other_classes(words, out.alarms);
  sort_by_place(out.alarms);
}

}  // namespace

std::unique_ptr<BlockInterpreter> make_interpreter(const Profile& profile,
                                                   const ReadingsInUse& readings,
                                                   OpenPaths open_paths) {
  static_cast<void>(open_paths);  // no path of this dialect is open
  return std::make_unique<Interpreter>(profile, readings);
}

}  // namespace gonogo::reference::hnc21t
