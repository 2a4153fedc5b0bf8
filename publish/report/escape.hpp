// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text from programs, subjects and results files is not to be trusted: with any content it comes
// out of here as text.
#pragma once

#include <string>
#include <string_view>

namespace gonogo::oracle::report {

// For XML and HTML text and quoted attributes. Bytes that are not UTF-8, and characters that XML
// does not have, become U+FFFD; what hides in a text or turns it is written out.
std::string markup_text(std::string_view bytes);

// Makes a JSON text safe inside <script>: no '<', '>' or '&' remains.
std::string script_json(std::string_view json);

// A value in an address, behind its '#': what is no plain character in percents.
std::string address_text(std::string_view text);

// The first `most` characters, with an ellipsis when some are left out.
std::string shortened(std::string_view text, std::size_t most);

// Base64 of bytes that are given as hexadecimal digits.
std::string base64_of_hex(std::string_view hex);

}  // namespace gonogo::oracle::report
