// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "expanders/common/tracer.hpp"

namespace gonogo::expanders::ngc {

/// What the controller can stop a program for: its own number, and the class that the gauge knows
/// the alarm by.
struct AlarmKind {
  static constexpr AlarmText kSyntax{"E101", "syntax"};
  static constexpr AlarmText kUndefinedCode{"E102", "undefined-code"};
  static constexpr AlarmText kDuplicateWord{"E103", "duplicate-word"};
  static constexpr AlarmText kConflictingWords{"E104", "conflicting-words"};
  static constexpr AlarmText kMissingWord{"E105", "missing-word"};
  static constexpr AlarmText kUnusedWord{"E106", "unused-word"};
  static constexpr AlarmText kProgramEnd{"E107", "program-end"};
  static constexpr AlarmText kValueOutOfRange{"E201", "value-out-of-range"};
  static constexpr AlarmText kValueSign{"E202", "value-sign"};
  static constexpr AlarmText kNotAnInteger{"E203", "not-an-integer"};
  static constexpr AlarmText kNoTool{"E204", "no-tool"};
  static constexpr AlarmText kAxisNotInPlane{"E301", "axis-not-in-plane"};
  static constexpr AlarmText kArcEndPoint{"E302", "arc-end-point"};
  static constexpr AlarmText kArcRadius{"E303", "arc-radius"};
  static constexpr AlarmText kFeedMissing{"E304", "feed-missing"};
  static constexpr AlarmText kPlaneNotAllowed{"E305", "plane-not-allowed"};
  static constexpr AlarmText kReferencePlane{"E306", "reference-plane"};
  static constexpr AlarmText kLeadMissing{"E307", "lead-missing"};
  static constexpr AlarmText kSpindleStopped{"E308", "spindle-stopped"};
  static constexpr AlarmText kDirectionConflict{"E309", "direction-conflict"};
};

}  // namespace gonogo::expanders::ngc
