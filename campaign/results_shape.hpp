// SPDX-License-Identifier: GPL-3.0-or-later
//
// The kinds of the values in a header and a footer. The reader of results asks once, so that
// all who take a value from there need not ask again.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace gonogo::oracle {

// What is wrong, as the rest of a sentence: "has no list of texts at /argv". Nothing: every value
// that is there is of its kind. Keys that the format does not have are not looked at.
std::optional<std::string> header_fault(const nlohmann::ordered_json& header);
std::optional<std::string> footer_fault(const nlohmann::ordered_json& footer);
// A key that the format does not have, as a place: "/subject/colour". Empty: there is none.
std::string header_surplus(const nlohmann::ordered_json& header);
std::string footer_surplus(const nlohmann::ordered_json& footer);

}  // namespace gonogo::oracle
