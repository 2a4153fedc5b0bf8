// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "expanders/common/tracer.hpp"

namespace gonogo::expanders::sinumerik {

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
  kAxisNotInPlane,
  kArcEndPoint,
  kArcIntermediatePoint,
  kArcTangent,
  kArcRadius,
  kFeedMissing,
  kSpindleStopped,
  kPlaneNotAllowed,
  kNoTool,
  kReferencePlane,
  kMachiningType,
  kDirectionParameter,
  kToolTooLarge,
  kAllowanceTooLarge,
  kPocketSize
};

/// The controller's own number and the class that the gauge knows the alarm by.
AlarmText text_of(AlarmKind kind);

}  // namespace gonogo::expanders::sinumerik
