// SPDX-License-Identifier: GPL-3.0-or-later
#include "checker/profile.hpp"

#include <algorithm>
#include <iterator>
#include <regex>
#include <utility>
#include <vector>

namespace gonogo::checker {
namespace {

// A reading, its default, and what is expected where an expectation does not say its value.
struct Choice {
  std::string_view key;
  std::string_view otherwise;
  std::string_view shown;
};

// kDefaults, as the catalog has them.
#include "checker/readings.inc"

const Json* inner(const Json& profile, std::string_view object, std::string_view key) {
  const Json* found = profile.find(object);
  return found == nullptr ? nullptr : found->find(key);
}

// The code of a G word at `at`, which stands behind the letter; 0: none. `G50.1` is another code.
long code_at(std::string_view line, std::size_t at) {
  while (at < line.size() && (line[at] == ' ' || line[at] == '\t')) ++at;
  long code = 0;
  std::size_t digits = 0;
  for (; at < line.size() && line[at] >= '0' && line[at] <= '9' && digits < 6; ++at, ++digits) {
    code = code * 10 + (line[at] - '0');
  }
  return digits == 0 || (at < line.size() && line[at] == '.') ? 0 : code;
}

// CR LF, LF and CR end a line.
std::vector<std::string_view> lines_of(std::string_view program) {
  std::vector<std::string_view> lines;
  for (std::size_t at = 0; at < program.size();) {
    const std::size_t end = std::min(program.find_first_of("\r\n", at), program.size());
    lines.push_back(program.substr(at, end - at));
    at = end + (program.substr(end, 2) == "\r\n" ? 2U : 1U);
  }
  return lines;
}

}  // namespace

std::optional<std::string_view> default_reading(std::string_view key) {
  const auto found = std::ranges::find(kDefaults, key, &Choice::key);
  if (found == std::end(kDefaults)) return std::nullopt;
  return found->otherwise;
}

std::string reading(const Json& profile, std::string_view key) {
  if (const Json* said = inner(profile, "readings", key)) return said->text;
  const auto otherwise = default_reading(key);
  if (!otherwise) throw Fault("The reading " + std::string(key) + " is unknown.");
  return std::string(*otherwise);
}

std::string shown_reading(const Json& profile, std::string_view key) {
  const std::string said = reading(profile, key);
  const auto found = std::ranges::find(kDefaults, key, &Choice::key);
  return said == "any" && found != std::end(kDefaults) ? std::string(found->shown) : said;
}

bool is_admissible(const Readings& when, const Json& profile) {
  return std::ranges::all_of(when, [&](const auto& choice) {
    const std::string in_force = reading(profile, choice.first);
    return in_force == "any" || in_force == choice.second;
  });
}

Rational resolution(std::string_view dialect, const Json& profile) {
  if (const Json* said = profile.find("resolution")) return parse_rational(said->text);
  if (dialect == "rs274") return Rational(1, 10000);
  const Json* increment = profile.find("increment");
  const bool is_fine = dialect == "gsk988ta" && increment != nullptr && increment->text == "ISC";
  return Rational(1, is_fine ? 10000 : 1000);
}

Rational parameter(const Json& profile, std::string_view name, const Rational& otherwise) {
  const Json* said = inner(profile, "parameters", name);
  return said == nullptr ? otherwise : parse_rational(said->text);
}

Position initial_position(const Json& profile) {
  Position position;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const Json* said = inner(profile, "initial", kAxisNames.substr(axis, 1));
    position[axis] = said == nullptr ? Real() : Real(parse_rational(said->text));
  }
  return position;
}

bool alarms_at_load(const Json& profile) {
  const Json* timing = profile.find("alarm_timing");
  return timing != nullptr && timing->text == "program";
}

bool is_open_path(const Record& record, std::string_view dialect, const Json& profile) {
  const std::string_view clause = record.clause;
  if (clause.starts_with("SIE-LC75-")) return true;
  if (dialect != "gsk988ta") return false;
  if (clause == "GSK-G110-09") return reading(profile, "gsk.pocket.path") == "any";
  if (clause == "GSK-G112-04" || clause == "GSK-G112-05" || clause == "GSK-G112-06") {
    return reading(profile, "gsk.helix.entry-side") == "any";
  }
  if (clause == "GSK-G114-06" || clause == "GSK-G114-11") {
    return reading(profile, "gsk.thread.path") == "any" ||
           reading(profile, "gsk.thread.runout") == "any";
  }
  return false;
}

long line_count(std::string_view program) {
  return static_cast<long>(lines_of(program).size());
}

long line_of_code(std::string_view program, long code) {
  long number = 0;
  for (const std::string_view line : lines_of(program)) {
    ++number;
    for (std::size_t at = line.find_first_of("Gg"); at != std::string_view::npos;
         at = line.find_first_of("Gg", at + 1)) {
      if (code_at(line, at + 1) == code) return number;
    }
  }
  return 0;
}

bool says_m_function(std::string_view program, long line, long number) {
  // Digits may have blanks between them (RS274/NGC).
  std::string digits = "(?:0[ \t]*)*";
  for (const char digit : std::to_string(number)) digits += std::string(1, digit) + "[ \t]*";
  const std::regex says("[Mm][ \t]*(?:[#=R(]|\\[|\\+?[ \t]*" + digits + "(?![0-9]))");
  const std::vector<std::string_view> lines = lines_of(program);
  const auto place = static_cast<std::size_t>(line) - 1;
  return place < lines.size() && std::regex_search(std::string(lines[place]), says);
}

long renaming_line(std::string_view dialect, std::string_view program) {
  if (dialect == "gsk988ta") return line_of_code(program, 50);
  return dialect == "hnc21t" ? line_of_code(program, 92) : 0;
}

bool lines_come_again(std::string_view dialect, std::string_view program) {
  static const std::regex kWord(
      "[oO][ \\t]*([0-9]+|<[^>]*>|\\[.*\\])[ \\t]*"
      "(while|do|repeat|sub|call|WHILE|DO|REPEAT|SUB|CALL)|[mM][ \\t]*9[89]");
  return dialect == "rs274" && std::regex_search(program.begin(), program.end(), kWord);
}

}  // namespace gonogo::checker
