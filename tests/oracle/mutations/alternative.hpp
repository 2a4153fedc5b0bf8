// SPDX-License-Identifier: GPL-3.0-or-later
//
// Other traces that mean the same, each by a rule of docs/judging.md: none of them is NO-GO.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "specimen.hpp"
#include "tests/chance.hpp"

namespace gonogo::mutations {

// A trace in change, with the tolerances and the profile under which it will be judged.
struct Attempt {
  Attempt(const Specimen& of, Chance& drawn)
      : specimen(of),
        chance(drawn),
        trace(of.right),
        tolerances(of.tolerances),
        profile(of.profile) {}

  // Where each record of the trace as it now is starts.
  std::vector<reference::Position> starts() const;
  // Puts other records in the place of each one; none where `make` gives none. True if any was.
  using Make = std::function<std::vector<Record>(const Record&, const reference::Position& from)>;
  bool replace(const Make& make);

  const Specimen& specimen;
  Chance& chance;
  Trace trace;
  oracle::Tolerances tolerances;
  reference::Profile profile;
};

struct Alternative {
  std::string_view name;
  std::string_view rule;                // what admits it
  std::function<bool(Attempt&)> apply;  // false where it cannot be applied
};

// A length within 1e-9 of a double.
Number number_near(double value);

std::vector<Alternative> splitting_alternatives();  // pieces, chords, other forms of an arc
std::vector<Alternative> wording_alternatives();    // roundings, fields, blocks, events
std::vector<Alternative> open_alternatives();       // other paths through open parts
std::vector<Alternative> all_alternatives();

}  // namespace gonogo::mutations
