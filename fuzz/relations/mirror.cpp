// SPDX-License-Identifier: GPL-3.0-or-later
//
// A program mirrored along an axis: places and ways along it change their sign, and arcs turn the
// other way in the planes that hold it.
#include <algorithm>

#include "fuzz/relations/related_lines.hpp"

namespace gonogo::fuzz {
namespace {

using reference::Axis;
using reference::Plane;
using reference::Profile;

// Where a word with a sign of its own stands along the axis.
struct MirroredAxis {
  std::size_t axis;
  char place() const { return "XYZ"[axis]; }
  char way() const { return "UVW"[axis]; }
  char centre() const { return "IJK"[axis]; }
};

// The plane that the line chooses.
std::optional<Plane> plane_of(const TextLine& line) {
  for (const Plane plane : {Plane::g17, Plane::g18, Plane::g19}) {
    if (holds(line, "G" + std::to_string(plane_code(plane)))) return plane;
  }
  return std::nullopt;
}

// Whether arcs turn the other way. Nothing where they would in some planes only: G2 is modal.
std::optional<bool> swaps_arcs(const std::vector<TextLine>& lines, const Profile& profile,
                               std::size_t axis) {
  Plane plane = profile.initial.plane;
  std::optional<bool> swaps;
  for (const TextLine& line : lines) {
    if (line.words.empty() || is_left_out(line, profile)) continue;
    plane = plane_of(line).value_or(plane);
    const bool holds_axis = index(axes_of(plane).d) != axis;
    if (swaps && *swaps != holds_axis) return std::nullopt;
    swaps = holds_axis;
  }
  return swaps;
}

// Cycles whose words have no sign to change, or one that depends on more than is followed here.
bool has_signs_of_its_own(const std::vector<TextLine>& lines, const Profile& profile) {
  const std::string& dialect = profile.dialect;
  if (dialect == "gsk988ta") {
    const bool only_g18 = profile.initial.plane == Plane::g18 && !holds_any(lines, {"G17", "G19"});
    if (!only_g18 && holds_any(lines, {"G90", "G92", "G94"})) return true;
    return holds_any(lines, {"G28", "G32", "G50", "G110", "G111", "G112", "G113", "G114", "G115",
                             "G116", "G117"});
  }
  if (dialect == "hnc21t") {
    return holds_any(lines, {"G28", "G29", "G32", "G74", "G75", "G82", "G92"});
  }
  if (dialect == "rs274") return false;
  const bool polar = std::ranges::any_of(lines, [](const TextLine& line) {
    return std::ranges::any_of(line.words, [](const TextWord& word) {
      const std::string address = address_of(word);
      return address == "AP" || address == "RP" || address == "RPL";
    });
  });
  return polar || holds_any(lines, {"G110", "G111", "G112", "G258", "G259", "LCYC75", "LCYC82"});
}

// X5 as X-5, X=R1 as X=-(R1), X=IC(2) as X=IC(-(2)). False where it cannot be read.
bool change_sign(TextWord& word, std::size_t address) {
  std::string& text = word.text;
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) {
    const std::vector<NumberPlace> places = numbers_of(word);
    if (places.size() != 1 || places.front().begin != address ||
        places.front().end != text.size()) {
      return false;
    }
    if (text[address] == '-') {
      text.erase(address, 1);
    } else if (text[address] == '+') {
      text[address] = '-';
    } else {
      text.insert(address, "-");
    }
    return true;
  }
  if (text.back() == '=' || text.find_first_of("\"[$<>;") != std::string::npos) return false;
  std::size_t value = equals + 1;
  const bool is_bracketed = text.size() > value + 2 && (text[value + 1] | 0x20) == 'c' &&
                            text[value + 2] == '(';  // AC(...), IC(...)
  if (!is_bracketed) {
    text.insert(value, "-(");
    text += ")";
    return true;
  }
  if (text.back() != ')') return false;
  text.insert(value + 3, "-(");
  text += ")";
  return true;
}

// The modal motions by which R and the centre words get their meaning.
struct Motion {
  bool is_arc = false;
  int taper_axis = -1;  // along which R, I or K is a difference

