// SPDX-License-Identifier: GPL-3.0-or-later
#include "checker/json.hpp"

#include <algorithm>
#include <string>

namespace gonogo::checker {
namespace {

constexpr int kDeepest = 64;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

void append_utf8(std::string& out, unsigned long code) {
  const auto put = [&](unsigned long byte) { out += static_cast<char>(byte); };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xC0 | (code >> 6));
    put(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    put(0xE0 | (code >> 12));
    put(0x80 | ((code >> 6) & 0x3F));
    put(0x80 | (code & 0x3F));
  } else {
    put(0xF0 | (code >> 18));
    put(0x80 | ((code >> 12) & 0x3F));
    put(0x80 | ((code >> 6) & 0x3F));
    put(0x80 | (code & 0x3F));
  }
}

class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  Json document() {
    Json value = read_value(0);
    skip_blanks();
    if (at_ != text_.size()) fail("something follows the value");
    return value;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw Fault("This is no JSON: at byte " + std::to_string(at_) + " " + what + ".");
  }
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void skip_blanks() {
    while (peek() == ' ' || peek() == '\t' || peek() == '\n' || peek() == '\r') ++at_;
  }
  void expect(char c) {
    skip_blanks();
    if (peek() != c) fail(std::string("a '") + c + "' is missing");
    ++at_;
  }
  bool take(char c) {
    skip_blanks();
    if (peek() != c) return false;
    ++at_;
    return true;
  }

  Json read_value(int depth) {
    if (depth > kDeepest) fail("the values are nested too deeply");
    skip_blanks();
    Json value;
    value.begin = at_;
    const char c = peek();
    if (c == '{') {
      read_object(value, depth);
    } else if (c == '[') {
      read_list(value, depth);
    } else if (c == '"') {
      value.kind = Json::Kind::text;
      value.text = read_text();
    } else if (c == '-' || is_digit(c)) {
      value.kind = Json::Kind::number;
      value.text = read_number();
    } else {
      read_name(value);
    }
    value.end = at_;
    return value;
  }

  void read_object(Json& value, int depth) {
    value.kind = Json::Kind::object;
    expect('{');
    if (take('}')) return;
    do {
      skip_blanks();
      std::string key = read_text();
      if (value.find(key) != nullptr) fail("the key \"" + key + "\" stands there twice");
      expect(':');
      Json member = read_value(depth + 1);
      value.members.push_back({std::move(key), std::move(member)});
    } while (take(','));
    expect('}');
  }

  void read_list(Json& value, int depth) {
    value.kind = Json::Kind::list;
    expect('[');
    if (take(']')) return;
    do {
      value.items.push_back(read_value(depth + 1));
    } while (take(','));
    expect(']');
  }

  void read_name(Json& value) {
    for (const std::string_view name : {"null", "true", "false"}) {
      if (text_.substr(at_, name.size()) != name) continue;
      at_ += name.size();
      value.kind = name == "null" ? Json::Kind::null : Json::Kind::boolean;
      value.truth = name == "true";
      return;
    }
    fail("no value begins");
  }

  void read_digits() {
    if (!is_digit(peek())) fail("a digit is missing");
    while (is_digit(peek())) ++at_;
  }

  std::string read_number() {
    const std::size_t begin = at_;
    if (peek() == '-') ++at_;
    if (peek() == '0') {
      ++at_;
    } else {
      read_digits();
    }
    if (peek() == '.') {
      ++at_;
      read_digits();
    }
    if (peek() == 'e' || peek() == 'E') {
      ++at_;
      if (peek() == '+' || peek() == '-') ++at_;
      read_digits();
    }
    return std::string(text_.substr(begin, at_ - begin));
  }

