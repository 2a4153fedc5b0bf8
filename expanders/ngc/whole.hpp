// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "expanders/common/fixed.hpp"
#include "expanders/ngc/faults.hpp"
#include "expanders/ngc/profile.hpp"

namespace gonogo::expanders::ngc {

/// Numbers that have to be whole (NGC-COM-01): how far one may lie beside a whole one is the
/// reading ngc.whole.
class WholeNumbers {
 public:
  WholeNumbers(const Readings& readings, const Faults& faults)
      : readings_(readings), faults_(faults) {}

  // The whole number that is meant; of a G code, of tenths. Nothing when the number lies too far
  // beside one or is too large.
  std::optional<Fixed> tenths(const Decimal& code) const;
  std::optional<Fixed> function(const Decimal& number) const;
  std::optional<Fixed> turns(const Decimal& number) const;
  /// L, and H of G76.
  std::optional<Fixed> repeats(const Decimal& number) const { return function(number); }

 private:
  // How far beside a whole number one may lie, in counts of the number as it is written.
  Fixed by_reading(Fixed nist, Fixed linuxcnc) const;
  std::optional<Fixed> steps(const Decimal& number, Fixed step, Fixed limit) const;
  // The same as grbl has it: cut at the point, and what is behind it rounded to hundredths, of
  // which a step has so many.
  static std::optional<Fixed> cut_steps(const Decimal& number, Fixed hundredths);

  const Readings& readings_;
  const Faults& faults_;
};

}  // namespace gonogo::expanders::ngc
