// SPDX-License-Identifier: GPL-3.0-or-later
// What holds of every pocket, in whole thousandths so that the sums here are exact.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "expanders/registry.hpp"
#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

long thousandths(const std::string& text) {
  return std::lround(std::stod(text) * 1000);
}

// The number after `key` in a record, in thousandths.
long field_in_thousandths(const std::string& record, const std::string& key) {
  return thousandths(record.substr(record.find(key) + key.size()));
}

// Valid pockets of at most 40 rings and 20 layers.
struct AnyPocket {
  long tool = *rc::gen::inRange(1L, 20'000L);
  long reach = *rc::gen::inRange(1L, 1 + std::min(40'000L, 60 * tool));
  long step = *rc::gen::inRange(std::max(1L, reach / 40), std::max(2L, 2 * tool));
  long depth = *rc::gen::inRange(1L, 30'000L);
  long step_down = *rc::gen::inRange(std::max(1L, depth / 20), 30'001L);

  std::string program() const {
    return "G17 G110 X0 Y0 Z-" + millimetres(depth) + " I" + millimetres(tool + reach) + " L" +
           millimetres(step) + " Q" + millimetres(step_down) + " D" + millimetres(tool) + " F100\n";
  }
};

RC_GTEST_PROP(GskPocketProperty, RingsAreAtMostAStepApartAndTheLastIsClean, ()) {
  const AnyPocket shape;
  const Outcome outcome = run(shape.program());
  RC_ASSERT(outcome.answer == GONOGO_OK);
  long radius = 0;
  std::size_t arcs = 0;
  for (const std::string& record : outcome.records) {
    if (record.starts_with("feed z=")) {
      // A layer ends on the circle of radius I - D.
      RC_ASSERT(radius == 0 || radius == shape.reach);
      radius = 0;
    }
    if (!record.starts_with("arc17")) continue;
    const long next = field_in_thousandths(record, " x=");
    RC_ASSERT(record.starts_with("arc17 c=0,0 rot=-1 "));
    RC_ASSERT(next > radius);
    RC_ASSERT(next - radius <= shape.step);
    RC_ASSERT(next <= shape.reach);
    radius = next;
    ++arcs;
  }
  RC_ASSERT(radius == shape.reach);
  const long rings = (shape.reach + shape.step - 1) / shape.step;
  const long layers = (shape.depth + shape.step_down - 1) / shape.step_down;
  RC_ASSERT(arcs == static_cast<std::size_t>(rings * layers));
}

RC_GTEST_PROP(GskPocketProperty, LayersGoDownByTheStepToTheBottom, ()) {
  const AnyPocket shape;
  const Outcome outcome = run(shape.program());
  long layer = 0;
  for (const std::string& record : outcome.records) {
    if (!record.starts_with("feed z=")) continue;
    ++layer;
    // Closed form: layer k is at min(k Q, depth).
    RC_ASSERT(field_in_thousandths(record, " z=") ==
              -std::min(layer * shape.step_down, shape.depth));
  }
  RC_ASSERT(layer == (shape.depth + shape.step_down - 1) / shape.step_down);
}

RC_GTEST_PROP(GskPocketProperty, NoPlantedFaultTouchesAProgramOfRapids, ()) {
  // The faults sit in single places: straight rapids in mm and absolute words never meet them.
  const auto all = faults("gsk");
  const auto& fault = all[*rc::gen::inRange<std::size_t>(0, all.size())];
  std::string program;
  for (int i = 0; i < 5; ++i) {
    program += "G0 X" + millimetres(*rc::gen::inRange(-9'999L, 9'999L)) + " Z" +
               millimetres(*rc::gen::inRange(-9'999L, 9'999L)) + "\n";
  }
  RC_ASSERT(run(program, "{}", fault.name).all() == run(program).all());
}

}  // namespace
}  // namespace gonogo::expanders::testing
