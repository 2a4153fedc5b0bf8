// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a motion of a cycle ends, along which way the lead of a thread counts, and a translation
// that leaves a rotation in force.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "fuzz/identify/variant.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::identify {
namespace {

void move_on(Position& at, const Record& record) {
  for (const Axis axis : reference::kAllAxes) {
    if (record.axes.has(axis)) at[axis] = record.to[axis];
  }
}

// The motions of one block, one after the other.
struct Run {
  std::vector<Record*> motions;
  Position from;  // where the first of them begins
};

std::vector<Run> runs_of(KeptOutcome& outcome, const Position& start) {
  std::vector<Run> runs;
  Position at = start;
  for (Record& record : outcome.records) {
    if (!is_motion(record.kind)) continue;
    const bool goes_on = !runs.empty() && runs.back().motions.back()->block == record.block;
    if (!goes_on) runs.push_back({{}, at});
    runs.back().motions.push_back(&record);
    move_on(at, record);
  }
  return runs;
}

// Where the first cut of the run begins; nothing where it has none.
std::optional<Position> start_of_cut(const Run& run) {
  Position at = run.from;
  for (const Record* record : run.motions) {
    if (record->kind != RecordKind::rapid) return at;
    move_on(at, *record);
  }
  return std::nullopt;
}

// The motion ends elsewhere, and so does what follows and does not move the axis.
void end_at(std::vector<Record>& records, Record& motion, Axis axis, const Number& place) {
  const Number before = std::exchange(motion.to[axis], place);
  for (Record* next = &motion + 1; next != records.data() + records.size(); ++next) {
    if (!next->axes.has(axis)) continue;
    if (is_motion(next->kind) || next->to[axis] != before) return;
    next->to[axis] = place;
  }
}

// A cycle of the subject that ends where its cut began ends where the reference's does.
void take_out_further(const Observation& seen, KeptOutcome& outcome, const Motions& motions) {
  auto right = run_reference(seen.profile, seen.program);
  if (!right) return;
  const ProgramText program(seen.profile, seen.program);
  std::vector<Run> due = runs_of(*right, seen.profile.initial.at);
  for (Run& run : runs_of(outcome, seen.profile.initial.at)) {
    Record& last = *run.motions.back();
    const auto began = is_of(program, last.block, motions) ? start_of_cut(run) : std::nullopt;
    const auto same = std::ranges::find_if(
        due, [&](const Run& one) { return one.motions.back()->block == last.block; });
    if (!began || same == due.end() || last.kind != RecordKind::rapid) continue;
    const Record& end = *same->motions.back();
    for (const Axis axis : reference::kLinearAxes) {
      const bool stops = last.axes.has(axis) && last.to[axis] == (*began)[axis];
      if (stops && end.axes.has(axis)) end_at(outcome.records, last, axis, end.to[axis]);
    }
  }
}

// How far a motion goes along its longest axis, and along one axis.
struct Ways {
  Number longest;
  std::array<Number, 3> along;
};

Ways ways_of(const Position& from, const Record& record) {
  Ways ways;
  for (const Axis axis : reference::kLinearAxes) {
    if (record.axes.has(axis)) ways.along[index(axis)] = abs(record.to[axis] - from[axis]);
    ways.longest = max(ways.longest, ways.along[index(axis)]);
  }
  return ways;
}

// Between places with roots the longest axis counts: no thread of a corpus goes there.
Number length_of(const Ways& ways) {
  Number square;
  for (const Number& way : ways.along) square += way * way;
  return square.is_rational() ? Number::root(0, 1, square) : ways.longest;
}

// A record has the lead along the longest axis.
bool give_leads(const Observation& seen, KeptOutcome& model, const Motions& motions,
                Number (*way)(const Ways&)) {
  bool changed = false;
  const ProgramText program(seen.profile, seen.program);
  Position at = seen.profile.initial.at;
  for (Record& record : model.records) {
    if (!is_motion(record.kind)) continue;
    const Ways ways = ways_of(at, record);
    move_on(at, record);
    const bool is_meant =
        record.kind == RecordKind::thread && is_of(program, record.block, motions);
    if (!is_meant || ways.longest.sign() == 0) continue;
    const Number lead = record.lead * way(ways) / ways.longest;
    changed = changed || lead != record.lead;
    record.lead = lead;
  }
  return changed;
}

void add_leads(const Motions& motions, Variants& out) {
  using Way = Number (*)(const Ways&);
  for (const auto& [name, way] :
       {std::pair<const char*, Way>{"X", [](const Ways& ways) { return ways.along[0]; }},
        {"Y", [](const Ways& ways) { return ways.along[1]; }},
        {"Z", [](const Ways& ways) { return ways.along[2]; }},
        {"the way", length_of}}) {
    add_model(
        fmt::format("the lead of {} comes out along {}, not along the longest axis",
                    names_of(motions), name),
        [motions, along = way](const Observation& seen, KeptOutcome& model) {
          return give_leads(seen, model, motions, along);
        },
        out);
  }
}

// With the codes that are named after them: G33.1 of G33.
Motions with_kin(Motions motions, const Descriptor& table) {
  const Motions own = motions;
  for (const Code& code : table.codes) {
    for (const std::string& name : own) {
      if (code.name.starts_with(name + ".")) motions.emplace(code.name);
    }
  }
  return motions;
}

const CodeWord* word_of_angle(const Code& code) {
  for (const auto& list : code.words) {
    for (const CodeWord& word : list) {
      if (word.role == Role::angle) return &word;
    }
  }
  return nullptr;
}

// What adds to the rotation in force: the table has it behind the one that replaces it. Null: the
// dialect has none.
const Code* adding_turn(const Descriptor& table) {
  const Code* last = nullptr;
  for (const Code& code : table.codes) {
    if (code.kind == Kind::frame && word_of_angle(code) != nullptr) last = &code;
  }
  return last;
}

// Whether the block has a word of its code.
bool has_words(const TextBlock& block, const Code& code) {
  return std::ranges::any_of(
      block.words, [&](const TextWord& word) { return code.find(name_of(word)) != nullptr; });
}

// The program with every rotation turned again behind a translation, in a line of its own, and the
// outcome with those lines counted.
std::optional<ChangedRun> with_turns_kept(const Observation& seen) {
  const ProgramText program(seen.profile, seen.program);
  const Code* const adds = adding_turn(*program.table);
  const reference::ReadingChoice& readings = seen.profile.readings;
  const bool keeps =
      readings.is("sie.g158=additive"_reading) || readings.is("sie.g158=translation-only"_reading);
  ChangedRun trial{{}, seen.profile, seen.outcome, std::nullopt};
  Number angle;
  std::uint64_t line = 0;
  for (const TextBlock& block : program.blocks) {
    ++line;
    trial.program += line_text(block);
    const Code* const own = block.modes.own;
    if (own == nullptr || own->kind != Kind::frame) continue;
    if (const CodeWord* const angle_word = word_of_angle(*own)) {
      const TextWord* const word = block.find(angle_word->address);
      const auto turned = word == nullptr ? std::nullopt : exact_value_of(*word);
      angle = (own == adds ? angle : Number(0)) + turned.value_or(0);
    } else if (angle.sign() != 0 && !block.end.empty() && !(keeps && has_words(block, *own))) {
      trial.program += fmt::format("{} {}={}{}", adds->name, word_of_angle(*adds)->address,
                                   angle.text(), block.end);
      ++line;
      const auto count = [line](std::uint64_t& number) { number += number >= line ? 1 : 0; };
      for (Record& record : trial.outcome.records) count(record.block);
      count(trial.outcome.end.alarm.block);
    }
  }
  if (trial.program == seen.program) return std::nullopt;
  return trial;
}

}  // namespace

void add_way_variants(const Observation& departure, Variants& out) {
  const Descriptor& table = *ProgramText(departure.profile, departure.program).table;
  if (adding_turn(table) != nullptr) {
    out.push_back({"a translation leaves the rotation in force", with_turns_kept});
  }
  for (const Motions& motions : motions_concerned(departure)) {
    add_leads(motions, out);
    if (Motions all = with_kin(motions, table); all != motions) add_leads(all, out);
    add_outcome(
        fmt::format("the end of {} is where its cut began", names_of(motions)),
        [motions](const Observation& seen, KeptOutcome& outcome) {
          take_out_further(seen, outcome, motions);
        },
        out);
  }
}

}  // namespace gonogo::identify
