// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/export_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "oracle/judge/judge_session.hpp"
#include "oracle/steps/step_text.hpp"
#include "reference/dialect.hpp"
#include "reference/power_on.hpp"

namespace gonogo::oracle {
namespace {

using reference::Axis;
using reference::Kind;
using reference::Profile;

// The modes that the reference takes for those at power-on, as codes.
std::string mode_line(const Profile& profile) {
  std::string line;
  for (const reference::Code* code : reference::power_on_codes(profile)) {
    line += fmt::format("{}{}", line.empty() ? "" : " ", code->name);
  }
  return line;
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
  const reference::Dialect& dialect = *reference::find_dialect(profile.dialect);
  const reference::Descriptor& table = *dialect.descriptor;
  // Z first: up on a mill, and on a lathe along the part before the tool comes in.
  constexpr Axis first = Axis::z;
  const reference::AxisSet own = dialect.lathe ? reference::AxisSet{Axis::x, Axis::z}
                                               : reference::AxisSet{Axis::x, Axis::y, Axis::z};
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
  const std::string approach =
      fmt::format("{0} {1}\n{0}{2}\n", table.find(Kind::traverse)->name, *depth, rest);
  std::string feed;
  if (profile.initial.feed.sign() != 0 && profile.initial.feed.is_rational()) {
    feed = fmt::format("F{}\n", profile.initial.feed.text());
  }
  // After the traverses the motion in force at power-on, however the dialect says it.
  std::vector<std::string> motions = {""};
  for (const Kind kind : {Kind::off, Kind::line}) {
    const reference::Code* const code = table.find(kind);
    if (code != nullptr) motions.push_back(fmt::format("{}\n", code->name));
  }
  for (const std::string& motion : motions) {
    ExportHeader header{fmt::format("{}\n{}{}{}", modes, approach, feed, motion), 0, axes};
    header.lines = static_cast<std::uint64_t>(std::ranges::count(header.text, '\n'));
    if (keeps_meaning(profile, program, header)) return header;
  }
  return std::nullopt;
}

}  // namespace gonogo::oracle
