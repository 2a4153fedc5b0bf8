// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/records/plain_record.hpp"

#include <limits>
#include <optional>

#include "oracle/records/record_keys.hpp"

namespace gonogo::oracle {
namespace {

using reference::Axis;
using reference::AxisSet;
using reference::FeedMode;
using reference::Number;
using reference::Plane;
using reference::Position;
using reference::Record;
using reference::RecordKind;

// The line as tokens. Each member takes one off the front, or says false and leaves the cursor
// anywhere: then the line is given up.
class Cursor {
 public:
  explicit Cursor(std::string_view text) : at_(text.data()), end_(at_ + text.size()) {}

  // One byte of the syntax, behind blanks.
  bool take(char byte) {
    skip_blanks();
    if (at_ == end_ || *at_ != byte) return false;
    ++at_;
    return true;
  }
  bool take_string(std::string_view& text) {
    if (!take('"')) return false;
    const char* const begin = at_;
    while (at_ != end_ && is_plain(*at_)) ++at_;
    if (at_ == end_ || *at_ != '"') return false;
    text = {begin, static_cast<std::size_t>(at_ - begin)};
    ++at_;
    return true;
  }
  bool take_key(std::string_view& key) { return take_string(key) && take(':'); }
  bool take_number(Number& number) {
    const char* const begin = at_;
    if (take_short_decimal(number)) return true;
    at_ = begin;
    std::string_view text;
    if (!take_string(text) || text.size() > kLongestString) return false;
    std::optional<Number> value = Number::parse(text);
    if (!value) return false;
    number = *std::move(value);
    return true;
  }
  // A JSON integer of [low, high], of so few digits that it fits.
  bool take_integer(std::int64_t low, std::int64_t high, std::int64_t& number) {
    constexpr std::ptrdiff_t kMostDigits = 18;
    skip_blanks();
    const bool negative = at_ != end_ && *at_ == '-';
    if (negative) ++at_;
    const char* const begin = at_;
    std::int64_t magnitude = 0;
    for (; at_ != end_ && is_digit(*at_) && at_ - begin < kMostDigits; ++at_) {
      magnitude = magnitude * 10 + (*at_ - '0');
    }
    if (at_ == begin || at_ == end_ || (*begin == '0' && at_ - begin > 1)) return false;
    number = negative ? -magnitude : magnitude;
    const bool goes_on = is_digit(*at_) || *at_ == '.' || *at_ == 'e' || *at_ == 'E';
    return !goes_on && number >= low && number <= high;
  }
  bool at_end() {
    skip_blanks();
    return at_ == end_;
  }

 private:
  // [-] digits [. digits], in one pass: of so few digits that they fit, and of no more places than
  // the small form of a number has.
  bool take_short_decimal(Number& number) {
    constexpr std::ptrdiff_t kMostDigits = 12;
    constexpr std::uint64_t kParts[] = {1'000'000, 100'000, 10'000, 1'000, 100, 10, 1};
    if (!take('"')) return false;
    const bool negative = at_ != end_ && *at_ == '-';
    if (negative) ++at_;
    std::uint64_t magnitude = 0;  // wraps round where it is given up
    const auto take_digits = [&] {
      const char* const first = at_;
      for (; at_ != end_ && is_digit(*at_); ++at_) {
        magnitude = magnitude * 10 + static_cast<std::uint64_t>(*at_ - '0');
      }
      return at_ - first;
    };
    const std::ptrdiff_t digits = take_digits();
    std::ptrdiff_t places = 0;
    if (digits > 0 && digits <= kMostDigits && at_ != end_ && *at_ == '.') {
      ++at_;
      places = take_digits();
    }
    const bool fits = digits > 0 && digits + places <= kMostDigits && places <= 6;
    if (!fits || at_ == end_ || *at_ != '"') return false;
    ++at_;
    const auto count = static_cast<std::int64_t>(magnitude * kParts[places]);
    number = Number::millionths(negative ? -count : count);
    return true;
  }
  static bool is_digit(char byte) { return byte >= '0' && byte <= '9'; }
  static bool is_plain(char byte) {
    return byte >= ' ' && byte <= '~' && byte != '"' && byte != '\\';
  }
  void skip_blanks() {
    while (at_ != end_ && (*at_ == ' ' || *at_ == '\t')) ++at_;
  }

  const char* at_;
  const char* end_;
};

// One object of axes.
bool take_position(Cursor& cursor, Position& at, AxisSet& named) {
  if (!cursor.take('{')) return false;
  do {
    std::string_view key;
    if (!cursor.take_key(key) || key.size() != 1) return false;
    const std::size_t place = std::string_view("xyzac").find(key[0]);
    if (place == std::string_view::npos || named.has(reference::kAllAxes[place])) return false;
    named.add(reference::kAllAxes[place]);
    if (!cursor.take_number(at.at[place])) return false;
  } while (cursor.take(','));
  return cursor.take('}');
}

// A record while its keys come in, in any order.
class PlainRecord {
 public:
  explicit PlainRecord(Record& record) : record_(record) {}

