// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/generator.hpp"
#include "reference/gsk988ta/milling.hpp"

namespace gonogo::reference::gsk988ta {

// The passes of a thread milling block along the path that `expand` shows (reading
// gsk.thread.path = arc, an open run-out as the polar one): from the centre at the R plane to the
// safe position of the last pass at the R plane.
Generator<Record> thread_passes(MillingSite site, ThreadMilling thread);
// Where they end in the plane, along p and q.
std::array<Number, 2> end_of_passes(const ThreadMilling& thread);
// How far from the centre, along p, the tool waits between passes.
Number safe_radius(const ThreadMilling& thread);
// Turns of each helix, a partial last one as its fraction.
Number turns_of(const ThreadMilling& thread);

}  // namespace gonogo::reference::gsk988ta
