// SPDX-License-Identifier: GPL-3.0-or-later
//
// The words that are passed over (SIE-WRD-01). A word that no rule passes over is used, has no
// meaning for the motion in force (SIE-COM-01), or is a name that is not read (SIE-MOD-02).
#pragma once

#include <span>

#include "reference/passed_words.hpp"

namespace gonogo::reference::sinumerik {

std::span<const PassedWords> passed_words();

}  // namespace gonogo::reference::sinumerik
