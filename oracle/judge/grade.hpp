// SPDX-License-Identifier: GPL-3.0-or-later
//
// How well a motion that passes is computed: exact, correctly rounded, or within the tolerance.
#pragma once

#include "oracle/judge/alignment.hpp"

namespace gonogo::oracle {

// J-CMP-09: of a motion that completes one of the reference's.
struct Grade {
  bool exact = true;    // end and centre are exact
  bool rounded = true;  // ... or correctly rounded
};
// `census` takes the coordinates that `want` gives (tells_end), and those that are not exact where
// `motion` alone moves; null: none does.
Grade grade_of(const Motion& motion, const Motion& want, const Tolerances& tolerances,
               RoundingCensus* census = nullptr);
// Whether a motion that goes on within one of the reference's ends exactly on it, about its exact
// centre. A chord of an arc does not; the ways of a traverse are not compared.
bool is_exact_piece(const Motion& piece, const Motion& want);
// R3: whether a coordinate that is not exact is the correctly rounded one.
bool is_correctly_rounded(const Number& got, const Number& exact, const Tolerances& tolerances);

}  // namespace gonogo::oracle
