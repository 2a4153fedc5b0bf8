// SPDX-License-Identifier: GPL-3.0-or-later
#include "checker/selection.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <optional>

#include "checker/sha256.hpp"

namespace gonogo::checker {
namespace {

// What of a glob stands for one letter: where it ends, and whether it takes the letter.
struct Element {
  std::size_t end;
  bool takes;
};

// [:digit:] and its like.
bool is_of_class(std::string_view name, char c) {
  struct Class {
    std::string_view name;
    int (*has)(int);
  };
  constexpr std::array<Class, 12> kClasses = {{{"alnum", std::isalnum},
                                               {"alpha", std::isalpha},
                                               {"blank", std::isblank},
                                               {"cntrl", std::iscntrl},
                                               {"digit", std::isdigit},
                                               {"graph", std::isgraph},
                                               {"lower", std::islower},
                                               {"print", std::isprint},
                                               {"punct", std::ispunct},
                                               {"space", std::isspace},
                                               {"upper", std::isupper},
                                               {"xdigit", std::isxdigit}}};
  const auto found = std::ranges::find(kClasses, name, &Class::name);
  return found != kClasses.end() && found->has(static_cast<unsigned char>(c)) != 0;
}

// A letter within brackets, which a backslash may stand before; nothing at the end of the glob.
std::optional<unsigned char> letter_at(std::string_view glob, std::size_t& at) {
  if (at < glob.size() && glob[at] == '\\') ++at;
  if (at >= glob.size()) return std::nullopt;
  return static_cast<unsigned char>(glob[at++]);
}

// [a-f], [!1]; nothing where no bracket closes it: it stands for itself then.
std::optional<Element> set_at(std::string_view glob, std::size_t at, char c) {
  std::size_t i = at + 1;
  const bool is_negated = i < glob.size() && (glob[i] == '!' || glob[i] == '^');
  if (is_negated) ++i;
  const std::size_t first = i;
  const auto letter = static_cast<unsigned char>(c);
  bool is_in = false;
  while (i < glob.size() && (glob[i] != ']' || i == first)) {
    const std::size_t named =
        glob.substr(i, 2) == "[:" ? glob.find(":]", i + 2) : std::string_view::npos;
    if (named != std::string_view::npos) {
      is_in = is_in || is_of_class(glob.substr(i + 2, named - i - 2), c);
      i = named + 2;
      continue;
    }
    const auto low = letter_at(glob, i);
    auto high = low;
    if (i + 1 < glob.size() && glob[i] == '-' && glob[i + 1] != ']') high = letter_at(glob, ++i);
    if (!low || !high) return std::nullopt;
    is_in = is_in || (*low <= letter && letter <= *high);
  }
  if (i >= glob.size()) return std::nullopt;
  return Element{i + 1, is_in != is_negated};
}

Element element_at(std::string_view glob, std::size_t at, char c) {
  if (glob[at] == '?') return {at + 1, true};
  if (glob[at] == '\\') {
    return at + 1 < glob.size() ? Element{at + 2, glob[at + 1] == c} : Element{at + 1, false};
  }
  if (glob[at] == '[') {
    if (const auto set = set_at(glob, at, c)) return *set;
  }
  return {at + 1, glob[at] == c};
}

}  // namespace

Selection::Selection(const Json& header) {
  const std::string& shard = header.text_of("shard");
  if (std::sscanf(shard.c_str(), "%lu/%lu", &shard_, &shards_) != 2 || shard_ < 1 ||
      shard_ > shards_) {
    throw Fault("The shard of the header is no i/n.");
  }
  const Json* selection = header.find("selection");
  if (selection == nullptr) return;
  dialects_ = selection->texts_of("dialects");
  only_ = selection->texts_of("only");
  if (const Json* one = selection->find("case"); one != nullptr && !one->text.empty()) {
    cases_ = {one->text};
  }
  if (const Json* list = selection->find("cases")) cases_ = list->texts();
  cycles_ = selection->texts_at("cycles");
  clauses_ = selection->texts_at("clauses");
}

bool Selection::takes(const std::string& id, const Topic& topic) const {
  const auto names = [](const std::vector<std::string>& list, const std::string& word) {
    return list.empty() || std::ranges::find(list, word) != list.end();
  };
  if (!names(dialects_, topic.dialect) || !names(cases_, id) || !names(cycles_, topic.cycle)) {
    return false;
  }
  if (!clauses_.empty() &&
      std::ranges::none_of(topic.clauses, [&](const auto& one) { return names(clauses_, one); })) {
    return false;
  }
  const bool is_named = only_.empty() || std::ranges::any_of(only_, [&](const std::string& glob) {
                          return matches_glob(glob, id);
                        });
  return is_named && shard_of(id, shards_) == shard_ - 1;
}

bool matches_glob(std::string_view glob, std::string_view text) {
  std::size_t g = 0;
  std::size_t t = 0;
  std::size_t star = std::string_view::npos;  // the last one, and how much it stands for so far
  std::size_t swallowed = 0;
  while (t < text.size()) {
    if (g < glob.size() && glob[g] == '*') {
      star = g++;
      swallowed = t;
      continue;
    }
    const Element element = g < glob.size() ? element_at(glob, g, text[t]) : Element{g, false};
    if (element.takes) {
      g = element.end;
      ++t;
    } else if (star != std::string_view::npos) {
      g = star + 1;
      t = ++swallowed;
    } else {
      return false;
    }
  }
  while (g < glob.size() && glob[g] == '*') ++g;
  return g == glob.size();
}

unsigned long shard_of(std::string_view id, unsigned long shards) {
  Sha256 hash;
  hash.update(id);
  const Sha256::Digest digest = hash.digest();
  unsigned long first = 0;
  for (std::size_t i = 0; i < 8; ++i) first = (first << 8) | digest[i];
  return first % shards;
}

}  // namespace gonogo::checker
