// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "expanders/common/tracer.hpp"

namespace gonogo::expanders::ngc {

/// What the controller can stop a program for.
enum class AlarmKind {
  kSyntax,
  kUndefinedCode,
  kDuplicateWord,
  kConflictingWords,
  kMissingWord,
  kUnusedWord,
  kProgramEnd,
  kValueOutOfRange,
  kValueSign,
  kNotAnInteger,
  kAxisNotInPlane,
  kArcEndPoint,
  kArcRadius,
  kFeedMissing
};

/// The controller's own number and the class that the gauge knows the alarm by.
AlarmText text_of(AlarmKind kind);

}  // namespace gonogo::expanders::ngc
