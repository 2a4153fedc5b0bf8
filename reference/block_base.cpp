// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/block_base.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "reference/compared.hpp"

namespace gonogo::reference {

void BlockBase::alarm(AlarmClass alarm, ClauseId clause, WordName address, std::string message) {
  const grammar::Span where = places.place_of(address).value_or(places.behind());
  out.alarms.push_back({alarm, clause, address, where, std::move(message)});
}

void BlockBase::missing(ClauseId clause, WordName address) {
  alarm(AlarmClass::missing_word, clause, address,
        fmt::format("The word {} is missing.", address.text()));
}

void BlockBase::need_feed(ClauseId clause) {
  if (state.feed.sign() > 0) return;
  alarm(AlarmClass::feed_missing, clause, 'F',
        "The block cuts, but no feed is in force. A machine that comes up with one has it in "
        "the profile: initial = { f = \"100\" }");
}

bool BlockBase::turns_alone(const Position& to) const {
  for (Axis axis : kLinearAxes) {
    if (to[axis] != state.position[axis]) return false;
  }
  return to != state.position;
}

void BlockBase::not_covered(std::string code, char address, std::string message) {
  out.not_covered = NotCovered{line, std::move(code), std::move(message),
                               places.place_of(address).value_or(grammar::Span{})};
}

void BlockBase::not_covered(int g_code, char address, std::string message) {
  not_covered(fmt::format("G{}", g_code), address, std::move(message));
}

Record BlockBase::motion(RecordKind kind, ClauseId clause, std::initializer_list<AxisValue> to) {
  Record record;
  write_motion(record, kind, clause, to);
  return record;
}

void BlockBase::write_motion(Record& record, RecordKind kind, ClauseId clause,
                             std::initializer_list<AxisValue> to) {
  record.kind = kind;
  record.block = line;
  record.clause = clause;
  for (const auto& [axis, value] : to) {
    state.position[axis] = value;
    record.axes.add(axis);
    record.to[axis] = value;
  }
  if (kind == RecordKind::feed || kind == RecordKind::arc || kind == RecordKind::arc3) {
    record.feed = state.feed;
    record.feed_mode = state.feed_mode;
  }
}

Record BlockBase::motion_to(RecordKind kind, ClauseId clause, AxisSet named, const Position& to) {
  Record record = motion(kind, clause, {});
  record.axes = named;
  record.to = to;
  state.position = to;
  return record;
}

void BlockBase::rapid(ClauseId clause, std::initializer_list<AxisValue> to) {
  write_motion(put_record(), RecordKind::rapid, clause, to);
}

void BlockBase::feed(ClauseId clause, std::initializer_list<AxisValue> to) {
  write_motion(put_record(), RecordKind::feed, clause, to);
}

Record BlockBase::arc_to(ClauseId clause, AxisSet named, const Position& to,
                         const std::array<Number, 2>& centre, int sense) {
  const PlaneAxes axes = axes_of(state.plane);
  Record record = motion_to(RecordKind::arc, clause, named | AxisSet{axes.p, axes.q}, to);
  record.plane = state.plane;
  record.centre = centre;
  record.rot = sense;
  return record;
}

void BlockBase::name_corners(Axis positioning, Axis cutting, const Number& taper,
                             const Position& c) const {
  if (!out.notes_places) return;
  const Position& a = state.position;
  Position b = a;
  Position d = a;
  b[positioning] = c[positioning] + taper;
  d[cutting] = c[cutting];
  out.name_point("A", a);
  out.name_point("B", b);
  out.name_point("C", c);
  out.name_point("D", d);
}

void BlockBase::rename(const Position& to) {
  Renaming renaming{line, {}};
  for (Axis axis : kAllAxes) renaming.shift[axis] = to[axis] - state.position[axis];
  state.position = to;
  out.items.emplace_back(std::move(renaming));
}

bool leaves_program(const grammar::Block& block, std::uint64_t line, bool has_begun,
                    ClauseId clause, BlockOutput& out) {
  if (!has_begun) return false;
  if (block.tape_mark) {
    out.program_end = true;
    out.end_clause = clause;
    out.accept(clause);
    return true;
  }
  if (!block.program_number) return false;
  out.not_covered =
      NotCovered{line, "program-head",
                 "Another program begins here, which the gauge does not read.", grammar::Span{}};
  return true;
}

NotCovered lacking_in_profile(std::string_view what, std::string line, const grammar::Span& where,
                              std::uint64_t block) {
  std::string message = fmt::format(
      "{} is needed here, and the profile does not say it. Write into the profile, with the "
      "machine's own value: {}",
      what, line);
  return {block, std::string(kLackingProfile), std::move(message), where, std::move(line)};
}

NotCovered word_outside(const grammar::Word& word, std::string_view code, std::uint64_t line) {
  return {line, std::string(1, word.address),
          fmt::format("The gauge does not read the word {} beside {}; a control may give it a "
                      "meaning.",
                      text_of(word), code),
          word.where};
}

namespace {

std::string_view kind_of(const grammar::OutsideConstruct& construct) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 7> kKinds{{
      {"variable", "a variable"},
      {"expression", "an expression"},
      {"control-statement", "a control statement"},
      {"file-name", "a file name"},
      {"o-word", "an O word"},
      {"string", "a string"},
      {"comma-word", "a word behind a comma"},
  }};
  for (const auto& [name, kind] : kKinds) {
    if (name == construct.name) return kind;
  }
  return "a word of the control";
}

}  // namespace

