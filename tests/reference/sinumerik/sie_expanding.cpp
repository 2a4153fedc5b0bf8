// SPDX-License-Identifier: GPL-3.0-or-later
#include "sie_expanding.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace gonogo::reference::testing::sie {
namespace {

constexpr int kDecimals = 9;

std::string pair_text(const Number& p, const Number& q) {
  return p.decimal_text(kDecimals) + "," + q.decimal_text(kDecimals);
}

}  // namespace

Profile sie(std::initializer_list<std::pair<std::string_view, std::string_view>> readings) {
  Profile profile = std::get<Profile>(default_profile("sinumerik840d"));
  for (const auto& [name, value] : readings) {
    if (auto error = set_reading(profile, name, value)) throw std::invalid_argument(error->message);
  }
  return profile;
}

Lines path(std::string_view program, const Profile& profile) {
  Lines all = lines(program, profile);
  std::erase_if(all, [](const std::string& line) { return line.starts_with('m'); });
  return all;
}

std::string line(std::string_view program, std::size_t place, const Profile& profile) {
  return path(program, profile).at(place);
}

std::string outcome(std::string_view block, const Profile& profile) {
  return outcome_of_program("F100\n" + std::string(block), profile);
}

std::string outcome_of_program(std::string_view program, const Profile& profile) {
  const Item last = expand(program, profile).back();
  if (const auto* end = std::get_if<NotCovered>(&last)) return "not-covered " + end->code;
  const auto* report = std::get_if<AlarmReport>(&last);
  if (report == nullptr) return "end";
  std::string text;
  for (const Alarm& alarm : report->alarms) {
    if (!text.empty()) text += ", ";
    text += fmt::format("{} {}", name(alarm.alarm), alarm.word.text());
  }
  return text;
}

Lines clauses(std::string_view program, const Profile& profile) {
  return clauses_of(program, profile);
}

Lines touched(std::string_view program, const Profile& profile) {
  return touched_readings(program, profile);
}

Record last_motion(std::string_view program, const Profile& profile) {
  std::optional<Record> last;
  for (const Item& item : expand(program, profile)) {
    const auto* record = std::get_if<Record>(&item);
    if (record == nullptr) throw std::invalid_argument("alarm: " + line_of(item));
    if (is_motion(record->kind)) last = *record;
  }
  return last.value();
}

std::string centre(const Record& arc) {
  return pair_text(arc.centre[0], arc.centre[1]);
}

std::string end_in_plane(const Record& arc) {
  const PlaneAxes axes = axes_of(arc.plane);
  return pair_text(arc.to[axes.p], arc.to[axes.q]);
}

}  // namespace gonogo::reference::testing::sie
