// SPDX-License-Identifier: GPL-3.0-or-later
//
// A program moved as a whole. HNC-21T has work offsets and the 802S frames: what stands in the
// blocks stays as it is. Elsewhere the absolute words are written anew.
#include <algorithm>
#include <cctype>

#include "fuzz/relations/related_lines.hpp"

namespace gonogo::fuzz {
namespace {

using reference::Axis;
using reference::Profile;
using reference::Units;

// How far, along X, Y, Z: whole inches, so that words in inches have no more decimals than before.
constexpr std::array<std::int64_t, 3> kInches = {1, -2, 3};
constexpr std::int64_t kTenthsAnInch = 254;

using Way = std::array<bool, 3>;  // the axes along which the program is moved

void move_places(const Way& way, Profile& profile, Related& related) {
  for (std::size_t axis = 0; axis < way.size(); ++axis) {
    if (!way[axis]) continue;
    related.shift[axis] = Number::millionths(kInches[axis] * kTenthsAnInch * 100'000);
    profile.initial.at.at[axis] += related.shift[axis];
  }
}

// The distance in the unit of the words: value / 10^scale.
SmallDecimal distance(std::size_t axis, bool inch) {
  return inch ? SmallDecimal{kInches[axis], 0} : SmallDecimal{kInches[axis] * kTenthsAnInch, 1};
}

// With all its decimals, which some controls count.
std::string full_text(const SmallDecimal& number, int scale) {
  std::string digits = std::to_string(number.value < 0 ? -number.value : number.value);
  const auto decimals = static_cast<std::size_t>(scale);
  while (digits.size() <= decimals) digits.insert(0, "0");
  if (decimals > 0) digits.insert(digits.size() - decimals, ".");
  return (number.value < 0 ? "-" : "") + digits;
}

// Adds to the number of a word. False where it cannot be read.
bool add(TextWord& word, const SmallDecimal& step) {
  // Words near the ends of their ranges have no room.
  constexpr std::int64_t kMost = 9'000;
  const std::vector<NumberPlace> places = numbers_of(word);
  if (places.size() != 1 || places.front().end != word.text.size()) return false;
  const SmallDecimal& number = places.front().number;
  const auto [value, added] = same_scale(number, step);
  const auto [most, size] = same_scale({kMost, 0}, number);
  if (size > most || size < -most) return false;
  const int scale = std::max(number.scale, step.scale);
  const SmallDecimal sum{value + added, scale};
  word.text.replace(places.front().begin, std::string::npos, full_text(sum, scale));
  return true;
}

// Adds to the value of a word of SINUMERIK: X10, X=R1+2, X=AC(3). False where it cannot be read.
bool add_to_expression(TextWord& word, const SmallDecimal& step) {
  std::string& text = word.text;
  if (text.find('=') == std::string::npos) return add(word, step);
  const std::string added = "+(" + step.text() + ")";
  if (text.back() == '=' || text.find_first_of("\"[$<>") != std::string::npos) return false;
  std::string value = text.substr(text.find('=') + 1);
  std::ranges::transform(value, value.begin(), [](unsigned char c) { return std::toupper(c); });
  const bool is_absolute = value.starts_with("AC(");
  if (value.starts_with("IC(") || (value.starts_with("AC") && !is_absolute)) return false;
  if (is_absolute && text.back() != ')') return false;
  text.insert(is_absolute ? text.size() - 1 : text.size(), added);
  return true;
}

std::size_t axis_of(const std::string& address) {
  return address.size() == 1 ? std::string_view("XYZ").find(address) : std::string_view::npos;
}
bool is_axis(std::size_t axis) {
  return axis != std::string_view::npos;
}

// The modes that say what a number means, as the codes of the lines set them.
struct Modes {
  bool inch = false;
  bool incremental = false;
  bool absolute_centre = false;

  void take(const TextLine& line, std::string_view in_inch, std::string_view metric) {
    if (holds(line, in_inch)) inch = true;
    if (holds(line, metric)) inch = false;
    if (holds(line, "G90")) incremental = false;
    if (holds(line, "G91")) incremental = true;
    if (holds(line, "G90.1")) absolute_centre = true;
    if (holds(line, "G91.1")) absolute_centre = false;
  }
};

Related moved_text(const GeneratedProgram& program, const Way& way,
                   const std::vector<TextLine>& lines) {
  Related related;
  related.program = {program.profile, text_of(lines)};
  related.lines = same_lines(lines.size());
  move_places(way, related.program.profile, related);
  return related;
}

std::optional<Related> translated_ngc(const GeneratedProgram& program) {
  std::vector<TextLine> lines = lines_of(program.text);
  if (has_unclear_words(lines)) return std::nullopt;
  Modes modes{program.profile.units == Units::inch};
  for (TextLine& line : lines) {
    if (is_left_out(line, program.profile)) continue;
    modes.take(line, "G20", "G21");
    for (TextWord& word : line.words) {
      const std::string address = address_of(word);
      const std::size_t offset =
          address.size() == 1 ? std::string_view("IJK").find(address) : std::string_view::npos;
      const bool is_place = is_axis(axis_of(address)) && !modes.incremental;
      const bool is_centre = is_axis(offset) && modes.absolute_centre;
      if (!is_place && !is_centre) continue;
      const std::size_t axis = is_place ? axis_of(address) : offset;
      if (!add(word, distance(axis, modes.inch))) return std::nullopt;
    }
  }
  return moved_text(program, {true, true, true}, lines);
}

// X Y Z are always absolute. Of the milling cycles the depth axis stays: R and P stand on it, too.
std::optional<Related> translated_gsk(const GeneratedProgram& program) {
  std::vector<TextLine> lines = lines_of(program.text);
  if (has_unclear_words(lines)) return std::nullopt;
  Way way = {true, true, true};
  if (holds_any(lines, {"G110", "G111", "G112", "G113", "G114", "G115", "G116", "G117"})) {
    const bool one_plane = !holds_any(lines, {"G17", "G18", "G19"});
    if (!one_plane) return std::nullopt;
    way[index(axes_of(program.profile.initial.plane).d)] = false;
  }
  Modes modes{program.profile.units == Units::inch};
  for (TextLine& line : lines) {
    if (is_left_out(line, program.profile)) continue;
    modes.take(line, "G20", "G21");
    if (holds(line, "G4")) continue;  // its X is a time
    for (TextWord& word : line.words) {
      const std::size_t axis = axis_of(address_of(word));
      if (!is_axis(axis) || !way[axis]) continue;
      SmallDecimal step = distance(axis, modes.inch);
      if (axis == 0 && program.profile.x_diameter) step.value *= 2;
      if (!add(word, step)) return std::nullopt;
    }
  }
  Related related = moved_text(program, way, lines);
  for (std::size_t axis = 0; axis < way.size(); ++axis) {
    related.program.profile.reference_point.at[axis] += related.shift[axis];
  }
  return related;
}

// G54 to G59 along X and Z; G54 before the program, where it makes no difference otherwise.
std::optional<Related> translated_hnc(const GeneratedProgram& program) {
  const auto own = program.profile.offsets.find("G54");
  if (own != program.profile.offsets.end() && own->second != reference::Position{}) {
    return std::nullopt;
  }
  std::optional<Related> related = with_block_before(program, "G54");
  if (!related) return std::nullopt;
  Profile& profile = related->program.profile;
  move_places({true, false, true}, profile, *related);
  for (const char* const name : {"G54", "G55", "G56", "G57", "G58", "G59"}) {
    for (const Axis axis : {Axis::x, Axis::z}) {
      profile.offsets[name][axis] += related->shift[index(axis)];
    }
  }
  return related;
}

std::optional<Related> translated_802s(const GeneratedProgram& program) {
  const std::vector<TextLine> lines = lines_of(program.text);
  if (has_bare_g(lines) || holds_any(lines, {"G158", "G258", "G259", "G53", "G500"})) {
    return std::nullopt;
  }
  std::string block = "G158";
  for (std::size_t axis = 0; axis < kInches.size(); ++axis) {
    block += std::string(" ") + "XYZ"[axis] +
             distance(axis, program.profile.units == Units::inch).text();
  }
  std::optional<Related> related = with_block_before(program, block);
  if (related) move_places({true, true, true}, related->program.profile, *related);
  return related;
}

// Whether the value of a word is a place, and not a way: X, I1= by the mode in force, I by AC()
// alone.
bool is_place(const TextWord& word, const Modes& modes, bool by_mode) {
  std::string value = word.text.substr(std::min(word.text.find('=') + 1, word.text.size()));
  std::ranges::transform(value, value.begin(), [](unsigned char c) { return std::toupper(c); });
  if (value.starts_with("AC")) return true;
  return by_mode && !modes.incremental && !value.starts_with("IC");
}

// The axis of X10, X=..., I=..., I1=...; npos for other words. `by_mode` as for is_place.
std::size_t axis_of_840d(const TextWord& word, bool& by_mode) {
  const std::string address = address_of(word);
  by_mode = true;
  if (is_axis(axis_of(address))) return axis_of(address);
  if (address.size() != 1) return std::string_view::npos;
  by_mode = word.text.size() > 2 && word.text[1] == '1' && word.text[2] == '=';
  return std::string_view("IJK").find(address);
}

// Poles at the workpiece zero, as they are after a plane code, stay there: no polar words.
std::optional<Related> translated_840d(const GeneratedProgram& program) {
  std::vector<TextLine> lines = lines_of(program.text);
  if (has_unclear_words(lines) || holds_any(lines, {"G110", "G111", "G112"})) return std::nullopt;
  Modes modes{program.profile.units == Units::inch};
  for (TextLine& line : lines) {
    if (is_left_out(line, program.profile)) continue;
    modes.take(line, "G70", "G71");
    for (TextWord& word : line.words) {
      const std::string address = address_of(word);
      if (address == "AP" || address == "RP") return std::nullopt;
      bool by_mode = false;
      const std::size_t axis = axis_of_840d(word, by_mode);
      if (!is_axis(axis) || !is_place(word, modes, by_mode)) continue;
      if (!add_to_expression(word, distance(axis, modes.inch))) return std::nullopt;
    }
  }
  return moved_text(program, {true, true, true}, lines);
}

}  // namespace

std::optional<Related> translated(const GeneratedProgram& program) {
  const std::string& dialect = program.profile.dialect;
  if (dialect == "gsk988ta") return translated_gsk(program);
  if (dialect == "hnc21t") return translated_hnc(program);
  if (dialect == "rs274") return translated_ngc(program);
  return dialect == "sinumerik802s" ? translated_802s(program) : translated_840d(program);
}

}  // namespace gonogo::fuzz
