// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which cases of the corpus a run was asked for, as its header says.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "checker/corpus.hpp"
#include "checker/json.hpp"

namespace gonogo::checker {

class Selection {
 public:
  // Throws Fault.
  explicit Selection(const Json& header);
  bool takes(const std::string& id, const Topic& topic) const;

 private:
  std::vector<std::string> dialects_;  // empty: all
  std::vector<std::string> only_;      // globs over ids; empty: all
  std::vector<std::string> cases_;     // empty: all
  std::vector<std::string> cycles_;    // empty: all
  std::vector<std::string> clauses_;   // empty: all
  unsigned long shard_ = 1;
  unsigned long shards_ = 1;
};

// As fnmatch reads it: `*` any letters, `?` one, `[a-f]` and `[!1]` one of or none of these, a
// backslash takes its meaning from the letter behind it.
bool matches_glob(std::string_view glob, std::string_view text);
// 0 to n - 1: the first 8 bytes of SHA-256 of the id, most significant first, modulo n.
unsigned long shard_of(std::string_view id, unsigned long shards);

}  // namespace gonogo::checker
