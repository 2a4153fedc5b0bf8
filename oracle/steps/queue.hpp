// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace gonogo::oracle {

// First in, first out. It has no memory while it is new, and keeps what it had: a judge has
// several, and most programs put little or nothing into them.
template <typename Element>
class Queue {
 public:
  std::size_t size() const { return elements_.size() - first_; }
  auto begin() const { return elements_.begin() + offset(); }
  auto end() const { return elements_.end(); }

  void push_back(Element element) { elements_.push_back(std::move(element)); }
  void pop_front() {
    ++first_;
    // Half of it has gone: every element is moved at most once on its way through.
    if (2 * first_ < elements_.size()) return;
    elements_.erase(elements_.begin(), elements_.begin() + offset());
    first_ = 0;
  }
  // The element so far behind the first becomes the first.
  void bring_forward(std::size_t place) {
    const auto first = elements_.begin() + offset();
    const auto one = first + static_cast<std::ptrdiff_t>(place);
    std::rotate(first, one, one + 1);
  }

 private:
  auto offset() const { return static_cast<std::ptrdiff_t>(first_); }

  std::vector<Element> elements_;
  std::size_t first_ = 0;  // those before it have gone
};

}  // namespace gonogo::oracle
