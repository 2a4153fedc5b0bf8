// SPDX-License-Identifier: GPL-3.0-or-later
//
// The names of the control that are no addresses: MSG, TRANS, CYCLE81.
#pragma once

#include <string>

#include "reference/sinumerik/codes.hpp"

namespace gonogo::reference::sinumerik {

// The row of a word that is no address; null when the control lacks it. What the table does not
// have may be a subprogram or a variable of the machine's owner: it is outside.
const Code* find_name(Control control, const grammar::NamedWord& word);
// As it is quoted: L1 of L1=5.
std::string written_name(const grammar::NamedWord& word);

}  // namespace gonogo::reference::sinumerik
