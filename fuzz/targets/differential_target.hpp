// SPDX-License-Identifier: GPL-3.0-or-later
//
// Differential: programs through a built-in expander and the judge. The bytes are the generator's
// decisions, or the program itself. Cost cap: the generator's settings; 512 bytes of a program,
// since a tiny Q over a great depth is a long one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fuzz/generate/choices.hpp"
#include "fuzz/targets/target.hpp"

namespace gonogo::fuzz {

// The program that the choices decide, through the expander of that name. One name and dialect a
// process.
void try_expander(std::string_view name, std::string_view dialect, generate::Choices choices);
// Makes the same choices, and tries nothing.
void decide_program(std::string_view name, std::string_view dialect, generate::Choices& choices);

// One input: a program for the dialect's machine of defaults.
void try_text(std::string_view name, std::string_view dialect, const std::uint8_t* data,
              std::size_t size);

}  // namespace gonogo::fuzz
