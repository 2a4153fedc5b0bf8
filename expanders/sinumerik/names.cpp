// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/sinumerik/names.hpp"

#include <algorithm>
#include <iterator>

namespace gonogo::expanders::sinumerik {
namespace {

constexpr Name kAddressNames[] = {
    {"CR", NameKind::kAddress, Address::kRadius},
    {"AR", NameKind::kAddress, Address::kOpeningAngle},
    {"AP", NameKind::kAddress, Address::kPolarAngle},
    {"RP", NameKind::kAddress, Address::kPolarRadius},
    {"TURN", NameKind::kAddress, Address::kTurn},
    {"CIP", NameKind::kThroughPoint},
    {"CT", NameKind::kTangent},
};

// Of 802S only.
constexpr Name kCycleNames[] = {
    {"RPL", NameKind::kAddress, Address::kRotation},
    {"LCYC75", NameKind::kCycle},
    {"LCYC82", NameKind::kCycle},
};

constexpr std::string_view kControl[] = {
    "IF",      "ELSE",   "ENDIF", "WHILE",  "ENDWHILE", "FOR",   "ENDFOR", "LOOP",
    "ENDLOOP", "REPEAT", "UNTIL", "CASE",   "GOTO",     "GOTOF", "GOTOB",  "GOTOC",
    "GOTOS",   "DEF",    "PROC",  "EXTERN", "CALL",     "PCALL", "MCALL",  "RET"};

constexpr std::string_view kPassedOver[] = {"MSG",    "STOPRE", "SOFT", "BRISK", "DRIVE",
                                            "FFWON",  "FFWOF",  "CFC",  "CFTCP", "CFIN",
                                            "COMPOF", "DIAMOF", "LIMS", "SPOS"};

constexpr std::string_view kOutsideNames[] = {
    "SUPA",    "TRANS",    "ATRANS",   "ROT",    "AROT",   "SCALE",    "ASCALE",  "MIRROR",
    "AMIRROR", "ROTS",     "AROTS",    "RPL",    "DIAMON", "DIAM90",   "INVCW",   "INVCCW",
    "ASPLINE", "BSPLINE",  "CSPLINE",  "POLY",   "COMPON", "COMPCURV", "COMPCAD", "TRAORI",
    "TRAFOOF", "TRACYL",   "TRANSMIT", "KONT",   "NORM",   "OFFN",     "CHF",     "CHR",
    "RND",     "RNDM",     "ANG",      "WAITM",  "START",  "INIT",     "FXS",     "SPCON",
    "SPCOF",   "PUTFTOC",  "OVR",      "ACC",    "FGROUP", "FL",       "FB",      "FRC",
    "FRCM",    "HOLES1",   "HOLES2",   "SLOT1",  "SLOT2",  "POCKET1",  "POCKET2", "POCKET3",
    "POCKET4", "LONGHOLE", "LCYC60",   "LCYC61", "LCYC83", "LCYC84",   "LCYC85",  "LCYC93",
    "LCYC94",  "LCYC95",   "LCYC96",   "LCYC97", "LCYC840"};

constexpr std::string_view kCycle = "CYCLE";

template <std::size_t kSize>
bool find_in(const std::string_view (&list)[kSize], std::string_view name, NameKind kind,
             Name& found) {
  const auto place = std::find(std::begin(list), std::end(list), name);
  if (place == std::end(list)) return false;
  found = {*place, kind};
  return true;
}

bool is_numbered(std::string_view name, std::string_view family) {
  if (!name.starts_with(family) || name.size() == family.size()) return false;
  name.remove_prefix(family.size());
  return std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

Name find_name(std::string_view name, Control control) {
  for (const Name& known : kAddressNames) {
    if (known.text == name) return known;
  }
  if (control == Control::k802S) {
    for (const Name& known : kCycleNames) {
      if (known.text == name) return known;
    }
  }
  Name found;
  if (find_in(kControl, name, NameKind::kControl, found)) return found;
  if (find_in(kPassedOver, name, NameKind::kPassedOver, found)) return found;
  if (find_in(kOutsideNames, name, NameKind::kOutside, found)) return found;
  if (is_numbered(name, kCycle)) return {kCycle, NameKind::kOutside};
  // LCYC is the maker's prefix; any other name may be a subprogram or a variable of the owner.
  if (is_numbered(name, "LCYC")) return {};
  return {"A name of the owner's", NameKind::kOutside};
}

Letter find_letter(char letter) {
  constexpr std::string_view kWords = "XYZACIJKFSTD";
  constexpr Address kWordAddresses[] = {Address::kX,       Address::kY,    Address::kZ,
                                        Address::kA,       Address::kC,    Address::kI,
                                        Address::kJ,       Address::kK,    Address::kFeed,
                                        Address::kSpindle, Address::kTool, Address::kCuttingEdge};
  const std::size_t index = kWords.find(letter);
  if (index != std::string_view::npos) return {LetterKind::kAddress, kWordAddresses[index]};
  switch (letter) {
    case 'G':
      return {LetterKind::kCode, Address::kX};
    case 'M':
      return {LetterKind::kFunction, Address::kX};
    case 'H':
      return {LetterKind::kPassedOver, Address::kX};
    // Further axes; subprograms and how often they run.
    case 'B':
    case 'E':
    case 'O':
    case 'Q':
    case 'U':
    case 'V':
    case 'W':
    case 'L':
    case 'P':
      return {LetterKind::kOutside, Address::kX};
    default:
      return {LetterKind::kUnknown, Address::kX};
  }
}

char letter_of(Address address) {
  // In the order of Address.
  constexpr char kLetters[kAddresses] = {'X', 'Y', 'Z', 'A', 'C', 'I', 'J', 'K', 'I', 'J', 'K',
                                         0,   0,   0,   0,   0,   'F', 'S', 'T', 'D', 0};
  return kLetters[static_cast<std::size_t>(address)];
}

}  // namespace gonogo::expanders::sinumerik
