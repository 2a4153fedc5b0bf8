// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "oracle/records/text.hpp"

namespace gonogo::oracle {

// A program as JSON: a string when it is UTF-8, else {"base64": "..."}.
inline nlohmann::ordered_json program_json(std::string_view program) {
  if (is_utf8(program)) return program;
  return {{"base64", base64(program)}};
}

// JSON with U+FFFD for bytes that are not UTF-8: on one line, or a line a member, indented.
inline std::string dump(const nlohmann::ordered_json& value, int indent = -1) {
  return value.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace gonogo::oracle
