// SPDX-License-Identifier: GPL-3.0-or-later
//
// A block whose words are calculated, as one whose words are written.
#pragma once

#include "reference/expander.hpp"
#include "reference/rs274/expression.hpp"
#include "reference/words.hpp"

namespace gonogo::reference::rs274 {

class CalculatedWords {
 public:
  // False after a problem, which `calculator` has.
  bool take(const grammar::Block& block, Calculator& calculator, BlockOutput& out);
  // Its words have the values as decimals; where a value is none, a near one for messages, and the
  // exact one in values().
  const grammar::Block& block() const { return block_; }
  const WordValues& values() const { return values_; }

 private:
  grammar::Block block_;
  WordValues values_;
};

}  // namespace gonogo::reference::rs274
