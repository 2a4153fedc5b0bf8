// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/captured_trace.hpp"

#include <fmt/format.h>

#include <fstream>
#include <vector>

#include "oracle/records/input_file.hpp"
#include "oracle/records/trace_reader.hpp"

namespace gonogo::oracle {
namespace {

using reference::Record;
using reference::RecordKind;

// Takes the header's own records out.
class HeaderFilter {
 public:
  HeaderFilter(const TraceHeader& header, const RecordSink& sink) : header_(header), sink_(sink) {}

  bool take(Record record) {
    if (is_of_header(record)) {
      note(record);
      return true;
    }
    if (record.block != 0) {
      record.block -= header_.lines;
      open_ = false;
    }
    begun_ = begun_ || !open_;
    if (header_.lines == 0 || !open_) return flush() && sink_(record);
    if (record.kind == RecordKind::m) {
      held_.push_back(std::move(record));
      return true;
    }
    if (record.kind != RecordKind::rapid) return flush() && sink_(record);
    note(record);
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

  // Why the record cannot stand where it does: of the header, amid the program or after it; or the
  // program's first, where the header has not led to its start.
  std::optional<std::string> fault(const Record& record) const {
    if (is_of_header(record)) {
      if (!begun_) return std::nullopt;
      return fmt::format("The record belongs to line {} of the header, but the program has begun.",
                         record.block);
    }
    if (begun_ || record.block == 0) return std::nullopt;
    for (const reference::Axis axis : reference::kAllAxes) {
      const auto& at = at_[reference::index(axis)];
      if (!at || abs(*at - header_.start[axis]) <= header_.tolerance) continue;
      return fmt::format("The header ends at {}{}, and the program starts at {}.", letter(axis),
                         at->text(), header_.start[axis].text());
    }
    return std::nullopt;
  }

 private:
  bool is_of_header(const Record& record) const {
    return record.block != 0 && record.block <= header_.lines;
  }
  void note(const Record& record) {
    if (!is_motion(record.kind)) return;
    for (reference::Axis axis : reference::kAllAxes) {
      if (record.axes.has(axis)) at_[reference::index(axis)] = record.to[axis];
    }
  }
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
  bool begun_ = false;  // a record of the program has come
  std::vector<Record> held_;
  std::array<std::optional<Number>, reference::kAxes> at_;
};

RunEnd protocol(const std::string& path, std::uint64_t line, const std::string& message) {
  return RunEnd::of(RunEnd::Kind::protocol, fmt::format("{}, line {}: {}", path, line, message));
}

}  // namespace

void leave_header(SubjectAlarm& alarm, std::uint64_t lines) {
  if (alarm.block == 0) return;
  alarm.before_program = alarm.block <= lines;
  if (!alarm.before_program) alarm.block -= lines;
}

RunEnd read_captured_trace(const std::string& path, const TraceHeader& header,
                           const RecordSink& sink) {
  std::ifstream file = open_regular(path);
  if (!file) return protocol(path, 0, "The file cannot be opened.");
  file.exceptions(std::ios::badbit);  // what cannot be read is not the end of the trace
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
      leave_header(end.alarm, header.lines);
      continue;
    }
    auto& record = std::get<Record>(read);
    if (const auto fault = filter.fault(record)) return protocol(path, number, *fault);
    if (!filter.take(std::move(record))) {
      end.kind = RunEnd::Kind::stopped;
      return end;
    }
  }
  if (!filter.flush()) end.kind = RunEnd::Kind::stopped;
  return end;
}

}  // namespace gonogo::oracle
