// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/expander.hpp"

#include <algorithm>

#include "grammar/byte_set.hpp"
#include "reference/dialect.hpp"
#include "reference/range.hpp"

namespace gonogo::reference {

namespace {

constexpr std::uint64_t kMostOfACycle = 10'000'000;

NotCovered too_many_motions(std::uint64_t line) {
  return {line, "motions", "The cycle has more motions than the gauge follows, 10,000,000.", {}};
}

Record end_record(const Position& position, ClauseId clause) {
  Record end = record_of(RecordKind::end, 0, clause);
  end.axes = kEveryAxis;
  end.to = position;
  return end;
}

// A block behind '/' is skipped, and nothing in it is wrong but what a reading says.
bool is_skipped(const grammar::Line& line) {
  const std::size_t first = line.text.find_first_not_of(" \t");
  return !line.too_long && first != std::string_view::npos && line.text[first] == '/';
}

// Whether what cannot be read is a sign behind another, or an '=' behind G: elsewhere such things
// are values and codes.
bool is_disputed(const grammar::Line& line, const grammar::SyntaxError& error) {
  if (line.too_long || error.where.begin >= line.text.size()) return false;
  const auto is_sign = [&](std::size_t place) {
    return line.text[place] == '+' || line.text[place] == '-';
  };
  const std::string_view before = line.text.substr(0, error.where.begin);
  const std::size_t last = before.find_last_not_of(" \t");
  if (last == std::string_view::npos) return false;
  const char letter = line.text[last];
  const bool is_code = line.text[error.where.begin] == '=' && (letter == 'G' || letter == 'g');
  return is_code || (is_sign(error.where.begin) && is_sign(last));
}

// Whether a block that cannot be read has letters at fault alone: it is one in capitals.
bool is_read_in_capitals(grammar::Dialect dialect, const grammar::Line& line) {
  if (line.too_long) return false;
  std::string capitals(line.text);
  for (char& letter : capitals) letter = grammar::capital_of(letter);
  grammar::Block block;
  return capitals != line.text && !grammar::parse_block(dialect, capitals, block);
}

// What the alarm of a block that cannot be read stands on.
ClauseId clause_of(const Dialect& dialect, const grammar::Line& line,
                   const grammar::SyntaxError& error) {
  const bool may_be_read = dialect.lower_case_clause != kNoClause;
  if (may_be_read && is_read_in_capitals(dialect.grammar, line)) return dialect.lower_case_clause;
  return is_disputed(line, error) ? dialect.disputed_syntax_clause : dialect.syntax_clause;
}

}  // namespace

void BlockOutput::clear() {
  items.clear();
  cycle = {};
  after.clear();
  alarms.clear();
  before_alarm.clear();
  warnings.clear();
  not_covered.reset();
  beyond_range.reset();
  program_end = false;
  end_clause = kNoClause;
  accepted.clear();
  cycle_places.places.clear();
  cycle_places.axes.clear();
}

Expander::Expander(const Profile& profile, grammar::LineSource& lines, OpenPaths open_paths)
    : profile_(profile),
      lines_(lines),
      readings_(profile.readings),
      dialect_(*find_dialect(profile.dialect)),
      interpreter_(dialect_.make_interpreter(profile, readings_, open_paths)) {}

Expander::~Expander() = default;

std::string Expander::failed_words() const {
  return grammar::without_comments(dialect_.grammar, line_.text);
}

const Item* Expander::finish(Item item) {
  ended_ = true;
  last_ = std::move(item);
  return &last_;
}

// What is beyond the range of any machine is not covered, but where a manual names the range.
void Expander::leave_out_of_range() {
  const grammar::Word* const word = word_beyond_range(block_);
  const bool is_beyond =
      word != nullptr || out_.beyond_range || is_beyond_range(interpreter_->position());
  if (!is_beyond || out_.not_covered) return;
  const auto has_range = [](const Alarm& alarm) {
    return alarm.alarm == AlarmClass::value_out_of_range;
  };
  if (std::ranges::any_of(out_.alarms, has_range)) return;
  out_.alarms.clear();
  out_.not_covered = NotCovered{
      line_.number, "range", "No manual says what a control does with a number as large as this.",
      word != nullptr ? word->where : out_.beyond_range.value_or(grammar::Span{})};
}

// Whether there is a block to run. At the end of the text the interpreter is heard once.
bool Expander::next_line() {
  out_.clear();
  next_item_ = next_after_ = 0;
  of_cycle_ = 0;
  const auto size = static_cast<std::uint32_t>(line_.text.size());
  if (interpreter_->next_line(lines_, line_)) return true;
  text_ended_ = true;
  interpreter_->end_text({size, size}, out_);
  return false;
}

const Item* Expander::next() {
  if (undecided_) throw exact::Undecided(*undecided_);
  try {
    return produce();
  } catch (const exact::Undecided& undecided) {
    undecided_ = undecided;
    throw;
  }
}

const Item* Expander::produce() {
  while (!ended_) {
    if (next_item_ < out_.items.size()) return &out_.items[next_item_++];
    if (const Item* item = out_.cycle.next()) {
      if (++of_cycle_ <= kMostOfACycle) return item;
      return finish(too_many_motions(line_.number));
    }
    if (next_after_ < out_.after.size()) return &out_.after[next_after_++];
    if (!out_.alarms.empty()) {
      // A text without a line has its alarm in the first.
      const std::uint64_t line = std::max<std::uint64_t>(line_.number, 1);
      return finish(AlarmReport{line, std::move(out_.alarms), std::nullopt});
    }
    if (out_.not_covered) return finish(*std::move(out_.not_covered));
    if (out_.program_end || text_ended_) {
      return finish(end_record(interpreter_->position(), out_.end_clause));
    }
    if (!next_line()) continue;
    std::optional<grammar::SyntaxError> error =
        line_.too_long ? grammar::line_too_long()
                       : grammar::parse_block(dialect_.grammar, line_.text, block_);
    if (profile_.block_skip && is_skipped(line_) && !(error && interpreter_->alarms_left_out())) {
      interpreter_->leave_out();
      continue;
    }
    if (error && grammar::is_limit_of_gauge(*error)) {
      return finish(NotCovered{line_.number, std::string(grammar::name(error->code)),
                               grammar::message(*error), error->where});
    }
    if (error) {
      // A block that cannot be read yields the syntax alarm alone.
      const ClauseId clause = clause_of(dialect_, line_, *error);
      Alarm alarm{AlarmClass::syntax, clause, 0, error->where, grammar::message(*error)};
      return finish(AlarmReport{line_.number, {std::move(alarm)}, std::move(error)});
    }
    if (block_.skip && profile_.block_skip) {
      interpreter_->leave_out();
      continue;
    }
    interpreter_->run(line_.number, block_, out_);
    leave_out_of_range();
    if (warn_) {
      for (const Warning& warning : out_.warnings) warn_(warning, line_);
    }
    if (!out_.alarms.empty() || out_.not_covered) {
      // None of the motion of the alarming block, but what a reading says.
      out_.items.clear();
      if (!out_.alarms.empty()) out_.items.swap(out_.before_alarm);
      out_.after.clear();
      out_.cycle = {};
    } else if (place_ && !out_.cycle_places.empty()) {
      place_(line_.number, out_.cycle_places);
    }
    for (const ClauseId clause : out_.accepted) accept_(line_.number, clause);
  }
  return nullptr;
}

}  // namespace gonogo::reference
