// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/recorded_trace.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>

#include "grammar/file_source.hpp"
#include "oracle/records/trace_reader.hpp"

namespace gonogo::cli {
namespace {

bool is_blank(std::string_view line) {
  return line.find_first_not_of(" \t") == std::string_view::npos;
}

oracle::RunEnd fault(std::string message) {
  return oracle::RunEnd::of(oracle::RunEnd::Kind::protocol, std::move(message));
}

// The records of a trace, except lines that `knows` says true of, until `take` says false, and how
// it ends.
template <typename Knows, typename Take>
oracle::RunEnd read_records(int descriptor, const Knows& knows, const Take& take) {
  grammar::FileSource bytes(descriptor);
  grammar::LineSource lines(bytes);
  grammar::Line line;
  oracle::TraceReader reader;
  oracle::RunEnd end;
  while (lines.next(line)) {
    if (end.kind != oracle::RunEnd::Kind::alarm && knows(line.text)) continue;
    if (is_blank(line.text)) continue;
    if (end.kind == oracle::RunEnd::Kind::alarm) {
      return fault(
          fmt::format("Line {} of the trace follows the alarm that closes it.", line.number));
    }
    oracle::TraceLine read = reader.read(line.text);
    if (auto* record = std::get_if<reference::Record>(&read)) {
      if (!take(*record)) return end;
    } else if (auto* alarm = std::get_if<oracle::SubjectAlarm>(&read)) {
      end.kind = oracle::RunEnd::Kind::alarm;
      end.alarm = std::move(*alarm);
    } else {
      return fault(fmt::format("Line {} of the trace: {}", line.number,
                               std::get<oracle::TraceFault>(read).message));
    }
  }
  return end;
}

}  // namespace

// At its beginning and its end: line numbers stand everywhere or nowhere, and the M functions of
// most programs are those of a spindle and M30.
TraceFeatures RecordedTrace::likely_features() const {
  std::array<char, 1 << 16> chunk;
  TraceFeatures features;
  struct stat status {};
  if (::fstat(file_.descriptor(), &status) != 0) return features;
  const auto size = static_cast<off_t>(chunk.size());
  for (const off_t at : {off_t{0}, std::max(status.st_size - size, off_t{0})}) {
    const ssize_t count = ::pread(file_.descriptor(), chunk.data(), chunk.size(), at);
    const std::string_view text(chunk.data(), count < 0 ? 0 : static_cast<std::size_t>(count));
    features.blocks = features.blocks || text.find("\"b\"") != std::string_view::npos;
    features.m = features.m || text.find("\"m\"") != std::string_view::npos;
  }
  return features;
}

TraceSummary RecordedTrace::read(const std::function<void(const reference::Record&)>& take,
                                 const std::function<bool(std::string_view)>& knows) {
  TraceSummary summary;
  records_ = 0;
  const auto count_known = [&](std::string_view line) {
    if (!knows || !knows(line)) return false;
    ++records_;
    summary.features.blocks = true;
    return true;
  };
  const auto count = [&](const reference::Record& record) {
    ++records_;
    summary.features.blocks = summary.features.blocks || record.block != 0;
    summary.features.m = summary.features.m || record.kind == reference::RecordKind::m;
    take(record);
    return true;
  };
  summary.end = read_records(file_.descriptor(), count_known, count);
  // For an alarm that is the only record; others without a line say that the subject has none.
  if (records_ == 0) summary.features.blocks = summary.end.alarm.block != 0;
  return summary;
}

void RecordedTrace::each(const std::function<bool(const reference::Record&)>& take) const {
  read_records(
      file_.descriptor(), [](std::string_view) { return false; }, take);
}

}  // namespace gonogo::cli
