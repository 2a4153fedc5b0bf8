// SPDX-License-Identifier: GPL-3.0-or-later
//
// The facade of the grammar: a line of NC text in, a block or a located error out. The Spirit
// grammars behind it are included by nobody outside grammar/.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "grammar/ast.hpp"

namespace gonogo::grammar {

// Parses one line (without its end). Returns nothing and fills `block`, or returns the error and
// leaves `block` unspecified. `block` is reused: its memory is kept.
[[nodiscard]] std::optional<SyntaxError> parse_block(Dialect dialect, std::string_view line,
                                                     Block& block);

// The error of a line above kMaximumLine bytes. parse_block gives it too, but a LineSource has only
// the beginning of such a line (Line::too_long).
SyntaxError line_too_long();

// Whether the line is beyond what the gauge reads. No text forbids it, so that it is no alarm.
bool is_limit_of_gauge(const SyntaxError& error);

// Writes a block so that parse_block of the same dialect reads the same tree again: words first,
// then comments, a program number as O, and for an outside construct, whose text is not in the
// tree, a short one of the same name. Values are written with the fewest brackets, calls without
// their arguments. The tree is one that parse_block of that dialect can give (no ')' in a comment,
// one comment to the end of the line, ...).
std::string print(Dialect dialect, const Block& block);
// Appends the number: -12.50.
void print(const Decimal& value, std::string& out);

// The stable name of a code ("number-expected"), and a whole sentence for people.
std::string_view name(SyntaxCode code);
std::string message(const SyntaxError& error);

// The message with file, line, column, the line itself and a caret under the fault. Bytes that are
// not printable are shown as one replacement sign each, and a long line is cut around the fault.
// Three lines, each with its line feed; the column counts bytes from 1.
// The same for any message about a place of a line.
std::string render(std::string_view message, const Span& where, std::string_view file,
                   std::uint64_t line_number, std::string_view line);
std::string render(const SyntaxError& error, std::string_view file, std::uint64_t line_number,
                   std::string_view line);

}  // namespace gonogo::grammar
