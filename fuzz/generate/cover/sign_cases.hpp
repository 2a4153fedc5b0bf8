// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cases one least increment below, on and above what the reference decides by.
#pragma once

#include "fuzz/generate/cover/cases.hpp"

namespace gonogo::cover {

// Up to `making.signs` triples of different kinds, from valid cases. Their ids depend on what they
// hold alone, and end in 1, 2, 3; their tags name the clause and the side: "GSK-G94-09:-", ":0",
// ":+".
std::vector<oracle::Case> sign_cases(const Making& making, const std::vector<DrawnCase>& from);

}  // namespace gonogo::cover
