// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two outcomes compared motion by motion: for a model of a subject whose mistake no change of the
// program shows in the reference. No verdict comes from it.
#pragma once

#include "fuzz/identify/outcome.hpp"

namespace gonogo::identify {

// Whether the subject put out what the model says: the same motions after dropping and joining, at
// the tolerance of the judge, and the same end. `start` is where the program begins.
bool same_path(const KeptOutcome& model, const KeptOutcome& subject,
               const reference::Position& start, const oracle::Tolerances& tolerances);

}  // namespace gonogo::identify
