// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/motion/tolerances.hpp"

namespace gonogo::oracle {
namespace {

// What of a declaration counts: no more than the profile's least increment, be it of lengths in mm
// or of feeds in mm/min and mm/rev (J-RUN-02).
std::optional<Number> at_most(const std::optional<Number>& declared, const Number& cap) {
  if (!declared) return std::nullopt;
  return min(*declared, cap);
}

}  // namespace

Tolerances make_tolerances(const SubjectInfo& subject, const reference::Profile& profile,
                           const Grants& grants) {
  const Number increment = profile.resolution();
  Tolerances tolerances;
  tolerances.increment = increment;
  // A subject that rounds more coarsely than the machine is not excused by saying so; a granted
  // tolerance is one of axes, not of leads, angles and dwells.
  tolerances.resolution = at_most(subject.resolution, increment);
  tolerances.tolerance = tolerances.resolution.value_or(increment);
  if (grants.tolerance) tolerances.tolerance = tolerances.granted = *grants.tolerance;
  if (grants.chord) tolerances.chord = *grants.chord;
  tolerances.feed_resolution = at_most(subject.feed_resolution, increment);
  if (grants.feed_resolution) tolerances.feed_resolution = grants.feed_resolution;
  tolerances.binary64 = subject.numeric_kind == "binary64";
  tolerances.exact = subject.says_numeric && subject.numeric_kind == "exact";
  tolerances.compare_blocks = subject.features.contains("blocks");
  tolerances.compare_m = subject.features.contains("m");
  tolerances.strict = grants.strict;
  return tolerances;
}

std::vector<Capped> capped(const SubjectInfo& subject, const reference::Profile& profile,
                           const Grants& grants) {
  const Number increment = profile.resolution();
  std::vector<Capped> found;
  auto look = [&](std::string_view what, const std::optional<Number>& declared,
                  const std::optional<Number>& granted, const Number& cap) {
    if (declared && !granted && *declared > cap) found.push_back({what, *declared, cap});
  };
  look("resolution", subject.resolution, grants.tolerance, increment);
  look("feed_resolution", subject.feed_resolution, grants.feed_resolution, increment);
  look("chord", subject.chord, grants.chord, 0);
  return found;
}

}  // namespace gonogo::oracle
