// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/descriptor.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gonogo::reference {
namespace {

constexpr std::string_view kAnyNumber = "<n>";

std::string two_digits(char letter, int tenths) {
  return tenths % 10 == 0 ? fmt::format("{}{:02}", letter, tenths / 10)
                          : fmt::format("{}{}.{}", letter, tenths / 10, tenths % 10);
}

// Whether the name is that of the pattern with a number: CYCLE81 of CYCLE<n>.
bool is_numbered(std::string_view pattern, std::string_view name) {
  if (!pattern.ends_with(kAnyNumber)) return false;
  pattern.remove_suffix(kAnyNumber.size());
  if (!name.starts_with(pattern) || name.size() == pattern.size()) return false;
  return name.find_first_not_of("0123456789", pattern.size()) == std::string_view::npos;
}

// The words of the rule, without those that the code takes.
std::string words_left(const IgnoredWords& rule, const Code& code) {
  if (!rule.when.empty()) return fmt::format("{} {}", rule.words, rule.when);
  std::string left;
  std::string_view words = rule.words;
  while (!words.empty()) {
    const std::string_view word = words.substr(0, words.find(' '));
    words.remove_prefix(std::min(word.size() + 1, words.size()));
    if (code.find(word) == nullptr) left += (left.empty() ? "" : " ") + std::string(word);
  }
  return left;
}

}  // namespace

std::string code_name(int tenths) {
  return two_digits('G', tenths);
}

bool stands_for(const CodeWord& word, std::string_view address) {
  return word.address == address || is_numbered(word.address, address);
}

const CodeWord* Code::find(std::string_view address) const {
  for (const WordLists::List& list : words) {
    for (const CodeWord& word : list) {
      if (stands_for(word, address)) return &word;
    }
  }
  return nullptr;
}

std::string Code::text() const {
  if (tenths < 0) return std::string(name);
  const std::string first = two_digits(name.front(), tenths);
  return last == 0 ? first : fmt::format("{} to {}", first, two_digits(name.front(), last));
}

const Code* Descriptor::find(std::string_view name) const {
  if (name.empty()) return nullptr;  // of a word that is no code
  const int tenths = tenths_of_name(name);
  const auto found = std::ranges::find_if(codes, [&](const Code& code) {
    if (code.name == name || is_numbered(code.name, name)) return true;
    const bool is_family = code.last > 0 && code.name.front() == name.front() && tenths % 10 == 0;
    return is_family && code.tenths <= tenths && tenths <= code.last;
  });
  return found == codes.end() ? nullptr : &*found;
}

const CodeWord* Descriptor::find_word(const Code* code, std::string_view address) const {
  const CodeWord* const own = code == nullptr ? nullptr : code->find(address);
  if (own != nullptr) return own;
  const auto found = std::ranges::find_if(
      everywhere, [&](const CodeWord& word) { return stands_for(word, address); });
  return found == everywhere.end() ? nullptr : &*found;
}

const Code* Descriptor::find(Setting setting) const {
  const auto found = std::ranges::find(codes, setting, &Code::setting);
  return found == codes.end() ? nullptr : &*found;
}

const Code* Descriptor::find(Kind kind) const {
  const auto found = std::ranges::find_if(codes, [&](const Code& code) {
    return code.kind == kind && code.treatment == Treatment::read;
  });
  return found == codes.end() ? nullptr : &*found;
}

ClauseId Descriptor::clause_of_holding(Holds what, const Code& code) const {
  const auto found = std::ranges::find_if(holding, [&](const HoldingRule& rule) {
    return rule.what == what && code.name.starts_with(rule.codes) &&
           (what != Holds::mode || rule.group == code.group);
  });
  return found == holding.end() ? kNoClause : found->clause;
}

const Code* opposite_of(const Descriptor& descriptor, const Code& code) {
  const auto found = std::ranges::find_if(descriptor.codes, [&](const Code& other) {
    const bool is_kin = other.kind == code.kind && other.feature == code.feature;
    return is_kin && code.sense != 0 && other.sense == -code.sense;
  });
  return found == descriptor.codes.end() ? nullptr : &*found;
}

std::vector<OutsideCode> outside_codes(const Descriptor& descriptor) {
  std::vector<OutsideCode> found;
  for (const Code& code : descriptor.codes) {
    if (code.treatment == Treatment::outside) found.push_back({code.text(), code.title});
  }
  return found;
}

std::vector<std::string> codes_without_effect(const Descriptor& descriptor) {
  std::vector<std::string> found;
  for (const Code& code : descriptor.codes) {
    if (code.treatment == Treatment::without_effect) found.emplace_back(code.name);
  }
  for (const CodeWord& word : descriptor.everywhere) {
    const bool shapes_path = word.role == Role::feed || word.role == Role::parameter;
    if (!shapes_path && word.address.size() == 1) found.emplace_back(word.address);
  }
  return found;
}

std::string words_text(const Code& code) {
  std::string text;
  const CodeWord* before = nullptr;
  const auto end_of = [](const CodeWord& word) {
    return fmt::format(" {}{}", word.title, word.life == Life::modal ? " (modal)" : "");
  };
  for (const WordLists::List& list : code.words) {
    for (const CodeWord& word : list) {
      if (before != nullptr) {
        const bool goes_on = before->title == word.title && before->life == word.life;
        text += goes_on ? " " : end_of(*before) + "; ";
      }
      text += word.address;
      before = &word;
    }
  }
  return before == nullptr ? text : text + end_of(*before);
}

std::vector<PassedWords> passed_words(const Descriptor& descriptor) {
  std::vector<PassedWords> rules;
  for (const IgnoredWords& rule : descriptor.passed_everywhere) {
    rules.push_back({"every block", std::string(rule.words), rule.clause, rule.why});
  }
  for (const Code& code : descriptor.codes) {
    for (const IgnoredWords& rule : code.passed) {
      std::string words = words_left(rule, code);
      if (words.empty()) continue;
      const auto same = std::ranges::find_if(rules, [&](const PassedWords& known) {
        return known.words == words && known.clause == rule.clause && known.why == rule.why;
      });
      if (same == rules.end()) {
        rules.push_back({code.text(), std::move(words), rule.clause, rule.why});
      } else {
        same->codes += ", " + code.text();
      }
    }
  }
  return rules;
}

}  // namespace gonogo::reference
