// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/gsk/codes.hpp"

#include <array>

namespace gonogo::expanders::gsk {
namespace {

constexpr Support kFull = Support::kFull;
constexpr Support kNone = Support::kNoEffect;
constexpr Support kLater = Support::kLater;

constexpr std::array kCodes{
    Code{0, Group::kMotion, kFull},      Code{10, Group::kMotion, kFull},
    Code{20, Group::kMotion, kFull},     Code{30, Group::kMotion, kFull},
    Code{40, Group::kNonModal, kFull},   Code{50, Group::kMotion, kLater},
    Code{71, Group::kCylinder, kLater},  Code{100, Group::kNonModal, kLater},
    Code{121, Group::kPolar, kLater},    Code{131, Group::kPolar, kLater},
    Code{170, Group::kPlane, kFull},     Code{180, Group::kPlane, kFull},
    Code{190, Group::kPlane, kFull},     Code{200, Group::kUnits, kFull},
    Code{210, Group::kUnits, kFull},     Code{220, Group::kStroke, kLater},
    Code{230, Group::kStroke, kLater},   Code{280, Group::kNonModal, kFull},
    Code{300, Group::kNonModal, kLater}, Code{310, Group::kNonModal, kLater},
    Code{320, Group::kMotion, kLater},   Code{330, Group::kMotion, kLater},
    Code{340, Group::kMotion, kLater},   Code{350, Group::kNonModal, kLater},
    Code{360, Group::kNonModal, kLater}, Code{370, Group::kNonModal, kLater},
    Code{400, Group::kRadius, kNone},    Code{410, Group::kRadius, kLater},
    Code{420, Group::kRadius, kLater},   Code{500, Group::kNonModal, kFull},
    Code{520, Group::kNonModal, kLater}, Code{530, Group::kNonModal, kLater},
    Code{540, Group::kOffset, kNone},    Code{550, Group::kOffset, kLater},
    Code{560, Group::kOffset, kLater},   Code{570, Group::kOffset, kLater},
    Code{580, Group::kOffset, kLater},   Code{590, Group::kOffset, kLater},
    Code{610, Group::kExact, kNone},     Code{640, Group::kExact, kNone},
    Code{650, Group::kNonModal, kLater}, Code{660, Group::kMacro, kLater},
    Code{670, Group::kMacro, kLater},    Code{700, Group::kNonModal, kLater},
    Code{710, Group::kNonModal, kLater}, Code{720, Group::kNonModal, kLater},
    Code{730, Group::kNonModal, kLater}, Code{740, Group::kNonModal, kLater},
    Code{750, Group::kNonModal, kLater}, Code{760, Group::kNonModal, kLater},
    Code{800, Group::kCycle, kFull},     Code{830, Group::kCycle, kLater},
    Code{840, Group::kCycle, kLater},    Code{850, Group::kCycle, kLater},
    Code{870, Group::kCycle, kLater},    Code{880, Group::kCycle, kLater},
    Code{890, Group::kCycle, kLater},    Code{900, Group::kMotion, kFull},
    Code{920, Group::kMotion, kFull},    Code{940, Group::kMotion, kFull},
    Code{960, Group::kSpindle, kNone},   Code{970, Group::kSpindle, kNone},
    Code{980, Group::kFeedMode, kFull},  Code{990, Group::kFeedMode, kFull},
    Code{1100, Group::kCycle, kFull},    Code{1110, Group::kCycle, kFull},
    Code{1120, Group::kCycle, kFull},    Code{1130, Group::kCycle, kFull},
    Code{1140, Group::kCycle, kFull},    Code{1150, Group::kCycle, kFull},
    Code{1160, Group::kCycle, kFull},    Code{1170, Group::kCycle, kFull},
};

constexpr std::size_t kHighest = 1170;

// 1 + the index into kCodes; 0: no such code.
constexpr std::array<std::uint8_t, kHighest + 1> make_index() {
  std::array<std::uint8_t, kHighest + 1> index{};
  for (std::size_t i = 0; i < kCodes.size(); ++i) {
    index[kCodes[i].number] = static_cast<std::uint8_t>(i + 1);
  }
  return index;
}
constexpr std::array<std::uint8_t, kHighest + 1> kIndex = make_index();

}  // namespace

const Code* find_code(const Decimal& number) {
  constexpr Fixed kTenth = kOne / 10;
  if (number.overflow || number.finer || number.value < 0 || number.value % kTenth != 0) {
    return nullptr;
  }
  const Fixed tenths = number.value / kTenth;
  if (tenths > static_cast<Fixed>(kHighest)) return nullptr;
  const std::size_t place = kIndex[static_cast<std::size_t>(tenths)];
  return place == 0 ? nullptr : &kCodes[place - 1];
}

}  // namespace gonogo::expanders::gsk
