// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/subject_files.hpp"

#include <fmt/format.h>

#include <utility>
#include <variant>

#include "cli/program_file.hpp"

namespace gonogo::cli {
namespace {

template <typename Result>
Result checked(std::variant<Result, oracle::FileFault> read, const std::string& file) {
  if (auto* fault = std::get_if<oracle::FileFault>(&read)) {
    throw UsageError(fmt::format("{}: {}", file, fault->message));
  }
  return std::get<Result>(std::move(read));
}

}  // namespace

std::vector<oracle::KnownFailure> load_known_failures(const std::string& file) {
  return checked(oracle::known_failures_from_toml(read_file(file, "a file of known failures")),
                 file);
}

std::vector<oracle::KnownCause> load_known_causes(const std::string& file) {
  return checked(oracle::known_causes_from_toml(read_file(file, "a file of known failures")), file);
}

std::shared_ptr<const oracle::AlarmMap> load_alarm_map(const std::string& file) {
  if (file.empty()) return nullptr;
  return std::make_shared<const oracle::AlarmMap>(
      checked(oracle::alarm_map_from_toml(read_file(file, "an alarm map")), file));
}

}  // namespace gonogo::cli
