// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "expanders/common/axes.hpp"
#include "expanders/common/profile_reader.hpp"
#include "expanders/ngc/whole.hpp"

namespace gonogo::expanders::ngc {

/// The machine: what its parameters and options fix. Lengths are millimetres.
struct Configuration {
  bool block_delete = false;

  // State at power-on.
  bool inch = false;
  Point position{};
  Fixed feed = 0;
  int plane = 17;
  int motion = -1;  ///< number of the G code; below 0: none

  // Options; false is the standard machine.
  bool forgiving_arcs = false;      ///< ngc.arc-tolerance
  bool circle_needs_word = false;   ///< ngc.full-circle-words
  bool forgets_g80 = false;         ///< ngc.g80-beside
  bool passes_over_words = false;   ///< ngc.unused-words
  bool whole_line_numbers = false;  ///< ngc.line-number
  bool refuses_names = false;       ///< ngc.o-name
  bool needs_no_end = false;        ///< ngc.program-end
  bool motion_needs_axis = false;   ///< ngc.bare-motion
  bool arc_needs_axis = false;      ///< ngc.arc-words-alone
  WholeRule whole;                  ///< ngc.whole
};

/// Reads {"dialect", "profile"}. When it cannot, `message` says what is not implemented or wrong.
ConfigurationResult read_configuration(std::string_view json, Configuration& configuration,
                                       std::string& message);

}  // namespace gonogo::expanders::ngc
