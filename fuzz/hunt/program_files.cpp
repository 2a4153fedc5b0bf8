// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/program_files.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "corpus/io/files.hpp"

namespace gonogo::hunt {

generate::GeneratedProgram read_program(const std::filesystem::path& text,
                                        const std::filesystem::path& machine,
                                        const std::string& dialect) {
  auto profile = reference::profile_from_json(oracle::file_text(machine.string()), dialect);
  auto* read = std::get_if<reference::Profile>(&profile);
  if (read == nullptr) {
    throw std::runtime_error(fmt::format("{} is no machine of the gauge.", machine.string()));
  }
  return {std::move(*read), oracle::file_text(text.string())};
}

}  // namespace gonogo::hunt
