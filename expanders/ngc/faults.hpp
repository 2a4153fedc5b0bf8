// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "expanders/faults.hpp"

namespace gonogo::expanders::ngc {

/// The planted faults; what each does stands in faults.cpp, in the same order.
enum class Fault {
  kNone,
  // G2, G3
  kG18SenseFlipped,
  kG3Clockwise,
  kRadiusSignIgnored,
  kRadiusCentreLeft,
  kShortRadiusForgiven,
  kOffsetsAbsolute,
  kAbsoluteCentreIgnored,
  kG18OffsetsSwapped,
  kFullCircleDropped,
  kEndPointUnchecked,
  kEndPointEqualityRefused,
  kInchToleranceMillimetres,
  kEndOntoCircle,
  kHelixFlat,
  kHelixZInG18,
  kArcRotaryDropped,
  kTurnsIgnored,
  kTurnExtra,
  kTurnsUnchecked,
  // numbers that have to be whole
  kWholeLimitRefused,
  kNearWholeCut,
  kCodeLimitUnscaled,
  // distances and units
  kG91IgnoredAfterG90,
  kInchFeedUnscaled,
  kInchOffsetsUnscaled,
  kInchRotaryScaled,
  kRotaryFeedScaled,
  // modes and order
  kG80KeepsMotion,
  kMotionLostAfterDwell,
  kFeedAfterMotion,
  kPlaneAfterMotion,
  kDwellInMilliseconds,
  kLastMotionWins,
  kBareFeedUnchecked,
  kArcWordsNeedCode,
  kUnusedWordPassed,
  kUnusedAlonePassed,
  // text and life of a program
  kBlanksEndNumbers,
  kOpenLineNumbers,
  kNameEndsProgram,
  kTapeMarkAnywhere,
  kTapeMarkAfterComment,
  kSecondTapeMarkOptional,
  kBlockDeleteAlways,
  kCapitalsOnly,
  kTapeMarkIgnored,
  kEndIgnored,
  kAlarmNextBlock,
  kCrLfCountedTwice,
  kFeedSurvivesReset
};

/// One description for each fault but kNone: that of Fault(i + 1) has the index i.
std::span<const FaultDescription> fault_descriptions();
inline constexpr std::size_t kFaults = static_cast<std::size_t>(Fault::kFeedSurvivesReset);

}  // namespace gonogo::expanders::ngc
