// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <type_traits>

#include "expanders/faults.hpp"

namespace gonogo::expanders {

/// How often one run has met its planted fault.
struct Met {
  std::uint64_t reached = 0;
  std::uint64_t triggered = 0;
};

/// The same of all runs of the process.
class MetCounter {
 public:
  void add(const Met& met) {
    reached_.fetch_add(met.reached, std::memory_order_relaxed);
    triggered_.fetch_add(met.triggered, std::memory_order_relaxed);
  }
  FaultCount count() const {
    return {reached_.load(std::memory_order_relaxed), triggered_.load(std::memory_order_relaxed)};
  }

 private:
  std::atomic<std::uint64_t> reached_{0};
  std::atomic<std::uint64_t> triggered_{0};
};

/// The fault that a run has planted, or none (0 of the maker's enumeration). Where none is planted
/// nothing is counted.
template <typename Fault>
class Planted {
 public:
  /// `met` must outlive the run.
  Planted(Fault fault, Met& met) : fault_(fault), met_(met) {}
  /// Whether the fault is the planted one: its line is reached.
  bool has(Fault fault) const {
    if (fault_ != fault) return false;
    ++met_.reached;
    return true;
  }
  /// What the line of the fault answers: `right`, or, where it is planted, `wrong`. It is triggered
  /// when they differ.
  template <typename Value>
  Value alters(Fault fault, Value right, std::type_identity_t<Value> wrong) const {
    if (!has(fault)) return right;
    if (right != wrong) ++met_.triggered;
    return wrong;
  }
  /// The same of a condition that only the fault adds, or takes away.
  bool adds(Fault fault, bool wrong = true) const { return alters(fault, false, wrong); }
  bool spares(Fault fault, bool right = true) const { return alters(fault, right, false); }

 private:
  Fault fault_;
  Met& met_;
};

}  // namespace gonogo::expanders
