// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/io/id_spans.hpp"

#include <algorithm>
#include <iterator>

namespace gonogo::oracle {

std::optional<std::string> IdSpans::add(std::span<const std::string> ids) {
  const std::size_t file = files_++;
  if (ids.empty()) return std::nullopt;
  std::string first = ids.front();
  Span own{ids.back(), {file}, std::nullopt};
  // The spans that it touches: from the last that begins no later than it does.
  auto begin = spans_.upper_bound(first);
  if (begin != spans_.begin() && std::prev(begin)->second.last >= first) --begin;
  const auto end = spans_.upper_bound(own.last);
  if (begin == end) {
    spans_.emplace(std::move(first), std::move(own));
    return std::nullopt;
  }
  own.ids.emplace();
  first = std::min(first, begin->first);
  for (auto at = begin; at != end; ++at) {
    Span& other = at->second;
    own.last = std::max(own.last, other.last);
    own.files.insert(own.files.end(), other.files.begin(), other.files.end());
    if (other.ids) {
      own.ids->absorb(*other.ids);
    } else {
      for (const std::string& id : read_(other.files.front())) own.ids->insert(id);
    }
  }
  spans_.erase(begin, end);
  Span& span = spans_.emplace(std::move(first), std::move(own)).first->second;
  for (const std::string& id : ids) {
    if (!span.ids->insert(id)) return id;
  }
  return std::nullopt;
}

std::size_t IdSpans::kept() const {
  std::size_t count = 0;
  for (const auto& [first, span] : spans_) count += span.ids ? span.files.size() : 0;
  return count;
}

}  // namespace gonogo::oracle
