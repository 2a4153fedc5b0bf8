// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/gsk/machine.hpp"

namespace gonogo::expanders::gsk {
namespace {

constexpr AddressSet kLengths{"XYZUVWRIJKLQDEP"};
constexpr AddressSet kSigned{"XYZUVWRP"};
constexpr AddressSet kUnsigned{"ILQDEJK"};
// Words whose size matters to the path; of the others any number of digits will do.
constexpr AddressSet kMeasured{"XYZUVWCHRIJKLQDEPF"};

// Absolute and incremental address of each axis, in the order of gonogo_axis.
constexpr char kAbsolute[] = {'X', 'Y', 'Z', 0, 'C'};
constexpr char kIncremental[] = {'U', 'V', 'W', 0, 'H'};

// The least input increment: ISB 0.001 mm or 0.0001 in, ISC a tenth of it.
Fixed increment(const Machine& machine) {
  const Fixed coarse = machine.state.inch ? kOne / 10'000 : kOne / 1'000;
  return machine.profile.fine ? coarse / 10 : coarse;
}

Fixed written(const Machine& machine, const Decimal& number) {
  if (!machine.follows("gsk.decimals=nearest"_reading)) return number.value;
  const Fixed unit = increment(machine);
  return static_cast<Fixed>(scaled(number.value, 1, unit)) * unit;
}

// In mm, divided by `share`, which is 1 or 2.
Wide to_millimetres(const Machine& machine, const Decimal& number, Fixed share) {
  const Fixed value = written(machine, number);
  if (machine.state.inch) return scaled(value, 254, 10 * share);
  return share == 1 ? value : (value + value % 2) / share;
}

void check_decimals(Machine& machine, const Block& block) {
  const Fixed unit = increment(machine);
  block.words().each([&](char address) {
    const Decimal& number = block.number(address);
    const bool too_fine = number.finer || number.value % unit != 0;
    if (!kLengths.has(address) || !too_fine) return;
    machine.complain(AlarmKind::kValueOutOfRange, address, block);
  });
}

// GSK-G112-01: L is a whole number of turns, 1 to 99999.
void check_turns(Machine& machine, const Block& block) {
  constexpr Fixed kMost = 99'999 * kOne;
  const Fixed turns = block.number('L').value;
  if (turns < kOne || turns > kMost) {
    machine.complain(AlarmKind::kValueOutOfRange, 'L', block);
  } else if (block.has_fraction('L')) {
    machine.complain(AlarmKind::kNotAnInteger, 'L', block);
  }
}

}  // namespace

Fixed length_of(const Machine& machine, const Block& block, char address) {
  return static_cast<Fixed>(to_millimetres(machine, block.number(address), 1));
}

Fixed angle_of(const Machine& machine, const Block& block, char address) {
  return written(machine, block.number(address));
}

void take(const Machine& machine, const Block& block, char address, Retained& store) {
  if (block.has(address)) store = {true, false, length_of(machine, block, address)};
}

AxisWord axis_word(const Machine& machine, const Block& block, std::size_t axis, bool as_diameter) {
  AxisWord word;
  word.incremental = !block.has(kAbsolute[axis]);
  word.address = word.incremental ? kIncremental[axis] : kAbsolute[axis];
  word.present = block.has(word.address);
  if (!word.present) return word;
  const Decimal& number = block.number(word.address);
  if (axis == GONOGO_C) {
    word.value = number.value;
    return word;
  }
  bool halved = axis == GONOGO_X && as_diameter && machine.profile.x_diameter;
  if (machine.has("increment-as-radius"_fault) && word.incremental) halved = false;
  word.value = static_cast<Fixed>(to_millimetres(machine, number, halved ? 2 : 1));
  return word;
}

Point commanded_point(Machine& machine, const Block& block, Axes& axes) {
  Point to = machine.state.position;
  axes = 0;
  for (const std::size_t axis : {GONOGO_X, GONOGO_Y, GONOGO_Z, GONOGO_C}) {
    const AxisWord word = axis_word(machine, block, axis);
    if (!word.present) continue;
    to[axis] = target_of(word, to[axis]);
    if (!fits(to[axis])) machine.complain(AlarmKind::kValueOutOfRange, word.address, block);
    axes |= axis_bit(axis);
  }
  return to;
}

void check_words(Machine& machine, const Block& block) {
  block.words().each([&](char address) {
    if (!kMeasured.has(address)) return;
    const Decimal& number = block.number(address);
    if (!number.overflow && fits(to_millimetres(machine, number, 1))) return;
    machine.complain(AlarmKind::kValueOutOfRange, address, block);
  });
  for (const std::size_t axis : {GONOGO_X, GONOGO_Y, GONOGO_Z, GONOGO_C}) {
    if (block.has(kAbsolute[axis]) && block.has(kIncremental[axis])) {
      machine.complain(AlarmKind::kConflictingWords, kIncremental[axis], block);
    }
  }
  if (machine.follows("gsk.decimals=alarm"_reading)) check_decimals(machine, block);
}

void check_ranges(Machine& machine, const Block& block) {
  const Mode mode = mode_of(machine.state.cycle);
  const bool threads = is_thread_milling(mode);
  const bool full_circle = threads && !machine.follows("gsk.thread.k-range=table"_reading);
  const bool inch = machine.state.inch && !machine.has("range-in-millimetres"_fault);
  // ISB 999999.999 mm or 99999.9999 in; ISC has one whole digit less and one decimal more.
  const Fixed coarse = inch ? 99'999'999'900'000 : 999'999'999'000'000;
  const Fixed highest = machine.profile.fine ? coarse / 10 : coarse;
  block.words().each([&](char address) {
    if (!kSigned.has(address) && !kUnsigned.has(address)) return;
    if (address == 'L' && mode == Mode::kHelix) return check_turns(machine, block);
    const Decimal& number = block.number(address);
    const bool positive = kUnsigned.has(address) || (address == 'P' && threads);
    // GSK-G114-13
    const Fixed most = address == 'K' && full_circle ? kFullTurn : highest;
    const bool too_low = positive ? number.minus : number.value < -highest;
    if (too_low || number.value > most) {
      machine.complain(AlarmKind::kValueOutOfRange, address, block);
    }
  });
}

}  // namespace gonogo::expanders::gsk
