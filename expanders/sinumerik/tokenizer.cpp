// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/sinumerik/tokenizer.hpp"

#include <algorithm>
#include <array>

namespace gonogo::expanders::sinumerik {
namespace {

constexpr std::size_t kLargestIndex = 1'000'000;

// Names begin with two of these.
bool is_name_start(char c) {
  return is_letter(c) || c == '_';
}

// CR5, TURN2: an address whose `=` is missing.
bool is_address_with_digits(std::string_view name, Control control) {
  const auto digits = std::find_if(name.begin(), name.end(), &is_digit);
  if (digits == name.end() || !std::all_of(digits, name.end(), &is_digit)) return false;
  const std::string_view word(name.begin(), digits);
  return find_name(word, control).kind == NameKind::kAddress;
}

}  // namespace

Head Tokenizer::head() {
  Head head;
  skip_blanks(cursor_, end_);
  if (at('%')) {
    head.kind = is_printed_name() ? Head::Kind::kProgramName : Head::Kind::kSyntax;
    return head;
  }
  if (at('/')) {
    head.skip = true;
    ++cursor_;
    if (cursor_ != end_ && is_digit(*cursor_)) ++cursor_;
    skip_blanks(cursor_, end_);
  }
  if (!skip_number()) head.kind = Head::Kind::kSyntax;
  skip_label();
  return head;
}

// What the name of a program is written in, up to a comment.
bool Tokenizer::is_printed_name() const {
  const char* const stop = std::find(cursor_, end_, ';');
  return std::all_of(cursor_, stop, [](char c) { return (c >= ' ' && c <= '~') || c == '\t'; });
}

// `N10` or `:10`; false when the number is none.
bool Tokenizer::skip_number() {
  if (cursor_ == end_) return true;
  const bool word = capital(*cursor_) == 'N' && !(end_ - cursor_ > 1 && is_name_start(cursor_[1]));
  if (!word && *cursor_ != ':') return true;
  if (manner_.capitals_only && *cursor_ == 'n') return false;
  ++cursor_;
  skip_blanks(cursor_, end_);
  if (cursor_ == end_ || !is_digit(*cursor_)) return false;
  while (cursor_ != end_ && is_digit(*cursor_)) ++cursor_;
  skip_blanks(cursor_, end_);
  return true;
}

void Tokenizer::skip_label() {
  const char* stop = cursor_;
  if (end_ - stop < 2 || !is_name_start(stop[0]) || !is_name_start(stop[1])) return;
  while (stop != end_ && is_name_part(*stop)) ++stop;
  if (stop != end_ && *stop == ':') cursor_ = stop + 1;
}

Item Tokenizer::next() {
  skip_blanks(cursor_, end_);
  Item item;
  if (cursor_ == end_ || *cursor_ == ';') return item;
  if (*cursor_ == '$') return marked(item, Scan::kOutside, cursor_);
  const bool small = *cursor_ >= 'a' && *cursor_ <= 'z';
  const bool named = end_ - cursor_ > 1 && is_name_start(cursor_[0]) && is_name_start(cursor_[1]);
  if ((!named && !is_letter(*cursor_)) || (small && manner_.capitals_only)) {
    return marked(item, Scan::kSyntax, cursor_);
  }
  return named ? name() : letter();
}

// The item unless `step` says that it could not be read.
Item Tokenizer::marked(Item item, Scan step, const char* from) const {
  if (step == Scan::kSyntax) item.kind = Item::Kind::kSyntax;
  if (step == Scan::kOutside) {
    item.kind = Item::Kind::kOutside;
    item.text = std::string_view(from, static_cast<std::size_t>(end_ - from)).substr(0, 16);
  }
  return item;
}

Item Tokenizer::letter() {
  const char* from = cursor_;
  Item item;
  item.kind = Item::Kind::kLetter;
  item.letter = capital(*cursor_++);
  skip_blanks(cursor_, end_);
  if (item.letter == 'R') return assignment(item);
  const bool plain = item.letter == 'G' || item.letter == 'N' || item.letter == 'L';
  if (item.letter == 'N') return marked(item, Scan::kSyntax, from);
  if (at('=')) return plain ? marked(item, Scan::kSyntax, from) : with_value(item);
  const char* digits = cursor_;
  if (read_index(cursor_, end_, kLargestIndex, item.index)) {
    skip_blanks(cursor_, end_);
    if (at('=')) {
      item.kind = Item::Kind::kIndexed;
      return item.letter == 'G' ? marked(item, Scan::kSyntax, from) : with_value(item);
    }
    cursor_ = digits;
  }
  if (!read_decimal(cursor_, end_, item.value.number)) return marked(item, Scan::kSyntax, from);
  return marked(item, at_exponent(cursor_, end_) ? Scan::kOutside : Scan::kRead, from);
}

Item Tokenizer::assignment(Item item) {
  item.kind = Item::Kind::kAssignment;
  if (at('[') || at('=')) return marked(item, Scan::kOutside, cursor_);
  if (!read_index(cursor_, end_, kLargestIndex, item.index)) {
    return marked(item, Scan::kSyntax, cursor_);
  }
  skip_blanks(cursor_, end_);
  return at('=') ? with_value(item) : marked(item, Scan::kSyntax, cursor_);
}

Item Tokenizer::name() {
  const char* from = cursor_;
  std::array<char, 16> capitals{};
  std::size_t size = 0;
  for (; cursor_ != end_ && is_name_part(*cursor_); ++cursor_, ++size) {
    if (size < capitals.size()) capitals[size] = capital(*cursor_);
  }
  Item item;
  item.kind = Item::Kind::kName;
  item.letter = capitals[0];
  // No name that is known is as long as that.
  std::string_view text(capitals.data(), std::min(size, capitals.size()));
  // Behind the letters that a name is known by.
  const auto are_digits = [&](std::size_t letters) {
    return std::all_of(from + letters, cursor_, &is_digit);
  };
  const bool rotation = text.starts_with("RPL") && are_digits(3);
  if (rotation) {
    text = text.substr(0, 3);
    cursor_ = from + 3;
  } else if (is_address_with_digits(text, manner_.control) && are_digits(text.size())) {
    return marked(item, Scan::kSyntax, from);
  }
  item.name = find_name(text, manner_.control);
  if (item.name.kind == NameKind::kControl) return marked(item, Scan::kOutside, from);
  skip_blanks(cursor_, end_);
  const bool address = item.name.kind == NameKind::kAddress;
  const bool motion =
      item.name.kind == NameKind::kThroughPoint || item.name.kind == NameKind::kTangent;
  if (at('[')) return marked(item, Scan::kOutside, from);
  if (rotation && !at('=') && !at('(')) return loose_rotation(item, from);
  if (at('='))
    return motion || item.name.kind == NameKind::kCycle ? marked(item, Scan::kSyntax, from)
                                                        : with_value(item);
  const bool bare = address || motion || item.name.kind == NameKind::kCycle;
  const bool broken = at('(') ? bare || !skip_call() : address;
  return marked(item, broken ? Scan::kSyntax : Scan::kRead, from);
}

// SIE-FRM-03: `RPL45`.
Item Tokenizer::loose_rotation(Item item, const char* from) {
  const char* number = cursor_;
  const bool read = read_decimal(cursor_, end_, item.value.number);
  if (!read) cursor_ = number;
  if (manner_.control == Control::k840D) return item;  // it has no RPL, with or without a value
  item.loose = true;
  const bool refused = !read || manner_.rotation_needs_equals;
  return marked(item, refused ? Scan::kSyntax : Scan::kRead, from);
}

// The arguments of a call; false when the brackets do not close.
bool Tokenizer::skip_call() {
  std::size_t depth = 0;
  bool in_string = false;
  for (; cursor_ != end_; ++cursor_) {
    const char c = *cursor_;
    if (c == '"') in_string = !in_string;
    if (in_string) continue;
    const auto byte = static_cast<unsigned char>(c);
    if (byte > 126 || (byte < 32 && c != '\t') || c == ';') return false;
    if (c == '(') ++depth;
    if (c == ')' && --depth == 0) {
      ++cursor_;
      return true;
    }
  }
  return false;
}

// At the `=`.
Item Tokenizer::with_value(Item item) {
  const char* from = cursor_;
  ++cursor_;
  const Scan step = value(item);
  return marked(item, step, from);
}

Scan Tokenizer::value(Item& item) {
  skip_blanks(cursor_, end_);
  const bool wrapped = end_ - cursor_ > 2 && capital(cursor_[1]) == 'C' &&
                       (capital(cursor_[0]) == 'A' || capital(cursor_[0]) == 'I') &&
                       !is_name_part(cursor_[2]);
  if (!wrapped) return expression(item);
  const bool absolute = capital(*cursor_) == 'A';
  cursor_ += 2;
  skip_blanks(cursor_, end_);
  if (!at('(')) return Scan::kSyntax;
  ++cursor_;
  const Scan step = expression(item);
  if (step != Scan::kRead) return step;
  skip_blanks(cursor_, end_);
  if (!at(')')) return Scan::kSyntax;
  ++cursor_;
  if (absolute ? manner_.ignores_absolute : manner_.ignores_incremental) return Scan::kRead;
  item.value.mode = absolute ? Value::Mode::kAbsolute : Value::Mode::kIncremental;
  return Scan::kRead;
}

Scan Tokenizer::expression(Item& item) {
  skip_blanks(cursor_, end_);
  const char* literal = cursor_;
  const std::size_t count = parameter_count(manner_.control);
  Expression expression(cursor_, end_, std::span(parameters_).first(count), manner_.left_to_right);
  const Scan step = expression.read();
  cursor_ = expression.cursor();
  item.real = expression.value();
  item.value.number = to_counts(item.real);
  // A number alone keeps the digits that a processor's real would lose.
  Decimal written;
  const bool is_number = read_decimal(literal, cursor_, written);
  skip_blanks(literal, cursor_);
  if (step == Scan::kRead && is_number && literal == cursor_) item.value.number = written;
  item.value.undefined = expression.undefined();
  return step;
}

}  // namespace gonogo::expanders::sinumerik
