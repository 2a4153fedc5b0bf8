// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "expanders/faults.hpp"

namespace gonogo::expanders::sinumerik {

/// The planted faults; what each does stands in faults.cpp, in the same order.
enum class Fault {
  kNone,
  // circles
  kG18SenseFlipped,
  kRadiusSignSwapped,
  kSemicircleRefused,
  kCentreAbsolute,
  kCentreAbsoluteIgnored,
  kOpeningAngleOtherSide,
  kOpeningAngleComplement,
  kFullAngleAccepted,
  kFullCircleDropped,
  kEndPointUnchecked,
  kEndRadiusTolerance,
  kConstantToleranceOnly,
  kEqualityRefused,
  kCorrectionEndRadius,
  kEndOntoCircle,
  kHelixThirdAxisZ,
  kHelixFlat,
  kTurnIgnored,
  kTurnExtra,
  kEndPointPlaneIgnored,
  // CIP, CT
  kThroughPointSenseFlipped,
  kIntermediateAbsolute,
  kIntermediateStraightRefused,
  kTangentOtherSide,
  kTangentOfStart,
  kTangentSkipsRapids,
  kTangentBehindAccepted,
  // polar
  kPoleG110AsG111,
  kPoleG112AsG110,
  kPoleKeptByPlane,
  kPolarG18Swapped,
  kPolarRadiusForgotten,
  kPolarAngleByG91,
  // dimensions, units, feeds
  kAbsoluteIgnored,
  kIncrementalIgnored,
  kInchFeedScaled,
  kInchCentreUnscaled,
  kInchRotaryScaled,
  kRotaryFeedScaled,
  kDwellRevolutionsAsSeconds,
  kDwellFeedKept,
  // modes, values, text
  kArcNotModal,
  kAssignmentLate,
  kLeftToRight,
  kBlockSkipAlways,
  kCapitalsOnly,
  kEndIgnored,
  kAlarmNextBlock,
  kCrLfCountedTwice,
  kParametersSurviveReset,
  // frames
  kShiftAdds,
  kShiftKeepsRotation,
  kRotationReplaces,
  kRotationG18Flipped,
  kRotationAboutBase,
  // LCYC82
  kDrillDwellMilliseconds,
  kDrillDwellForgotten,
  kDrillRetractToClearance,
  // both cycles
  kPlaneEqualityRefused,
  kFeedAfterCycle,
  kMotionAfterCycle,
  kParameterLost,
  // LCYC75
  kCentreInBase,
  kLengthWidthSwapped,
  kDepthFromClearance,
  kInfeedsRoundedDown,
  kLastLevelMissed,
  kPlaneAllowanceForgotten,
  kDepthAllowanceForgotten,
  kPocketSenseFlipped,
  kFinishingSenseIgnored,
  kCycleFeedsSwapped,
  kPlungeOffCentre,
  kStepTooWide,
  kCornerGouged,
  kCornerLeft,
  kStripLeft,
  kContourOnlyByDepth,
  kEndsOffCentre,
  kPocketRetractToClearance,
  kToolUnchecked,
  kToolEqualityRefused
};

/// One description for each fault but kNone: that of Fault(i + 1) has the index i.
std::span<const FaultDescription> fault_descriptions();
inline constexpr std::size_t kFaults = static_cast<std::size_t>(Fault::kToolEqualityRefused);

}  // namespace gonogo::expanders::sinumerik
