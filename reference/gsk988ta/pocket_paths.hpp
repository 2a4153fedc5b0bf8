// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/generator.hpp"
#include "reference/outcome.hpp"

namespace gonogo::reference::gsk988ta {

// The two paths that readings of GSK-G110-09 name. Both start at the centre and end on the circle
// of radius I - D.

// Semicircles whose ends alternate on p: first towards +p, abs(s_k) = min(k L / 2, I - D); then the
// full circle of radius I - D.
Generator<Record> semicircles(PocketLevel level);

// Full circles of radius L, 2 L, ..., I - D, each reached by a straight feed along +p.
Generator<Record> concentric_circles(PocketLevel level);

}  // namespace gonogo::reference::gsk988ta
