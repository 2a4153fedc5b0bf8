// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/editions.hpp"

#include <array>
#include <utility>

namespace gonogo::reference {
namespace {

constexpr auto kEditions = std::to_array<std::pair<std::string_view, std::string_view>>({
    {"gsk988ta",
     "GSK 988TA, programming: the chapters on its codes, on G90, G92 and G94 and on the milling "
     "cycles G110 to G117. The copies that were read state neither edition nor date"},
    {"hnc21t",
     "HNC-21T (Century Star), lathe cycles. The copy that was read states neither edition nor "
     "date; what an older print has otherwise stands at the clause"},
    {"rs274",
     "NIST's RS274/NGC interpreter, version 3 (NISTIR 6556, 2000); LinuxCNC's documents, version "
     "2.9, unless a clause names 2.10"},
    {"sinumerik840d",
     "SINUMERIK 840D, programming: path commands. The copy that was read states neither edition "
     "nor date"},
    {"sinumerik802s",
     "SINUMERIK 802S: LCYC82, LCYC75 and frames; and the path commands of the 840D. The copies "
     "that were read state neither edition nor date"},
});

}  // namespace

std::string_view editions_of(std::string_view dialect) {
  for (const auto& [name, text] : kEditions) {
    if (name == dialect) return text;
  }
  return {};
}

}  // namespace gonogo::reference
