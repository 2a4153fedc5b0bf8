// SPDX-License-Identifier: GPL-3.0-or-later
//
// Machining operations before they are a program: what is to be cut, said without a dialect. The
// same list can be written for each dialect, with its cycles or without, and has to give one path;
// and what is to be cut says what a path must never do, whoever made it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/program/mutator/dice.hpp"
#include "reference/axis.hpp"

namespace gonogo::relations {

using reference::Number;

enum class MachineKind : std::uint8_t { lathe, mill };

// A point of the working plane, mm: Z and X (a radius) of a lathe, X and Y of a mill.
struct PlanePoint {
  Number p;
  Number q;
  friend bool operator==(const PlanePoint&, const PlanePoint&) = default;
};

struct Cut {
  PlanePoint to;
  int rot = 0;        // 0: straight; 1 counterclockwise, -1 clockwise, as in a record
  PlanePoint centre;  // of an arc
  Number radius;
  bool by_radius = false;  // how it is written
};

enum class OperationKind : std::uint8_t { contour, face, turn, holes };
enum class HoleKind : std::uint8_t {
  drill,        // out at rapid
  dwell_drill,  // with a dwell at the bottom
  peck,         // in pecks, each time back to the R plane
  chip_break,   // in pecks, each time back a little
  ream,         // out at feed
  bore,         // out at feed, with a dwell at the bottom
};
constexpr bool is_pecked(HoleKind kind) {
  return kind == HoleKind::peck || kind == HoleKind::chip_break;
}

struct Operation {
  OperationKind kind = OperationKind::contour;
  Number feed;
  bool per_revolution = false;
  // contour, face, turn: where it begins, outside of the stock.
  PlanePoint start;
  std::vector<Cut> cuts;  // contour; a lathe's leads out of the stock again
  Number depth;           // contour of a mill and holes: Z of the bottom
  PlanePoint end;         // face, turn: the corner
  Number taper;           // face, turn: from the corner to where the cut begins, signed
  HoleKind hole = HoleKind::drill;
  std::vector<PlanePoint> places;  // holes
  Number level;                    // mill: Z that it begins at
  Number r;                        // holes: Z of the R plane
  bool ends_at_r = false;          // holes: retract to the R plane, else to `level`
  Number peck;
  Number dwell;  // s
};

struct OperationList {
  MachineKind machine = MachineKind::mill;
  Number bar;  // lathe: radius of the stock; its face lies at Z0, as the top of a mill's does
  std::vector<Operation> operations;
};

// Drawn at random, one to three operations. Coordinates are whole micrometres within 600 mm.
OperationList draw_operations(program::Dice& dice, MachineKind machine);

// A way to write a list: in a dialect, with its cycles or with traverses and cuts alone.
struct Notation {
  std::string_view dialect;
  bool has_cycles = true;
};

// Whether the dialect has a cycle for one of the operations.
bool has_cycle_for(const OperationList& list, std::string_view dialect);
// Empty: it cannot be written so, for want of a machine of this kind, of its feed, or of a cycle
// for pecks, of which only a maker says how they go back.
std::string written(const OperationList& list, const Notation& notation);

}  // namespace gonogo::relations
