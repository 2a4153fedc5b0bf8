// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/program/mutator/dictionary_entries.hpp"

#include <algorithm>

#include "fuzz/program/mutator/dictionary.hpp"

namespace gonogo::program {
namespace {

using reference::Code;
using reference::CodeWord;
using reference::Kind;
using reference::Role;

// A value that the word may well have.
std::string_view value_of(Role role) {
  switch (role) {
    case Role::place:
      return "50";
    case Role::way:
    case Role::along_d:
      return "-10";
    case Role::centre:
      return "-5";
    case Role::middle:
      return "20";
    case Role::along_p:
    case Role::along_q:
      return "-2.5";
    case Role::radius:
      return "16";
    case Role::size:
    case Role::step:
      return "3";
    case Role::turns:
    case Role::count:
    case Role::number:
      return "2";
    case Role::angle:
    case Role::polar_angle:
      return "45";
    case Role::polar_radius:
      return "20";
    case Role::lead:
      return "1.5";
    case Role::feed:
      return "150";
    case Role::speed:
      return "500";
    case Role::time:
    case Role::parameter:
      return "1";
  }
  return "";
}

// A name that stands for those with any number, with this one: "R1" of "R<n>".
std::string numbered(std::string_view pattern, std::string_view number) {
  constexpr std::string_view kAnyNumber = "<n>";
  if (!pattern.ends_with(kAnyNumber)) return std::string(pattern);
  return std::string(pattern.substr(0, pattern.size() - kAnyNumber.size())).append(number);
}

// "X50", "CR=16", "R1=1"; nothing of words that stand for several.
std::string entry_of(const CodeWord& word) {
  const std::string address = numbered(word.address, "1");
  if (address.find(' ') != std::string::npos) return "";
  return address + (address.size() > 1 ? "=" : "") + std::string(value_of(word.role));
}

// Words one after the other, in blocks that are no longer than an entry may be.
class Blocks {
 public:
  Blocks(std::string_view head, std::vector<std::string>& entries)
      : head_(head), block_(head), entries_(entries) {}
  void add(const CodeWord& word) {
    const std::string text = entry_of(word);
    if (text.empty()) return;
    if (block_.size() + 1 + text.size() > kLongestEntry) put();
    block_ += (block_.empty() ? "" : " ") + text;
  }
  void put() {
    if (block_.size() > head_.size()) entries_.push_back(block_);
    block_ = head_;
  }

 private:
  std::string_view head_;
  std::string block_;
  std::vector<std::string>& entries_;
};

bool is_of_form(const CodeWord& word, Role form) {
  const bool shapes_arc = word.role == Role::centre || word.role == Role::radius;
  return !shapes_arc || word.role == form;
}

// An arc has one form: a centre or a radius.
void add_block(const Code& code, Role form, std::vector<std::string>& entries) {
  // The words of a cycle that is called by its name stand before it.
  Blocks blocks(code.tenths < 0 && code.kind == Kind::cycle ? "" : code.name, entries);
  for (const auto& list : code.words) {
    for (const CodeWord& word : list) {
      const bool is_end = word.role == Role::way || word.role == Role::polar_angle ||
                          word.role == Role::polar_radius;  // beside places
      if (!is_end && (code.kind != Kind::arc || is_of_form(word, form))) blocks.add(word);
    }
  }
  blocks.put();
}

void add_words(const reference::Descriptor& table, std::vector<std::string>& entries) {
  const auto add = [&](const CodeWord& word) { entries.push_back(entry_of(word)); };
  for (const Code& code : table.codes) {
    for (const auto& list : code.words) std::ranges::for_each(list, add);
  }
  std::ranges::for_each(table.everywhere, add);
  std::erase(entries, "");
}

}  // namespace

std::vector<std::string> entries_of(const reference::Descriptor& table) {
  std::vector<std::string> entries;
  for (const Code& code : table.codes) {
    // What names stand for that have no row.
    if (code.name.find(' ') != std::string_view::npos) continue;
    entries.push_back(numbered(code.name, "81"));
    if (code.last > 0) entries.push_back(code.name.front() + std::to_string(code.last / 10));
  }
  add_words(table, entries);
  for (const Code& code : table.codes) {
    if (code.treatment != reference::Treatment::read) continue;
    add_block(code, Role::centre, entries);
    if (code.kind == Kind::arc) add_block(code, Role::radius, entries);
  }
  return entries;
}

}  // namespace gonogo::program
