// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texts on their way to and from a subject: JSON strings, base64, bytes that are not UTF-8, and
// words of a shell command.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace gonogo::oracle {

bool is_utf8(std::string_view text);

// A JSON string with its quotes. REQUIRES: is_utf8(text).
void append_json_string(std::string_view text, std::string& out);

// Base64 (RFC 4648 section 4: with padding, without blanks, unused bits zero), and the bytes of
// it; nothing when the text is none.
std::string base64(std::string_view bytes);
std::optional<std::string> decode_base64(std::string_view text);

// The same text with U+FFFD for each byte that is not part of well-formed UTF-8.
std::string readable(std::string_view bytes);

// A text of others for people, at a terminal or in a log: readable, with what would move the
// cursor, turn the writing or hide in it written out, as \n or \u{202e}. What is visible stays as
// it is.
enum class Lines { shown, kept };  // line ends and tabs: as \n and \t, or as they are
std::string visible(std::string_view bytes, Lines lines = Lines::shown);

// At most `limit` bytes of a text for a message, visible, with "..." when it was cut.
std::string excerpt(std::string_view bytes, std::size_t limit = 120);

// "2026-03-14 22:41 UTC"
std::string date_text(std::chrono::system_clock::time_point time);

// One word of a POSIX shell command.
std::string shell_quoted(std::string_view word);

}  // namespace gonogo::oracle
