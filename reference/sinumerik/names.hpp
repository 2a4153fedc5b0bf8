// SPDX-License-Identifier: GPL-3.0-or-later
//
// The names of the control that are no addresses: MSG, TRANS, CYCLE81.
#pragma once

#include <span>
#include <string_view>

#include "reference/g_codes.hpp"

namespace gonogo::reference::sinumerik {

struct Name {
  std::string_view name;  // "CYCLE<n>" stands for all of them
  Treatment treatment;    // without_effect or outside
  std::string_view title;
};
std::span<const Name> names();

// The name of a word that is no address; null when the control lacks it.
const Name* find_name(const grammar::NamedWord& word);

}  // namespace gonogo::reference::sinumerik
