// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/sinumerik/names.hpp"

#include <algorithm>
#include <string>

namespace gonogo::expanders::sinumerik {
namespace {

constexpr CodeRow kRows[] = {
    {Group::kMotion, Support::kFull, "0 1 2 3"},
    {Group::kOnce, Support::kFull, "4 110 111 112"},
    {Group::kPlane, Support::kFull, "17 18 19"},
    {Group::kUnits, Support::kFull, "70 71"},
    {Group::kDimension, Support::kFull, "90 91"},
    {Group::kFeedMode, Support::kFull, "94 95 96 97 961 971"},
    {Group::kExactStop, Support::kNoEffect, "9"},
    {Group::kCutter, Support::kNoEffect, "40"},
    {Group::kSuppress, Support::kNoEffect, "53"},
    {Group::kFrame, Support::kNoEffect, "54 55 56 57 500"},
    {Group::kControl, Support::kNoEffect, "60 64"},
    {Group::kWindow, Support::kNoEffect, "601 602"},
    {Group::kCorner, Support::kNoEffect, "450 451"},
    {Group::kProgrammedFrame, Support::kFull, "158 258 259"},
    // Grinding, radius and diameter, thread cutting, cutter radius compensation, feeds of other
    // kinds, working area, reference points, soft approach, tapping, further frames, smoothing,
    // units of the feed.
    {Group::kControl, Support::kOutside,
     "5 7 22 23 25 26 33 34 35 41 42 58 59 62 63 74 75 93 140 141 142 143 147 148 153 247 248 "
     "290 291 331 332 335 336 340 341 347 348 460 461 462 603 621 641 642 643 644 645 700 710 "
     "751 931 942 952 962 972 973"},
    // The machine's maker gives them a meaning.
    {Group::kControl, Support::kOutside,
     "810 811 812 813 814 815 816 817 818 819 820 821 822 823 824 825 826 827 828 829"},
};
constexpr CodeTable kCodes{kRows};
constexpr Code kNewSpeedMode{0, static_cast<GroupNumber>(Group::kFeedMode), Support::kOutside};
constexpr Code kFurtherFrame{0, static_cast<GroupNumber>(Group::kFrame), Support::kOutside};

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
    {"CIP", {NameKind::kCode, Address::kX, &kThroughPointCode}},
    {"CT", {NameKind::kCode, Address::kX, &kTangentCode}},
};

// The 802S has them; on the 840D the cycles are as those of kOutside.
constexpr KnownName kCycleNames[] = {
    {"RPL", {NameKind::kAddress, Address::kRotation}},
    {"LCYC75", {NameKind::kCode, Address::kX, &kPocketCode}},
    {"LCYC82", {NameKind::kCode, Address::kX, &kDrillingCode}},
};

constexpr std::string_view kControl =
    " IF ELSE ENDIF WHILE ENDWHILE FOR ENDFOR LOOP ENDLOOP REPEAT UNTIL CASE GOTO GOTOF GOTOB "
    "GOTOC "
    "GOTOS DEF PROC EXTERN CALL PCALL MCALL RET ";

constexpr std::string_view kIgnored =
    " MSG STOPRE SOFT BRISK DRIVE FFWON FFWOF CFC CFTCP CFIN COMPOF DIAMOF KONT "
    "LIMS NORM SPCON SPCOF SPOS SPOSA WAITS ";

constexpr std::string_view kOutside =
    " LCYC60 LCYC61 LCYC75 LCYC82 LCYC83 LCYC84 LCYC85 LCYC93 LCYC94 LCYC95 LCYC96 LCYC97 "
    "LCYC840 ";

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
  // No offset that the 840D is read with could be left out.
  const bool no_offsets = name == "SUPA" && control == Control::k840D;
  if (contains(kIgnored, name) || no_offsets) return {NameKind::kIgnored};
  // LCYC is the maker's prefix; any other name is one of the control's that this expander lacks, or
  // may be a subprogram or a variable of the owner.
  if (is_cycle(name) && !contains(kOutside, name)) return {};
  return {NameKind::kOutside};
}

Name find_letter(char letter) {
  constexpr std::string_view kWords = "XYZACIJK";
  const std::size_t index = kWords.find(letter);
  if (index != std::string_view::npos) return {NameKind::kAddress, static_cast<Address>(index)};
  constexpr std::string_view kMore = "FSTD";
  constexpr Address kAddressesOfMore[] = {Address::kFeed, Address::kSpindle, Address::kTool,
                                          Address::kCuttingEdge};
  const std::size_t more = kMore.find(letter);
  if (more != std::string_view::npos) return {NameKind::kAddress, kAddressesOfMore[more]};
  if (letter == 'G') return {NameKind::kGCode};
  if (letter == 'M') return {NameKind::kFunction};
  if (letter == 'H') return {NameKind::kIgnored};
  // Further axes; subprograms and how often they run.
  const bool outside = std::string_view("BEOQUVWLP").find(letter) != std::string_view::npos;
  return {outside ? NameKind::kOutside : NameKind::kUnknown};
}

const Code* find_code(const Decimal& number, Control control) {
  const Code* code = kCodes.find(number);
  if (code == nullptr) {
    const bool whole = !number.overflow && !number.finer && number.value % kOne == 0;
    const bool frame = whole && number.value >= 505 * kOne && number.value <= 599 * kOne;
    return frame ? &kFurtherFrame : nullptr;
  }
  if ((code->tenths == 220 || code->tenths == 230) && control == Control::k840D) return nullptr;
  // SIE-MOD-07
  const bool new_speed_mode = code->tenths == 9610 || code->tenths == 9710;
  if (new_speed_mode && control == Control::k802S) return &kNewSpeedMode;
  const bool frame = code->group == static_cast<GroupNumber>(Group::kProgrammedFrame);
  return frame && control == Control::k840D ? nullptr : code;
}

}  // namespace gonogo::expanders::sinumerik
