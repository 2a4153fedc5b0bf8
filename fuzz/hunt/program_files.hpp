// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "fuzz/generate/generator.hpp"

namespace gonogo::hunt {

// A program and the machine beside it, as JSON; one that names no dialect is of `dialect`. Throws
// std::runtime_error where a file cannot be read or is no machine, naming it.
generate::GeneratedProgram read_program(const std::filesystem::path& text,
                                        const std::filesystem::path& machine,
                                        const std::string& dialect);

}  // namespace gonogo::hunt
