// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <utility>

#include "campaign/selection.hpp"
#include "reference/dialect.hpp"
#include "subjects/sandbox.hpp"

namespace gonogo::cli {
namespace {

constexpr std::string_view kMayChange = ":rw";

bool starts_processes(const std::string& subject) {
  return subject.starts_with("pipe:") || subject.starts_with("oneshot:") ||
         subject.starts_with("lib:");
}

void add_bound(oracle::Sandbox& sandbox, std::string path) {
  const bool may_change = path.ends_with(kMayChange);
  if (may_change) path.resize(path.size() - kMayChange.size());
  if (!std::filesystem::exists(path)) {
    throw UsageError(fmt::format("--bind {}: there is no such file or folder.", path));
  }
  (may_change ? sandbox.changed : sandbox.bound).push_back(path);
}

}  // namespace

Shard shard_option(const std::string& text) {
  Shard shard;
  if (!oracle::read_shard(text, shard.number, shard.of)) {
    throw UsageError(fmt::format("--shard {} is not of the form i/n with 1 <= i <= n.", text));
  }
  return shard;
}

void add_profile_options(Command& command, ProfileOptions& options) {
  command.option("--dialect", options.dialect,
                 "dialect of the program: " + reference::dialect_names());
  command.option("--profile", options.file, "machine profile (TOML, or JSON by its ending)");
  command.repeated_option("--reading", options.readings, "one reading as key=value");
}

void add_strict_option(Command& command, LimitOptions& options) {
  command.flag("--strict", options.strict,
               "a departure from what no text of a manual states is NO-GO, not an advice");
}

void add_run_options(Command& command, LimitOptions& options) {
  constexpr long kMost = 1'000'000'000;
  command.number("--timeout", options.timeout, 1, kMost, "limit of one run, milliseconds");
  command.number("--memory", options.memory, 1, kMost, "memory limit of a subject, MB");
  command.repeated_option(
      "--env", options.environment,
      "a variable of the environment that the subject is given as well: NAME, or NAME=VALUE");
  command.option("--tolerance", options.tolerance, "tolerance an axis, mm, a decimal");
  command.option("--chord", options.chord, "chord tolerance of arcs, mm, a decimal");
  command.option("--feed-resolution", options.feed_resolution,
                 "what feeds may be rounded to, mm/min or mm/rev, a decimal");
}

void add_subject_options(Command& command, LimitOptions& options) {
  add_run_options(command, options);
  command.option("--feed-tolerance", options.feed_tolerance,
                 "of feeds from sampled positions, percent, a decimal (5)");
  command.option("--blend", options.blend,
                 "by how much sampled positions may cut corners, mm, a decimal (0)");
  command.option("--columns", options.columns,
                 "what the columns of sampled positions are: t=Time[ms],x=X_act:diameter,...");
  command.option("--manifest", options.manifest, "manifest.json of the export, of captured output");
}

void check_capture_options(const LimitOptions& options, const std::vector<std::string>& subjects) {
  const auto is_captured = [](const std::string& one) { return one.starts_with("capture:"); };
  if (std::ranges::any_of(subjects, is_captured)) return;
  const std::pair<std::string_view, const std::string&> given[] = {
      {"--manifest", options.manifest},
      {"--columns", options.columns},
      {"--blend", options.blend},
      {"--feed-tolerance", options.feed_tolerance}};
  for (const auto& [option, value] : given) {
    if (value.empty()) continue;
    throw UsageError(
        fmt::format("{} is of captured output, and no subject is any. Write --subject capture:DIR, "
                    "or leave {} out.",
                    option, option));
  }
}

oracle::Limits LimitOptions::limits() const {
  oracle::Limits limits;
  if (timeout > 0) limits.run = std::chrono::milliseconds(timeout);
  if (memory > 0) limits.memory_bytes = static_cast<std::size_t>(memory) << 20;
  limits.environment = environment;
  limits.show_ids = show_ids;
  limits.stated = stated;
  if (!feed_tolerance.empty()) {
    limits.capture.feed_tolerance =
        *decimal_option(feed_tolerance, "--feed-tolerance", "percent") / 100;
  }
  limits.capture.manifest = manifest;
  limits.capture.blend = length_option(blend, "--blend");
  limits.capture.columns = columns;
  return limits;
}

oracle::Grants LimitOptions::grants() const {
  return {length_option(tolerance, "--tolerance"), length_option(chord, "--chord"),
          feed_option(feed_resolution, "--feed-resolution"), strict};
}

std::optional<reference::Number> decimal_option(const std::string& text, const char* option,
                                                const char* what) {
  if (text.empty()) return std::nullopt;
  auto value = reference::Number::parse(text);
  if (!value || !value->is_rational() || value->sign() < 0) {
    throw UsageError(
        fmt::format("{} takes {} as a decimal, zero or more, not \"{}\".", option, what, text));
  }
  return value;
}

std::optional<reference::Number> length_option(const std::string& text, const char* option) {
  return decimal_option(text, option, "a length in mm");
}

std::optional<reference::Number> feed_option(const std::string& text, const char* option) {
  return decimal_option(text, option, "a feed in mm/min or mm/rev");
}

generate::GeneratorSettings settings_option(const std::string& text) {
  const auto settings = generate::read_settings(text);
  if (!settings) {
    throw UsageError(
        "--settings " + text +
        " cannot be read. Write as valid=1,boundary=2,blocks=4,readings=off; numbers are "
        "named valid, near-invalid, boundary, raw, tiny, blocks, fault-one-in, open-one-in, "
        "turns, rings, layers, pecks, steps, starts; state, readings, parameters, offsets, tools, "
        "pockets are on or off.");
  }
  return *settings;
}

oracle::StatedMachine stated_machine(const ProfileOptions& options) {
  oracle::StatedMachine stated{std::nullopt, options.readings};
  if (!options.file.empty()) stated.profile = load_profile({options.dialect, options.file, {}});
  return stated;
}

void add_sandbox_options(Command& command, SandboxOptions& options, const std::string& by_default) {
  options.wish = by_default;
  command.option("--sandbox", options.wish,
                 fmt::format("run the subject in bubblewrap: auto (where it can be had), off, "
                             "required ({})",
                             by_default));
  command.repeated_option("--bind", options.bound,
                          "a file or folder that the subject sees in its sandbox as well; "
                          "PATH:rw for one that it may change");
}

oracle::Limits sandboxed(oracle::Limits limits, const SandboxOptions& options,
                         const std::string& subject, const std::vector<std::string>& hidden) {
  if (options.wish != "auto" && options.wish != "off" && options.wish != "required") {
    throw UsageError(
        fmt::format("--sandbox takes auto, off or required, not \"{}\".", options.wish));
  }
  if (options.wish == "off" || !starts_processes(subject)) return limits;
  static const oracle::SandboxSearch found = oracle::find_sandbox();
  if (found.program.empty() && options.wish == "required") {
    throw UsageError(fmt::format(
        "--sandbox required: {}. Install it (Debian's package bubblewrap) and allow user "
        "namespaces, or write --sandbox off.",
        found.why_not));
  }
  limits.sandbox.program = found.program;
  for (const std::string& folder : hidden) {
    if (!folder.empty()) limits.sandbox.hidden.push_back(folder);
  }
  for (const std::string& path : options.bound) add_bound(limits.sandbox, path);
  // A build that is measured writes there what ran.
  if (const char* measured = std::getenv("LLVM_PROFILE_FILE")) {
    limits.sandbox.changed.push_back(std::filesystem::absolute(measured).parent_path().string());
  }
  return limits;
}

std::string sandbox_name(const oracle::Limits& limits, const std::string& subject) {
  if (!starts_processes(subject)) return {};
  return limits.sandbox.is_on() ? "bubblewrap" : "none";
}

}  // namespace gonogo::cli
