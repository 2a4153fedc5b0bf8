// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "expanders/faults.hpp"

namespace gonogo::expanders::hnc {

/// The planted faults; what each does stands in faults.cpp, in the same order.
enum class Fault {
  kNone,
  // G74, G75: pecks
  kPeckRunningSum,
  kWithdrawalTwice,
  kExtraPeckAtMultiple,
  kLastPeckOvershoots,
  kWithdrawalAtBottom,
  kWithdrawalAtFeed,
  kEndlessPecks,
  kWithdrawalSignUnchecked,
  kDrillTakesX,
  // G75
  kGrooveDepthDiameter,
  kGrooveStepShort,
  kGrooveEndsAtLast,
  kGrooveRunningSum,
  kGrooveCountUnchecked,
  // G80, G81
  kTurnTaperDiameter,
  kTurnTaperSign,
  kTurnAsFace,
  kTurnRapidRetract,
  kTurnTaperLost,
  kFaceTaperIgnored,
  kFaceTaperSign,
  // G82
  kRunOutBefore,
  kRunOutDiameter,
  kRunOutSign,
  kRatioEqualityRefused,
  kRatioUnchecked,
  kPairUnchecked,
  kStartsFromCircle,
  kStartsAtZero,
  kStartShort,
  kThreadsOut,
  kInchLeadAsMillimetres,
  kLeadLeaksIntoFeed,
  kFeedServesAsLead,
  // modal words and codes
  kTaperLeaksPastRapid,
  kWithdrawalLeaksIntoGroove,
  kCycleSurvivesRapid,
  kCycleFeedStuck,
  kThreadLeadForgotten,
  // coordinates
  kOffsetIgnoredInCycle,
  kRenameIgnoresOffset,
  kIncrementalZIgnored,
  kIncrementAsRadius,
  kIncrementAsDiameter,
  kCentreAsDiameter,
  // all
  kRevolutionIgnored,
  kDwellInSeconds,
  kInchFeed,
  kLateAlarm,
  kAlarmNextBlock,
  kBlankLinesNotCounted,
  kFeedSurvivesReset
};

/// One description for each fault but kNone: that of Fault(i + 1) has the index i.
std::span<const FaultDescription> fault_descriptions();
inline constexpr std::size_t kFaults = static_cast<std::size_t>(Fault::kFeedSurvivesReset);

}  // namespace gonogo::expanders::hnc
