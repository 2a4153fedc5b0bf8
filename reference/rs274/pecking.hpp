// SPDX-License-Identifier: GPL-3.0-or-later
//
// Holes in pecks: what G73 and G83 share.
#pragma once

#include "reference/rs274/hole_block.hpp"

namespace gonogo::reference::rs274 {

// A block of G73 or G83.
class PeckBlock {
 public:
  explicit PeckBlock(BlockContext& block);

  HoleBlock& holes() { return holes_; }
  // REQUIRES for all: holes().is_sound().
  Number count() const;  // N
  Number depth() const;  // q
  bool has_several() const { return count() > 1; }
  // d: how far above the bottom of the last peck the tool stops on its way back. A reading, so only
  // where it does.
  Number clearance() const;

 private:
  HoleBlock holes_;
};

// NGC-G83-01: where peck k ends except for the last one, which ends on the bottom. A closed form,
// so that the millionth is as exact as the first.
Number end_of_peck(const Holes& holes, const Number& depth, const Number& k);

}  // namespace gonogo::reference::rs274
