// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/relations/operation.hpp"

namespace gonogo::relations {
namespace {

constexpr std::int64_t kMicrometre = 1000;  // millionths of a millimetre

// A whole number of micrometres in [low, high]; one time in four a whole one of millimetres.
Number length(program::Dice& dice, int low_mm, int high_mm) {
  const auto span = static_cast<std::size_t>(high_mm - low_mm);
  const auto low = static_cast<std::int64_t>(low_mm) * 1000;
  const std::int64_t count = dice.one_in(4)
                                 ? low + 1000 * static_cast<std::int64_t>(dice.below(span + 1))
                                 : low + static_cast<std::int64_t>(dice.below(span * 1000 + 1));
  return Number::millionths(count * kMicrometre);
}

// One to `most` times so many millionths.
Number times(program::Dice& dice, std::size_t most, std::int64_t step) {
  return Number::millionths(step * static_cast<std::int64_t>(1 + dice.below(most)));
}

// An arc of a quarter, from one point to the other corner of a square.
Cut quarter(program::Dice& dice, const PlanePoint& from, const Number& radius, int sense_p,
            int sense_q) {
  Cut cut;
  cut.radius = radius;
  cut.by_radius = dice.one_in(2);
  cut.to = {from.p + Number(sense_p) * radius, from.q + Number(sense_q) * radius};
  // Round the one or the other of the two corners that are left.
  if (dice.one_in(2)) {
    cut.centre = {cut.to.p, from.q};
    cut.rot = -sense_p * sense_q;
  } else {
    cut.centre = {from.p, cut.to.q};
    cut.rot = sense_p * sense_q;
  }
  return cut;
}

// From outside of the bar into it, along it towards -Z, and out again.
Operation lathe_contour(program::Dice& dice, const Number& bar) {
  Operation operation;
  operation.start = {length(dice, -20, 0), bar + length(dice, 1, 5)};
  PlanePoint at{operation.start.p, length(dice, 10, 14)};
  operation.cuts.push_back({at, 0, {}, {}, false});
  for (std::size_t i = 1 + dice.below(3); i > 0; --i) {
    const Number size = length(dice, 1, 4);
    if (dice.one_in(2)) {
      operation.cuts.push_back(quarter(dice, at, size, -1, dice.one_in(2) ? 1 : -1));
    } else {
      operation.cuts.push_back({{at.p - size, at.q + length(dice, -1, 1)}, 0, {}, {}, false});
    }
    at = operation.cuts.back().to;
    if (at.q < Number(5)) break;
  }
  operation.cuts.push_back({{at.p, operation.start.q}, 0, {}, {}, false});
  return operation;
}

// A cut of the face along -X, or along the bar towards -Z, from outside.
Operation lathe_pass(program::Dice& dice, const Number& bar, OperationKind kind) {
  Operation operation;
  operation.kind = kind;
  operation.start = {length(dice, 1, 5), bar + length(dice, 1, 5)};
  const bool is_face = kind == OperationKind::face;
  operation.end = is_face ? PlanePoint{length(dice, -6, -3), length(dice, 2, 10)}
                          : PlanePoint{length(dice, -30, -6), length(dice, 12, 15)};
  // A tapered face begins outside of the stock, or deeper in it than it ends.
  if (!dice.one_in(3)) operation.taper = length(dice, -2, 2);
  return operation;
}

Operation mill_contour(program::Dice& dice) {
  Operation operation;
  operation.level = length(dice, 2, 10);
  operation.depth = length(dice, -8, -1);
  operation.start = {length(dice, -50, 50), length(dice, -50, 50)};
  PlanePoint at = operation.start;
  for (std::size_t i = 1 + dice.below(4); i > 0; --i) {
    if (dice.one_in(2)) {
      operation.cuts.push_back(
          quarter(dice, at, length(dice, 1, 9), dice.one_in(2) ? 1 : -1, dice.one_in(2) ? 1 : -1));
    } else {
      operation.cuts.push_back(
          {{at.p + length(dice, -9, 9), at.q + length(dice, 1, 9)}, 0, {}, {}, false});
    }
    at = operation.cuts.back().to;
  }
  return operation;
}

// Places apart from each other along X.
Operation holes(program::Dice& dice) {
  Operation operation;
  operation.kind = OperationKind::holes;
  operation.hole = static_cast<HoleKind>(dice.below(6));
  operation.level = length(dice, 5, 15);
  operation.r = length(dice, 1, 4);
  operation.depth = length(dice, -20, -2);
  // The page of G73 does not speak of G98 (NGC-G73-02): asked for R, it has one meaning.
  operation.ends_at_r = operation.hole == HoleKind::chip_break || dice.one_in(2);
  if (is_pecked(operation.hole)) operation.peck = length(dice, 1, 6);
  const bool dwells = operation.hole == HoleKind::dwell_drill || operation.hole == HoleKind::bore;
  if (dwells) operation.dwell = times(dice, 30, 100'000);
  Number x = length(dice, -40, 0);
  for (std::size_t i = 1 + dice.below(3); i > 0; --i) {
    operation.places.push_back({x, length(dice, -40, 40)});
    x += length(dice, 1, 20);
  }
  return operation;
}

// What a mill does in one operation lies apart from the others: a hole is asked for once.
void move_aside(Operation& operation, std::size_t number) {
  constexpr int kApart = 200;  // mm
  const Number along(kApart * static_cast<int>(number));
  operation.start.p += along;
  for (PlanePoint& place : operation.places) place.p += along;
  for (Cut& cut : operation.cuts) {
    cut.to.p += along;
    cut.centre.p += along;
  }
}

}  // namespace

OperationList draw_operations(program::Dice& dice, MachineKind machine) {
  OperationList list;
  list.machine = machine;
  list.bar = length(dice, 20, 40);
  for (std::size_t i = 1 + dice.below(3); i > 0; --i) {
    Operation operation;
    if (machine == MachineKind::mill) {
      operation = dice.one_in(4) ? mill_contour(dice) : holes(dice);
    } else {
      const std::size_t kind = dice.below(3);
      operation = kind == 0 ? lathe_contour(dice, list.bar)
                            : lathe_pass(dice, list.bar,
                                         kind == 1 ? OperationKind::face : OperationKind::turn);
    }
    if (machine == MachineKind::mill) move_aside(operation, list.operations.size());
    operation.per_revolution = dice.one_in(4);
    operation.feed =
        operation.per_revolution ? times(dice, 50, 10'000) : times(dice, 80, 10'000'000);
    list.operations.push_back(std::move(operation));
  }
  return list;
}

}  // namespace gonogo::relations
