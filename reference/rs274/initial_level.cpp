// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rs274/initial_level.hpp"

namespace gonogo::reference::rs274 {

// NGC-CYC-08, NGC-CYC-09: a series begins here, or has kept its level as a place, or as a number
// for the axis and units that are in force when it is used.
InitialLevel::InitialLevel(const BlockContext& block) : readings_(block.readings) {
  const Number& here = block.machine.position[axes_of(block.machine.plane).d];
  std::optional<Series>& series = block.machine.cycle.series;
  const WordModes& modes = block.machine.modes;
  if (!series) series = Series{here, modes.number_of(here)};
  if (!series->place) series->place = here;
  of_block_ = here;
  of_place_ = *series->place;
  of_number_ = modes.length_of(series->number);
  is_one_ = of_place_ == of_block_ && of_number_ == of_block_;
}

}  // namespace gonogo::reference::rs274
