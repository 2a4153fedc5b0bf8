// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/hnc/codes.hpp"

#include <array>

namespace gonogo::expanders::hnc {
namespace {

constexpr Support kFull = Support::kFull;
constexpr Support kNone = Support::kNoEffect;
constexpr Support kOut = Support::kOutside;

constexpr std::array kCodes{
    Code{0, Group::kMotion, kFull},    Code{1, Group::kMotion, kFull},
    Code{2, Group::kMotion, kFull},    Code{3, Group::kMotion, kFull},
    Code{4, Group::kOnce, kFull},      Code{17, Group::kPlane, kFull},
    Code{18, Group::kPlane, kNone},    Code{19, Group::kPlane, kFull},
    Code{20, Group::kUnits, kFull},    Code{21, Group::kUnits, kFull},
    Code{28, Group::kOnce, kOut},      Code{29, Group::kOnce, kOut},
    Code{32, Group::kMotion, kFull},   Code{36, Group::kDiameter, kFull},
    Code{37, Group::kDiameter, kFull}, Code{40, Group::kRadius, kNone},
    Code{41, Group::kRadius, kOut},    Code{42, Group::kRadius, kOut},
    Code{52, Group::kFree, kOut},      Code{53, Group::kFree, kOut},
    Code{54, Group::kFrame, kFull},    Code{55, Group::kFrame, kFull},
    Code{56, Group::kFrame, kFull},    Code{57, Group::kFrame, kFull},
    Code{58, Group::kFrame, kFull},    Code{59, Group::kFrame, kFull},
    Code{61, Group::kPathMode, kNone}, Code{64, Group::kPathMode, kNone},
    Code{65, Group::kOnce, kOut},      Code{70, Group::kFree, kOut},
    Code{71, Group::kMotion, kOut},    Code{72, Group::kMotion, kOut},
    Code{73, Group::kMotion, kOut},    Code{74, Group::kMotion, kFull},
    Code{75, Group::kMotion, kFull},   Code{76, Group::kMotion, kOut},
    Code{80, Group::kMotion, kFull},   Code{81, Group::kMotion, kFull},
    Code{82, Group::kMotion, kFull},   Code{90, Group::kDistance, kFull},
    Code{91, Group::kDistance, kFull}, Code{92, Group::kOnce, kFull},
    Code{94, Group::kFeedMode, kFull}, Code{95, Group::kFeedMode, kFull},
    Code{96, Group::kSpindle, kNone},  Code{97, Group::kSpindle, kNone},
    Code{98, Group::kFree, kOut},      Code{99, Group::kFree, kOut},
};

// 1 + the index into kCodes; 0: no such code.
constexpr std::array<std::uint8_t, 100> make_index() {
  std::array<std::uint8_t, 100> index{};
  for (std::size_t i = 0; i < kCodes.size(); ++i) {
    index[kCodes[i].number] = static_cast<std::uint8_t>(i + 1);
  }
  return index;
}
constexpr std::array<std::uint8_t, 100> kIndex = make_index();

}  // namespace

const Code* find_code(const Decimal& number) {
  if (number.overflow || number.finer || number.value < 0 || number.value % kOne != 0) {
    return nullptr;
  }
  const auto code = static_cast<std::uint64_t>(number.value / kOne);
  if (code >= kIndex.size() || kIndex[code] == 0) return nullptr;
  return &kCodes[kIndex[code] - 1u];
}

}  // namespace gonogo::expanders::hnc
