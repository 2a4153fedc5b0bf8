// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>

#include "grammar/parser.hpp"
#include "grammar/utf8.hpp"

namespace gonogo::grammar {
namespace {

constexpr std::size_t kWindow = 100;  // cells of the line that are shown
constexpr std::string_view kIndent = "    ";
constexpr std::string_view kCut = "...";
constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

// One character as it is shown: tabs as one blank, so that the caret stays in its place.
struct Glyph {
  std::string_view text;
  std::size_t width = 1;
  std::size_t bytes = 1;
};

Glyph glyph_at(std::string_view line, std::size_t offset) {
  if (line[offset] == '\t') return {" "};
  const Character character = decode_character(line, offset);
  if (!character.valid || !is_printable(character.code_point)) {
    return {kReplacement, 1, character.length};
  }
  return {line.substr(offset, character.length), cells(character.code_point), character.length};
}

std::size_t width_of(std::string_view line) {
  std::size_t width = 0;
  for (std::size_t offset = 0; offset < line.size();) {
    const Glyph glyph = glyph_at(line, offset);
    width += glyph.width;
    offset += glyph.bytes;
  }
  return width;
}

// The part of a line that is shown, and the cell in it that `fault` cells of the line come before.
struct Excerpt {
  std::string text;
  std::size_t caret = 0;
};

Excerpt excerpt(std::string_view line, std::size_t fault, std::size_t total) {
  const std::size_t most = total > kWindow ? total - kWindow : 0;
  const std::size_t from = std::min(fault > kWindow / 2 ? fault - kWindow / 2 : 0, most);
  const std::size_t to = from + kWindow;

  Excerpt out;
  if (from > 0) out.text = kCut;
  std::size_t before = from;  // cells that are left out; one more when a wide character is cut
  std::size_t cell = 0;
  for (std::size_t offset = 0; offset < line.size() && cell < to;) {
    const Glyph glyph = glyph_at(line, offset);
    if (cell < from) {
      before = std::max(before, cell + glyph.width);
    } else if (cell + glyph.width <= to) {
      out.text += glyph.text;
    }
    cell += glyph.width;
    offset += glyph.bytes;
  }
  if (to < total) out.text += kCut;
  out.caret = fault - before + (from > 0 ? kCut.size() : 0);
  return out;
}

}  // namespace

std::string render(std::string_view message, const Span& where, std::string_view file,
                   std::uint64_t line_number, std::string_view line) {
  const std::size_t begin = std::min<std::size_t>(where.begin, line.size());
  const std::size_t fault = width_of(line.substr(0, begin));
  const Excerpt shown = excerpt(line, fault, width_of(line));
  std::string out(file);
  out.append(":").append(std::to_string(line_number));
  out.append(":").append(std::to_string(begin + 1)).append(": ");
  out.append(message).append("\n");
  out.append(kIndent).append(shown.text).append("\n");
  out.append(kIndent).append(shown.caret, ' ').append("^\n");
  return out;
}

std::string render(const SyntaxError& error, std::string_view file, std::uint64_t line_number,
                   std::string_view line) {
  return render("error: " + message(error), error.where, file, line_number, line);
}

}  // namespace gonogo::grammar
