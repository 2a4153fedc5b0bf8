// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace gonogo::expanders {

/// What a controller can stop a program for; each maker has some of them.
enum class AlarmKind : std::uint8_t {
  kSyntax,                // block that cannot be read
  kUndefinedCode,         // code, address or name that the control lacks
  kDuplicateWord,         // address or group of codes twice in a block
  kConflictingWords,      // words that exclude each other
  kMissingWord,           // word that the block needs
  kValueOutOfRange,       // number that the word does not take
  kValueSign,             // number with the wrong sign
  kNotAnInteger,          // count with decimals
  kAxisNotInPlane,        // word of an axis outside the plane
  kPlaneNotAllowed,       // plane that the control or the rotation in force does not have
  kArcEndPoint,           // end not on the circle, or no circle
  kArcIntermediatePoint,  // three points that fix no circle
  kArcTangent,            // no direction to go on in
  kArcRadius,             // circle of no size, radius shorter than half the chord
  kFeedMissing,           // cut without F
  kLeadMissing,           // thread without a lead
  kSpindleStopped,        // cut with a spindle that does not turn
  kDirectionConflict,     // R plane or approach on the wrong side
  kTaperLimit,            // taper longer than the travel against it
  kToolTooLarge,          // pocket or bore that the tool does not go into
  kStepTooLarge,          // step not below the tool's diameter
  kDepthExceedsTool,      // thread higher than the tool
  kRetractPair,           // half of a run-out
  kRetractRatio,          // run-out too steep
  kNoTool,                // cycle without a tool that is described
  kReferencePlane,        // planes of a cycle in the wrong order
  kMachiningType,         // neither roughing nor finishing
  kDirectionParameter,    // neither sense of milling
  kAllowanceTooLarge,     // allowance that the machining cannot leave
  kPocketSize             // pocket without length or width
};
inline constexpr std::size_t kAlarmKinds = static_cast<std::size_t>(AlarmKind::kPocketSize) + 1;

/// The class that the gauge knows the alarm by.
constexpr std::string_view class_of(AlarmKind kind) {
  // In the order of AlarmKind.
  std::string_view classes =
      "syntax undefined-code duplicate-word conflicting-words missing-word value-out-of-range "
      "value-sign not-an-integer axis-not-in-plane plane-not-allowed arc-end-point "
      "arc-intermediate-point arc-tangent arc-radius feed-missing lead-missing spindle-stopped "
      "direction-conflict taper-limit tool-too-large step-too-large depth-exceeds-tool "
      "retract-pair retract-ratio no-tool reference-plane machining-type direction-parameter "
      "allowance-too-large pocket-size";
  for (auto before = static_cast<std::size_t>(kind); before > 0; --before) {
    classes.remove_prefix(classes.find(' ') + 1);
  }
  return classes.substr(0, classes.find(' '));
}

/// A maker's own numbers, in the order of AlarmKind; "": it has no such alarm.
using AlarmNumbers = std::array<std::string_view, kAlarmKinds>;

}  // namespace gonogo::expanders
