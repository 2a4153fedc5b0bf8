// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which records of a shown path are one of many: the manual leaves that part open.
#pragma once

#include "corpus/io/corpus.hpp"

namespace gonogo::oracle {

// The open parts of `records`, the path that the reference shows of the program; in their order.
std::vector<OpenPart> open_parts(const reference::Profile& profile, std::string_view program,
                                 const std::vector<reference::Record>& records);

}  // namespace gonogo::oracle
