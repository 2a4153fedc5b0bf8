// SPDX-License-Identifier: GPL-3.0-or-later
//
// NGC-OWD-13: M98 and M99, subprograms with numbers.
#include <algorithm>

#include "grammar/parser.hpp"
#include "reference/clause_literal.hpp"
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

// NGC-OWD-13: the lines behind O and the number up to the last M99 before another O.
OWords::Found OWords::find_numbered(std::int64_t number, Text& text) {
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
    } else if (is_found) {
      text.push_back(line);
      if (has_m99(scratch_)) end = text.size();
    }
  }
  text.resize(end);
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
    called_at_ = current_->text;
    current_->text = called_at_;  // the source forgets the line
    Text text;
    const Found what =
        subs_.contains(std::to_string(number)) ? Found::another_style : find_numbered(number, text);
    if (what == Found::nowhere) {
      return leave("No subprogram of this number, with its M99, stands behind the call.");
    }
    if (what == Found::another_style) {
      out.alarms.push_back({AlarmClass::syntax, "NGC-OWD-13"_clause, 'M', where,
                            "M98 calls O and a number up to M99, not a subroutine with sub or "
                            "endsub."});
      return;
    }
    found = numbered_.emplace(number, std::move(text)).first;
  }
  if (times == 0) return;
  levels_.push_back({std::to_string(number), &found->second, 0, {}, true, times});
}

void OWords::end_numbered(std::uint64_t line, const grammar::Span& where, BlockOutput& out) {
  Level& level = levels_.back();
  if (is_main()) {
    out.not_covered = NotCovered{
        line, "M99", "The program begins again here without an end, which the gauge does not read.",
        where};
    return;
  }
  if (!level.is_numbered) {
    out.alarms.push_back({AlarmClass::syntax, "NGC-OWD-13"_clause, 'M', where,
                          "M99 ends no subroutine that begins with sub."});
    return;
  }
  level.at = 0;
  level.open.clear();
  if (--level.left == 0) levels_.pop_back();
  forget();
}

}  // namespace gonogo::reference::rs274
