// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "expanders/faults.hpp"

namespace gonogo::expanders {

/// The one fault of a subject, or none, and how often the process has met each fault of the maker.
/// `Fault` is an enumeration from 0, no fault, to kCount. Where no fault is planted nothing is
/// counted.
template <typename Fault, std::size_t kCount>
class Planted {
 public:
  explicit Planted(Fault fault) : fault_(fault) {}

  /// Whether the fault is the planted one: its line is reached.
  bool has(Fault fault) const {
    if (fault_ != fault) return false;
    counter(fault).reached.fetch_add(1, std::memory_order_relaxed);
    return true;
  }

  /// What the line of the fault answers: `right`, or, where it is planted, `wrong`. It is triggered
  /// when they differ.
  template <typename Value>
  Value alters(Fault fault, Value right, std::type_identity_t<Value> wrong) const {
    if (!has(fault)) return right;
    if (right != wrong) counter(fault).triggered.fetch_add(1, std::memory_order_relaxed);
    return wrong;
  }
  /// The same of a condition that only the fault adds, or takes away.
  bool adds(Fault fault, bool wrong = true) const { return alters(fault, false, wrong); }
  bool spares(Fault fault, bool right = true) const { return alters(fault, right, false); }

  static FaultCount count(Fault fault) {
    const Counter& met = counter(fault);
    return {met.reached.load(std::memory_order_relaxed),
            met.triggered.load(std::memory_order_relaxed)};
  }

 private:
  struct Counter {
    std::atomic<std::uint64_t> reached{0};
    std::atomic<std::uint64_t> triggered{0};
  };
  static Counter& counter(Fault fault) {
    static std::array<Counter, kCount + 1> all;
    return all[static_cast<std::size_t>(fault)];
  }

  Fault fault_;
};

}  // namespace gonogo::expanders
