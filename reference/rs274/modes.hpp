// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rules of G7, G93, G95, G96 and M98, and modes that are saved and restored.
#pragma once

#include <optional>
#include <vector>

#include "reference/rs274/machine.hpp"

namespace gonogo::reference::rs274 {

// What no text says: the gauge expects nothing from this block on.
void leave_out(BlockContext& block, char address, std::string message);

// NGC-SAV-01: what M72 would have to restore. M50 to M53 switch off with P0, and on without P.
void take_overrides(BlockContext& block);
// Rules of modes that ask for words of the block.
void check_modes(BlockContext& block);
// Whether the motion runs in the modes in force; else an alarm, or it is not read.
bool fits_modes(BlockContext& block);

// NGC-SAV-01: M70 to M73. Each call of a subroutine has its own saved modes.
class SavedModes {
 public:
  void take(BlockContext& block);
  // Drops what calls that have ended saved, and restores what M73 saved in them; `calls` are still
  // open. False: the gauge cannot restore it.
  bool follow(std::size_t calls, Machine& machine);

 private:
  struct Saved {
    Machine machine;
    bool returns = false;  // M73: when the call ends
  };
  bool restore(const Saved& saved, Machine& machine) const;

  std::vector<std::optional<Saved>> by_call_ = std::vector<std::optional<Saved>>(1);
};

}  // namespace gonogo::reference::rs274
