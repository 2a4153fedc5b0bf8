// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/generator.hpp"
#include "reference/outcome.hpp"

namespace gonogo::reference::rs274 {

// The records, all of them `Record`s, without those by which nothing happens: motions of linear
// axes that end where they start, from `at` on, and dwells of no time.
Generator<Item> without_idle(Generator<Item> items, Position at);

}  // namespace gonogo::reference::rs274
