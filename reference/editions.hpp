// SPDX-License-Identifier: GPL-3.0-or-later
//
// The documents that the clauses of a dialect cite.
#pragma once

#include <string_view>

namespace gonogo::reference {

// The documents that the clauses of `dialect` name as their sources, each with its edition as far
// as the text states it; a sentence or more without the last full stop. Empty: there is no such
// dialect.
std::string_view editions_of(std::string_view dialect);

}  // namespace gonogo::reference
