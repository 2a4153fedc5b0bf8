// SPDX-License-Identifier: GPL-3.0-or-later
//
// Options that mean the same wherever they make sense.
#pragma once

#include <optional>
#include <string>

#include "cli/command_line.hpp"
#include "cli/program_file.hpp"
#include "fuzz/generate/generator_settings.hpp"
#include "oracle/motion/tolerances.hpp"
#include "subjects/make_subject.hpp"

namespace gonogo::cli {

// Part `number` of `of`.
struct Shard {
  unsigned number = 1;
  unsigned of = 1;
};
// --shard i/n. Throws UsageError.
Shard shard_option(const std::string& text);

// --dialect, --profile, --reading
void add_profile_options(Command& command, ProfileOptions& options);

struct SandboxOptions {
  std::string wish = "off";
  std::vector<std::string> bound;
};

struct LimitOptions {
  long timeout = 0;  // ms; 0: the default
  long memory = 0;   // MB; 0: the default
  std::vector<std::string> environment;
  SandboxOptions sandbox;
  bool show_ids = false;
  std::string tolerance;
  std::string chord;
  std::string feed_resolution;
  bool strict = false;
  std::string feed_tolerance;
  std::string manifest;
  std::string blend;
  std::string columns;
  oracle::StatedMachine stated;
  oracle::Limits limits() const;
  oracle::Grants grants() const;
};

// What --profile and --reading say of the machine of every program.
oracle::StatedMachine stated_machine(const ProfileOptions& options);
// --strict
void add_strict_option(Command& command, LimitOptions& options);
// --tolerance, --chord, --feed-resolution, and of a subject that runs --timeout, --memory, --env
void add_run_options(Command& command, LimitOptions& options);
// Those, and of captured output --feed-tolerance, --blend, --columns, --manifest
void add_subject_options(Command& command, LimitOptions& options);
// Throws UsageError where one of the latter is given and none of the subjects is captured output.
void check_capture_options(const LimitOptions& options, const std::vector<std::string>& subjects);

// Adds --sandbox auto|off|required and --bind PATH[:rw] to a command. `by_default` holds where
// --sandbox is not given.
void add_sandbox_options(Command& command, SandboxOptions& options, const std::string& by_default);

// The limits with the sandbox for a subject of this kind; `hidden` are folders that it does not
// see. Throws UsageError when a sandbox is required and cannot be had.
oracle::Limits sandboxed(oracle::Limits limits, const SandboxOptions& options,
                         const std::string& subject, const std::vector<std::string>& hidden);

// "bubblewrap", "none"; empty for a subject that starts no process.
std::string sandbox_name(const oracle::Limits& limits, const std::string& subject);

// What is not below zero, as a decimal: "a feed in mm/min". Throws UsageError.
std::optional<reference::Number> decimal_option(const std::string& text, const char* option,
                                                const char* what);
std::optional<reference::Number> feed_option(const std::string& text, const char* option);
std::optional<reference::Number> length_option(const std::string& text, const char* option);

// --settings: what generated programs are like. Throws UsageError.
generate::GeneratorSettings settings_option(const std::string& text);

}  // namespace gonogo::cli
