// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/capture/export_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "oracle/judge/evidence.hpp"
#include "oracle/judge/judge_session.hpp"

namespace gonogo::oracle {
namespace {

using reference::Axis;
using reference::Profile;

constexpr bool is_lathe(std::string_view dialect) {
  return dialect == "gsk988ta" || dialect == "hnc21t";
}

// The modes that the reference takes for those at power-on, as codes.
std::string mode_line(const Profile& profile) {
  const bool inch = profile.units == reference::Units::inch;
  const int plane = plane_code(profile.initial.plane);
  if (profile.dialect == "gsk988ta") {
    return fmt::format("{} G{} G40 G97 G98 G80", inch ? "G20" : "G21", plane);
  }
  if (profile.dialect == "hnc21t") {
    return fmt::format("{} {} G{} G40 G90 G94 G97", inch ? "G20" : "G21",
                       profile.x_diameter ? "G36" : "G37", plane);
  }
  if (profile.dialect == "rs274") {
    return fmt::format("{} G{} G40 G80 G90 G91.1 G94 G97", inch ? "G20" : "G21", plane);
  }
  return fmt::format("{} G{} G40 G90 G94", inch ? "G70" : "G71", plane);
}

// A coordinate as the program would say it; nothing when it is no decimal.
std::optional<std::string> word(const Profile& profile, Axis axis, const Number& value) {
  Number said = value;
  if (reference::is_linear(axis) && profile.units == reference::Units::inch) {
    said = said * 10 / 254;
  }
  if (axis == Axis::x && profile.x_diameter) said = said * 2;
  if (!said.is_rational()) return std::nullopt;
  std::string text = said.text();
  if (text.find('/') != std::string::npos) return std::nullopt;
  const auto letter_upper = static_cast<char>(letter(axis) - 'a' + 'A');
  return fmt::format("{}{}", letter_upper, text);
}

// What is expanded, as texts without line numbers of the header.
struct Expansion {
  std::vector<std::string> items;
  bool approach_only = true;  // of the header come traverses alone
};

std::string shifted(Record record, std::uint64_t header) {
  if (record.block > header) record.block -= header;
  return record_text(record);
}

Expansion expansion_of(const Profile& profile, std::string_view program, std::uint64_t header) {
  Expansion expansion;
  ProgramInput input(program);
  reference::Expander expander(profile, input.lines, reference::OpenPaths::shown);
  while (const reference::Item* item = expander.next()) {
    if (const auto* record = std::get_if<Record>(item)) {
      if (record->block != 0 && record->block <= header) {
        expansion.approach_only = expansion.approach_only && record->kind == RecordKind::rapid;
      } else {
        expansion.items.push_back(shifted(*record, header));
      }
    } else if (const auto* alarm = std::get_if<reference::AlarmReport>(item)) {
      if (alarm->block <= header) expansion.approach_only = false;
      expansion.items.push_back(fmt::format("alarm {} {} {}", alarm->block - header,
                                            name(alarm->alarms.front().alarm),
                                            alarm->alarms.front().word.text()));
    } else if (const auto* outside = std::get_if<reference::NotCovered>(item)) {
      if (outside->block <= header) expansion.approach_only = false;
      expansion.items.push_back(fmt::format("outside {}", outside->block - header));
    }
  }
  return expansion;
}

bool keeps_meaning(const Profile& profile, std::string_view program, const ExportHeader& header) {
  const Number elsewhere = Number(15) / 2;
  const std::string whole = header.text + std::string(program);
  for (const reference::ReadingChoice& choice : assignments_of(profile, program).choices) {
    Profile assigned = profile;
    assigned.readings = choice;
    const Expansion alone = expansion_of(assigned, program, 0);
    for (Axis axis : reference::kAllAxes) {
      if (header.axes.has(axis)) assigned.initial.at[axis] += elsewhere;
    }
    const Expansion led = expansion_of(assigned, whole, header.lines);
    if (!led.approach_only || led.items != alone.items) return false;
  }
  return true;
}

}  // namespace

std::optional<ExportHeader> export_header(const Profile& profile, std::string_view program,
                                          reference::AxisSet moved) {
  const bool lathe = is_lathe(profile.dialect);
  // Z first: up on a mill, and on a lathe along the part before the tool comes in.
  constexpr Axis first = Axis::z;
  const reference::AxisSet own =
      lathe ? reference::AxisSet{Axis::x, Axis::z} : reference::AxisSet{Axis::x, Axis::y, Axis::z};
  const reference::AxisSet axes = own | moved;
  std::string rest;
  for (Axis axis : reference::kAllAxes) {
    if (!axes.has(axis) || axis == first) continue;
    const auto text = word(profile, axis, profile.initial.at[axis]);
    if (!text) return std::nullopt;
    rest += " " + *text;
  }
  const auto depth = word(profile, first, profile.initial.at[first]);
  if (!depth) return std::nullopt;
  const std::string modes = mode_line(profile);
  const std::string approach = fmt::format("G0 {}\nG0{}\n", *depth, rest);
  std::string feed;
  if (profile.initial.feed.sign() != 0 && profile.initial.feed.is_rational()) {
    feed = fmt::format("F{}\n", profile.initial.feed.text());
  }
  // After the traverses the motion in force at power-on, however the dialect says it.
  for (const std::string_view motion : {"", "G80\n", "G1\n"}) {
    ExportHeader header{fmt::format("{}\n{}{}{}", modes, approach, feed, motion), 0, axes};
    header.lines = static_cast<std::uint64_t>(std::ranges::count(header.text, '\n'));
    if (keeps_meaning(profile, program, header)) return header;
  }
  return std::nullopt;
}

}  // namespace gonogo::oracle
