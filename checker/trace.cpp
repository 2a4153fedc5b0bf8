// SPDX-License-Identifier: GPL-3.0-or-later
#include "checker/trace.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "checker/profile.hpp"

namespace gonogo::checker {
namespace {

bool is_alarm(const Json& value) {
  return value.text_of("k") == "alarm";
}

void take(const Json& value, Trace& trace) {
  if (trace.end) throw Fault("A record follows the end.");
  Record record = read_record(value);
  if (record.kind == RecordKind::end) {
    trace.end = record.to;
  } else {
    trace.records.push_back(std::move(record));
  }
}

std::optional<Rational> declared(const Json& numeric, std::string_view key) {
  const Json* found = numeric.find(key);
  if (found == nullptr) return std::nullopt;
  return parse_rational(found->text);
}

}  // namespace

Tolerances tolerances_of(const Json& header, std::string_view dialect, const Json& profile) {
  const Json& subject = header.member("subject", Json::Kind::object);
  const Json none;
  const Json* found = subject.find("numeric");
  const Json& numeric = found == nullptr ? none : *found;
  Tolerances tolerances;
  Rational tolerance = resolution(dialect, profile);
  const Rational least = tolerance;  // increment of the machine: the most that a declaration counts
  tolerances.resolution = declared(numeric, "resolution");
  if (tolerances.resolution && *tolerances.resolution > least) tolerances.resolution = least;
  if (tolerances.resolution && *tolerances.resolution < tolerance)
    tolerance = *tolerances.resolution;
  const Json* set = header.find("tolerance");
  if (set != nullptr && set->is(Json::Kind::text)) tolerance = parse_rational(set->text);
  tolerances.tolerance = tolerance;
  tolerances.feed_resolution = declared(numeric, "feed_resolution");
  if (tolerances.feed_resolution && *tolerances.feed_resolution > least)
    tolerances.feed_resolution = least;
  const Json* feeds = header.find("feed_resolution");
  if (feeds != nullptr && feeds->is(Json::Kind::text)) {
    tolerances.feed_resolution = parse_rational(feeds->text);
  }
  const Json* kind = numeric.find("kind");
  tolerances.increment = least;
  tolerances.is_binary64 = kind != nullptr && kind->text == "binary64";
  tolerances.is_exact = kind != nullptr && kind->text == "exact";
  const std::vector<std::string> features = subject.texts_at("features");
  const auto lists = [&](const char* feature) {
    return std::ranges::find(features, feature) != features.end();
  };
  tolerances.has_blocks = lists("blocks");
  tolerances.has_functions = lists("m");
  return tolerances;
}

std::optional<Trace> read_trace_file(const std::string& path) {
  if (!std::filesystem::exists(path)) return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Fault(path + " cannot be opened.");
  Trace trace;
  std::string line;
  for (std::size_t number = 1; std::getline(file, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    try {
      if (trace.ending == TraceEnd::alarm) throw Fault("A line follows the alarm.");
      const Json value = parse_json(line);
      if (is_alarm(value)) {
        trace.ending = TraceEnd::alarm;
        trace.alarm = read_alarm(value);
      } else {
        take(value, trace);
      }
    } catch (const Fault& fault) {
      throw Fault(path + ", line " + std::to_string(number) + ": " + fault.what());
    }
  }
  return trace;
}

Trace trace_of_line(const Json& line) {
  Trace trace;
  trace.ending = TraceEnd::unknown;
  for (const Json& value : line.member("trace", Json::Kind::list).items) take(value, trace);
  const Json* got = line.find("got");
  if (got == nullptr || !got->text.starts_with("{\"k\":\"alarm\"")) return trace;
  trace.ending = TraceEnd::alarm;
  trace.alarm = read_alarm(parse_json(got->text));
  return trace;
}

}  // namespace gonogo::checker
