// SPDX-License-Identifier: GPL-3.0-or-later
//
// The reply to `run`, one line of it.
#pragma once

#include "oracle/records/json_document.hpp"
#include "oracle/records/trace_reader.hpp"

namespace gonogo::oracle {

struct PipeReply {
  bool more = false;  // further parts follow; there is no outcome yet
  RunEnd::Kind outcome = RunEnd::Kind::ok;
  std::optional<simdjson::dom::array> records;  // in the document that was read
  SubjectAlarm alarm;
  std::string feature;
  std::string message;
  std::string notes;  // of this run alone
};

std::variant<PipeReply, TraceFault> read_pipe_reply(const simdjson::dom::object& reply,
                                                    std::int64_t seq);

}  // namespace gonogo::oracle
