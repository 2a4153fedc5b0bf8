// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rs274/m_functions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/reading_literal.hpp"
#include "reference/rs274/machine.hpp"
#include "reference/rs274/whole.hpp"

namespace gonogo::reference::rs274 {
namespace {

// NGC-COM-01, NGC-MOD-01
void take_m_function(const grammar::Word& word, std::uint64_t line, const ReadingsInUse& readings,
                     BlockOutput& out) {
  const ClauseId clause = "NGC-COM-01"_clause;
  const NearWhole value(to_number(word.value));
  if (!value.counts_as_whole(Whole::m_function, readings)) {
    out.alarms.push_back({AlarmClass::not_an_integer, clause, 'M', word.where,
                          fmt::format("{} is no M function: its number is whole.", text_of(word))});
    return;
  }
  const std::optional<std::int64_t> number = value.nearest().to_int64();  // nothing: too large
  const Code* const function = number ? m_function(*number) : nullptr;
  if (function == nullptr) {
    out.alarms.push_back({AlarmClass::undefined_code, clause, 'M', word.where,
                          fmt::format("The control has no function {}.", text_of(word))});
    return;
  }
  if (function->treatment == Treatment::outside) {
    if (!out.not_covered) {
      out.not_covered = m_function_outside(*number, function->title, word, line);
    }
    return;
  }
  if (*number == 98 || *number == 99) return;  // NGC-OWD-13: no functions of the machine
  const bool before = function->kind == Kind::machine;
  (before ? out.items : out.after)
      .emplace_back(function_record(line, clause, static_cast<int>(*number)));
  if (function->kind == Kind::program_end) out.program_end = true;
}

// NGC-MOD-01: functions run by their groups, not in their order on the line.
std::ptrdiff_t place_in_order(const Item& function) {
  constexpr std::array kOrder = {Group::signals,     Group::tool,    Group::spindle,
                                 Group::saved_modes, Group::coolant, Group::override_switches};
  const Group group = m_function(std::get<Record>(function).m)->group;
  return std::ranges::find(kOrder, group) - kOrder.begin();
}

}  // namespace

Record function_record(std::uint64_t line, ClauseId clause, int m) {
  Record record = record_of(RecordKind::m, line, clause);
  record.m = m;
  record.among_motions = true;
  return record;
}

// NGC-COM-01
std::optional<std::int64_t> m_number(const grammar::Word& word, const ReadingsInUse& readings) {
  const NearWhole number(to_number(word.value));
  if (!number.counts_as_whole(Whole::m_function, readings)) return std::nullopt;
  return number.nearest().to_int64();
}

MFunctions m_functions_of(const grammar::Block& block, const ReadingsInUse& readings) {
  MFunctions functions;
  for (const grammar::Word& word : block.words) {
    if (word.address != 'M') continue;
    const std::int64_t number = m_number(word, readings).value_or(-1);
    const bool is_small = number >= 0 && number < 100;
    if (is_small) functions.set(static_cast<std::size_t>(number));
  }
  return functions;
}

void take_m_functions(const grammar::Block& block, std::uint64_t line,
                      const ReadingsInUse& readings, BlockOutput& out) {
  for (const grammar::Word& word : block.words) {
    if (word.address == 'M') take_m_function(word, line, readings, out);
  }
  // Few of them, and std::stable_sort warns under clang-19.
  for (auto next = out.items.begin(); next != out.items.end(); ++next) {
    const auto behind = std::ranges::upper_bound(out.items.begin(), next, place_in_order(*next), {},
                                                 place_in_order);
    std::rotate(behind, next, next + 1);
  }
}

// NGC-COM-01
void check_m_groups(const grammar::Block& block, const ReadingsInUse& readings,
                    std::vector<Alarm>& alarms) {
  constexpr int kMostFunctions = 4;
  std::uint32_t seen = 0;
  int functions = 0;
  for (const grammar::Word& word : block.words) {
    if (word.address != 'M') continue;
    if (++functions == kMostFunctions + 1) {
      alarms.push_back({AlarmClass::duplicate_word, "NGC-COM-01"_clause, 'M', word.where,
                        "A block has four M functions at most."});
    }
    const std::optional<std::int64_t> number = m_number(word, readings);
    const Code* const function = number ? m_function(*number) : nullptr;
    if (function == nullptr) continue;
    const std::uint32_t group = std::uint32_t{1} << static_cast<unsigned>(function->group);
    if ((seen & group) != 0) {
      alarms.push_back(
          {AlarmClass::duplicate_word, "NGC-COM-01"_clause, 'M', word.where,
           fmt::format("{} is of the group of an M function before it.", text_of(word))});
    }
    seen |= group;
  }
}

namespace {

// NGC-COM-11
void check_tool_table(BlockContext& block, const Number& number, const grammar::Word& word) {
  if (number.sign() <= 0 || block.profile.tools.contains(number.text())) return;
  if (!block.readings.is("ngc.missing-tool=alarm"_reading)) return;
  block.alarm(AlarmClass::no_tool, "NGC-COM-11"_clause, word.address,
              fmt::format("{} is no tool of the table.", text_of(word)));
}

}  // namespace

// NGC-COM-09
void check_spindle_and_tool(BlockContext& block) {
  const ClauseId clause = "NGC-COM-09"_clause;
  for (const char address : {'S', 'T'}) {
    if (!block.words.has(address)) continue;
    const grammar::Word& word = *block.words.word(address);
    const Number number = block.words.written(address);
    if (number.sign() < 0) {
      block.alarm(AlarmClass::value_sign, clause, address,
                  fmt::format("{} is below zero.", text_of(word)));
    }
    if (address == 'S') continue;
    const NearWhole tool(number);
    if (tool.counts_as_whole(Whole::m_function, block.readings)) {
      check_tool_table(block, tool.nearest(), word);
      continue;
    }
    block.alarm(AlarmClass::not_an_integer, clause, address,
                fmt::format("{} is no tool: its number is whole.", text_of(word)));
  }
}

namespace {

// NGC-COM-09: the words of one of M61 to M68.
class SignalWords {
 public:
  SignalWords(const grammar::Word& function, BlockContext& block)
      : function_(function), block_(block), words_(block.words) {}

