// SPDX-License-Identifier: GPL-3.0-or-later
// Two ways of writing one program give the same motions: in another plane, in inches.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

// `units` times 0.0001.
std::string decimal_of_units(long units) {
  char text[32];
  std::snprintf(text, sizeof text, "%s%ld.%04ld", units < 0 ? "-" : "", std::labs(units) / 10'000,
                std::labs(units) % 10'000);
  return text;
}

// A word as address and number; the lengths of a program can be scaled before it is written.
struct Part {
  std::string text;  // a code, or the address
  long units = 0;
  bool length = false;
};
using ProgramParts = std::vector<Part>;

long some_length(long lowest, long highest) {
  return *rc::gen::inRange(lowest, highest);
}

// Two taper cycles, a helical pocket and two threads, in G17.
ProgramParts some_threads() {
  const auto coordinate = [] { return some_length(-500'000, 500'000); };
  const auto code = [](const char* a, const char* b) {
    return *rc::gen::arbitrary<bool>() ? a : b;
  };
  const long tool = some_length(10'000, 50'000);
  const long bore = 2 * tool + some_length(-10, 200'000);
  const long height = some_length(100, tool + 20);
  return {{"G0 "},
          {"X", coordinate(), true},
          {"Y", coordinate(), true},
          {"Z", coordinate(), true},
          {"\nG90 "},
          {"V", -some_length(1, 100'000), true},
          {"U", coordinate(), true},
          {"R", -some_length(0, 500'000), true},
          {" F100"},
          {"\nG92 "},
          {"V", -some_length(1, 100'000), true},
          {"U", coordinate(), true},
          {"R", -some_length(0, 500'000), true},
          {"F", some_length(1'000, 50'000), true},
          {"\n"},
          {code("G112 L", "G113 L")},
          {std::to_string(*rc::gen::inRange(1, 99'999))},
          {" X", coordinate(), true},
          {"Y", coordinate(), true},
          {"W", -some_length(1, 300'000), true},
          {"I", tool + some_length(-10, 100'000), true},
          {"D", tool, true},
          {code("\nG114 ", "\nG115 ")},
          {"X", coordinate(), true},
          {"Y", coordinate(), true},
          {"W", -some_length(1, 300'000), true},
          {"R", some_length(-20'000, 500), true},
          {"I", some_length(1, 100'000), true},
          {"J", some_length(0, 50'000), true},
          {"K" + std::to_string(*rc::gen::inRange(0, 361))},
          {"E", bore, true},
          {"P", height, true},
          {"Q", some_length(height / 10, tool), true},
          {"D", tool, true},
          {code("\nG116 ", "\nG117 ")},
          {"X", coordinate(), true},
          {"Y", coordinate(), true},
          {"W", -some_length(1, 300'000), true},
          {"I", some_length(1, 100'000), true},
          {"E", bore, true},
          {"P", height, true},
          {"D", tool, true},
          {"\n"}};
}

// A rapid, then an arc by R, a taper cycle and two pockets, in G17.
ProgramParts some_pockets() {
  const auto coordinate = [] { return some_length(-500'000, 500'000); };
  const long tool = some_length(10'000, 50'000);
  const long travel = some_length(1, 100'000);
  return {{"G0 "},
          {"X", coordinate(), true},
          {"Y", coordinate(), true},
          {"Z", coordinate(), true},
          {"\nG94 "},
          {"U", travel, true},
          {"V", coordinate(), true},
          {"R", -some_length(0, travel + 20), true},
          {" F100"},
          {"\n"},
          {"U", coordinate(), true},
          {"\nG3 "},
          {"U", travel, true},
          {"R", some_length(40'000, 200'000), true},
          {"W", coordinate(), true},
          {"\nG111 "},
          {"X", coordinate(), true},
          {"Y", coordinate(), true},
          {"W", -some_length(1, 300'000), true},
          {"R", some_length(-20'000, 500), true},
          {"I", tool + some_length(-10, 100'000), true},
          {"L", 2 * tool - some_length(-10, 10'000), true},
          {"Q", some_length(30'000, 300'000), true},
          {"P", coordinate(), true},
          {"D", tool, true},
          {"\n"},
          {"X", coordinate(), true},
          {"Y", coordinate(), true},
          {"Z", coordinate(), true},
          {"\n"}};
}

ProgramParts some_work() {
  return *rc::gen::arbitrary<bool>() ? some_threads() : some_pockets();
}

std::string written(const ProgramParts& program) {
  std::string text;
  for (const Part& part : program) {
    text += part.length ? part.text + decimal_of_units(part.units) : part.text;
  }
  return text;
}

// `from` letters become those of `to`, one by one.
std::string relabelled(std::string text, std::string_view from, std::string_view to) {
  for (char& c : text) {
    const std::size_t place = from.find(c);
    if (place != std::string_view::npos) c = to[place];
  }
  return text;
}

// The fields of all records, sorted in each: records name their axes in a fixed order.
std::vector<std::vector<std::string>> fields(const Outcome& outcome, std::string_view from,
                                             std::string_view to) {
  std::vector<std::vector<std::string>> all;
  for (const std::string& record : outcome.records) {
    std::istringstream text(record);
    std::vector<std::string> one;
    for (std::string field; text >> field;) {
      if (field.size() > 1 && field[1] == '=') field[0] = relabelled({field[0]}, from, to)[0];
      if (field.starts_with("arc")) field = "arc";
      one.push_back(field);
    }
    std::sort(one.begin(), one.end());
    all.push_back(one);
  }
  return all;
}

RC_GTEST_PROP(GskSymmetry, EveryPlaneIsTheSame, ()) {
  const std::string g17 = written(some_work());
  const Outcome want = run("G17 " + g17, kRadiusProfile);
  // (X, Y, Z) of G17 is (Z, X, Y) of G18 and (Y, Z, X) of G19.
  const Outcome in_g18 = run("G18 " + relabelled(g17, "XYZUVW", "ZXYWUV"), kRadiusProfile);
  const Outcome in_g19 = run("G19 " + relabelled(g17, "XYZUVW", "YZXVWU"), kRadiusProfile);
  RC_TAG(want.alarm.empty() ? std::string("no alarm") : want.alarm);
  RC_ASSERT(fields(in_g18, "zxy", "xyz") == fields(want, "", ""));
  RC_ASSERT(fields(in_g19, "yzx", "xyz") == fields(want, "", ""));
  RC_ASSERT(in_g18.alarm == want.alarm);
  RC_ASSERT(in_g19.alarm == want.alarm);
}

RC_GTEST_PROP(GskSymmetry, InchesAreTwentyFivePointFourMillimetres, ()) {
  // Lengths of k * 0.0254 mm are k * 0.001 in: 254 units of 0.0001 mm for 10 of 0.0001 in.
  ProgramParts program = some_work();
  for (Part& part : program) part.units = part.units / 254 * 254;
  const Outcome metric = run("G17 " + written(program));
  for (Part& part : program) part.units = part.units / 254 * 10;
  std::string inches = "G17 G20 " + written(program);
  const std::size_t feed = inches.find("F100");
  const Outcome imperial = run(inches.replace(feed, 4, "F10"));
  const std::string wanted = metric.all();
  std::string got = imperial.all();
  for (std::size_t at = got.find("f=254"); at != std::string::npos; at = got.find("f=254", at)) {
    got.replace(at, 5, "f=100");
  }
  RC_ASSERT(got == wanted);
}

}  // namespace
}  // namespace gonogo::expanders::testing
