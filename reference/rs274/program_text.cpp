// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rs274/program_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "reference/clause_literal.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::reference::rs274 {
namespace {

constexpr std::uint64_t kMostOfNist = 99'999;  // of a line number

bool is_blank(const grammar::Block& block) {
  return !block.tape_mark && !block.skip && !block.sequence_number && !block.program_number &&
         !block.outside && block.words.empty() && block.comments.empty() &&
         block.line_comment.span.end == 0;
}

// "(abort," in either case and with blanks.
bool begins_with_abort(std::string_view comment) {
  constexpr std::string_view kAbort = "abort,";
  std::size_t found = 0;
  for (const char byte : comment) {
    if (byte == ' ' || byte == '\t') continue;
    const char small = byte >= 'A' && byte <= 'Z' ? static_cast<char>(byte - 'A' + 'a') : byte;
    if (small != kAbort[found]) return false;
    if (++found == kAbort.size()) return true;
  }
  return false;
}

bool is_whole_to_99999(const grammar::Decimal& number) {
  return number.scale == 0 && number.long_digits.empty() && number.magnitude <= kMostOfNist;
}

}  // namespace

// NGC-COM-07
void ProgramText::take(const grammar::Block& block, BlockOutput& out) {
  if (block.tape_mark) {
    if (!has_line_) {
      is_opened_ = true;
    } else if (is_opened_) {
      out.program_end = true;
    } else {
      out.alarms.push_back({AlarmClass::syntax,
                            "NGC-COM-07"_clause,
                            0,
                            {},
                            "A % line stands only before everything else, and a second one at "
                            "the end of a program that begins with one."});
    }
  }
  has_line_ = has_line_ || !is_blank(block);
}

void check_numbers(const grammar::Block& block, const ReadingsInUse& readings, BlockOutput& out) {
  // NGC-COM-05
  if (block.sequence_number && !is_whole_to_99999(*block.sequence_number) &&
      readings.is("ngc.line-number=whole"_reading)) {
    out.alarms.push_back({AlarmClass::syntax, "NGC-COM-05"_clause, 'N', block.number_place.span,
                          "A line number is whole and at most 99999."});
  }
  // NGC-COM-06
  if (block.program_number && readings.is("ngc.o-name=syntax"_reading)) {
    out.alarms.push_back({AlarmClass::syntax, "NGC-COM-06"_clause, 'O', block.number_place.span,
                          "A line that only names the program is not read."});
  }
}

// NGC-COM-10: the last comment in brackets alone is looked at.
void check_abort(const grammar::Block& block, BlockOutput& out) {
  const auto last = std::find_if(block.comments.rbegin(), block.comments.rend(),
                                 [](const auto& comment) { return !comment.to_end_of_line; });
  if (last == block.comments.rend() || !begins_with_abort(last->text)) return;
  out.alarms.push_back({AlarmClass::program_end, "NGC-COM-10"_clause, 0, last->where,
                        "The program ends itself here with an error."});
}

// NGC-COM-08
void check_text_end(const grammar::Span& end, std::string_view skipped,
                    const ReadingsInUse& readings, BlockOutput& out) {
  if (readings.is("ngc.program-end=free"_reading)) return;
  std::string message = "A program ends with M2 or M30, or with the second of two % lines.";
  if (!skipped.empty()) {
    message +=
        fmt::format(" What ends O{} does not come: all lines behind it were skipped.", skipped);
  }
  out.alarms.push_back({AlarmClass::program_end, "NGC-COM-08"_clause, 0, end, std::move(message)});
}

}  // namespace gonogo::reference::rs274
