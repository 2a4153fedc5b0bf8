// SPDX-License-Identifier: GPL-3.0-or-later
// Programs that are mirrored, moved or written in radii give the motions that follow from it.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <functional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "expanders/common/fixed.hpp"
#include "harness.hpp"
#include "random_numbers.hpp"

namespace gonogo::expanders::testing {
namespace {

// A word in thousandths.
struct Item {
  char address;
  long value;
};
struct HncBlock {
  std::string code;
  std::vector<Item> words;
};
using HncProgram = std::vector<HncBlock>;

long coordinate() {
  return between(-200'000, 200'000);
}
// An axis word, absolute or incremental; X even, so that its half is a thousandth.
Item any_axis_word(char absolute, char incremental) {
  const char address = *rc::gen::arbitrary<bool>() ? absolute : incremental;
  return {address, absolute == 'X' ? 2 * coordinate() : coordinate()};
}

HncBlock some_block() {
  const Item x = any_axis_word('X', 'U');
  const Item z = any_axis_word('Z', 'W');
  switch (between(0, 6)) {
    case 0:
      return {"G74", {z, {'R', between(0, 3'000)}, {'Q', between(9'000, 40'000)}, {'F', 50'000}}};
    case 1:
      return {"G75", {x, {'R', between(0, 3'000)}, {'Q', between(9'000, 40'000)}, {'F', 50'000}}};
    case 2:
      return {"G75", {x, z, {'I', 1'000 * between(1, 9)}, {'F', 60'000}}};
    case 3:
      return {"G80", {x, z, {'I', coordinate()}, {'F', 70'000}}};
    case 4:
      return {"G81", {x, z, {'K', coordinate()}, {'F', 80'000}}};
    case 5:
      return {"G82",
              {x,
               z,
               {'I', between(-9'000, 9'000)},
               {'R', between(-3'000, 3'000)},
               {'E', between(-60'000, 60'000)},
               {'C', 1'000 * between(0, 3)},
               {'P', between(-400'000, 400'000)},
               {'F', between(1, 4'000)}}};
    default:
      return {*rc::gen::arbitrary<bool>() ? "G00" : "G01", {x, z, {'F', 90'000}}};
  }
}

HncProgram some_hnc_program() {
  HncProgram program;
  for (long steps = between(1, 8); steps > 0; --steps) program.push_back(some_block());
  return program;
}

using Change = std::function<long(const HncBlock&, const Item&)>;

std::string program_text(const HncProgram& program, const Change& change) {
  std::string text;
  for (const HncBlock& step : program) {
    text += step.code;
    for (const Item& item : step.words) text += item.address + millimetres(change(step, item));
    text += '\n';
  }
  return text;
}

std::string program_text(const HncProgram& program) {
  return program_text(program, [](const HncBlock&, const Item& item) { return item.value; });
}

// The records with `change` made to the values of `field` ("x=" or "z=").
std::vector<std::string> with_changed_field(const Outcome& outcome, std::string_view field,
                                            const std::function<Fixed(Fixed)>& change) {
  std::vector<std::string> records;
  for (const std::string& record : outcome.records) {
    std::istringstream text(record);
    std::string all;
    for (std::string part; text >> part;) {
      if (part.starts_with(field)) {
        const char* cursor = part.data() + field.size();
        Decimal number;
        EXPECT_TRUE(read_decimal(cursor, part.data() + part.size(), number));
        char digits[kTextSize];
        part =
            std::string(field) + std::string(digits, write_decimal(change(number.value), digits));
      }
      all += (all.empty() ? "" : " ") + part;
    }
    records.push_back(all);
  }
  return records;
}

Fixed negative(Fixed value) {
  return -value;
}

void expect_same(const Outcome& got, const Outcome& want, const std::vector<std::string>& records) {
  RC_TAG(want.alarm.empty() ? std::string("no alarm") : want.alarm);
  RC_ASSERT(got.records == records);
  RC_ASSERT(got.alarm == want.alarm);
  RC_ASSERT(got.alarm_block == want.alarm_block);
}

RC_GTEST_PROP(HncSymmetry, MirroredAlongZ, ()) {
  const HncProgram program = some_hnc_program();
  const Outcome plain = run_hnc(program_text(program));
  const Outcome mirrored =
      run_hnc(program_text(program, [](const HncBlock& step, const Item& item) {
        const bool along_z = std::string_view("ZWK").find(item.address) != std::string_view::npos ||
                             (item.address == 'R' && step.code == "G82");
        return along_z ? -item.value : item.value;
      }));
  expect_same(mirrored, plain, with_changed_field(plain, "z=", negative));
}

RC_GTEST_PROP(HncSymmetry, MirroredAlongX, ()) {
  const HncProgram program = some_hnc_program();
  const Outcome plain = run_hnc(program_text(program));
  const Outcome mirrored =
      run_hnc(program_text(program, [](const HncBlock& step, const Item& item) {
        const bool along_x = std::string_view("XUE").find(item.address) != std::string_view::npos ||
                             (item.address == 'I' && step.code != "G75");
        return along_x ? -item.value : item.value;
      }));
  expect_same(mirrored, plain, with_changed_field(plain, "x=", negative));
}

RC_GTEST_PROP(HncSymmetry, MovedByTheWorkOffset, ()) {
  const HncProgram program = some_hnc_program();
  const long shift = coordinate();
  const std::string by = "\"" + millimetres(shift) + "\"";
  const Outcome plain = run_hnc(program_text(program));
  const Outcome moved =
      run_hnc(program_text(program),
              R"({"initial":{"z":)" + by + R"(},"offsets":{"G54":{"z":)" + by + "}}}");
  expect_same(moved, plain,
              with_changed_field(plain, "z=", [&](Fixed z) { return z + shift * 1'000'000; }));
}

RC_GTEST_PROP(HncSymmetry, WrittenInRadii, ()) {
  const HncProgram program = some_hnc_program();
  const Outcome plain = run_hnc(program_text(program));
  const Outcome radii = run_hnc(program_text(program,
                                             [](const HncBlock&, const Item& item) {
                                               const bool x =
                                                   item.address == 'X' || item.address == 'U';
                                               return x ? item.value / 2 : item.value;
                                             }),
                                R"({"x_diameter":false})");
  expect_same(radii, plain, plain.records);
}

// A cycle ends where it began, whatever its words are.
RC_GTEST_PROP(HncSymmetry, CyclesEndAtTheirStart, ()) {
  HncBlock step = some_block();
  RC_PRE(step.code != "G00" && step.code != "G01");
  const Outcome outcome = run_hnc(program_text({{"G00", {{'X', 14'000}, {'Z', 3'000}}}, step}));
  RC_PRE(outcome.alarm.empty());
  RC_ASSERT(outcome.records.back() == "end x=7 y=0 z=3 a=0 c=0");
}

}  // namespace
}  // namespace gonogo::expanders::testing
