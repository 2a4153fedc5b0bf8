// SPDX-License-Identifier: GPL-3.0-or-later
//
// What terminal, summaries and hunts say of one departure in the same words: the machine where it
// is not the default, the program with the block that departs, what is wanted and what came.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace gonogo::oracle {

// A record or an alarm as people write it: {"k":"rapid","b":2,"to":{"z":"-7"}} is "rapid Z-7". What
// is none comes back as it is.
std::string short_step(std::string_view json);

// "want rapid Z-7 / got rapid Z-3"; empty: there is neither.
std::string want_and_got(std::string_view want, std::string_view got);

// The lines about this one of a program with their numbers, the line itself marked by a caret
// below; nothing without such a line. Bytes that are no text of ASCII are shown as ?.
std::string marked_blocks(std::string_view program, std::uint64_t line);

// What a profile in JSON has other than the default machine, which is all that it says: "units
// inch; gsk.decimals keep". Empty: nothing.
std::string other_machine(std::string_view profile);

}  // namespace gonogo::oracle
