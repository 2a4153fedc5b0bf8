// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/times_text.hpp"

#include <fmt/format.h>

#include <optional>

#include "grammar/file_source.hpp"
#include "oracle/judge/cycle_time.hpp"
#include "oracle/judge/grade.hpp"
#include "oracle/records/rounding_census.hpp"
#include "reference/expander.hpp"

namespace gonogo::cli {
namespace {

using oracle::CycleTime;
using reference::Number;

// Nothing: the program gives positions other names, in which no record says how far it goes.
std::optional<CycleTime> time_of_reference(const reference::Profile& profile,
                                           const ProgramFile& program) {
  grammar::FileSource bytes(program.descriptor());
  grammar::LineSource lines(bytes);
  reference::Expander expander(profile, lines, reference::OpenPaths::shown);
  CycleTime time(profile.initial.at);
  while (const reference::Item* item = expander.next()) {
    if (std::holds_alternative<reference::Renaming>(*item)) return std::nullopt;
    if (const auto* record = std::get_if<reference::Record>(item)) time.take(*record);
  }
  return time;
}

CycleTime time_of_trace(const reference::Profile& profile, RecordedTrace& trace) {
  CycleTime time(profile.initial.at);
  trace.read([&](const reference::Record& record) { time.take(record); });
  return time;
}

// Three decimals of what is enclosed far closer.
std::string shown(const Number& number) {
  constexpr int kDecimals = 3;
  return number.decimal_text(kDecimals);
}

}  // namespace

std::string times_text(const reference::Profile& profile, const ProgramFile& program,
                       RecordedTrace& trace) {
  const std::optional<CycleTime> want = time_of_reference(profile, program);
  if (!want) return "times: none, for the program gives positions other names.\n";
  const CycleTime got = time_of_trace(profile, trace);
  std::string text = fmt::format("times{:>22}{:>21}\n", "reference", "subject");
  const auto wants = oracle::parts_of(*want);
  const auto gots = oracle::parts_of(got);
  for (std::size_t i = 0; i < wants.size(); ++i) {
    const auto& [what, unit, amount] = wants[i];
    text += fmt::format("  {:<11}{:>16} {:<4}{:>16} {:<4}{}\n", what, shown(amount), unit,
                        shown(gots[i].amount), unit, oracle::time_hint(i, amount, gots[i].amount));
  }
  if (want->left_out() + got.left_out() != 0) {
    text +=
        fmt::format("  {} and {} motions are left out: of rotary axes, circles askew in space.\n",
                    want->left_out(), got.left_out());
  }
  return text;
}

namespace {

// The motions of the reference; nothing: a part of the path is open, or more than can be shown.
std::optional<std::vector<reference::Record>> motions_of_reference(
    const reference::Profile& profile, const ProgramFile& program) {
  constexpr std::size_t kMost = 1'000'000;
  grammar::FileSource bytes(program.descriptor());
  grammar::LineSource lines(bytes);
  reference::Expander expander(profile, lines, reference::OpenPaths::judged);
  std::vector<reference::Record> motions;
  while (const reference::Item* item = expander.next()) {
    const auto* record = std::get_if<reference::Record>(item);
    const bool ends = std::holds_alternative<reference::AlarmReport>(*item);
    if ((record == nullptr && !ends) || motions.size() >= kMost) return std::nullopt;
    if (record != nullptr && reference::is_motion(record->kind)) motions.push_back(*record);
  }
  return motions;
}

// The coordinates of one motion: of its end, and of its centre.
void take(oracle::RoundingCensus& census, const reference::Record& want,
          const reference::Record& got, const oracle::Tolerances& tolerances) {
  const auto compare = [&](const Number& exact, const Number& number) {
    census.take(exact, number, oracle::is_correctly_rounded(number, exact, tolerances));
  };
  for (const reference::Axis axis : reference::kLinearAxes) {
    if (want.axes.has(axis) && got.axes.has(axis)) compare(want.to[axis], got.to[axis]);
  }
  if (want.kind != reference::RecordKind::arc) return;
  for (std::size_t i = 0; i < want.centre.size(); ++i) compare(want.centre[i], got.centre[i]);
}

}  // namespace

std::string rounding_text(const reference::Profile& profile, const ProgramFile& program,
                          RecordedTrace& trace, const oracle::Tolerances& tolerances) {
  const auto want = motions_of_reference(profile, program);
  if (!want) return "coordinates: not counted, because a part of the path is open.\n";
  oracle::RoundingCensus census;
  std::size_t count = 0;
  bool alike = true;
  trace.read([&](const reference::Record& record) {
    if (!reference::is_motion(record.kind) || !alike) return;
    alike = count < want->size() && (*want)[count].kind == record.kind;
    if (alike) take(census, (*want)[count++], record, tolerances);
  });
  if (!alike || count != want->size()) {
    return "coordinates: not counted, because the motions are not those of the reference one by "
           "one.\n";
  }
  return "coordinates: " + census.text() + "\n";
}

}  // namespace gonogo::cli
