// SPDX-License-Identifier: GPL-3.0-or-later
#include "checker/profile.hpp"

#include <algorithm>
#include <array>
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

// `gonogo spec` prints the same.
constexpr std::array kDefaults = {
    Choice{"gsk.arc.tolerance-zero", "any", "off"},
    Choice{"gsk.arc.zero-radius", "any", "alarm"},
    Choice{"gsk.decimals", "any", "keep"},
    Choice{"gsk.duplicate", "alarm", "alarm"},
    Choice{"gsk.dwell-without-word", "any", "alarm"},
    Choice{"gsk.g50.initial-plane", "any", "shifted"},
    Choice{"gsk.g92.lead", "any", "own"},
    Choice{"gsk.g94.after-00", "any", "stays"},
    Choice{"gsk.g94.empty-block", "any", "none"},
    Choice{"gsk.g94.in-mode", "any", "keep"},
    Choice{"gsk.g94.rewrite", "any", "keep"},
    Choice{"gsk.helix.entry-side", "any", "any"},
    Choice{"gsk.helix.flat", "any", "off"},
    Choice{"gsk.helix.L", "any", "per-block"},
    Choice{"gsk.missing-axis", "any", "skip"},
    Choice{"gsk.pocket.end", "any", "initial"},
    Choice{"gsk.pocket.p-omitted", "any", "0"},
    Choice{"gsk.pocket.pair", "any", "shared"},
    Choice{"gsk.pocket.path", "any", "any"},
    Choice{"gsk.pocket.R", "any", "per-block"},
    Choice{"gsk.rotary-feed-inch", "any", "scaled"},
    Choice{"gsk.thread.direction", "any", "alarm"},
    Choice{"gsk.thread.k-range", "any", "360"},
    Choice{"gsk.thread.modal", "any", "code"},
    Choice{"gsk.thread.mode", "any", "pairs"},
    Choice{"gsk.thread.path", "any", "any"},
    Choice{"gsk.thread.r", "any", "optional"},
    Choice{"gsk.thread.runout", "any", "any"},
    Choice{"gsk.thread.v-from", "any", "r-plane"},
    Choice{"gsk.x-depth", "any", "diameter"},
    Choice{"gsk.zero-depth", "any", "no-cut"},
    Choice{"gsk.zero-depth-end", "any", "initial"},
    Choice{"hnc.arc.zero-radius", "any", "alarm"},
    Choice{"hnc.g75.depth-scale", "any", "radius"},
    Choice{"hnc.g75.end", "any", "start"},
    Choice{"hnc.g75.i", "any", "I"},
    Choice{"hnc.g75.mode3", "off", "off"},
    Choice{"hnc.g75.steps", "any", "i-plus-1"},
    Choice{"hnc.g82.e-scale", "any", "radius"},
    Choice{"hnc.g82.exit", "any", "rapid"},
    Choice{"hnc.g82.starts", "any", "all"},
    Choice{"hnc.lead.unit", "mm", "mm"},
    Choice{"hnc.missing-axis", "reject", "reject"},
    Choice{"hnc.modal.f", "any", "feed"},
    Choice{"hnc.offset.initial", "any", "G54"},
    Choice{"hnc.peck.clamp", "any", "none"},
    Choice{"hnc.peck.from", "any", "last-bottom"},
    Choice{"hnc.peck.withdraw", "any", "rapid"},
    Choice{"ngc.alarm-dwell", "any", "none"},
    Choice{"ngc.arc-tolerance", "any", "nist"},
    Choice{"ngc.arc-words-alone", "any", "arc"},
    Choice{"ngc.bare-motion", "any", "nothing"},
    Choice{"ngc.block-delete", "any", "unread"},
    Choice{"ngc.call-parameters", "any", "kept"},
    Choice{"ngc.cycle.alarm-at", "any", "block"},
    Choice{"ngc.cycle.approach", "current-level", "current-level"},
    Choice{"ngc.cycle.feed", "any", "needed"},
    Choice{"ngc.cycle.g91-r", "current", "current"},
    Choice{"ngc.cycle.initial", "any", "series"},
    Choice{"ngc.cycle.initial-kept", "any", "place"},
    Choice{"ngc.cycle.retract-start", "any", "r-plane"},
    Choice{"ngc.cycle.sticky", "number", "number"},
    Choice{"ngc.equal", "any", "millionth"},
    Choice{"ngc.feed-units", "before", "before"},
    Choice{"ngc.full-circle-words", "any", "free"},
    Choice{"ngc.g33.k", "any", "positive"},
    Choice{"ngc.g73.end", "any", "r-plane"},
    Choice{"ngc.g74.l", "any", "allowed"},
    Choice{"ngc.g76.checks", "text", "text"},
    Choice{"ngc.g76.entry", "any", "thread"},
    Choice{"ngc.g76.slide", "any", "start"},
    Choice{"ngc.g80-beside", "any", "alarm"},
    Choice{"ngc.g83.retract", "any", "r-plane"},
    Choice{"ngc.g83.return", "rapid", "rapid"},
    Choice{"ngc.g85.out", "any", "r-plane"},
    Choice{"ngc.g92-other-axes", "any", "zero"},
    Choice{"ngc.g94-feed", "any", "kept"},
    Choice{"ngc.line-number", "any", "decimal"},
    Choice{"ngc.lone-cr", "any", "line-end"},
    Choice{"ngc.missing-tool", "any", "taken"},
    Choice{"ngc.o-name", "any", "passed-over"},
    Choice{"ngc.peck.clearance", "any", "ten-thou"},
    Choice{"ngc.peck.d", "any", "barred"},
    Choice{"ngc.peck.dwell", "none", "none"},
    Choice{"ngc.program-end", "needed", "needed"},
    Choice{"ngc.sign-of-value", "any", "taken"},
    Choice{"ngc.tap.p", "any", "optional"},
    Choice{"ngc.unused-words", "alarm", "alarm"},
    Choice{"ngc.whole", "any", "exact"},
    Choice{"sie.arc.correct", "any", "start-radius"},
    Choice{"sie.corner", "clamp", "clamp"},
    Choice{"sie.cr.tolerance", "any", "0"},
    Choice{"sie.finish.levels", "any", "any"},
    Choice{"sie.g158", "absolute", "absolute"},
    Choice{"sie.g258", "any", "absolute"},
    Choice{"sie.g70.f", "any", "mm"},
    Choice{"sie.infeed", "any", "any"},
    Choice{"sie.infeed-from", "any", "reference"},
    Choice{"sie.initial-motion", "any", "g1"},
    Choice{"sie.lc75.r125-limit", "any", "none"},
    Choice{"sie.lcyc.unit", "any", "mm"},
    Choice{"sie.pocket.path", "any", "any"},
    Choice{"sie.rpl-equals", "lenient", "lenient"},
    Choice{"sie.spindle", "off", "off"},
};

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
  if (found == kDefaults.end()) return std::nullopt;
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
  return said == "any" && found != kDefaults.end() ? std::string(found->shown) : said;
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
      "(while|do|repeat|sub|call|WHILE|DO|REPEAT|SUB|CALL)");
  return dialect == "rs274" && std::regex_search(program.begin(), program.end(), kWord);
}

}  // namespace gonogo::checker
