// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the origin of a program lies. NGC-OFS-01: a coordinate of the program, the tool length, the
// offset of G92 and that of the work coordinate system in force make a coordinate of the machine.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>

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

// Where a program lies on the machine. NGC-OFS-16: it may be turned in X and Y.
struct Frame {
  // At the machine's origin.
  explicit Frame(const Number& angle = 0);

  Position origin;  // of the program, in coordinates of the machine
  Number cosine = 1;
  Number sine;
  bool is_moved = false;  // whether program and machine differ
  bool is_turned = false;

  // The way of a program in the machine's axes, and back.
  Position turned(Position way) const;
  Position turned_back(Position way) const;
  Position to_machine(const Position& place) const;
  Position to_program(const Position& place) const;
  // The record in coordinates of the machine. `at`: where it begins, and then where it ends; it is
  // used only where the frame is turned.
  void move(Record& record, Position& at) const;
};

// Lengths in mm, degrees.
struct Offsets {
  std::array<Position, kSystems.size()> systems;  // of the machine's origin, as the program has it
  std::array<Number, kSystems.size()> angles;     // NGC-OFS-16
  std::size_t system = 0;                         // in force
  Position shift;                                 // of G92 and G52
  Position kept_shift;                            // NGC-OFS-06: what G92.3 puts in force again
  Position tool;                                  // tool length
  std::array<Position, 2> homes;                  // NGC-OFS-11: of G28 and G30, of the machine
  Frame frame;                                    // what all of the above come to

  explicit Offsets(const Profile& profile);
  // Once something has changed.
  void settle();
};

// NGC-OFS-08: the tool of which G43 takes the length.
struct ToolState {
  std::optional<Number> selected;  // T
  std::optional<Number> loaded;    // M6, M61
  // NGC-OFS-17: entries of the tool table that the program has changed, by their numbers.
  std::map<std::string, Position> changed;
};

}  // namespace gonogo::reference::rs274