  unsigned long read_four_digits() {
    unsigned long code = 0;
    for (int i = 0; i < 4; ++i, ++at_) {
      const char c = peek();
      const std::size_t digit =
          std::string_view("0123456789abcdef")
              .find(c >= 'A' && c <= 'F' ? static_cast<char>(c - 'A' + 'a') : c);
      if (digit == std::string_view::npos) fail("a hexadecimal digit is missing");
      code = code * 16 + digit;
    }
    return code;
  }

  void read_escape(std::string& out) {
    constexpr std::string_view kNames = "\"\\/bfnrt";
    constexpr std::string_view kMeant = "\"\\/\b\f\n\r\t";
    const char c = peek();
    ++at_;
    if (c != 'u') {
      const std::size_t which = kNames.find(c);
      if (which == std::string_view::npos) fail("an escape is unknown");
      out += kMeant[which];
      return;
    }
    unsigned long code = read_four_digits();
    if (code >= 0xD800 && code < 0xDC00) {
      if (text_.substr(at_, 2) != "\\u") fail("half of a character is missing");
      at_ += 2;
      const unsigned long low = read_four_digits();
      if (low < 0xDC00 || low > 0xDFFF) fail("half of a character is missing");
      code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
    } else if (code >= 0xDC00 && code <= 0xDFFF) {
      fail("half of a character is missing");
    }
    append_utf8(out, code);
  }

  std::string read_text() {
    if (peek() != '"') fail("a text is missing");
    ++at_;
    std::string out;
    while (peek() != '"') {
      if (at_ >= text_.size()) fail("a text has no end");
      const char c = text_[at_++];
      if (static_cast<unsigned char>(c) < 0x20) fail("a control character stands in a text");
      if (c == '\\') {
        read_escape(out);
      } else {
        out += c;
      }
    }
    ++at_;
    return out;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

const Json* Json::find(std::string_view key) const {
  for (const auto& [name, value] : members) {
    if (name == key) return &value;
  }
  return nullptr;
}

const Json& Json::member(std::string_view key, Kind what) const {
  const Json* found = find(key);
  if (found == nullptr) throw Fault("The key \"" + std::string(key) + "\" is missing.");
  if (!found->is(what)) {
    throw Fault("The value of \"" + std::string(key) + "\" is of the wrong kind.");
  }
  return *found;
}

const std::string& Json::text_of(std::string_view key) const {
  return member(key, Kind::text).text;
}

long Json::integer_of(std::string_view key) const {
  return member(key, Kind::number).integer();
}

std::vector<std::string> Json::texts_of(std::string_view key) const {
  return member(key, Kind::list).texts();
}

std::string Json::text_at(std::string_view key) const {
  const Json* found = find(key);
  return found != nullptr && found->is(Kind::text) ? found->text : std::string();
}

std::vector<std::string> Json::texts_at(std::string_view key) const {
  const Json* found = find(key);
  return found == nullptr ? std::vector<std::string>() : found->texts();
}

long Json::integer() const {
  const bool is_whole = is(Kind::number) && text.size() <= 15 &&
                        text.find_first_not_of("-0123456789") == std::string::npos;
  if (!is_whole) throw Fault("An integer is wanted, not " + (text.empty() ? "this" : text) + ".");
  return std::stol(text);
}

std::vector<std::string> Json::texts() const {
  if (!is(Kind::list)) throw Fault("A list of texts is wanted.");
  std::vector<std::string> all;
  for (const Json& item : items) {
    if (!item.is(Kind::text)) throw Fault("A list holds what is no text.");
    all.push_back(item.text);
  }
  return all;
}

bool Json::same_as(const Json& other) const {
  if (kind != other.kind || truth != other.truth || text != other.text) return false;
  if (items.size() != other.items.size() || members.size() != other.members.size()) return false;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (!items[i].same_as(other.items[i])) return false;
  }
  return std::ranges::all_of(members, [&](const auto& member) {
    const Json* theirs = other.find(member.key);
    return theirs != nullptr && member.value.same_as(*theirs);
  });
}

Json parse_json(std::string_view text) {
  return Parser(text).document();
}

}  // namespace gonogo::checker
