// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string_view>
#include <utility>

#include "reference/dialect.hpp"

namespace gonogo::cli {

Shard shard_option(const std::string& text) {
  Shard shard;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%u/%u%c", &shard.number, &shard.of, &rest) != 2 ||
      shard.number < 1 || shard.number > shard.of) {
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

void add_tolerance_options(Command& command, LimitOptions& options) {
  command.option("--tolerance", options.tolerance, "tolerance an axis, mm, a decimal");
  command.option("--chord", options.chord, "chord tolerance of arcs, mm, a decimal");
  command.option("--feed-resolution", options.feed_resolution,
                 "what feeds may be rounded to, mm/min or mm/rev, a decimal");
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
  add_tolerance_options(command, options);
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

}  // namespace gonogo::cli
