// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/ngc/codes.hpp"

#include <algorithm>
#include <iterator>

namespace gonogo::expanders::ngc {
namespace {

constexpr CodeRow kRows[] = {
    {Group::kMotion, Support::kFull, "0 1 2 3 33 33.1 73 74 76 80 81 82 83 84 85 86 89"},
    {Group::kMotion, Support::kOutside, "5 38.2 38.3 38.4 38.5 70 71 71.1 71.2 72 72.1 72.2 87 88"},
    {Group::kOnce, Support::kFull, "4"},
    {Group::kOnce, Support::kOutside, "10 28 28.1 30 30.1 52 53 92 92.1 92.2 92.3"},
    {Group::kPlane, Support::kFull, "17 18 19"},
    {Group::kPlane, Support::kOutside, "17.1 18.1 19.1"},
    {Group::kUnits, Support::kFull, "20 21"},
    {Group::kDistance, Support::kFull, "90 91"},
    {Group::kArcDistance, Support::kFull, "90.1 91.1"},
    {Group::kFeedMode, Support::kFull, "93 94 95"},
    {Group::kCutter, Support::kNoEffect, "40"},
    {Group::kCutter, Support::kOutside, "41 41.1 42 42.1"},
    {Group::kLength, Support::kNoEffect, "49"},
    {Group::kLength, Support::kOutside, "43 43.1 43.2"},
    {Group::kFrame, Support::kNoEffect, "54"},
    {Group::kFrame, Support::kOutside, "55 56 57 58 59 59.1 59.2 59.3"},
    {Group::kControl, Support::kNoEffect, "61 61.1 64"},
    {Group::kReturn, Support::kFull, "98 99"},
    {Group::kSpindle, Support::kFull, "96 97"},
    {Group::kScale, Support::kOutside, "50 51"},
    {Group::kLathe, Support::kFull, "7 8"},
};
constexpr CodeTable kCodes{kRows};

constexpr FunctionKind kFunctionKinds[] = {
    {0, 2, FunctionGroup::kStop, {}},
    {3, 5, FunctionGroup::kSpindle, {}},
    {6, 6, FunctionGroup::kTool, {}},
    {7, 9, FunctionGroup::kCoolant, {}},
    {19, 19, FunctionGroup::kOutside, {}},
    {30, 30, FunctionGroup::kStop, {}},
    {48, 49, FunctionGroup::kOverride, {}},
    {50, 53, FunctionGroup::kOverride, AddressSet{"P"}},
    {60, 60, FunctionGroup::kStop, {}},
    {61, 61, FunctionGroup::kTool, AddressSet{"Q"}},
    {62, 65, FunctionGroup::kSignal, AddressSet{"P"}},
    {66, 66, FunctionGroup::kSignal, AddressSet{"PELQ"}},
    {67, 68, FunctionGroup::kSignal, AddressSet{"EQ"}},
    {70, 73, FunctionGroup::kModes, {}},
    {98, 199, FunctionGroup::kOutside, {}},
};

}  // namespace

const Code* find_code(Fixed tenths) {
  return kCodes.find(tenths);
}

const FunctionKind* find_function(Fixed m) {
  const auto* const found =
      std::find_if(std::begin(kFunctionKinds), std::end(kFunctionKinds),
                   [&](const FunctionKind& kind) { return kind.first <= m && m <= kind.last; });
  return found == std::end(kFunctionKinds) ? nullptr : found;
}

}  // namespace gonogo::expanders::ngc
