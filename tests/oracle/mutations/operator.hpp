// SPDX-License-Identifier: GPL-3.0-or-later
//
// Operators: each makes one thing wrong, or otherwise right, with a trace, as a control might. One
// file a family.
#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "specimen.hpp"
#include "tests/chance.hpp"

namespace gonogo::mutations {

// A trace in change.
class Edit {
 public:
  Edit(const Specimen& of, Chance& drawn) : specimen(of), chance(drawn), trace(of.right) {}

  using Wanted = std::function<bool(std::size_t)>;
  // The number of any record of the right trace that is wanted.
  std::optional<std::size_t> any(const Wanted& wanted);
  std::optional<std::size_t> any_motion();
  std::optional<std::size_t> any_of_kind(RecordKind kind);

  const Record& right(std::size_t number) const { return specimen.right.records[number]; }
  // Largest way of an axis, and whether an arc goes round: what is seen of the motion, mm.
  double size_of(std::size_t number) const;
  // The next motion after record `number` of the trace as it stood leads where it led, on every
  // axis. False where there is none.
  bool lead_next_to_its_end(std::size_t number);
  // A motion of the same words that leads to a place.
  Record motion_to(RecordKind kind, std::uint64_t block, const reference::Position& to) const;
  // A feed that is in force thereabouts; nothing where nothing cuts.
  std::optional<Record> cutting_words(std::size_t near) const;
  // A cut with the feed of another record.
  Record cut_to(const Record& words, std::uint64_t block, const reference::Position& to) const;
  void insert(std::size_t before, Record record);
  void erase(std::size_t number);
  // The records before `end` from `begin` on; others come in their place.
  void replace(std::size_t begin, std::size_t end, const std::vector<Record>& records = {});
  // A length well beyond the tolerance, of either sign.
  Number off();
  Number times_tolerance(double factor) const;

  const Specimen& specimen;
  Chance& chance;
  Trace trace;
};

// False where it cannot be applied.
using Apply = std::function<bool(Edit&)>;
// What changes one record, of any motion or of any record of a kind.
using Change = std::function<void(Edit&, std::size_t number)>;
Apply to_any_motion(Change change);
Apply to_any(RecordKind kind, Change change);

struct Operator {
  std::string_view name;
  std::string_view says;  // what it makes wrong, or another way of doing the same
  Apply apply;
  // It moves M functions or dwells among the motions; line numbers say nothing of their places.
  bool orders_events = false;
};

std::vector<Operator> shifting_operators();  // ends, centres, radii
std::vector<Operator> sequence_operators();  // dropped, repeated, reversed, inserted
std::vector<Operator> word_operators();      // kinds, feeds, blocks, leads, planes
std::vector<Operator> turning_operators();   // senses, turns, rings
std::vector<Operator> event_operators();     // M functions, dwells, alarms, the end
std::vector<Operator> m_operators();         // M functions and dwells out of their place
std::vector<Operator> cycle_operators();     // steps of cycles
std::vector<Operator> pocket_operators();    // senses, turns and heights of pockets
std::vector<Operator> thread_operators();    // steps of threads
std::vector<Operator> wrong_operators();     // all of these

}  // namespace gonogo::mutations
