// SPDX-License-Identifier: GPL-3.0-or-later
//
// The settings of a profile one by one, each of which can go back to its dialect's default or
// become that of another profile.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fuzz/hunt/specimen.hpp"
#include "fuzz/program/mutator/dice.hpp"
#include "reference/profile.hpp"

namespace gonogo::hunt {

// What somebody has said of the machine of every program: all of it, or some readings.
struct GivenMachine {
  std::optional<reference::Profile> profile;                            // nothing: any
  std::vector<std::pair<reference::ReadingKey, std::string>> readings;  // over every profile

  void put_in(reference::Profile& machine) const;
  // Whether every program of the reproducer has it.
  bool is_in(const Reproducer& reproducer) const;
};

std::size_t profile_parts();
// Those that are not the default ones.
std::vector<std::size_t> parts_set(const reference::Profile& profile);
// Sets part i of the profile to its default; false where it is there already.
bool reset_part(reference::Profile& profile, std::size_t part);
// Lengths and feed that may become simpler: of the start, the offsets, the tools, the reference
// point.
std::vector<reference::Number*> numbers_of(reference::Profile& profile);
// Takes entry i of the offsets, the tools and the parameters away; false where there are not so
// many.
bool drop_entry(reference::Profile& profile, std::size_t i);
// Changes one thing: a setting becomes that of `other`, which is of the same dialect, or a reading
// another of its alternatives.
void mutate_profile(program::Dice& dice, reference::Profile& profile,
                    const reference::Profile& other);

}  // namespace gonogo::hunt