NotCovered construct_outside(const grammar::Block& block, std::uint64_t line) {
  const grammar::OutsideConstruct& construct = block.outside.value();
  return {line, construct.name,
          fmt::format("The gauge does not read {}, {}.", construct.word, kind_of(construct)),
          construct.where};
}

NotCovered m_function_outside(std::int64_t number, std::string_view title,
                              const grammar::Word& word, std::uint64_t line) {
  return {
      line, fmt::format("M{}", number),
      fmt::format("M{} ({}) is a code of the control that the gauge does not read.", number, title),
      word.where};
}

NotCovered m_function_too_large(std::int64_t number, const grammar::Span& where,
                                std::uint64_t line) {
  return {line, fmt::format("M{}", number), "No text says how far M functions go.", where};
}

std::optional<Record> read_m_function(const grammar::Word& word, std::uint64_t line,
                                      ClauseId clause, ClauseId alarm_clause, BlockOutput& out) {
  const Number value = to_number(word.value);
  const std::optional<std::int64_t> number = value.to_int64();  // nothing: not whole, or too large
  if (!number || *number < 0 || *number > kLargestM) {
    const bool is_whole = value == value.floor();
    out.alarms.push_back({is_whole ? AlarmClass::value_out_of_range : AlarmClass::not_an_integer,
                          alarm_clause, 'M', word.where,
                          with_values("An M function is a whole number from 0 to {}, and not {}.",
                                      {kLargestM, value})});
    return std::nullopt;
  }
  if (*number > kLastCommonM) {
    out.not_covered = m_function_too_large(*number, word.where, line);
    return std::nullopt;
  }
  if (*number == 98 || *number == 99) {
    out.not_covered = m_function_outside(*number, "subprogram", word, line);
    return std::nullopt;
  }
  Record record = record_of(RecordKind::m, line, clause);
  record.m = static_cast<std::int32_t>(*number);
  return record;
}

void put_m_function(Record record, BlockOutput& out) {
  const std::int32_t m = record.m;
  const bool ends_program = m == 2 || m == 17 || m == 30;
  const bool after = ends_program || m == 0 || m == 1 || m == 5 || m == 9;
  if (after && out.program_end) return;  // nothing runs after the end
  (after ? out.after : out.items).emplace_back(std::move(record));
  if (ends_program) out.program_end = true;
}

}  // namespace gonogo::reference
