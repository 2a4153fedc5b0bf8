// SPDX-License-Identifier: GPL-3.0-or-later
//
// NGC-OWD-13, NGC-OWD-14: M98 and M99, subprograms with numbers.
#include <algorithm>
#include <utility>

#include "grammar/parser.hpp"
#include "reference/clause_literal.hpp"
#include "reference/reading_literal.hpp"
#include "reference/rs274/o_words.hpp"

namespace gonogo::reference::rs274 {
namespace {

// A program number as a label; nothing where the block has none, or one that is not small.
std::optional<std::int64_t> program_number_of(const grammar::Block& block) {
  if (!block.program_number) return std::nullopt;
  return to_number(*block.program_number).to_int64();
}

bool has_m99(const grammar::Block& block) {
  return std::ranges::any_of(block.words, [](const grammar::Word& word) {
    return word.address == 'M' && word.terms.count == 0 && to_number(word.value) == Number(99);
  });
}

}  // namespace

void refuse_style(char word, const grammar::Span& where, std::string message, BlockOutput& out) {
  out.alarms.push_back({AlarmClass::syntax, "NGC-OWD-13"_clause, word, where, std::move(message)});
}

// NGC-OWD-13: the lines behind O and the number up to the last M99 before another O.
OWords::Found OWords::find_numbered(std::int64_t number, Sub& found) {
  bool is_found = false;
  std::size_t end = 0;
  for (std::size_t at = levels_.front().at; at < tape_.size() || remember_next(); ++at) {
    const StoredLine& line = tape_[at];
    if (is_tape_mark(line.text)) break;
    if (grammar::parse_block(grammar::Dialect::rs274, line.text, scratch_)) scratch_.clear();
    const grammar::Control* const control = scratch_.control ? &*scratch_.control : nullptr;
    const bool is_same = control != nullptr && control->label == std::to_string(number);
    if (is_same && (is_found || control->kind == grammar::ControlKind::sub))
      return Found::another_style;
    if (scratch_.program_number) {
      if (is_found) break;
      is_found = program_number_of(scratch_) == number;
      found.line = line.number;
    } else if (is_found) {
      found.text.push_back(line);
      if (has_m99(scratch_)) end = found.text.size();
    }
  }
  found.text.resize(end);
  return end == 0 ? Found::nowhere : Found::here;
}

// Whether a line of the number stands in the lines that are kept.
bool OWords::is_numbered_behind(const std::string& label) {
  return std::ranges::any_of(tape_, [&](const StoredLine& line) {
    if (grammar::parse_block(grammar::Dialect::rs274, line.text, scratch_)) return false;
    const std::optional<std::int64_t> number = program_number_of(scratch_);
    return number && std::to_string(*number) == label;
  });
}

// NGC-OWD-13
void OWords::call_numbered(const BlockWords& words, const grammar::Span& where, BlockOutput& out) {
  is_used_ = true;
  const auto leave = [&](std::string message) {
    out.not_covered = NotCovered{current_->number, "M98", std::move(message), where};
  };
  const std::int64_t number = words.written('P').to_int64().value_or(-1);
  const std::int64_t times = words.has('L') ? words.written('L').to_int64().value_or(-1) : 1;
  if (number < 0 || times < 0) return leave("The gauge does not read numbers as large as these.");
  if (levels_.size() > kMostCalls) return leave("The gauge follows nine calls in each other.");
  auto found = numbered_.find(number);
  if (found == numbered_.end()) {
    keep_current();
    Sub sub;
    const Found what =
        subs_.contains(std::to_string(number)) ? Found::another_style : find_numbered(number, sub);
    if (what == Found::nowhere) {
      return leave("No subprogram of this number, with its M99, stands behind the call.");
    }
    if (what == Found::another_style) {
      refuse_style('M', where,
                   "M98 calls O and a number up to M99, not a subroutine with sub or endsub.", out);
      return;
    }
    found = numbered_.emplace(number, std::move(sub)).first;
  }
  if (times == 0) return;
  // NGC-OWD-14
  if (found->second.line < current_->number && readings_.is("ngc.m98-before=syntax"_reading)) {
    out.alarms.push_back({AlarmClass::syntax, "NGC-OWD-14"_clause, 'M', where,
                          "The subprogram stands before the line that calls it."});
    return;
  }
  enter({std::to_string(number), &found->second.text, 0, {}, true, times});
}

void OWords::end_numbered(std::uint64_t line, const grammar::Span& where, BlockOutput& out) {
  if (is_main()) {
    out.not_covered = NotCovered{
        line, "M99", "The program begins again here without an end, which the gauge does not read.",
        where};
    return;
  }
  if (!levels_.back().is_numbered) {
    refuse_style('M', where, "M99 ends no subroutine that begins with sub.", out);
    return;
  }
  Level again = std::move(levels_.back());
  leave();
  // Each pass is a call of its own.
  if (--again.left > 0) {
    again.at = 0;
    again.open.clear();
    enter(std::move(again));
  }
  forget();
}

}  // namespace gonogo::reference::rs274
