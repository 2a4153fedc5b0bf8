// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "expanders/common/tracer.hpp"

namespace gonogo::expanders::hnc {

/// What the controller can stop a program for.
enum class AlarmKind {
  kSyntax,
  kUndefinedCode,
  kDuplicateWord,
  kConflictingWords,
  kMissingWord,
  kValueOutOfRange,
  kValueSign,
  kNotAnInteger,
  kDirectionConflict,
  kPlaneNotAllowed,
  kRetractPair,
  kRetractRatio,
  kArcEndPoint,
  kArcRadius,
  kFeedMissing,
  kLeadMissing
};

/// The controller's own number and the class that the gauge knows the alarm by.
AlarmText text_of(AlarmKind kind);

}  // namespace gonogo::expanders::hnc
