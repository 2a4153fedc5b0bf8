// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/sinumerik/codes.hpp"

#include <fmt/format.h>

#include "reference/clause_literal.hpp"
#include "reference/sinumerik/descriptor.hpp"
#include "reference/sinumerik/names.hpp"
#include "reference/sinumerik/words.hpp"

namespace gonogo::reference::sinumerik {
namespace {

constexpr ClauseId kKnown = "SIE-MOD-02"_clause;
constexpr ClauseId kRepeated = "SIE-MOD-05"_clause;
constexpr GCodeTable kTable840d{table::kCodes840d, kKnown, kRepeated};
constexpr GCodeTable kTable802s{table::kCodes, kKnown, kRepeated};

void read_g_code(Control control, const grammar::Block& block, const grammar::NamedWord& word,
                 CodeReading& reading) {
  const grammar::Word code{'G', block.terms[word.first_term].number, word.where};
  const GCodeTable& known_codes = control == Control::sinumerik802s ? kTable802s : kTable840d;
  const Code* const known = known_codes.find(code.value);
  if (known != nullptr && known->group == Group::once && reading.codes.once >= 0) {
    reading.codes.several_once = true;
  }
  known_codes.take(code, known, false, reading);
  reading.codes.once = reading.of(Group::once);
}

// SIE-MOD-01
void read_motion_name(Motion motion, const grammar::NamedWord& word, CodeReading& reading) {
  if (!reading.is_first_of(Group::motion)) {
    reading.alarms.push_back(
        {AlarmClass::duplicate_word, kRepeated, WordName(word.name), word.where,
         fmt::format("{} is the second code of its group in the block.", word.name)});
  }
  reading.codes.motion = motion;
}

void read_name(Control control, const grammar::NamedWord& word, CodeReading& reading) {
  const Code* const name = find_name(control, word);
  // A code that stands by itself; what follows does not belong to it.
  if (name != nullptr && name->treatment == Treatment::read) {
    reading.alarms.push_back({AlarmClass::syntax, "SIE-LEX-02"_clause, WordName(word.name),
                              word.where, fmt::format("{} takes no value.", word.name)});
    return;
  }
  if (name == nullptr) {
    reading.alarms.push_back({AlarmClass::undefined_code, kKnown, WordName(word.name), word.where,
                              fmt::format("The control has no code {}.", word.name)});
  } else if (name->treatment == Treatment::without_effect) {
    reading.warnings.push_back(
        {fmt::format("{} ({}) is ignored: the gauge reads it as without effect on the path.",
                     word.name, name->title),
         word.where});
  } else if (!reading.not_covered) {
    reading.not_covered = NotCovered{
        0, written_name(word),
        fmt::format("{} ({}) is not read by the gauge.", written_name(word), name->title),
        word.where};
  }
}

}  // namespace

std::optional<int> once_code_of(const grammar::Block& block, const grammar::NamedWord& word) {
  if (address_of(word) != Address::g) return std::nullopt;
  const Code* const code = kTable802s.find(block.terms[word.first_term].number);
  if (code == nullptr || code->group != Group::once) return std::nullopt;
  return code->tenths / 10;
}

Cycle cycle_of(const grammar::NamedWord& word) {
  if (word.terms != 0 || word.is_call) return Cycle::none;
  if (word.name == "LCYC75") return Cycle::lcyc75;
  if (word.name == "LCYC82") return Cycle::lcyc82;
  return Cycle::none;
}

void read_codes(Control control, const grammar::Block& block, CodeReading& reading) {
  reading.clear();
  reading.warnings.clear();
  reading.codes = {};
  for (const grammar::NamedWord& word : block.named) {
    const bool is_bare = word.terms == 0 && !word.is_call;
    const std::optional<Address> address = address_of(word);
    if (address == Address::g) {
      read_g_code(control, block, word, reading);
    } else if (is_bare && word.name == "CIP") {
      read_motion_name(Motion::intermediate, word, reading);
    } else if (is_bare && word.name == "CT") {
      read_motion_name(Motion::tangent, word, reading);
    } else if (control == Control::sinumerik802s && cycle_of(word) != Cycle::none) {
      reading.codes.cycle = cycle_of(word);
    } else if (!address || (address == Address::rpl && control == Control::sinumerik840d)) {
      read_name(control, word, reading);
    }
  }
  BlockCodes& codes = reading.codes;
  if (const int motion = reading.of(Group::motion); motion >= 0 && !codes.motion) {
    codes.motion = static_cast<Motion>(motion);
  }
  codes.plane = reading.of(Group::plane);
  codes.units = reading.of(Group::units);
  codes.dimension = reading.of(Group::distance);
  codes.feed_mode = reading.of(Group::feed_mode);
  codes.without_offset = reading.of(Group::frame) == 53;
}

}  // namespace gonogo::reference::sinumerik
