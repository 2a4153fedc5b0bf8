// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/sinumerik/block.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "expanders/common/tokenizer.hpp"
#include "expanders/sinumerik/machine.hpp"

namespace gonogo::expanders::sinumerik {
namespace {

constexpr std::size_t kLargestIndex = 1'000'000;

// AC( ) and IC( ) belong to coordinates, centres and the polar angle.
constexpr Addresses kPlaces = addresses(
    Address::kX, Address::kY, Address::kZ, Address::kA, Address::kC, Address::kI, Address::kJ,
    Address::kK, Address::kI1, Address::kJ1, Address::kK1, Address::kPolarAngle);

bool is_axis(char letter) {
  return std::string_view("XYZABCEOQUVW").find(letter) != std::string_view::npos;
}

}  // namespace

/// Cuts a line into items, computes their values and sorts them into the block. `;` ends the block;
/// bytes beyond ASCII may stand in comments and strings only.
class BlockReader {
 public:
  BlockReader(std::string_view line, Block& block, Machine& machine)
      : cursor_(line.data()), end_(cursor_ + line.size()), block_(block), machine_(machine) {}

  Block::Reading read();

 private:
  struct Late {
    std::size_t index;
    Real value;
  };

  bool at(char c) const { return cursor_ != end_ && *cursor_ == c; }
  void skip() { skip_blanks(cursor_, end_); }
  bool skip_number();
  Block::Reading read_items();
  Scan item();
  Scan letter();
  bool decimal(Value& value);
  Scan assignment();
  Scan name();
  Scan loose_rotation();
  Scan value(char letter, Value& value);
  Scan expression(char letter, Value& value);
  Scan take(const Name& name, std::string_view text, const Value& value);
  Scan take_word(Address address, char letter, const Value& value);
  void take_code(const Decimal& number);
  void put_code(const Code& code, char letter);
  void note_outside(std::string_view what);
  void warn(const std::string& text) { machine_.tracer.note(GONOGO_NOTE_WARNING, text); }
  Position position() const { return static_cast<Position>(block_.items_); }

