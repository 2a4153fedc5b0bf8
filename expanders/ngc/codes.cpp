// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/ngc/codes.hpp"

#include <array>

namespace gonogo::expanders::ngc {
namespace {

constexpr Support kFull = Support::kFull;
constexpr Support kNone = Support::kNoEffect;
constexpr Support kOut = Support::kOutside;

constexpr std::array kCodes{
    Code{0, Group::kMotion, kFull},        Code{10, Group::kMotion, kFull},
    Code{20, Group::kMotion, kFull},       Code{30, Group::kMotion, kFull},
    Code{40, Group::kOnce, kFull},         Code{50, Group::kMotion, kOut},
    Code{70, Group::kLathe, kFull},        Code{80, Group::kLathe, kFull},
    Code{100, Group::kOnce, kOut},         Code{170, Group::kPlane, kFull},
    Code{171, Group::kPlane, kOut},        Code{180, Group::kPlane, kFull},
    Code{181, Group::kPlane, kOut},        Code{190, Group::kPlane, kFull},
    Code{191, Group::kPlane, kOut},        Code{200, Group::kUnits, kFull},
    Code{210, Group::kUnits, kFull},       Code{280, Group::kOnce, kOut},
    Code{281, Group::kOnce, kOut},         Code{300, Group::kOnce, kOut},
    Code{301, Group::kOnce, kOut},         Code{330, Group::kMotion, kFull},
    Code{331, Group::kMotion, kFull},      Code{382, Group::kMotion, kOut},
    Code{383, Group::kMotion, kOut},       Code{384, Group::kMotion, kOut},
    Code{385, Group::kMotion, kOut},       Code{400, Group::kCutter, kNone},
    Code{410, Group::kCutter, kOut},       Code{411, Group::kCutter, kOut},
    Code{420, Group::kCutter, kOut},       Code{421, Group::kCutter, kOut},
    Code{430, Group::kLength, kOut},       Code{431, Group::kLength, kOut},
    Code{432, Group::kLength, kOut},       Code{490, Group::kLength, kNone},
    Code{500, Group::kScale, kOut},        Code{510, Group::kScale, kOut},
    Code{520, Group::kOnce, kOut},         Code{530, Group::kOnce, kOut},
    Code{540, Group::kFrame, kNone},       Code{550, Group::kFrame, kOut},
    Code{560, Group::kFrame, kOut},        Code{570, Group::kFrame, kOut},
    Code{580, Group::kFrame, kOut},        Code{590, Group::kFrame, kOut},
    Code{591, Group::kFrame, kOut},        Code{592, Group::kFrame, kOut},
    Code{593, Group::kFrame, kOut},        Code{610, Group::kControl, kNone},
    Code{611, Group::kControl, kNone},     Code{640, Group::kControl, kNone},
    Code{700, Group::kMotion, kOut},       Code{710, Group::kMotion, kOut},
    Code{711, Group::kMotion, kOut},       Code{712, Group::kMotion, kOut},
    Code{720, Group::kMotion, kOut},       Code{721, Group::kMotion, kOut},
    Code{722, Group::kMotion, kOut},       Code{730, Group::kMotion, kFull},
    Code{740, Group::kMotion, kFull},
    Code{760, Group::kMotion, kFull},      Code{800, Group::kMotion, kFull},
    Code{810, Group::kMotion, kFull},      Code{820, Group::kMotion, kFull},
    Code{830, Group::kMotion, kFull},      Code{840, Group::kMotion, kFull},
    Code{850, Group::kMotion, kFull},      Code{860, Group::kMotion, kFull},
    Code{870, Group::kMotion, kOut},       Code{880, Group::kMotion, kOut},
    Code{890, Group::kMotion, kFull},      Code{900, Group::kDistance, kFull},
    Code{901, Group::kArcDistance, kFull}, Code{910, Group::kDistance, kFull},
    Code{911, Group::kArcDistance, kFull}, Code{920, Group::kOnce, kOut},
    Code{921, Group::kOnce, kOut},         Code{922, Group::kOnce, kOut},
    Code{923, Group::kOnce, kOut},         Code{930, Group::kFeedMode, kFull},
    Code{940, Group::kFeedMode, kFull},    Code{950, Group::kFeedMode, kFull},
    Code{960, Group::kSpindle, kFull},     Code{970, Group::kSpindle, kFull},
    Code{980, Group::kReturn, kFull},      Code{990, Group::kReturn, kFull},
};

// 1 + the index into kCodes; 0: no such code.
constexpr std::array<std::uint8_t, 1000> make_index() {
  std::array<std::uint8_t, 1000> index{};
  for (std::size_t i = 0; i < kCodes.size(); ++i) {
    index[kCodes[i].tenths] = static_cast<std::uint8_t>(i + 1);
  }
  return index;
}
constexpr std::array<std::uint8_t, 1000> kIndex = make_index();

}  // namespace

const Code* find_code(Fixed tenths) {
  if (tenths < 0 || tenths >= static_cast<Fixed>(kIndex.size())) return nullptr;
  const std::uint8_t place = kIndex[static_cast<std::size_t>(tenths)];
  return place == 0 ? nullptr : &kCodes[place - 1u];
}

Function find_function(Fixed m) {
  if (m == 19 || m == 98 || m == 99 || (m >= 100 && m <= 199)) return Function::kOutside;
  const bool known = (m >= 0 && m <= 9) || m == 30 || (m >= 48 && m <= 53) ||
                     (m >= 60 && m <= 68) || (m >= 70 && m <= 73);
  return known ? Function::kKnown : Function::kUnknown;
}

FunctionGroup group_of(Fixed m) {
  switch (m) {
    case 3:
    case 4:
    case 5:
      return FunctionGroup::kSpindle;
    case 6:
    case 61:
      return FunctionGroup::kTool;
    case 7:
    case 8:
    case 9:
      return FunctionGroup::kCoolant;
    case 0:
    case 1:
    case 2:
    case 30:
    case 60:
      return FunctionGroup::kStop;
    default:
      break;
  }
  if (m >= 70) return FunctionGroup::kModes;
  return m >= 62 ? FunctionGroup::kSignal : FunctionGroup::kOverride;
}

bool uses_word(Fixed m, char address) {
  if (m >= 50 && m <= 53) return address == 'P';  // overrides
  if (m == 61) return address == 'Q';             // tool
  if (m >= 62 && m <= 65) return address == 'P';  // outputs
  if (m == 66) return address == 'P' || address == 'E' || address == 'L' || address == 'Q';
  if (m == 67 || m == 68) return address == 'E' || address == 'Q';  // analogue outputs
  return false;
}

}  // namespace gonogo::expanders::ngc
