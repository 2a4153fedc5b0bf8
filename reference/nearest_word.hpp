// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which word somebody meant who wrote an unknown one.
#pragma once

#include <string>
#include <vector>

namespace gonogo::reference {

// The known word that is nearest to the one written, in large or small letters; empty: none is
// near.
std::string nearest_word(const std::string& word, const std::vector<std::string>& known);
// "Did you mean taper-sign? "; empty for an empty word.
std::string did_you_mean(const std::string& word);

}  // namespace gonogo::reference
