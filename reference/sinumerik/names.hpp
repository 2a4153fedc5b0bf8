// SPDX-License-Identifier: GPL-3.0-or-later
//
// The names of the control that are no addresses: MSG, TRANS, CYCLE81.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "reference/g_codes.hpp"

namespace gonogo::reference::sinumerik {

struct Name {
  std::string_view name;  // "CYCLE<n>" stands for all of them
  Treatment treatment;    // without_effect or outside
  std::string_view title;
};
std::span<const Name> names();

// The name of a word that is no address; null when the control lacks it. What the list does not
// have may be a subprogram or a variable of the machine's owner: it is outside.
const Name* find_name(const grammar::NamedWord& word);
// As it is quoted: L1 of L1=5.
std::string written_name(const grammar::NamedWord& word);

}  // namespace gonogo::reference::sinumerik
