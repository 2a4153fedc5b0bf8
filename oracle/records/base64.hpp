// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gonogo::oracle {

// The bytes of canonical base64 (RFC 4648 section 4: with padding, without blanks, unused bits
// zero); nothing when the text is none.
std::optional<std::string> decode_base64(std::string_view text);

}  // namespace gonogo::oracle
