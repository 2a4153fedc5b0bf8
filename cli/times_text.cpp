// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/times_text.hpp"

#include <fmt/format.h>

#include <optional>

#include "grammar/file_source.hpp"
#include "oracle/judge/cycle_time.hpp"
#include "oracle/judge/rounding_census.hpp"
#include "oracle/judge/unit_error.hpp"
#include "reference/expander.hpp"

namespace gonogo::cli {
namespace {

using oracle::CycleTime;
using reference::Number;

// Nothing: the program gives positions other names, in which no record says how far it goes.
std::optional<CycleTime> time_of_reference(const reference::Profile& profile,
                                           const StoredFile& program) {
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
  trace.read([](std::string_view) { return false; },
             [&](const reference::Record& record) { time.take(record); });
  return time;
}

// Three decimals of what is enclosed far closer.
std::string shown(const Number& number) {
  constexpr int kDecimals = 3;
  return number.decimal_text(kDecimals);
}

std::string row(std::string_view what, std::string_view unit, const Number& want, const Number& got,
                std::optional<oracle::Quantity> quantity) {
  std::string hint;
  if (quantity) {
    // Of numbers that are rounded one by one.
    const Number close = want / 100'000;
    hint = oracle::unit_error(*quantity, want, got, close);
  }
  return fmt::format("  {:<11}{:>16} {:<4}{:>16} {:<4}{}\n", what, shown(want), unit, shown(got),
                     unit, hint);
}

}  // namespace

std::string times_text(const reference::Profile& profile, const StoredFile& program,
                       RecordedTrace& trace) {
  const std::optional<CycleTime> want = time_of_reference(profile, program);
  if (!want) return "times: none, for the program gives positions other names.\n";
  const CycleTime got = time_of_trace(profile, trace);
  using oracle::Quantity;
  std::string text = fmt::format("times{:>22}{:>21}\n", "reference", "subject");
  text += row("cuts", "s", want->feed_seconds(), got.feed_seconds(), Quantity::time);
  text += row("turns", "rev", want->revolutions(), got.revolutions(), std::nullopt);
  text += row("dwells", "s", want->dwell_seconds(), got.dwell_seconds(), Quantity::dwell);
  text += row("traverses", "mm", want->rapid_length(), got.rapid_length(), std::nullopt);
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
    const reference::Profile& profile, const StoredFile& program) {
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
          const reference::Record& got) {
  for (const reference::Axis axis : reference::kLinearAxes) {
    if (want.axes.has(axis) && got.axes.has(axis)) census.take(want.to[axis], got.to[axis]);
  }
  if (want.kind != reference::RecordKind::arc) return;
  for (std::size_t i = 0; i < want.centre.size(); ++i) census.take(want.centre[i], got.centre[i]);
}

}  // namespace

std::string rounding_text(const reference::Profile& profile, const StoredFile& program,
                          RecordedTrace& trace) {
  const auto want = motions_of_reference(profile, program);
  if (!want) return "coordinates: not told, for a part of the path is open.\n";
  oracle::RoundingCensus census;
  std::size_t count = 0;
  bool alike = true;
  trace.read([](std::string_view) { return false; },
             [&](const reference::Record& record) {
               if (!reference::is_motion(record.kind) || !alike) return;
               alike = count < want->size() && (*want)[count].kind == record.kind;
               if (alike) take(census, (*want)[count++], record);
             });
  if (!alike || count != want->size()) {
    return "coordinates: not told, for the motions are not those of the reference one by one.\n";
  }
  return census.text() + "\n";
}

}  // namespace gonogo::cli
