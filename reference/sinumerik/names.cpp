// SPDX-License-Identifier: GPL-3.0-or-later
//
// SIE-MOD-02: names that the gauge passes over, and names of the control that it does not read.
#include "reference/sinumerik/names.hpp"

#include <algorithm>
#include <array>

namespace gonogo::reference::sinumerik {
namespace {

using enum Treatment;

constexpr std::string_view kAnyCycle = "CYCLE<n>";
constexpr std::string_view kOtherAxis = "axis <n>";
constexpr std::string_view kOtherSpindle = "spindle <n>";
constexpr std::string_view kOtherAddress = "address <n>";
constexpr std::string_view kOwnName = "name <n>";

// In the order of the bytes.
constexpr auto kNames = std::to_array<Name>({
    {"ACC", outside, "acceleration of an axis"},
    {"AMIRROR", outside, "mirroring, added"},
    {"ANG", outside, "angle of a straight line"},
    {"AROT", outside, "rotation, added"},
    {"ASCALE", outside, "scaling, added"},
    {"ASPLINE", outside, "Akima spline"},
    {"ATRANS", outside, "translation, added"},
    {"B", outside, "axis that the gauge does not have"},
    {"BRISK", without_effect, "acceleration by steps"},
    {"BSPLINE", outside, "B spline"},
    {"CFC", without_effect, "constant feed at the contour"},
    {"CFIN", without_effect, "constant feed at inner radii"},
    {"CFTCP", without_effect, "constant feed of the tool's centre"},
    {"CHF", outside, "chamfer by its length"},
    {"CHR", outside, "chamfer by its width"},
    {"COMPCAD", outside, "compressor"},
    {"COMPCURV", outside, "compressor"},
    {"COMPOF", without_effect, "compressor off"},
    {"COMPON", outside, "compressor"},
    {"CSPLINE", outside, "cubic spline"},
    {kAnyCycle, outside, "cycle"},
    {"DIAM90", outside, "diameters under G90"},
    {"DIAMOF", without_effect, "radius programming"},
    {"DIAMON", outside, "diameter programming"},
    {"DRIVE", without_effect, "acceleration of the drives"},
    {"E", outside, "axis that the gauge does not have"},
    {"FB", outside, "feed of the block"},
    {"FFWOF", without_effect, "feedforward control off"},
    {"FFWON", without_effect, "feedforward control on"},
    {"FGROUP", outside, "axes that the feed holds for"},
    {"FL", outside, "limit of an axis' feed"},
    {"FRC", outside, "feed of chamfers and roundings"},
    {"FRCM", outside, "feed of chamfers and roundings, modal"},
    {"FXS", outside, "travel to a fixed stop"},
    {"HOLES1", outside, "row of holes"},
    {"HOLES2", outside, "circle of holes"},
    {"INIT", outside, "selection of a program of another channel"},
    {"INVCCW", outside, "involute counterclockwise"},
    {"INVCW", outside, "involute clockwise"},
    {"KONT", outside, "approach round the contour"},
    {"L", outside, "subprogram"},
    {"LCYC60", outside, "row of holes"},
    {"LCYC61", outside, "circle of holes"},
    {"LCYC83", outside, "deep drilling"},
    {"LCYC84", outside, "rigid tapping"},
    {"LCYC840", outside, "tapping with a compensating chuck"},
    {"LCYC85", outside, "boring"},
    {"LCYC93", outside, "groove"},
    {"LCYC94", outside, "undercut"},
    {"LCYC95", outside, "stock removal"},
    {"LCYC96", outside, "thread undercut"},
    {"LCYC97", outside, "thread cutting"},
    {"LIMS", without_effect, "limit of the spindle speed"},
    {"LONGHOLE", outside, "slots on a circle, of the tool's width"},
    {"MIRROR", outside, "mirroring"},
    {"MSG", without_effect, "message"},
    {"NORM", outside, "approach along a normal"},
    {"O", outside, "address that the gauge does not have"},
    {"OFFN", outside, "allowance on the contour"},
    {"OVR", outside, "override"},
    {"P", outside, "passes of a subprogram"},
    {"POCKET1", outside, "rectangular pocket"},
    {"POCKET2", outside, "circular pocket"},
    {"POCKET3", outside, "rectangular pocket"},
    {"POCKET4", outside, "circular pocket"},
    {"POLY", outside, "polynomial"},
    {"PUTFTOC", outside, "tool correction while moving"},
    {"Q", outside, "axis that the gauge does not have"},
    {"RND", outside, "rounding"},
    {"RNDM", outside, "rounding, modal"},
    {"ROT", outside, "rotation"},
    {"ROTS", outside, "rotation by angles in space"},
    {"RPL", outside, "angle of a rotation"},
    {"SCALE", outside, "scaling"},
    {"SETAL", outside, "alarm set by the program"},
    {"SLOT1", outside, "slots on a circle"},
    {"SLOT2", outside, "slots along a circle"},
    {"SOFT", without_effect, "acceleration without jerks"},
    {"SPCOF", outside, "position control of the spindle off"},
    {"SPCON", outside, "position control of the spindle on"},
    {"SPOS", without_effect, "position of the spindle"},
    {"START", outside, "start of a program of another channel"},
    {"STOPRE", without_effect, "stop of the block preparation"},
    {"SUPA", outside, "all offsets off in the block"},
    {"TRACYL", outside, "transformation of a cylinder's surface"},
    {"TRAFOOF", outside, "transformation off"},
    {"TRANS", outside, "translation"},
    {"TRANSMIT", outside, "transformation of a face"},
    {"TRAORI", outside, "transformation of the tool's orientation"},
    {"U", outside, "axis that the gauge does not have"},
    {"V", outside, "axis that the gauge does not have"},
    {"W", outside, "axis that the gauge does not have"},
    {"WAITM", outside, "waiting for another channel"},
    {"WORKPIECE", outside, "blank of the simulation"},
    {kOtherAddress, outside, "address with a number, whose meaning is the machine's"},
    {kOtherAxis, outside, "axis by its number"},
    {kOwnName, outside, "name of a subprogram, of a variable, or of a code that the list lacks"},
    {kOtherSpindle, outside, "word of a spindle by its number"},
});
static_assert(std::ranges::is_sorted(kNames, {}, &Name::name));

const Name* find(std::string_view name) {
  const auto* const found = std::ranges::lower_bound(kNames, name, {}, &Name::name);
  return found != kNames.end() && found->name == name ? found : nullptr;
}

bool is_numbered(std::string_view name, std::string_view prefix) {
  if (!name.starts_with(prefix) || name.size() == prefix.size()) return false;
  return std::ranges::all_of(name.substr(prefix.size()),
                             [](char byte) { return byte >= '0' && byte <= '9'; });
}

bool is_cycle(std::string_view name) {
  return is_numbered(name, "CYCLE");
}

}  // namespace

std::span<const Name> names() {
  return kNames;
}

const Name* find_name(const grammar::NamedWord& word) {
  if (word.index) {
    if (word.name == "S" || word.name == "M" || word.name == "T") return find(kOtherSpindle);
    constexpr std::string_view kAxisLetters = "ABCUVWXYZ";
    const bool is_axis =
        word.name.size() == 1 && kAxisLetters.find(word.name[0]) != std::string_view::npos;
    return find(is_axis ? kOtherAxis : kOtherAddress);
  }
  if (is_cycle(word.name)) return find(kAnyCycle);
  if (const Name* const listed = find(word.name)) return listed;
  // Names beginning with LCYC are the maker's, of its own cycles; of others the machine decides.
  return is_numbered(word.name, "LCYC") || word.name.size() == 1 ? nullptr : find(kOwnName);
}

std::string written_name(const grammar::NamedWord& word) {
  return word.index ? word.name + std::to_string(*word.index) : word.name;
}

}  // namespace gonogo::reference::sinumerik