  void take(const TextLine& line, const std::string& dialect) {
    const auto set = [&](std::string_view code, bool arc, int taper) {
      if (!holds(line, code)) return;
      is_arc = arc;
      taper_axis = taper;
    };
    for (const std::string_view code : {"G0", "G1", "CIP", "CT"}) set(code, false, -1);
    for (const std::string_view code : {"G2", "G3"}) set(code, true, -1);
    if (dialect == "gsk988ta") {
      for (const std::string_view code : {"G90", "G92"}) set(code, false, 0);
      set("G94", false, 2);
    } else if (dialect == "hnc21t") {
      set("G80", false, 0);
      set("G81", false, 2);
    }
  }
};

// Whether the word has the sign of the axis.
bool is_along(const TextWord& word, const MirroredAxis& mirror, const Motion& motion,
              const std::string& dialect) {
  const std::string address = address_of(word);
  if (address.size() != 1) return false;
  const char letter = address.front();
  if (letter == mirror.place()) return true;
  const bool is_lathe = dialect == "gsk988ta" || dialect == "hnc21t";
  if (is_lathe && letter == mirror.way()) return true;
  const bool is_taper = motion.taper_axis == static_cast<int>(mirror.axis);
  if (dialect == "gsk988ta") {
    return (letter == 'R' && is_taper) || (letter == mirror.centre() && motion.is_arc);
  }
  if (dialect == "hnc21t") return letter == mirror.centre() && (motion.is_arc || is_taper);
  return letter == mirror.centre();
}

// SINUMERIK takes the plane of an arc from the axes that it names.
bool names_depth_axis(const TextLine& line, Plane plane) {
  const std::size_t depth = index(axes_of(plane).d);
  return std::ranges::any_of(line.words, [&](const TextWord& word) {
    const std::string address = address_of(word);
    return address.size() == 1 &&
           (address.front() == "XYZ"[depth] || address.front() == "IJK"[depth]);
  });
}

void swap_arc(TextWord& word) {
  const std::string code = code_of(word);
  if (code == "G2") word.text = "G3";
  if (code == "G3") word.text = "G2";
}

void mirror_machine(Profile& profile, std::size_t axis, bool swaps) {
  const auto turn = [&](reference::Position& position) { position.at[axis] = -position.at[axis]; };
  turn(profile.initial.at);
  turn(profile.reference_point);
  for (auto& [name, offset] : profile.offsets) turn(offset);
  const int motion = profile.initial.motion;
  if (swaps && (motion == 2 || motion == 3)) profile.initial.motion = 5 - motion;
}

}  // namespace

std::optional<Related> mirrored(const GeneratedProgram& program, std::size_t axis) {
  const std::string& dialect = program.profile.dialect;
  if (dialect == "hnc21t" && axis == 1) return std::nullopt;  // a lathe without Y
  std::vector<TextLine> lines = lines_of(program.text);
  if (has_unclear_words(lines) || has_signs_of_its_own(lines, program.profile)) return std::nullopt;
  const std::optional<bool> swaps = swaps_arcs(lines, program.profile, axis);
  if (!swaps) return std::nullopt;
  const bool is_sinumerik = dialect.starts_with("sinumerik");
  Plane plane = program.profile.initial.plane;
  Motion motion;
  motion.is_arc = program.profile.initial.motion == 2 || program.profile.initial.motion == 3;
  for (TextLine& line : lines) {
    if (is_left_out(line, program.profile)) continue;
    plane = plane_of(line).value_or(plane);
    motion.take(line, dialect);
    if (is_sinumerik && motion.is_arc && names_depth_axis(line, plane)) return std::nullopt;
    if (dialect == "gsk988ta" && holds(line, "G4")) continue;  // its X is a time
    for (TextWord& word : line.words) {
      if (is_along(word, {axis}, motion, dialect) && !change_sign(word, address_of(word).size())) {
        return std::nullopt;
      }
      if (*swaps) swap_arc(word);
    }
  }
  Related related;
  related.program = {program.profile, text_of(lines)};
  related.lines = same_lines(lines.size());
  related.mirrored[axis] = true;
  mirror_machine(related.program.profile, axis, *swaps);
  return related;
}

}  // namespace gonogo::fuzz
