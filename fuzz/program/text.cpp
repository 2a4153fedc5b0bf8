// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/program/text.hpp"

#include <algorithm>

#include "fuzz/program/lines.hpp"

namespace gonogo::program {
namespace {

constexpr std::size_t kMostDigits = 15;

bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

// Only rs274 has them (NGC-POL-01).
bool is_polar_address(char c) {
  return c == '@' || c == '^';
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_sign(char c) {
  return c == '-' || c == '+';
}

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

char capital(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

// One past the bracket that closes the one at `at`, or the end.
std::size_t close_of(std::string_view line, std::size_t at) {
  int depth = 0;
  for (; at < line.size(); ++at) {
    if (line[at] == '(') ++depth;
    if (line[at] == ')' && --depth == 0) return at + 1;
  }
  return line.size();
}

// Where the number of an address begins that blanks part from it: G 01, X -5. `at`: no blanks, or
// no number behind them.
std::size_t number_behind_blanks(std::string_view line, std::size_t at) {
  const std::size_t next = line.find_first_not_of(" \t", at);
  if (next == at || next == std::string_view::npos) return at;
  const std::size_t digit = is_sign(line[next]) ? line.find_first_not_of(" \t", next + 1) : next;
  if (digit == std::string_view::npos || (!is_digit(line[digit]) && line[digit] != '.')) return at;
  return next;
}

bool is_of_number(char c) {
  return is_digit(c) || c == '.' || is_sign(c);
}

// Where a number goes on behind blanks in it, X- 3 3.1 (NGC-COM-04); `at` where it does not.
std::size_t digits_behind_blanks(std::string_view text, std::size_t at) {
  const std::size_t next = text.find_first_not_of(" \t", at);
  if (next == at || next == std::string_view::npos) return at;
  return is_digit(text[next]) || text[next] == '.' ? next : at;
}

// One past the word that begins at `at`. A letter begins a new word after a digit, but not after
// what needs an operand: R1=R2+SIN(30).
std::size_t word_end(std::string_view line, std::size_t at) {
  if (line[at] == ';') return line.size();
  if (line[at] == '(') return close_of(line, at);
  const auto begins_word = [](char c) { return is_letter(c) || is_polar_address(c); };
  if (!begins_word(line[at])) {
    while (at < line.size() && !begins_word(line[at]) && !is_blank(line[at]) && line[at] != '(') {
      ++at;
    }
    return at;
  }
  if (is_polar_address(line[at])) ++at;
  while (at < line.size() && is_letter(line[at])) ++at;
  at = number_behind_blanks(line, at);
  while (at < line.size() && !is_blank(line[at]) && line[at] != ';') {
    const char before = line[at - 1];
    const bool takes_operand = before == '=' || before == '+' || before == '-' || before == '*' ||
                               before == '/' || is_letter(before);
    if (line[at] == '(' && !takes_operand) break;
    if (begins_word(line[at]) && !takes_operand) break;
    at = line[at] == '(' ? close_of(line, at) : at + 1;
    if (is_of_number(line[at - 1])) at = digits_behind_blanks(line, at);
  }
  return at;
}

TextLine cut(std::string_view line, std::string_view end) {
  TextLine result;
  std::size_t at = 0;
  while (at < line.size()) {
    TextWord word;
    while (at < line.size() && is_blank(line[at])) word.gap += line[at++];
    if (at == line.size()) {
      result.rest = word.gap;
      break;
    }
    const std::size_t stop = std::max(word_end(line, at), at + 1);
    word.text = line.substr(at, stop - at);
    at = stop;
    result.words.push_back(std::move(word));
  }
  result.end = end;
  return result;
}

}  // namespace

std::vector<TextLine> lines_of(std::string_view program) {
  std::vector<TextLine> lines;
  for (const ProgramLine& line : program_lines(program)) lines.push_back(cut(line.text, line.end));
  return lines;
}

std::string line_text(const TextLine& line) {
  std::string text;
  for (const TextWord& word : line.words) text += word.gap + word.text;
  return text + line.rest + line.end;
}

std::string text_of(const std::vector<TextLine>& lines) {
  std::string text;
  for (const TextLine& line : lines) text += line_text(line);
  return text;
}

std::size_t count_blocks(std::string_view program) {
  const std::vector<TextLine> lines = lines_of(program);
  return static_cast<std::size_t>(
      std::ranges::count_if(lines, [](const TextLine& line) { return !line.words.empty(); }));
}

std::string address_of(const TextWord& word) {
  std::string address;
  if (!word.text.empty() && is_polar_address(word.text.front())) return {word.text.front()};
  for (const char c : word.text) {
    if (!is_letter(c)) break;
    address += capital(c);
  }
  return address;
}

std::string name_of(const TextWord& word) {
  std::string name = address_of(word);
  const std::size_t end = word.text.find_first_not_of("0123456789", name.size());
  if (!name.empty() && end != std::string::npos && word.text[end] == '=') {
    name += word.text.substr(name.size(), end - name.size());
  }
  return name;
}

bool is_word(const TextWord& word) {
  const std::string address = address_of(word);
  return !address.empty() && address != "N" && address != "O";
}

bool is_comment(const TextWord& word) {
  return word.text.starts_with('(') || word.text.starts_with(';');
}

std::string code_of(const TextWord& word) {
  std::string code = address_of(word);
  std::string rest = word.text.substr(code.size());
  std::erase_if(rest, is_blank);
  const bool is_number = rest.find_first_not_of("0123456789.") == std::string_view::npos;
  if (!is_number || code.empty()) return {};
  if (code.size() == 1 && (code != "G" && code != "M")) return {};
  if (rest.empty()) return code.size() > 1 ? code : std::string();
  const std::size_t first = std::min(rest.find_first_not_of('0'), rest.size());
  std::string digits = rest.substr(first);
  if (digits.empty() || digits.front() == '.') digits.insert(0, "0");
  return code + digits;
}

std::string SmallDecimal::text() const {
  std::string digits = std::to_string(value < 0 ? -value : value);
  const auto decimals = static_cast<std::size_t>(scale);
  if (decimals > 0) {
    while (digits.size() <= decimals) digits.insert(0, "0");
    digits.insert(digits.size() - decimals, ".");
    while (digits.back() == '0') digits.pop_back();
    if (digits.back() == '.') digits.pop_back();
  }
  return (value < 0 ? "-" : "") + digits;
}

namespace {

// The number whose digits begin at `at`, without a sign; nothing where it is too long.
std::optional<NumberPlace> number_at(std::string_view text, std::size_t at) {
  NumberPlace place{at, at, {}};
  bool point = false;
  std::size_t digits = 0;
  while (place.end < text.size()) {
    const char c = text[place.end];
    if (c == '.' && !point) {
      point = true;
    } else if (is_digit(c)) {
      if (++digits <= kMostDigits) place.number.value = place.number.value * 10 + (c - '0');
      if (point) ++place.number.scale;
    } else {
      break;
    }
    place.end = digits_behind_blanks(text, place.end + 1);
  }
  if (digits == 0 || digits > kMostDigits) return std::nullopt;
  return place;
}

// The sign of the number that begins at `at`, which is no operator behind a digit; blanks may part
// them.
std::optional<std::size_t> sign_before(std::string_view text, std::size_t at) {
  while (at > 0 && is_blank(text[at - 1])) --at;
  if (at == 0 || !is_sign(text[at - 1])) return std::nullopt;
  if (at > 1 && is_digit(text[at - 2])) return std::nullopt;
  return at - 1;
}

}  // namespace

std::vector<NumberPlace> numbers_of(const TextWord& word) {
  std::vector<NumberPlace> places;
  const std::string& text = word.text;
  if (is_comment(word)) return places;
  const std::size_t equals = text.find('=');
  std::size_t at = equals == std::string::npos ? 0 : equals + 1;
  while (at < text.size()) {
    if (!is_digit(text[at]) && text[at] != '.') {
      ++at;
      continue;
    }
    std::optional<NumberPlace> place = number_at(text, at);
    if (!place) {
      at = text.find_first_not_of("0123456789.", at);
      continue;
    }
    at = place->end;
    if (const auto sign = sign_before(text, place->begin)) {
      if (text[*sign] == '-') place->number.value = -place->number.value;
      place->begin = *sign;
    }
    places.push_back(*place);
  }
  return places;
}

std::optional<SmallDecimal> value_of(const TextWord& word) {
  const std::vector<NumberPlace> places = numbers_of(word);
  if (places.empty()) return std::nullopt;
  return places.front().number;
}

namespace {

// Where the value of a word stands that is one number.
std::optional<std::pair<std::size_t, std::size_t>> place_of_value(const TextWord& word) {
  const std::string& text = word.text;
  std::size_t begin = name_of(word).size();
  if (begin == 0) return std::nullopt;
  std::size_t end = text.size();
  if (begin < end && text[begin] == '=') ++begin;
  const auto is_capital = [&](std::size_t at, char letter) {
    return at < end && capital(text[at]) == letter;
  };
  const bool is_bracketed = (is_capital(begin, 'A') || is_capital(begin, 'I')) &&
                            is_capital(begin + 1, 'C') && begin + 2 < end &&
                            text[begin + 2] == '(' && text.back() == ')';
  if (is_bracketed) {
    begin += 3;
    --end;
  }
  while (begin < end && is_blank(text[begin])) ++begin;
  while (end > begin && is_blank(text[end - 1])) --end;
  if (begin == end) return std::nullopt;
  return std::pair(begin, end);
}

}  // namespace

std::optional<exact::Number> exact_value_of(const TextWord& word) {
  const auto place = place_of_value(word);
  if (!place) return std::nullopt;
  std::string digits;
  for (const char c : word.text.substr(place->first, place->second - place->first)) {
    if (!is_blank(c) && c != '+') digits += c;
  }
  if (digits.starts_with('.')) digits.insert(0, "0");
  if (digits.starts_with("-.")) digits.insert(1, "0");
  if (digits.ends_with('.')) digits.pop_back();
  if (digits.find_first_not_of("-.0123456789") != std::string::npos) return std::nullopt;
  return exact::Number::parse(digits);
}

std::string with_value(const TextWord& word, const exact::Number& value) {
  const auto [begin, end] = place_of_value(word).value();
  // Quotients by 25.4 have no last decimal.
  const std::string text = value.text();
  const bool is_decimal = text.find('/') == std::string::npos;
  return word.text.substr(0, begin) + (is_decimal ? text : value.decimal_text(15)) +
         word.text.substr(end);
}

SameScale same_scale(const SmallDecimal& a, const SmallDecimal& b) {
  auto scaled = [](const SmallDecimal& number, int scale) {
    std::int64_t value = number.value;
    constexpr std::int64_t kMost = INT64_MAX / 10;
    for (int i = number.scale; i < scale; ++i) {
      if (value > kMost || value < -kMost) return value;  // too far apart to matter
      value *= 10;
    }
    return value;
  };
  const int scale = std::max(a.scale, b.scale);
  return {scaled(a, scale), scaled(b, scale)};
}

}  // namespace gonogo::program
