// SPDX-License-Identifier: GPL-3.0-or-later
//
// A number of a trace that is off by more than the tolerance is a departure, whichever it is.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "checker/match.hpp"

namespace gonogo::checker {
namespace {

// The subject does what it must; every number in it can be made wrong.
constexpr std::array<std::string_view, 4> kRecords = {
    R"({"k":"rapid","b":1,"to":{"x":"10","z":"@"}})",
    R"({"k":"feed","b":2,"to":{"x":"@","y":"-5"},"f":"@"})",
    R"({"k":"arc","b":3,"plane":"G17","c":{"x":"@","y":"@"},"rot":2,"to":{"x":"@","y":"@","z":"@"},"f":"80"})",
    R"({"k":"thread","b":4,"to":{"z":"@"},"lead":"@","start":"@"})",
};
// z 4; x 20, f 100; centre (15, 0): from (20, -5) to (10, 5), down to z 1; thread to z -8, lead
// 3/2, start 90.
constexpr std::array<std::string_view, 11> kNumbers = {"4", "20", "100", "15",  "0", "10",
                                                       "5", "1",  "-8",  "3/2", "90"};

std::vector<Record> records_with(std::size_t which, const Rational& off) {
  std::vector<Record> records;
  std::size_t number = 0;
  for (const std::string_view form : kRecords) {
    std::string text;
    for (const char c : form) {
      if (c != '@') {
        text += c;
        continue;
      }
      Rational value = parse_rational(kNumbers.at(number));
      if (number == which) value += off;
      text += value.get_str();
      ++number;
    }
    records.push_back(read_record(parse_json(text)));
  }
  return records;
}

Answer answer_to(std::size_t which, const Rational& off) {
  Vector vector{"x.y.000001", "rs274", {}, parse_json("{}"), "\n\n\n\n", {}};
  Expectation expectation;
  expectation.records = records_with(kNumbers.size(), 0);
  Tolerances tolerances;
  tolerances.tolerance = Rational(1, 1000);
  const Trace trace{records_with(which, off), std::nullopt, TraceEnd::end, {}};
  return match(vector, expectation, trace, tolerances).answer;
}

TEST(CheckerPerturbation, NothingOffFits) {
  EXPECT_EQ(answer_to(kNumbers.size(), 0), Answer::fits);
}

RC_GTEST_PROP(CheckerPerturbation, MoreThanTheToleranceIsNeverAPass, ()) {
  const auto which = *rc::gen::inRange<std::size_t>(0, kNumbers.size());
  // From just above the tolerance to more than a metre, either way.
  const auto steps = *rc::gen::inRange<long>(1, 1'000'000'000);
  const bool below = *rc::gen::arbitrary<bool>();
  Rational off = Rational(1, 1000) + Rational(steps, 1'000'000);
  off.canonicalize();
  if (below) off = -off;
  RC_PRE(which != 10 || abs(off) < 359);  // a start angle is one modulo 360
  RC_ASSERT(answer_to(which, off) != Answer::fits);
  // And no excuse is made for it, except an arc that might go on.
  if (which < 3 || which > 7) RC_ASSERT(answer_to(which, off) == Answer::departs);
}

RC_GTEST_PROP(CheckerPerturbation, TheToleranceItselfIsAlwaysAPass, ()) {
  const auto which = *rc::gen::inRange<std::size_t>(0, kNumbers.size());
  RC_PRE(which != 2 && which < 9);  // feed, lead and start angle have no tolerance
  const auto steps = *rc::gen::inRange<long>(-1000, 1001);
  Rational off(steps, 1'000'000);
  off.canonicalize();
  RC_ASSERT(answer_to(which, off) == Answer::fits);
}

}  // namespace
}  // namespace gonogo::checker
