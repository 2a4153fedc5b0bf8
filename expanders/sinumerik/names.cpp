// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/sinumerik/names.hpp"

#include <algorithm>
#include <string>

namespace gonogo::expanders::sinumerik {
namespace {

struct KnownName {
  std::string_view text;
  Name name;
};

constexpr KnownName kNames[] = {
    {"CR", {NameKind::kAddress, Address::kRadius}},
    {"AR", {NameKind::kAddress, Address::kOpeningAngle}},
    {"AP", {NameKind::kAddress, Address::kPolarAngle}},
    {"RP", {NameKind::kAddress, Address::kPolarRadius}},
    {"TURN", {NameKind::kAddress, Address::kTurn}},
    {"CIP", {NameKind::kThroughPoint}},
    {"CT", {NameKind::kTangent}},
};

// Of 802S only.
constexpr KnownName kCycleNames[] = {
    {"RPL", {NameKind::kAddress, Address::kRotation}},
    {"LCYC75", {NameKind::kPocket}},
    {"LCYC82", {NameKind::kDrilling}},
};

constexpr std::string_view kControl =
    " IF ELSE ENDIF WHILE ENDWHILE FOR ENDFOR LOOP ENDLOOP REPEAT UNTIL CASE GOTO GOTOF GOTOB "
    "GOTOC "
    "GOTOS DEF PROC EXTERN CALL PCALL MCALL RET ";

constexpr std::string_view kPassedOver =
    " MSG STOPRE SOFT BRISK DRIVE FFWON FFWOF CFC CFTCP CFIN COMPOF DIAMOF LIMS SPOS ";

constexpr std::string_view kOutside =
    " LCYC60 LCYC61 LCYC83 LCYC84 LCYC85 LCYC93 LCYC94 LCYC95 LCYC96 LCYC97 LCYC840 ";

bool contains(std::string_view list, std::string_view name) {
  return list.find(' ' + std::string(name) + ' ') != std::string_view::npos;
}

bool is_cycle(std::string_view name) {
  return name.starts_with("LCYC") && name.size() > 4 &&
         name.find_first_not_of("0123456789", 4) == std::string_view::npos;
}

template <std::size_t kSize>
const Name* find_in(const KnownName (&list)[kSize], std::string_view name) {
  const auto* found = std::find_if(std::begin(list), std::end(list),
                                   [&](const KnownName& known) { return known.text == name; });
  return found == std::end(list) ? nullptr : &found->name;
}

}  // namespace

Name find_name(std::string_view name, Control control) {
  if (const Name* found = find_in(kNames, name)) return *found;
  if (control == Control::k802S) {
    if (const Name* found = find_in(kCycleNames, name)) return *found;
  }
  if (contains(kControl, name)) return {NameKind::kControl};
  if (contains(kPassedOver, name)) return {NameKind::kPassedOver};
  // LCYC is the maker's prefix; any other name is one of the control's that this expander lacks, or
  // may be a subprogram or a variable of the owner.
  if (is_cycle(name) && !contains(kOutside, name)) return {};
  return {NameKind::kOutside};
}

Name find_letter(char letter) {
  constexpr std::string_view kWords = "XYZACIJK";
  const std::size_t index = kWords.find(letter);
  if (index != std::string_view::npos) return {NameKind::kAddress, static_cast<Address>(index)};
  switch (letter) {
    case 'F':
      return {NameKind::kAddress, Address::kFeed};
    case 'S':
      return {NameKind::kAddress, Address::kSpindle};
    case 'T':
      return {NameKind::kAddress, Address::kTool};
    case 'D':
      return {NameKind::kAddress, Address::kCuttingEdge};
    case 'G':
      return {NameKind::kCode};
    case 'M':
      return {NameKind::kFunction};
    case 'H':
      return {NameKind::kPassedOver};
    default:
      break;
  }
  // Further axes; subprograms and how often they run.
  const bool outside = std::string_view("BEOQUVWLP").find(letter) != std::string_view::npos;
  return {outside ? NameKind::kOutside : NameKind::kUnknown};
}

}  // namespace gonogo::expanders::sinumerik
