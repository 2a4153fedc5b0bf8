// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/sinumerik/codes.hpp"

#include <algorithm>
#include <array>

namespace gonogo::expanders::sinumerik {
namespace {

constexpr Support kFull = Support::kFull;
constexpr Support kNone = Support::kNoEffect;

constexpr std::array kCodes{
    Code{0, Group::kMotion, kFull},     Code{1, Group::kMotion, kFull},
    Code{2, Group::kMotion, kFull},     Code{3, Group::kMotion, kFull},
    Code{4, Group::kOnce, kFull},       Code{9, Group::kExactStop, kNone},
    Code{17, Group::kPlane, kFull},     Code{18, Group::kPlane, kFull},
    Code{19, Group::kPlane, kFull},     Code{40, Group::kCutter, kNone},
    Code{53, Group::kSuppress, kNone},  Code{54, Group::kFrame, kNone},
    Code{55, Group::kFrame, kNone},     Code{56, Group::kFrame, kNone},
    Code{57, Group::kFrame, kNone},     Code{60, Group::kControl, kNone},
    Code{64, Group::kControl, kNone},   Code{70, Group::kUnits, kFull},
    Code{71, Group::kUnits, kFull},     Code{90, Group::kDimension, kFull},
    Code{91, Group::kDimension, kFull}, Code{94, Group::kFeedMode, kFull},
    Code{95, Group::kFeedMode, kFull},  Code{110, Group::kOnce, kFull},
    Code{111, Group::kOnce, kFull},     Code{112, Group::kOnce, kFull},
    Code{500, Group::kFrame, kNone},    Code{601, Group::kWindow, kNone},
    Code{602, Group::kWindow, kNone},
};

// Thread cutting, cutter radius compensation, feeds of other kinds, working area, reference points,
// soft approach, tapping, corner behaviour, further frames, units of the feed.
constexpr std::uint16_t kOutsideCodes[] = {
    25,  26,  33,  34,  35,  41,  42,  62,  63,  74,  75,  93,  96,  97,  147, 148, 153, 247, 248,
    290, 291, 331, 332, 340, 341, 347, 348, 450, 451, 603, 641, 642, 700, 710, 961, 962, 971};

constexpr Code kOutsideCode{0, Group::kOther, Support::kOutside};
constexpr Code kThroughPoint{kThroughPointCode, Group::kMotion, kFull};
constexpr Code kTangent{kTangentCode, Group::kMotion, kFull};
constexpr Code kPocket{kPocketCode, Group::kCycle, kFull};
constexpr Code kDrilling{kDrillingCode, Group::kCycle, kFull};

// Of 802S only.
constexpr std::array kFrames{Code{158, Group::kProgrammedFrame, kFull},
                             Code{258, Group::kProgrammedFrame, kFull},
                             Code{259, Group::kProgrammedFrame, kFull}};

template <std::size_t kSize>
const Code* find_in(const std::array<Code, kSize>& codes, Fixed number) {
  const auto found = std::find_if(codes.begin(), codes.end(),
                                  [&](const Code& code) { return code.number == number; });
  return found == codes.end() ? nullptr : &*found;
}

}  // namespace

const Code* find_code(Fixed number, Control control) {
  if (const Code* code = find_in(kCodes, number)) return code;
  if (control == Control::k802S) {
    if (const Code* code = find_in(kFrames, number)) return code;
  }
  const bool frame = number >= 505 && number <= 599;
  const bool outside = frame || std::find(std::begin(kOutsideCodes), std::end(kOutsideCodes),
                                          number) != std::end(kOutsideCodes);
  return outside ? &kOutsideCode : nullptr;
}

const Code& through_point_code() {
  return kThroughPoint;
}

const Code& tangent_code() {
  return kTangent;
}

const Code& cycle_code(std::string_view name) {
  return name == "LCYC75" ? kPocket : kDrilling;
}

}  // namespace gonogo::expanders::sinumerik
