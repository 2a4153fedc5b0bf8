// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "oracle/subjects/text.hpp"

namespace gonogo::oracle {

// A program as JSON: a string when it is UTF-8, else {"base64": "..."}.
inline nlohmann::ordered_json program_json(std::string_view program) {
  if (is_utf8(program)) return program;
  return {{"base64", base64(program)}};
}

}  // namespace gonogo::oracle
