// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/sinumerik/block.hpp"

#include <algorithm>

#include "expanders/common/tokenizer.hpp"

namespace gonogo::expanders::sinumerik {
namespace {

// AC( ) and IC( ) belong to coordinates, centres and the polar angle.
constexpr Addresses kPlaces = addresses(
    Address::kX, Address::kY, Address::kZ, Address::kA, Address::kC, Address::kI, Address::kJ,
    Address::kK, Address::kI1, Address::kJ1, Address::kK1, Address::kPolarAngle);

bool is_axis(char letter) {
  return std::string_view("XYZABCEOQUVW").find(letter) != std::string_view::npos;
}

}  // namespace

void Block::clear() {
  words_ = 0;
  codes_.fill(nullptr);
  functions_.clear();
  warnings_.clear();
  late_.clear();
  items_ = 0;
  loose_rotation_ = false;
  outside_ = {};
  unknown_ = duplicate_ = undefined_ = Defect{};
}

// Keeps a copy: the line is gone when the note is sent.
void Block::note_outside(std::string_view what) {
  if (!outside_.empty()) return;
  const std::size_t size = std::min(what.size(), text_.size());
  std::copy_n(what.begin(), size, text_.begin());
  outside_ = {text_.data(), size};
}

Block::Reading Block::read(std::string_view line, const Manner& manner, Parameters& parameters) {
  clear();
  if (line.size() > kLongestLine) return Reading::kSyntax;
  control_ = manner.tokens.control;
  Tokenizer tokens(line, parameters, manner.tokens);
  const Head head = tokens.head();
  if (head.kind == Head::Kind::kProgramName) return Reading::kWords;
  if (head.skip && manner.skips) return Reading::kSkipped;
  if (head.kind == Head::Kind::kSyntax) return Reading::kSyntax;
  const Reading reading = read_items(tokens, manner, parameters);
  for (const Late& late : late_) parameters[late.index] = late.value;
  return reading;
}

Block::Reading Block::read_items(Tokenizer& tokens, const Manner& manner, Parameters& parameters) {
  for (;; ++items_) {
    const Item item = tokens.next();
    switch (item.kind) {
      case Item::Kind::kEnd:
        return outside_.empty() ? Reading::kWords : Reading::kOutside;
      case Item::Kind::kSyntax:
        return Reading::kSyntax;
      case Item::Kind::kOutside:
        note_outside(item.text);
        return Reading::kOutside;
      default:
        if (!take(item, manner, parameters)) return Reading::kSyntax;
    }
  }
}

// False: a syntax error.
bool Block::take(const Item& item, const Manner& manner, Parameters& parameters) {
  const auto position = static_cast<Position>(items_);
  if (item.value.undefined) undefined_.note(position, item.letter);
  switch (item.kind) {
    case Item::Kind::kAssignment:
      if (item.value.mode != Value::Mode::kPlain) return false;
      if (item.index >= parameter_count(control_)) {
        undefined_.note(position, 'R');
      } else if (manner.assigns_late) {
        late_.push_back({item.index, item.real});
      } else {
        parameters[item.index] = item.real;
      }
      return true;
    case Item::Kind::kName:
      return take_name(item);
    case Item::Kind::kLetter:
      return take_letter(item);
    case Item::Kind::kIndexed:
      return take_indexed(item);
    default:
      return false;
  }
}

bool Block::take_letter(const Item& item) {
  const Letter letter = find_letter(item.letter);
  const auto position = static_cast<Position>(items_);
  if (letter.kind == LetterKind::kAddress) return take_word(letter.address, item);
  const bool axis = letter.kind == LetterKind::kOutside && is_axis(item.letter);
  if (item.value.mode != Value::Mode::kPlain && !axis) return false;
  switch (letter.kind) {
    case LetterKind::kCode:
      take_code(item.value);
      break;
    case LetterKind::kFunction:
      functions_.push_back({item.value, position});
      break;
    case LetterKind::kOutside:
      note_outside({&item.letter, 1});
      break;
    case LetterKind::kUnknown:
      unknown_.note(position, item.letter);
      break;
    default:
      break;
  }
  return true;
}

bool Block::take_indexed(const Item& item) {
  const bool intermediate = item.index == 1 && item.letter >= 'I' && item.letter <= 'K';
  if (intermediate) {
    return take_word(intermediate_address(static_cast<std::size_t>(item.letter - 'I')), item);
  }
  if (item.value.mode != Value::Mode::kPlain && !is_axis(item.letter)) return false;
  if (item.letter != 'H') note_outside({&item.letter, 1});
  return true;
}

bool Block::take_name(const Item& item) {
  if (item.loose) loose_rotation_ = true;
  if (item.name.kind == NameKind::kAddress) return take_word(item.name.address, item);
  if (item.value.mode != Value::Mode::kPlain) return false;
  switch (item.name.kind) {
    case NameKind::kThroughPoint:
      put_code(through_point_code(), item.letter);
      break;
    case NameKind::kTangent:
      put_code(tangent_code(), item.letter);
      break;
    case NameKind::kCycle:
      put_code(cycle_code(item.name.text), item.letter);
      break;
    case NameKind::kPassedOver:
      warnings_.push_back(item.name.text);
      break;
    case NameKind::kOutside:
      note_outside(item.name.text);
      break;
    default:
      unknown_.note(static_cast<Position>(items_), item.letter);
      break;
  }
  return true;
}

bool Block::take_word(Address address, const Item& item) {
  const auto position = static_cast<Position>(items_);
  if (item.value.mode != Value::Mode::kPlain && (kPlaces & bit(address)) == 0) return false;
  if (has(address)) {
    duplicate_.note(position, item.letter);
    return true;
  }
  words_ |= bit(address);
  values_[index_of(address)] = item.value;
  positions_[index_of(address)] = position;
  return true;
}

void Block::take_code(const Value& value) {
  const Decimal& number = value.number;
  const bool whole = !number.overflow && !number.finer && number.value % kOne == 0;
  const Code* code = whole ? find_code(number.value / kOne, control_) : nullptr;
  if (code == nullptr) return unknown_.note(static_cast<Position>(items_), 'G');
  if (code->support == Support::kOutside) return note_outside("This G code");
  put_code(*code, 'G');
}

void Block::put_code(const Code& code, char letter) {
  const Code*& place = codes_[static_cast<std::size_t>(code.group)];
  // Cycles stand alone: that two are too many is seen where they are run.
  if (place != nullptr && code.group == Group::kCycle) return;
  if (place != nullptr) return duplicate_.note(static_cast<Position>(items_), letter);
  place = &code;
}

}  // namespace gonogo::expanders::sinumerik
