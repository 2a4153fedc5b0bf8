// SPDX-License-Identifier: GPL-3.0-or-later
//
// R8: what a manual leaves open, by the conditions of its clause.
#pragma once

#include <vector>

#include "oracle/relation/subject_side.hpp"
#include "reference/outcome.hpp"

namespace gonogo::relation {

// A helical pocket leaves open at which point of its circle the tool comes to the helix; that point
// settles everything. The paths for all points at which the subject, from its event `begin` on, may
// have come to it.
std::vector<std::vector<reference::Record>> paths_of(const reference::HelixPocket& pocket,
                                                     SubjectSide& subject, std::size_t begin,
                                                     const Number& tau);

}  // namespace gonogo::relation
