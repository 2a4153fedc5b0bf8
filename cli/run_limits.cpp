// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/run_limits.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "campaign/results_reader.hpp"
#include "publish/report/command.hpp"
#include "publish/report/json_value.hpp"

namespace gonogo::cli {
namespace {

using Json = nlohmann::ordered_json;
using oracle::ResultsReader;

std::string last_of(const Json& argv, std::string_view option) {
  const auto values = oracle::report::option_values(argv, option);
  return values.empty() ? std::string() : values.back();
}

// 0: the default.
long limit_of(const Json& argv, std::string_view option) {
  return std::strtol(last_of(argv, option).c_str(), nullptr, 10);
}

[[noreturn]] void refuse(const std::string& journal, std::string_view option, long begun,
                         long now) {
  throw UsageError(
      fmt::format("{} is of a run with {} {}, this one has {}. Run the command that it was begun "
                  "with, or leave --resume out to begin anew.",
                  journal, option, begun, now));
}

}  // namespace

LimitOptions limits_of_run(const Json& header) {
  LimitOptions limits;
  const Json argv = oracle::report::run_argv(header);
  limits.timeout = limit_of(argv, "--timeout");
  limits.memory = limit_of(argv, "--memory");
  limits.environment = oracle::report::option_values(argv, "--env");
  limits.sandbox.bound = oracle::report::option_values(argv, "--bind");
  limits.columns = last_of(argv, "--columns");
  limits.manifest = last_of(argv, "--manifest");
  // Shards may have had them in other words; the header holds these.
  limits.blend = oracle::report::text_of(header, "blend");
  limits.feed_tolerance = oracle::report::text_of(header, "feed_tolerance");
  // A run of before the header said so has them in its command line alone.
  if (limits.feed_tolerance.empty()) limits.feed_tolerance = last_of(argv, "--feed-tolerance");
  limits.show_ids = header.value("show_ids", Json(false)) == true ||
                    oracle::report::is_flag_set(argv, "--show-ids");
  if (header.value("sandbox", Json()) == "bubblewrap") limits.sandbox.wish = "auto";
  return limits;
}

void need_same_limits(const std::string& journal, const LimitOptions& limits) {
  oracle::Limits begun;
  try {
    begun = limits_of_run(ResultsReader(journal, ResultsReader::Order::as_run).header()).limits();
  } catch (const oracle::ResultsError&) {
    return;
  }
  const oracle::Limits now = limits.limits();
  if (begun.run != now.run) refuse(journal, "--timeout", begun.run.count(), now.run.count());
  if (begun.memory_bytes != now.memory_bytes) {
    constexpr int kMegabyte = 20;
    refuse(journal, "--memory", static_cast<long>(begun.memory_bytes >> kMegabyte),
           static_cast<long>(now.memory_bytes >> kMegabyte));
  }
}

}  // namespace gonogo::cli