  bool read(Cursor& cursor) {
    if (!cursor.take('{')) return false;
    do {
      if (!take_field(cursor)) return false;
    } while (cursor.take(','));
    return cursor.take('}') && cursor.at_end() && complete();
  }

 private:
  bool take_field(Cursor& cursor);
  bool take_value(Key key, Cursor& cursor);
  bool take_kind(Cursor& cursor);
  bool take_feed_mode(Cursor& cursor);
  bool take_plane(Cursor& cursor);
  bool complete();
  bool complete_arc();

  Record& record_;
  const Shape* shape_ = nullptr;
  std::uint32_t present_ = 0;
  bool has_clause_ = false;
  Position centre_;
  AxisSet centre_axes_;
};

bool PlainRecord::take_field(Cursor& cursor) {
  std::string_view text;
  if (!cursor.take_key(text)) return false;
  if (text == "clause") {
    const bool twice = has_clause_;
    has_clause_ = true;
    return !twice && cursor.take_string(text);
  }
  const std::optional<Key> key = record_key(text);
  if (!key || (present_ & bit(*key)) != 0) return false;
  present_ |= bit(*key);
  return take_value(*key, cursor);
}

bool PlainRecord::take_value(Key key, Cursor& cursor) {
  constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max();
  std::int64_t number = 0;
  switch (key) {
    case Key::k:
      return take_kind(cursor);
    case Key::b:
      if (!cursor.take_integer(1, std::numeric_limits<std::int64_t>::max(), number)) return false;
      record_.block = static_cast<std::uint64_t>(number);
      return true;
    case Key::to:
      return take_position(cursor, record_.to, record_.axes);
    case Key::f:
      return cursor.take_number(record_.feed);
    case Key::fm:
      return take_feed_mode(cursor);
    case Key::plane:
      return take_plane(cursor);
    case Key::c:
      return take_position(cursor, centre_, centre_axes_);
    case Key::rot:
      if (!cursor.take_integer(-kMost, kMost, number)) return false;
      record_.rot = static_cast<std::int32_t>(number);
      return true;
    case Key::lead:
      return cursor.take_number(record_.lead);
    case Key::start:
      return cursor.take_number(record_.start);
    case Key::s:
      return cursor.take_number(record_.seconds);
    case Key::m:
      if (!cursor.take_integer(0, kMost, number)) return false;
      record_.m = static_cast<std::int32_t>(number);
      return true;
    default:
      return false;  // circles in space and alarms are rare
  }
}

bool PlainRecord::take_kind(Cursor& cursor) {
  std::string_view text;
  if (!cursor.take_string(text)) return false;
  for (const Shape& shape : kShapes) {
    if (shape.name != text) continue;
    shape_ = &shape;
    record_.kind = shape.kind;
    return true;
  }
  return false;
}

bool PlainRecord::take_feed_mode(Cursor& cursor) {
  std::string_view text;
  if (!cursor.take_string(text) || (text != "min" && text != "rev")) return false;
  record_.feed_mode = text == "rev" ? FeedMode::per_revolution : FeedMode::per_minute;
  return true;
}

bool PlainRecord::take_plane(Cursor& cursor) {
  std::string_view text;
  if (!cursor.take_string(text) || text.size() != 3 || !text.starts_with("G1")) return false;
  if (text[2] < '7' || text[2] > '9') return false;
  record_.plane = static_cast<Plane>(text[2] - '7');
  return true;
}

bool PlainRecord::complete() {
  if (shape_ == nullptr) return false;
  const bool fits = (shape_->required & ~present_) == 0 && (present_ & ~shape_->allowed) == 0;
  return fits && (shape_->kind != RecordKind::arc || complete_arc());
}

bool PlainRecord::complete_arc() {
  const auto [p, q, d] = reference::axes_of(record_.plane);
  if (centre_axes_ != AxisSet{p, q} || !record_.axes.has(p) || !record_.axes.has(q)) return false;
  record_.centre = {std::move(centre_[p]), std::move(centre_[q])};
  return record_.rot != 0;
}

}  // namespace

bool read_plain_record(std::string_view line, Record& record) {
  Cursor cursor(line);
  return PlainRecord(record).read(cursor);
}

}  // namespace gonogo::oracle
