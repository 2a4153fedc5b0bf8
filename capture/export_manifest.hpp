// SPDX-License-Identifier: GPL-3.0-or-later
//
// The manifest that `gonogo export` writes beside its programs: the part of it that the judge of
// what came back needs.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "reference/axis.hpp"

namespace gonogo::oracle {

struct ExportedProgram {
  std::string stem;                // of the file: "0001"
  std::uint64_t header_lines = 0;  // before the case's own
  reference::Position start;
  reference::AxisSet start_axes;
};

// By the id of the case. Throws SubjectUnusable, with what is wrong.
std::map<std::string, ExportedProgram> read_export_manifest(const std::string& path);

}  // namespace gonogo::oracle
