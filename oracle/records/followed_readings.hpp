// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a run says of the readings that its subject follows: one sentence for terminal, page and
// Markdown.
#pragma once

#include <span>
#include <string>

namespace gonogo::oracle {

// `assignments`: the readings that explain all passes, each "k=v k=v" (the footer of results). Says
// what is not the default, and which readings have several values among them: "the defaults of 27
// readings, except ngc.arc-tolerance=nist; cannot be told apart: gsk.decimals=keep or nearest".
// Empty: no reading mattered.
std::string followed_readings(std::span<const std::string> assignments);

}  // namespace gonogo::oracle
