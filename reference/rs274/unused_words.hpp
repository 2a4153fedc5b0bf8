// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which words the codes of a block take.
#pragma once

#include "reference/rs274/machine.hpp"

namespace gonogo::reference::rs274 {

// Whether a code of the block beside its motion takes the word: P of an arc is then not its turns.
bool is_taken_beside_motion(const BlockContext& block, char address);
// NGC-COM-02
void check_unused_words(BlockContext& block);

}  // namespace gonogo::reference::rs274
