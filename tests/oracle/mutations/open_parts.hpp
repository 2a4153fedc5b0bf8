// SPDX-License-Identifier: GPL-3.0-or-later
//
// Conditions that every right path through an open part meets, one file a cycle. They are written
// from the clauses and need not be all: what breaks none of them is not counted.
#pragma once

#include "path_map.hpp"

namespace gonogo::mutations {

// GSK-G114-06, -10, -11.
std::shared_ptr<const OpenPart> open_thread(const reference::ThreadMilling& thread);
// GSK-G112-04 to -06.
std::shared_ptr<const OpenPart> open_helix_pocket(const reference::HelixPocket& pocket);
// GSK-G110-09, GSK-CYC-02.
std::shared_ptr<const OpenPart> open_level(const reference::PocketLevel& level);
// SIE-LC75-04 to -13.
std::shared_ptr<const OpenPart> open_pocket_milling(const reference::PocketMilling& pocket);

}  // namespace gonogo::mutations
