// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the reference says of a program, item by item: records, levels to be cleared, and how it
// ends.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "grammar/ast.hpp"
#include "reference/record.hpp"

namespace gonogo::reference {

enum class AlarmClass : std::uint8_t {
#define GONOGO_ALARM(name, text, sentence) name,
#include "reference/alarm_classes.def"
};
std::string_view name(AlarmClass alarm);
std::string_view sentence(AlarmClass alarm);
std::optional<AlarmClass> alarm_class(std::string_view text);
std::span<const std::string_view> alarm_class_names();

// One rule that a block breaks.
struct Alarm {
  AlarmClass alarm = AlarmClass::syntax;
  ClauseId clause = kNoClause;
  char word = 0;        // the address at fault or missing; 0: none
  grammar::Span where;  // of the word; past the line's end when it is missing
  std::string message;  // a sentence with the values
};

// A block with at least one broken rule; the program ends before its motion. Any of them may be
// reported; the first is the one whose word stands first.
struct AlarmReport {
  std::uint64_t block = 0;
  std::vector<Alarm> alarms;
  std::optional<grammar::SyntaxError> syntax;
};

// A code or construct that the maker has and the gauge does not read; the program ends here for it.
struct NotCovered {
  std::uint64_t block = 0;
  std::string code;
  std::string message;
  grammar::Span where;
};

// One level of a circular pocket whose path the manual leaves open (reading gsk.pocket.path = any):
// the motions between the plunge and the retract, judged by what they clear.
struct PocketLevel {
  std::uint64_t block = 0;
  ClauseId clause = kNoClause;
  Plane plane = Plane::g18;
  std::array<Number, 2> centre;  // along p and q
  Number depth;                  // coordinate of d
  Number pocket_radius;          // I
  Number tool_radius;            // D
  Number step;                   // L
  int sense = -1;                // sign of rot
  Number feed;
  FeedMode feed_mode = FeedMode::per_minute;
};

// The position got a new name (G50): nothing moves and no record says so, but the records that
// follow are in the new coordinates.
struct Renaming {
  std::uint64_t block = 0;
  Position shift;  // new coordinate less old one
};

using Item = std::variant<Record, PocketLevel, Renaming, AlarmReport, NotCovered>;

}  // namespace gonogo::reference
