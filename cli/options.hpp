// SPDX-License-Identifier: GPL-3.0-or-later
//
// Options that mean the same wherever they make sense.
#pragma once

#include <optional>
#include <string>

#include "cli/command_line.hpp"
#include "cli/program_file.hpp"
#include "fuzz/generator_settings.hpp"
#include "oracle/subject.hpp"

namespace gonogo::cli {

// --dialect, --profile, --reading
void add_profile_options(Command& command, ProfileOptions& options);

// --timeout, --memory, --tolerance, --chord, and of captured output --feed-tolerance, --manifest
struct LimitOptions {
  long timeout = 0;  // ms; 0: the default
  long memory = 0;   // MB; 0: the default
  std::string tolerance;
  std::string chord;
  std::string feed_tolerance;
  std::string manifest;
  oracle::Limits limits() const;
};
void add_limit_options(Command& command, LimitOptions& options);

// A length given as a decimal; throws UsageError.
std::optional<reference::Number> length_option(const std::string& text, const char* option);

// --settings: what generated programs are like. Throws UsageError.
fuzz::GeneratorSettings settings_option(const std::string& text);

}  // namespace gonogo::cli
