// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/sinumerik/codes.hpp"

namespace gonogo::expanders::sinumerik {
namespace {

constexpr CodeRow kRows[] = {
    {Group::kMotion, Support::kFull, "0 1 2 3"},
    {Group::kOnce, Support::kFull, "4 110 111 112"},
    {Group::kPlane, Support::kFull, "17 18 19"},
    {Group::kUnits, Support::kFull, "70 71"},
    {Group::kDimension, Support::kFull, "90 91"},
    {Group::kFeedMode, Support::kFull, "94 95"},
    {Group::kExactStop, Support::kNoEffect, "9"},
    {Group::kCutter, Support::kNoEffect, "40"},
    {Group::kSuppress, Support::kNoEffect, "53"},
    {Group::kFrame, Support::kNoEffect, "54 55 56 57 500"},
    {Group::kControl, Support::kNoEffect, "60 64"},
    {Group::kWindow, Support::kNoEffect, "601 602"},
    {Group::kProgrammedFrame, Support::kFull, "158 258 259"},
    // Thread cutting, cutter radius compensation, feeds of other kinds, working area, reference
    // points, soft approach, tapping, corner behaviour, further frames, units of the feed.
    {Group::kControl, Support::kOutside,
     "25 26 33 34 35 41 42 62 63 74 75 93 96 97 147 148 153 247 248 290 291 331 332 340 341 347 "
     "348 "
     "450 451 603 641 642 700 710 961 962 971"},
};
constexpr CodeTable kCodes{kRows};
constexpr Code kFurtherFrame{0, static_cast<GroupNumber>(Group::kFrame), Support::kOutside};

}  // namespace

const Code* find_code(const Decimal& number, Control control) {
  const Code* code = kCodes.find(number);
  if (code == nullptr) {
    const bool whole = !number.overflow && !number.finer && number.value % kOne == 0;
    const bool frame = whole && number.value >= 505 * kOne && number.value <= 599 * kOne;
    return frame ? &kFurtherFrame : nullptr;
  }
  const bool frame = code->group == static_cast<GroupNumber>(Group::kProgrammedFrame);
  return frame && control == Control::k840D ? nullptr : code;
}

}  // namespace gonogo::expanders::sinumerik
