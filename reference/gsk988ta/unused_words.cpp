// SPDX-License-Identifier: GPL-3.0-or-later
//
// GSK-COM-10, GSK-COM-12: words of a block that the code in force does not use, and speeds and
// tools below zero. No text says that they are wrong, nor that they are not.
#include <string>

#include "reference/arc_centre.hpp"
#include "reference/gsk988ta/machine.hpp"

namespace gonogo::reference::gsk988ta {
namespace {

constexpr std::string_view kAxisWords = "XYZUVWCH";

bool is_among(std::string_view set, char address) {
  return set.find(address) != std::string_view::npos;
}

// The addresses that the code of the block uses.
std::string used_words(const BlockContext& block) {
  const Machine& machine = block.machine;
  const CycleFamily family = machine.milling.family();
  std::string used;
  if (block.codes.once == 4) {
    used = "PXU";
  } else {
    used = kAxisWords;
  }
  // The words of a cycle that is entered are taken in beside a code of group 00, too.
  if (block.codes.once >= 0 && !block.entered_cycle) return used;
  used += words_of_cycle(family, machine.motion);
  const bool is_arc = machine.motion == 2 || machine.motion == 3;
  if (family == CycleFamily::none && is_arc) {
    const PlaneAxes axes = axes_of(machine.plane);
    used += {'R', offset_address(axes.p), offset_address(axes.q)};
  }
  return used;
}

}  // namespace

std::string_view words_of_cycle(CycleFamily family, int motion) {
  switch (family) {
    case CycleFamily::pocket:
      return "XYZUVWRILQPD";
    case CycleFamily::helix:
      return "XYZUVWRILD";
    case CycleFamily::thread:
      return "XYZUVWRIJKPQDE";
    case CycleFamily::none:
      break;
  }
  if (motion == 92) return "XYZUVWRIJKLPQ";
  return is_cutting_cycle(motion) ? "XYZUVWR" : "";
}

void note_unused_words(const BlockContext& block) {
  const std::string used = used_words(block);
  for (const grammar::Word& word : block.words.block().words) {
    if (is_among("ST", word.address) && to_number(word.value).sign() < 0) {
      block.out.accept("GSK-COM-12"_clause);
    } else if (!is_among("GMSTF", word.address) && !is_among(used, word.address)) {
      block.out.accept("GSK-COM-10"_clause);
    }
  }
}

}  // namespace gonogo::reference::gsk988ta
