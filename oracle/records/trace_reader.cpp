// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/records/trace_reader.hpp"

#include "oracle/records/json_document.hpp"
#include "oracle/records/plain_record.hpp"
#include "oracle/records/record_json.hpp"

namespace gonogo::oracle {

struct TraceReader::Impl {
  TraceLine read(std::string_view line) {
    auto parsed = document.parse(line);
    if (auto* fault = std::get_if<JsonFault>(&parsed)) return TraceFault{std::move(fault->message)};
    return read_trace_line(std::get<simdjson::dom::object>(parsed));
  }
  JsonDocument document;
};

TraceReader::TraceReader() : impl_(std::make_unique<Impl>()) {}
TraceReader::~TraceReader() = default;

TraceLine TraceReader::read(std::string_view line) {
  TraceLine result;
  if (!read_plain_record(line, std::get<reference::Record>(result))) result = impl_->read(line);
  return result;
}

}  // namespace gonogo::oracle
