// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/ngc/block.hpp"

#include <algorithm>

namespace gonogo::expanders::ngc {
namespace {

// Functions that may stand for a number: `X SIN[30]`.
constexpr std::string_view kFunctions[] = {"ABS", "ACOS", "ASIN", "ATAN",  "COS", "EXISTS", "EXP",
                                           "FIX", "FUP",  "LN",   "ROUND", "SIN", "SQRT",   "TAN"};

// NGC-POL-01
bool is_polar_address(char c) {
  return c == '@' || c == '^';
}

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

bool is_function(std::string_view rest) {
  std::size_t letters = 0;
  while (letters < rest.size() && is_letter(rest[letters])) ++letters;
  return std::any_of(std::begin(kFunctions), std::end(kFunctions), [&](std::string_view name) {
    return same_letters(rest.substr(0, letters), name);
  });
}

// The construct at the start of `rest`, where no word could be read; empty: none.
std::string_view macro_at(std::string_view rest) {
  if (rest.empty()) return {};
  if (std::string_view("#[Oo").find(rest[0]) != std::string_view::npos) return rest.substr(0, 1);
  const bool special = rest[0] == '$';  // NGC-G76-13: of another spindle
  if (!is_letter(rest[0]) && !is_polar_address(rest[0]) && !special) return {};
  rest.remove_prefix(1);
  while (!rest.empty() && is_blank(rest[0])) rest.remove_prefix(1);
  if (!rest.empty() && (rest[0] == '-' || rest[0] == '+')) rest.remove_prefix(1);
  const std::string_view begins = special ? "#[.0123456789" : "#[";
  const bool macro =
      !rest.empty() && (begins.find(rest[0]) != std::string_view::npos || is_function(rest));
  return macro ? rest.substr(0, 1) : std::string_view{};
}

// NGC-COM-07: `%` with nothing but blanks beside it.
bool is_alone(std::string_view line) {
  return std::all_of(line.begin(), line.end(), [](char c) { return is_blank(c) || c == '%'; }) &&
         std::count(line.begin(), line.end(), '%') == 1;
}

// NGC-COM-04: copies the line without the blanks that stand outside comments.
void copy_without_blanks(std::string_view line, std::string& into) {
  into.clear();
  bool comment = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (!comment && line[i] == ';') {
      into.append(line.substr(i));
      return;
    }
    if (comment || !is_blank(line[i])) into.push_back(line[i]);
    if (line[i] == '(') comment = true;
    if (line[i] == ')') comment = false;
  }
}

std::size_t digits_at(std::string_view text, std::size_t from) {
  std::size_t end = from;
  while (end < text.size() && text[end] >= '0' && text[end] <= '9') ++end;
  return end - from;
}

// Whether a comment stands before `token`, which ends `line`.
bool follows_comment(std::string_view line, std::string_view token) {
  return line.substr(0, line.size() - token.size()).find('(') != std::string_view::npos;
}

bool is_small(std::string_view token) {
  return !token.empty() && token[0] >= 'a' && token[0] <= 'z';
}

bool begins_with_abort(std::string_view comment) {
  std::string_view rest = "ABORT,";
  for (const char c : comment) {
    if (is_blank(c)) continue;
    if (!same_letters({&c, 1}, rest.substr(0, 1))) return false;
    rest.remove_prefix(1);
    if (rest.empty()) return true;
  }
  return false;
}

}  // namespace

void Block::clear() {
  WordBlock::clear();
  functions_.clear();
  long_number_ = false;
  skipped_ = false;
  twice_polar_ = false;
  motions_ = {};
}

bool Block::aborts() const {
  std::string_view last;
  std::size_t at = 0;
  while (at < line_.size()) {
    const std::size_t begin = line_.find_first_of("(;", at);
    if (begin == std::string::npos) break;
    if (line_[begin] == ';') break;
    at = std::min(line_.find(')', begin), line_.size());
    last = std::string_view(line_).substr(begin + 1, at - begin - 1);
  }
  return begins_with_abort(last);
}

Block::Reading Block::unreadable(std::string_view rest) {
  macro_ = macro_at(rest);
  return macro_.empty() ? Reading::kSyntax : Reading::kMacro;
}

