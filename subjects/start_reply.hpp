// SPDX-License-Identifier: GPL-3.0-or-later
//
// The reply to `start`, which the C interface gives as its description too.
#pragma once

#include "oracle/records/json_document.hpp"
#include "subjects/make_subject.hpp"

namespace gonogo::oracle {

std::variant<SubjectInfo, JsonFault> read_start_reply(const simdjson::dom::object& reply);

// The description of the C interface. Throws SubjectUnusable.
SubjectInfo read_description(std::string_view text);

}  // namespace gonogo::oracle