  const char* cursor_;
  const char* end_;
  Block& block_;
  Machine& machine_;
  std::vector<Late> late_;  // assignments of the fault that delays them
};

Block::Reading BlockReader::read() {
  skip();
  if (at('%'))
    return is_program_name(cursor_, end_) ? Block::Reading::kTapeMark : Block::Reading::kSyntax;
  const bool slash = at('/');
  if (slash) {
    ++cursor_;
    if (cursor_ != end_ && is_digit(*cursor_)) ++cursor_;
    skip();
  }
  const bool numbered = skip_number();
  skip_label(cursor_, end_);
  // SIE-MOD-05
  const bool skips = machine_.profile.block_skip || machine_.has("block-skip-always"_fault);
  if (slash && skips) return Block::Reading::kSkipped;
  const Block::Reading reading = numbered ? read_items() : Block::Reading::kSyntax;
  for (const Late& late : late_) machine_.state.parameters[late.index] = late.value;
  return reading;
}

// `N10` or `:10`; false when the number is none.
bool BlockReader::skip_number() {
  if (cursor_ == end_) return true;
  const bool word = capital(*cursor_) == 'N' && !(end_ - cursor_ > 1 && is_name_start(cursor_[1]));
  if (!word && *cursor_ != ':') return true;
  if (machine_.has("capitals-only"_fault) && *cursor_ == 'n') return false;
  ++cursor_;
  skip();
  if (cursor_ == end_ || !is_digit(*cursor_)) return false;
  while (cursor_ != end_ && is_digit(*cursor_)) ++cursor_;
  skip();
  return true;
}

Block::Reading BlockReader::read_items() {
  for (;; ++block_.items_) {
    skip();
    const char* from = cursor_;
    if (cursor_ == end_ || at(';')) {
      return block_.outside_.empty() ? Block::Reading::kWords : Block::Reading::kOutside;
    }
    const Scan scan = item();
    if (scan == Scan::kSyntax) return Block::Reading::kSyntax;
    if (scan == Scan::kRead) continue;
    note_outside(std::string_view(from, static_cast<std::size_t>(end_ - from)).substr(0, 16));
    return Block::Reading::kOutside;
  }
}

Scan BlockReader::item() {
  if (at('$')) return Scan::kOutside;
  const bool small = *cursor_ >= 'a' && *cursor_ <= 'z';
  const bool named = end_ - cursor_ > 1 && is_name_start(cursor_[0]) && is_name_start(cursor_[1]);
  if (!named && !is_letter(*cursor_)) return Scan::kSyntax;
  if (small && machine_.has("capitals-only"_fault)) return Scan::kSyntax;
  return named ? name() : letter();
}

Scan BlockReader::letter() {
  const char letter = capital(*cursor_++);
  skip();
  if (letter == 'R') return assignment();
  if (letter == 'N') return Scan::kSyntax;
  Name name = find_letter(letter);
  bool may_assign = letter != 'G' && letter != 'L';
  const char* digits = cursor_;
  std::size_t index = 0;
  if (!at('=') && read_index(cursor_, end_, kLargestIndex, index)) {
    skip();
    // I1=3, S2=500: a letter with a number of its own.
    if (at('=')) {
      const bool intermediate = index == 1 && letter >= 'I' && letter <= 'K';
      name = {letter == 'H' ? NameKind::kIgnored : NameKind::kOutside};
      if (intermediate) {
        const auto axis = static_cast<std::size_t>(letter - 'I');
        name = {NameKind::kAddress, intermediate_address(axis)};
      }
      may_assign = letter != 'G';
    } else {
      cursor_ = digits;
    }
  }
  Value number;
  Scan scan = Scan::kSyntax;
  if (at('=')) {
    if (may_assign) scan = value(letter, number);
  } else if (decimal(number)) {
    scan = at_exponent(cursor_, end_) ? Scan::kOutside : Scan::kRead;
  }
  return scan == Scan::kRead ? take(name, {&letter, 1}, number) : scan;
}

bool BlockReader::decimal(Value& value) {
  const bool read = read_decimal(cursor_, end_, value.number);
  value.counts = static_cast<Real>(value.number.value);
  return read;
}

Scan BlockReader::assignment() {
  if (at('[') || at('=')) return Scan::kOutside;
  std::size_t index = 0;
  if (!read_index(cursor_, end_, kLargestIndex, index)) return Scan::kSyntax;
  skip();
  if (!at('=')) return Scan::kSyntax;
  Value number;
  const Scan scan = value('R', number);
  if (scan != Scan::kRead) return scan;
  if (number.mode != Value::Mode::kPlain) return Scan::kSyntax;
  if (index >= parameter_count(machine_.control())) {
    block_.undefined_.note(position(), 'R');
  } else if (machine_.has("assignment-late"_fault)) {
    late_.push_back({index, number.counts / kOne});
  } else {
    machine_.state.parameters[index] = number.counts / kOne;
  }
  return Scan::kRead;
}

Scan BlockReader::name() {
  const char* from = cursor_;
  std::string text;
  for (; cursor_ != end_ && is_name_part(*cursor_); ++cursor_) {
    // No name that is known is as long as that.
    if (text.size() < 16) text += capital(*cursor_);
  }
  const bool rotation = text.starts_with("RPL") && are_digits(from + 3, cursor_);
  if (rotation) {
    text.resize(3);
    cursor_ = from + 3;
  } else {
    // CR5, TURN2: an address whose `=` is missing.
    const std::size_t letters = std::min(text.find_first_of("0123456789"), text.size());
    const bool digits = are_digits(from + letters, cursor_) && from + letters != cursor_;
    const Name word = find_name(text.substr(0, letters), machine_.control());
    if (digits && word.kind == NameKind::kAddress) return Scan::kSyntax;
  }
  const Name name = find_name(text, machine_.control());
  if (name.kind == NameKind::kControl) return Scan::kOutside;
  skip();
  const bool bare = name.kind == NameKind::kCode;
  const bool address = name.kind == NameKind::kAddress;
  if (at('[')) return Scan::kOutside;
  if (rotation && !at('=') && !at('(')) return loose_rotation();
  Value number;
  if (at('=')) {
    if (bare) return Scan::kSyntax;
    const Scan scan = value(text[0], number);
    if (scan != Scan::kRead) return scan;
  } else if (at('(') ? bare || address || !skip_call(cursor_, end_) : address) {
    return Scan::kSyntax;
  }
  return take(name, text, number);
}

// SIE-FRM-03: `RPL45`.
Scan BlockReader::loose_rotation() {
  const char* from = cursor_;
  Value number;
  const bool read = decimal(number);
  if (!read) cursor_ = from;
  // 840D has no RPL, with or without a value.
  if (machine_.control() == Control::k840D) return take({NameKind::kOutside}, "RPL", number);
  if (!read || machine_.follows("sie.rpl-equals=required"_reading)) return Scan::kSyntax;
  warn("RPL stands without its =.");
  return take_word(Address::kRotation, 'R', number);
}

// At the `=`.
Scan BlockReader::value(char letter, Value& value) {
  ++cursor_;
  skip();
  const bool wrapped = end_ - cursor_ > 2 && capital(cursor_[1]) == 'C' &&
                       (capital(cursor_[0]) == 'A' || capital(cursor_[0]) == 'I') &&
                       !is_name_part(cursor_[2]);
  if (!wrapped) return expression(letter, value);
  const bool absolute = capital(*cursor_) == 'A';
  cursor_ += 2;
  skip();
  if (!at('(')) return Scan::kSyntax;
  ++cursor_;
  const Scan scan = expression(letter, value);
  if (scan != Scan::kRead) return scan;
  skip();
  if (!at(')')) return Scan::kSyntax;
  ++cursor_;
  if (machine_.has(absolute ? "ac-ignored"_fault : "ic-ignored"_fault)) return Scan::kRead;
  value.mode = absolute ? Value::Mode::kAbsolute : Value::Mode::kIncremental;
  return Scan::kRead;
}

// What rounding leaves of a calculation whose value is zero, such as SIN(180), in counts.
constexpr Real kResidue = 1e-6L;

Scan BlockReader::expression(char letter, Value& value) {
  skip();
  const std::size_t count = parameter_count(machine_.control());
  Expression expression(cursor_, end_, std::span(machine_.state.parameters).first(count),
                        machine_.has("left-to-right"_fault));
  const Scan scan = expression.read();
  value.number = to_counts(expression.value());
  const Real counts = expression.value() * kOne;
  value.counts = expression.calculated() && std::fabs(counts) <= kResidue ? 0 : counts;
  if (expression.undefined()) block_.undefined_.note(position(), letter);
  return scan;
}

// AC( ) and IC( ) may stand with further axes, too.
Scan BlockReader::take(const Name& name, std::string_view text, const Value& value) {
  if (name.kind == NameKind::kAddress) return take_word(name.address, text[0], value);
  const bool axis = text.size() == 1 && is_axis(text[0]);
  if (value.mode != Value::Mode::kPlain && !axis) return Scan::kSyntax;
  switch (name.kind) {
    case NameKind::kGCode:
      take_code(value.number);
      break;
    case NameKind::kFunction:
      block_.functions_.push_back({value.number, position()});
      break;
    case NameKind::kCode:
      put_code(*name.code, text[0]);
      break;
    case NameKind::kIgnored:
      if (text.size() > 1) warn(std::string(text) + " is ignored.");
      break;
    case NameKind::kOutside:
      note_outside(text);
      break;
    default:
      block_.unknown_.note(position(), text[0]);
      break;
  }
  return Scan::kRead;
}

Scan BlockReader::take_word(Address address, char letter, const Value& value) {
  if (value.mode != Value::Mode::kPlain && (kPlaces & bit(address)) == 0) return Scan::kSyntax;
  if (block_.has(address)) {
    block_.duplicate_.note(position(), letter);
    return Scan::kRead;
  }
  block_.words_ |= bit(address);
  block_.values_[Block::index_of(address)] = value;
  block_.positions_[Block::index_of(address)] = position();
  return Scan::kRead;
}

void BlockReader::take_code(const Decimal& number) {
  const Code* code = find_code(number, machine_.control());
  if (code == nullptr) return block_.unknown_.note(position(), 'G');
  if (code->support == Support::kOutside) return note_outside("This G code");
  put_code(*code, 'G');
}

void BlockReader::put_code(const Code& code, char letter) {
  const Code*& place = block_.codes_[code.group];
  // Cycles stand alone: that two are too many is seen where they are run.
  if (place != nullptr && code.group == static_cast<GroupNumber>(Group::kCycle)) return;
  if (place != nullptr) return block_.duplicate_.note(position(), letter);
  place = &code;
}

void BlockReader::note_outside(std::string_view what) {
  if (block_.outside_.empty()) block_.outside_ = what;
}

Block::Reading Block::read(std::string_view line, Machine& machine) {
  words_ = 0;
  codes_.fill(nullptr);
  functions_.clear();
  items_ = 0;
  outside_.clear();
  unknown_ = duplicate_ = undefined_ = Defect{};
  if (line.size() > kLongestLine) return Reading::kSyntax;
  return BlockReader(line, *this, machine).read();
}

bool Block::has_only(Addresses addresses) const {
  return items_ == static_cast<std::size_t>(std::popcount(words_ & addresses)) + 1;
}

}  // namespace gonogo::expanders::sinumerik
