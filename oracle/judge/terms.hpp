// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "oracle/subject.hpp"

namespace gonogo::oracle {

// On what terms a subject is judged: what it declared, and what the certifier granted.
struct JudgeTerms {
  Number tolerance = Number::millionths(1000);  // tau, mm an axis
  Number granted;                               // mm; the certifier's own tolerance, 0: none
  Number chord;                                 // mm; chords of arcs allowed when above 0
  std::optional<Number> resolution;             // declared; for correctly rounded values
  std::optional<Number> feed_resolution;
  bool binary64 = false;       // numbers come as doubles
  bool compare_blocks = true;  // feature `blocks`
  bool compare_m = false;      // feature `m`
  bool strict = false;         // a departure from what no text states is NO-GO, no advice
  bool skip_equal =
      true;  // false: even equal records are dropped, joined and matched, to the same end

  // J-CONST-07: of a level of a pocket, mm. Centre and start of an arc are each rounded by half of
  // the resolution along an axis: 3/sqrt(2) = 2.12 times it is what its points may be off.
  Number level_tolerance() const {
    constexpr int kEighths = 17;
    return resolution ? max(tolerance, *resolution * kEighths / 8) : tolerance;
  }
};

// tau is the smaller of the declared resolution and the profile's, unless the certifier says
// otherwise.
JudgeTerms make_terms(const SubjectInfo& subject, const reference::Profile& profile,
                      const std::optional<Number>& tolerance, const std::optional<Number>& chord);

}  // namespace gonogo::oracle
