// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the origin of a program lies. NGC-OFS-01: a coordinate of the program, the tool length, the
// offset of G92 and that of the work coordinate system in force make a coordinate of the machine.
#pragma once

#include <array>
#include <optional>

#include "reference/generator.hpp"
#include "reference/outcome.hpp"
#include "reference/profile.hpp"

namespace gonogo::reference::rs274 {

// G54 to G59 and G59.1 to G59.3, in the order of their numbers for P.
inline constexpr std::array<std::string_view, 9> kSystems = {"G54", "G55",   "G56",   "G57",  "G58",
                                                             "G59", "G59.1", "G59.2", "G59.3"};
// The second reference point of a machine, by its parameters.
struct HomeParameter {
  Axis axis;
  std::string_view name;
};
inline constexpr std::array<HomeParameter, kAxes> kSecondHome = {{{Axis::x, "5181"},
                                                                  {Axis::y, "5182"},
                                                                  {Axis::z, "5183"},
                                                                  {Axis::a, "5184"},
                                                                  {Axis::c, "5186"}}};

// Lengths in mm, degrees.
struct Offsets {
  std::array<Position, kSystems.size()> systems;  // of the machine's origin, as the program has it
  std::size_t system = 0;                         // in force
  Position shift;                                 // of G92
  Position kept_shift;                            // NGC-OFS-06: what G92.3 puts in force again
  Position tool;                                  // tool length
  std::array<Position, 2> homes;                  // NGC-OFS-11: of G28 and G30, of the machine

  // The offset of the program, in coordinates of the machine; what all of the above come to.
  Position origin;
  bool is_moved = false;  // whether it is not the machine's

  explicit Offsets(const Profile& profile);
  // Once something has changed.
  void settle();
};

// NGC-OFS-08: the tool of which G43 takes the length.
struct ToolState {
  std::optional<Number> selected;  // T
  std::optional<Number> loaded;    // M6, M61
};

// The same motions in coordinates of the machine.
void move(Record& record, const Position& by);
Generator<Item> moved(Generator<Item> items, Position by);

}  // namespace gonogo::reference::rs274