  void need(char address) {
    if (!words_.has(address)) add_missing(address);
  }
  // One that is below zero is none.
  void need_index(char address) {
    need(address);
    if (!is_negative(address)) return;
    add(AlarmClass::value_sign, address,
        with_values(fmt::format("{} of {} is {{}}, below zero.", address, name()),
                    {words_.written(address)}));
    add_missing(address);
  }
  void check_input();

 private:
  std::string name() const { return text_of(function_); }
  bool is_negative(char address) const {
    return words_.has(address) && words_.written(address).sign() < 0;
  }
  void check_wait();
  void add_missing(char address) {
    add(AlarmClass::missing_word, address, fmt::format("{} needs {}.", name(), address));
  }
  void add(AlarmClass alarm, char address, std::string message) {
    block_.alarm(alarm, "NGC-COM-09"_clause, address, std::move(message));
  }

  const grammar::Word& function_;
  BlockContext& block_;
  const BlockWords& words_;
};

// M66 takes a digital input or an analogue one.
void SignalWords::check_input() {
  if (words_.has('P') && words_.has('E')) {
    return add(AlarmClass::conflicting_words, 'E', "M66 waits for P or for E, not for both.");
  }
  need_index(words_.has('E') ? 'E' : 'P');
  if (is_negative('L')) {
    return add(AlarmClass::value_sign, 'L',
               with_values("L of M66 is {}, below zero.", {words_.written('L')}));
  }
  const NearWhole mode(words_.has('L') ? words_.written('L') : Number(0));
  if (!mode.counts_as_whole(Whole::m_function, block_.readings)) {
    return add(AlarmClass::not_an_integer, 'L',
               with_values("L of M66 is {} and not whole.", {words_.written('L')}));
  }
  if (mode.nearest().sign() != 0) check_wait();
}

// A digital input alone is waited for, and not for ever.
void SignalWords::check_wait() {
  if (words_.has('E')) {
    add(AlarmClass::conflicting_words, 'L', "M66 does not wait for an analogue input: L is 0.");
    add(AlarmClass::value_out_of_range, 'L', "L of M66 with E is 0.");  // either is true
  }
  need('Q');
  if (!words_.has('Q') || words_.written('Q').sign() > 0) return;
  add(AlarmClass::value_sign, 'Q',
      with_values("The longest wait, {} s, is not above zero.", {words_.written('Q')}));
  if (!is_negative('Q')) add(AlarmClass::value_out_of_range, 'Q', "The longest wait is 0 s.");
}

// Whether a word is there and none of the numbers from 0 to `last`.
bool is_beyond(const BlockWords& words, char address, int last) {
  if (!words.has(address)) return false;
  const Number number = words.written(address);
  return number.sign() < 0 || number > Number(last) || number != number.floor();
}

// NGC-COM-15: whether the function names what some machines do not have.
bool may_be_unknown(std::int64_t function, const BlockWords& words) {
  constexpr int kLastPin = 3;
  constexpr int kLastMode = 4;  // how M66 waits
  if (function >= 50 && function <= 53) return is_beyond(words, 'P', 1);
  if (function >= 62 && function <= 65) return is_beyond(words, 'P', kLastPin);
  if (function == 66) {
    return is_beyond(words, 'P', kLastPin) || is_beyond(words, 'E', kLastPin) ||
           is_beyond(words, 'L', kLastMode);
  }
  if (function != 67 && function != 68) return false;
  return is_beyond(words, 'E', kLastPin) || !words.has('Q');
}

}  // namespace

// NGC-COM-09
void check_signals(BlockContext& block) {
  const BlockWords& words = block.words;
  for (const grammar::Word& word : words.block().words) {
    if (word.address != 'M') continue;
    SignalWords signal(word, block);
    const std::int64_t number = m_number(word, block.readings).value_or(0);
    if (number == 61) signal.need_index('Q');
    if (number == 61 && words.has('Q')) {
      check_tool_table(block, words.written('Q'), *words.word('Q'));
    }
    if (may_be_unknown(number, words)) block.out.accept("NGC-COM-15"_clause);
    if (number >= 62 && number <= 65) signal.need('P');
    if (number == 66) signal.check_input();
    if (number == 67 || number == 68) signal.need_index('E');
  }
}

}  // namespace gonogo::reference::rs274
