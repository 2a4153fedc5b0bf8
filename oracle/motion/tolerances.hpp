// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "oracle/records/subject_outcome.hpp"
#include "oracle/region/constants.hpp"

namespace gonogo::oracle {

// How a subject is judged: what it declared, and what the certifier granted.
struct Tolerances {
  Number tolerance = Number::millionths(1000);  // tau, mm an axis
  Number granted;                               // mm; the certifier's own tolerance, 0: none
  Number chord;                                 // mm; chords of arcs allowed when above 0
  std::optional<Number> resolution;             // declared; for correctly rounded values
  std::optional<Number> feed_resolution;
  Number increment = Number::millionths(1000);  // the profile's least, mm
  bool binary64 = false;                        // numbers come as doubles
  bool exact = false;                           // it says that none is rounded
  bool compare_blocks = true;                   // feature `blocks`
  bool compare_m = false;                       // feature `m`
  bool strict = false;  // a departure from what no text states is NO-GO, no advice
  bool measure = true;  // for samples: figures beside the verdict, which take longer
  bool skip_equal =
      true;  // false: even equal records are dropped, joined and matched, to the same end

  // R2: for a level of a pocket, mm. Centre and start of an arc are each rounded by half of the
  // resolution along an axis: its points may be off by 3/sqrt(2) = 2.12 times the resolution.
  Number level_tolerance() const {
    return resolution ? max(tolerance, *resolution * kRoundingEighths / 8) : tolerance;
  }
};

// What the certifier grants with options of his own, beyond what the subject declares and the
// profile says.
struct Grants {
  std::optional<Number> tolerance = {};        // mm an axis
  std::optional<Number> chord = {};            // mm
  std::optional<Number> feed_resolution = {};  // mm/min or mm/rev
  bool strict = false;
};

// What a subject declares counts up to the profile's `resolution`, unless the certifier grants
// more (J-RUN-02).
Tolerances make_tolerances(const SubjectInfo& subject, const reference::Profile& profile,
                           const Grants& grants = {});

// A declaration that counts for less than it says.
struct Capped {
  std::string_view what;  // "resolution", "feed_resolution", "chord"
  Number declared;
  Number counts;
};
// The capped declarations of a subject.
std::vector<Capped> capped(const SubjectInfo& subject, const reference::Profile& profile,
                           const Grants& grants);

}  // namespace gonogo::oracle