Block::Reading Block::read(std::string_view line, const Manner& manner) {
  clear();
  if (line.size() > kLongestLine) return Reading::kSyntax;
  copy_without_blanks(line, line_);
  if (line_.empty()) return Reading::kBlank;
  const std::string_view text =
      manner.faults.alters("blanks-end-numbers"_fault, std::string_view(line_), line);
  Reading reading = read_words(text, manner);
  if (skipped_ && reading != Reading::kSyntax) reading = Reading::kSkipped;
  if (reading == Reading::kWords) settle_motion(manner);
  return reading;
}

Block::Reading Block::read_words(std::string_view line, const Manner& manner) {
  Tokenizer tokens(line, "@^");
  Word word;
  bool first_word = true;  // N may stand here
  for (Position position = 0;; ++position) {
    switch (tokens.next(word)) {
      case Token::kEnd:
        return Reading::kWords;
      case Token::kSyntax:
        return unreadable(tokens.from_token());
      case Token::kTapeMark:
        return is_alone(line) ? Reading::kTapeMark : Reading::kSyntax;
      case Token::kSkip:
        if (position != 0 || follows_comment(line, tokens.from_token())) return Reading::kSyntax;
        skipped_ = manner.faults.alters("block-delete-always"_fault, manner.block_delete, true);
        if (skipped_ && !manner.reads_skipped) return Reading::kSkipped;
        break;
      case Token::kWord:
        if (word.address == 'O') {
          const std::string_view rest = tokens.from_token();
          const bool named = position == 0 && tokens.has_plain_number() && rest == line;
          // NGC-COM-06
          if (named && tokens.next(word) == Token::kEnd) return Reading::kName;
          return unreadable(rest);
        }
        last_address_ = word.address;
        if (is_small(tokens.from_token()) && manner.faults.adds("capitals-only"_fault)) {
          return Reading::kSyntax;
        }
        if (word.address != 'N') {
          take(word, position, manner.whole);
        } else if (!first_word || !take_line_number(tokens, word, manner) ||
                   follows_comment(line, tokens.from_token())) {
          return Reading::kSyntax;
        }
        first_word = false;
        break;
    }
  }
}

// NGC-COM-05
bool Block::take_line_number(const Tokenizer& tokens, const Word& word, const Manner& manner) {
  std::string_view text = tokens.number_text();
  while (!text.empty() && is_blank(text[0])) text.remove_prefix(1);
  const std::size_t whole = digits_at(text, 0);
  if (whole == 0) return false;
  long_number_ = text.size() > whole || word.number.overflow || word.number.value > 99'999 * kOne;
  if (text.size() == whole) return true;
  const std::size_t decimals = digits_at(text, whole + 1);
  return (decimals > 0 || manner.faults.adds("open-line-numbers"_fault)) &&
         whole + 1 + decimals == text.size();
}

void Block::take(const Word& word, Position position, const WholeNumbers& whole) {
  if (word.address == 'G') return take_code(whole.tenths(word.number), position);
  if (word.address == 'M') {
    const std::optional<Fixed> number = whole.function(word.number);
    functions_.push_back(
        {number, number ? find_function(*number) : nullptr, word.number.overflow, position});
    return;
  }
  if (!has(word.address)) return put(word, position);
  if (!is_polar_address(word.address)) return note_duplicate(word.address, position);
  twice_polar_ = true;
}

void Block::take_code(std::optional<Fixed> tenths, Position position) {
  const Code* code = tenths ? find_code(*tenths) : nullptr;
  if (!note_code(code)) return;
  if (static_cast<Group>(code->group) == Group::kMotion) return take_motion(*code, position);
  if (codes_[code->group] != nullptr) return note_duplicate('G', position);
  codes_[code->group] = code;
}

void Block::take_motion(const Code& code, Position position) {
  if (motions_.codes + motions_.offs == 1) motions_.second = position;
  const bool off = code.tenths == 800;
  (off ? motions_.off : motions_.code) = &code;
  ++(off ? motions_.offs : motions_.codes);
  motions_.last = &code;
}

// NGC-COM-03: the code of the motion group; G80 beside another one is forgotten, or is too many.
void Block::settle_motion(const Manner& manner) {
  const Motions& found = motions_;
  const Code*& motion = codes_[static_cast<std::size_t>(Group::kMotion)];
  motion = found.code != nullptr ? found.code : found.off;
  if (found.codes + found.offs <= 1) return;
  motion = manner.faults.alters("last-motion-wins"_fault, motion, found.last);
  const bool forgiven = manner.forgets_g80 && found.codes <= 1;
  if (!forgiven && manner.faults.spares("last-motion-wins"_fault)) {
    note_duplicate('G', found.second);
  }
}

}  // namespace gonogo::expanders::ngc
