// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "expanders/faults.hpp"

namespace gonogo::expanders::gsk {

/// The planted faults; what each does stands in faults.cpp, in the same order.
enum class Fault {
  kNone,
  // G94
  kTaperSign,
  kTaperDiameter,
  kTaperLeaksPastMotion,
  kTaperLeaksPastNonModal,
  kTaperLost,
  kEndPointLost,
  kApproachTakesEnd,
  kEndsAtB,
  kRapidRetract,
  kFeedReturn,
  kTaperUnchecked,
  kTaperEqualityRefused,
  kTaperZeroTravelRefused,
  kDwellClearsTaper,
  kOffPlaneUnchecked,
  kG80KeepsG94,
  // G110, G111
  kToolEqualityAccepted,
  kStepEqualityAccepted,
  kLastLayerDropped,
  kLastLayerOvershoots,
  kExtraLayer,
  kEndlessLayers,
  kClearanceTwice,
  kClearanceUnclamped,
  kClearanceSigned,
  kRPlaneIgnored,
  kDepthFromInitialPlane,
  kStepDownForgotten,
  kMissingStepDownAccepted,
  kClosingCircleMissing,
  kGouge,
  kIsland,
  kSenseInG18,
  kG111AsG110,
  kPocketLeaksPastMotion,
  kInitialPlaneDrifts,
  kDirectionUnchecked,
  kRoundedCentre,
  kEndsAtRPlane,
  kNoRetract,
  // G90, G92
  kTurnTaperSign,
  kTurnTaperDiameter,
  kTurnAsFace,
  kTurnRapidRetract,
  kTurnLeaksIntoFace,
  kThreadAtFeed,
  kLeadInInches,
  kThreadFeedRetract,
  // G112, G113
  kHelixTurnShort,
  kHelixDepthPerTurn,
  kHelixDepthFromInitial,
  kHelixEntryWrongWay,
  kHelixExitRadius,
  kHelixFlatCircle,
  kTurnsLeak,
  kHelixToolEqualityAccepted,
  kHelixEndsAtRPlane,
  kG113AsG112,
  kToolLeaksIntoHelix,
  kClampLate,
  kClampDropped,
  kG80RestoresMotion,
  // G114 to G117
  kThreadDiameterAsRadius,
  kThreadToolSide,
  kThreadLastPassTooDeep,
  kThreadExtraPass,
  kThreadTurnShort,
  kThreadLeadOff,
  kThreadPartialTurnDropped,
  kG115AsG114,
  kThreadNoRetract,
  kThreadEndsAtRPlane,
  kRunOutIntoWall,
  kRunOutBackwards,
  kRunOutParameterIgnored,
  kAngleParameterIgnored,
  kThreadDepthFromInitial,
  kThreadHeightEqualityRefused,
  kBoreEqualityAccepted,
  kThreadModeLost,
  // all
  kLateAlarm,
  kAlarmNextBlock,
  kRangeInMillimetres,
  kCycleFeedStuck,
  kInchFeed,
  kIncrementAsRadius,
  kDwellHalved,
  kBlankLinesNotCounted,
  kPairsCountedTwice,
  kLongArcShort,
  kCentreSwappedInG18,
  kHomeDirect,
  kFeedSurvivesReset
};

/// One description for each fault but kNone: that of Fault(i + 1) has the index i.
std::span<const FaultDescription> fault_descriptions();
inline constexpr std::size_t kFaults = static_cast<std::size_t>(Fault::kFeedSurvivesReset);

}  // namespace gonogo::expanders::gsk
