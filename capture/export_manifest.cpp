// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/export_manifest.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "oracle/records/input_file.hpp"
#include "subjects/make_subject.hpp"

namespace gonogo::oracle {
namespace {

ExportedProgram program_of(const nlohmann::json& entry) {
  ExportedProgram program;
  program.stem = std::filesystem::path(entry.at("file").get<std::string>()).stem().string();
  program.header_lines = entry.at("header_lines").get<std::uint64_t>();
  for (reference::Axis axis : reference::kAllAxes) {
    const auto found = entry.at("start").find(std::string(1, letter(axis)));
    if (found == entry.at("start").end()) continue;
    auto value = Number::parse(found->get<std::string>());
    if (!value) throw std::runtime_error("a start position is no number");
    program.start[axis] = *value;
    program.start_axes.add(axis);
  }
  return program;
}

}  // namespace

std::map<std::string, ExportedProgram> read_export_manifest(const std::string& path) {
  std::ifstream file = open_regular(path);
  if (!file) throw SubjectUnusable(fmt::format("The manifest {} cannot be opened.", path));
  std::map<std::string, ExportedProgram> programs;
  try {
    const nlohmann::json manifest = nlohmann::json::parse(file);
    for (const nlohmann::json& entry : manifest.at("programs")) {
      programs.emplace(entry.at("id").get<std::string>(), program_of(entry));
    }
  } catch (const std::exception& error) {
    throw SubjectUnusable(
        fmt::format("{} is not a manifest that `gonogo export` wrote: {}.", path, error.what()));
  }
  return programs;
}

}  // namespace gonogo::oracle
