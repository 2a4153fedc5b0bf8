// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/capture/captured_trace.hpp"

#include <fmt/format.h>

#include <fstream>
#include <vector>

#include "oracle/trace_reader.hpp"

namespace gonogo::oracle {
namespace {

using reference::Record;
using reference::RecordKind;

// Takes the header's own records out.
class HeaderFilter {
 public:
  HeaderFilter(const TraceHeader& header, const RecordSink& sink) : header_(header), sink_(sink) {}

  bool take(Record record) {
    if (record.block != 0) {
      if (record.block <= header_.lines) return true;
      record.block -= header_.lines;
      open_ = false;
    }
    if (header_.lines == 0 || !open_) return flush() && sink_(record);
    if (record.kind == RecordKind::m) {
      held_.push_back(std::move(record));
      return true;
    }
    if (record.kind != RecordKind::rapid) return flush() && sink_(record);
    for (reference::Axis axis : reference::kAllAxes) {
      if (!record.axes.has(axis)) continue;
      at_[reference::index(axis)] = record.to[axis];
    }
    held_.push_back(std::move(record));
    if (arrived()) {
      held_.clear();
      open_ = false;
    }
    return true;
  }
  bool flush() {
    open_ = false;
    for (const Record& record : held_) {
      if (!sink_(record)) return false;
    }
    held_.clear();
    return true;
  }

 private:
  bool arrived() const {
    std::size_t known = 0;
    for (reference::Axis axis : reference::kAllAxes) {
      const auto& at = at_[reference::index(axis)];
      if (!at) continue;
      ++known;
      if (*at != header_.start[axis]) return false;
    }
    return known >= 2;
  }

  const TraceHeader& header_;
  const RecordSink& sink_;
  bool open_ = true;
  std::vector<Record> held_;
  std::array<std::optional<Number>, reference::kAxes> at_;
};

RunEnd protocol(const std::string& path, std::uint64_t line, const std::string& message) {
  return RunEnd::of(RunEnd::Kind::protocol, fmt::format("{}, line {}: {}", path, line, message));
}

}  // namespace

RunEnd read_captured_trace(const std::string& path, const TraceHeader& header,
                           const RecordSink& sink) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return protocol(path, 0, "The file cannot be opened.");
  TraceReader reader;
  HeaderFilter filter(header, sink);
  RunEnd end;
  std::string line;
  for (std::uint64_t number = 1; std::getline(file, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    if (end.kind == RunEnd::Kind::alarm) {
      return protocol(path, number, "The line follows the alarm that closes the trace.");
    }
    TraceLine read = reader.read(line);
    if (auto* fault = std::get_if<TraceFault>(&read)) return protocol(path, number, fault->message);
    if (auto* alarm = std::get_if<SubjectAlarm>(&read)) {
      end.kind = RunEnd::Kind::alarm;
      end.alarm = *alarm;
      if (end.alarm.block > header.lines) end.alarm.block -= header.lines;
      continue;
    }
    if (!filter.take(std::get<Record>(std::move(read)))) {
      end.kind = RunEnd::Kind::stopped;
      return end;
    }
  }
  if (!filter.flush()) end.kind = RunEnd::Kind::stopped;
  return end;
}

}  // namespace gonogo::oracle
