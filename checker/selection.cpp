// SPDX-License-Identifier: GPL-3.0-or-later
#include "checker/selection.hpp"

#include <algorithm>
#include <cstdio>

#include "checker/sha256.hpp"

namespace gonogo::checker {

Selection::Selection(const Json& header) {
  const std::string& shard = header.text_of("shard");
  if (std::sscanf(shard.c_str(), "%lu/%lu", &shard_, &shards_) != 2 || shard_ < 1 ||
      shard_ > shards_) {
    throw Fault("The shard of the header is no i/n.");
  }
  const Json* selection = header.find("selection");
  if (selection == nullptr) return;
  dialects_ = selection->member("dialects", Json::Kind::list).texts();
  only_ = selection->member("only", Json::Kind::list).texts();
  if (const Json* one = selection->find("case"); one != nullptr && !one->text.empty()) {
    cases_ = {one->text};
  }
  if (const Json* list = selection->find("cases")) cases_ = list->texts();
  if (const Json* list = selection->find("cycles")) cycles_ = list->texts();
  if (const Json* list = selection->find("clauses")) clauses_ = list->texts();
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
    } else if (g < glob.size() && (glob[g] == '?' || glob[g] == text[t])) {
      ++g;
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
