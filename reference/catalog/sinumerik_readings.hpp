// SPDX-License-Identifier: GPL-3.0-or-later
//
// The readings of SINUMERIK: of the path commands, which both controls have, and of the frames and
// cycles of the 802S. In the order of ReadingKey.
#pragma once

#include <vector>

#include "reference/reading.hpp"

namespace gonogo::reference::catalog {

// NOLINTNEXTLINE(readability-function-size): a table.
inline std::vector<Reading> sinumerik_readings() {
  const auto reading = [](ReadingKey key, std::string_view name,
                          std::vector<std::string_view> alternatives, std::string_view fallback,
                          ClauseId clause, std::string_view text) {
    return Reading{key,    name, "sinumerik840d", std::move(alternatives), fallback, false, false,
                   clause, text, "sinumerik802s"};
  };
  const auto only_802s = [](ReadingKey key, std::string_view name,
                            std::vector<std::string_view> alternatives, std::string_view fallback,
                            bool by_properties, ClauseId clause, std::string_view text) {
    return Reading{key,      name,          "sinumerik802s", std::move(alternatives),
                   fallback, by_properties, false,           clause,
                   text};
  };
  return {
      reading(ReadingKey::sie_arc_correct, "sie.arc.correct",
              {"start-radius", "project", "programmed"}, "any", "SIE-ARC-08"_clause,
              "the centre of an arc whose end misses its circle within the limit: on the "
              "perpendicular bisector at the radius of the start, the programmed one projected on "
              "it, or the programmed one with a radius linear in the angle"),
      reading(ReadingKey::sie_cr_tolerance, "sie.cr.tolerance", {"0", "const"}, "any",
              "SIE-ARC-11"_clause,
              "by how much a chord may exceed twice CR: not at all, or by CIRCLE_ERROR_CONST (the "
              "arc is then half a turn about the chord's middle)"),
      reading(ReadingKey::sie_spindle, "sie.spindle", {"off", "alarm"}, "off", "SIE-G1-02"_clause,
              "cutting while the spindle stands: no matter, or an alarm"),
      reading(ReadingKey::sie_initial_motion, "sie.initial-motion", {"g1", "g0"}, "any",
              "SIE-MOD-02"_clause, "the motion in force before any code: G1 or G0"),
      reading(ReadingKey::sie_g70_f, "sie.g70.f", {"mm", "inch"}, "any", "SIE-MOD-04"_clause,
              "F under G70: millimetres, or inches"),
      only_802s(ReadingKey::sie_g158, "sie.g158", {"absolute", "additive"}, "any", false,
                "SIE-FRM-01"_clause,
                "G158: it replaces translation and rotation, or is added to those in force"),
      only_802s(ReadingKey::sie_rpl_equals, "sie.rpl-equals", {"lenient", "required"}, "any", false,
                "SIE-FRM-03"_clause, "RPL45 without '=': read as RPL=45, or an alarm"),
      only_802s(ReadingKey::sie_g258, "sie.g258", {"absolute", "rotation-only"}, "any", false,
                "SIE-FRM-04"_clause,
                "G258: it replaces translation and rotation, or the rotation alone"),
      only_802s(
          ReadingKey::sie_infeed, "sie.infeed", {"equal", "max-rest"}, "any", true,
          "SIE-LC75-06"_clause,
          "how the depth of a pocket is divided: equal infeeds, whole ones and a rest, or any "
          "of at most R121"),
      only_802s(ReadingKey::sie_infeed_from, "sie.infeed-from", {"reference", "clearance"}, "any",
                false, "SIE-LC75-06"_clause,
                "where the divided depth begins: at the reference plane, or R102 above it"),
      only_802s(ReadingKey::sie_finish_levels, "sie.finish.levels", {"split"}, "any", true,
                "SIE-LC75-11"_clause,
                "the levels of finishing: divided as in roughing, or also one at the full depth"),
      only_802s(ReadingKey::sie_corner, "sie.corner", {"clamp", "reject"}, "any", false,
                "SIE-LC75-09"_clause,
                "a corner radius above half the width or length: as large as fits, or an alarm"),
      only_802s(ReadingKey::sie_pocket_path, "sie.pocket.path", {"contour-parallel"}, "any", true,
                "SIE-LC75-12"_clause,
                "the path that clears a level: judged by what it clears, or the given one"),
      only_802s(ReadingKey::sie_lcyc_unit, "sie.lcyc.unit", {"mm", "inch"}, "any", false,
                "SIE-LC75-01"_clause,
                "the lengths among the parameters of LCYC75 and LCYC82 under G70: millimetres, or "
                "inches"),
      only_802s(ReadingKey::sie_lc75_r125_limit, "sie.lc75.r125-limit", {"none", "alarm"}, "any",
                false, "SIE-LC75-09"_clause,
                "an allowance in depth R125 that is not smaller than the tool's diameter: no "
                "matter, or an alarm"),
  };
}

}  // namespace gonogo::reference::catalog
