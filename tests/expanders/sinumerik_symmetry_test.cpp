// SPDX-License-Identifier: GPL-3.0-or-later
// One SINUMERIK program larger, in increments, in inches, with parameters
// and backwards: the motions of the expander follow, within its own increment. The programs and
// their writings are those that the reference is tried on.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>

#include "expanders/registry.hpp"
#include "oracle/subject.hpp"
#include "tests/reference/path_trace.hpp"
#include "tests/reference/sinumerik/sie_program.hpp"

namespace gonogo::expanders::testing {
namespace {

namespace sie = reference::testing::sie;
using reference::Number;
using reference::testing::AxesChange;
using reference::testing::PathTrace;
using sie::Ends;
using sie::Program;
using sie::Writing;

struct Result {
  PathTrace trace;  // without the alarm
  std::string alarm;
  std::uint64_t alarm_block = 0;
};

oracle::Subject& subject() {
  static const auto made = oracle::make_interface_subject(*find("sinumerik"));
  return *made;
}

Result result_of(const std::string& text, const reference::Profile& profile) {
  Result result;
  subject().configure(profile);
  const oracle::RunEnd end = subject().run("symmetry", text, [&](const reference::Record& record) {
    result.trace.push_back(reference::testing::path_item(record));
    return true;
  });
  RC_ASSERT(end.kind == oracle::RunEnd::Kind::ok || end.kind == oracle::RunEnd::Kind::alarm);
  result.alarm = end.alarm.alarm_class;
  result.alarm_block = end.alarm.block;
  return result;
}
Result result_of(const Program& program, const Writing& writing) {
  return result_of(sie::text(write(program, writing)), machine(program, writing));
}

// Twice the increment, and more where the centre of a shallow arc is far.
bool near(const Number& a, const Number& b) {
  const Number increment = subject().info().resolution.value_or(Number::decimal(false, 1, 9));
  return abs(a - b) <= increment * 2 + abs(b) * Number::decimal(false, 1, 8);
}
template <typename Numbers>
bool all_near(const Numbers& a, const Numbers& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), near);
}

void expect_near(PathTrace got, const PathTrace& want) {
  RC_LOG() << "got" << got << "\nwant" << want << "\n";
  RC_ASSERT(got.size() == want.size());
  for (std::size_t i = 0; i < want.size(); ++i) {
    RC_ASSERT(all_near(got[i].to, want[i].to));
    RC_ASSERT(all_near(got[i].via, want[i].via));
    RC_ASSERT(all_near(got[i].centre, want[i].centre));
    got[i].to = want[i].to;
    got[i].via = want[i].via;
    got[i].centre = want[i].centre;
  }
  RC_ASSERT(got == want);
}

void expect_same_end(const Result& got, const Result& want) {
  RC_TAG(want.alarm.empty() ? std::string("no alarm") : want.alarm);
  RC_ASSERT(got.alarm == want.alarm);
  RC_ASSERT(got.alarm_block == want.alarm_block);
}

Writing any_writing() {
  Writing writing;
  writing.ends = static_cast<Ends>(reference::testing::any_between(0, 3));
  writing.absolute_centres = reference::testing::any_between(0, 1) == 1;
  return writing;
}

RC_GTEST_PROP(SinumerikSymmetry, ALargerProgramHasLargerLimits, ()) {
  const Program program = *sie::programs();
  const Writing writing = any_writing();
  const Result plain = result_of(program, writing);
  AxesChange change;
  change.scale = 4;
  const Program larger = sie::scaled(program, change.scale);
  reference::Profile profile = machine(larger, writing);
  profile.parameters["CIRCLE_ERROR_CONST"] = Number::millionths(40'000);
  const Result other = result_of(sie::text(write(larger, writing)), profile);
  expect_same_end(other, plain);
  expect_near(other.trace, changed(plain.trace, change));
}

RC_GTEST_PROP(SinumerikSymmetry, IncrementsLeadWhereAbsoluteWordsLead, ()) {
  const Program program = *sie::programs();
  Writing writing;
  const Result absolute = result_of(program, writing);
  for (const Ends ends : {Ends::incremental, Ends::ac_and_ic, Ends::mixed}) {
    writing.ends = ends;
    writing.absolute_centres = !writing.absolute_centres;
    const Result other = result_of(program, writing);
    expect_same_end(other, absolute);
    expect_near(other.trace, absolute.trace);
  }
}

RC_GTEST_PROP(SinumerikSymmetry, AnInchIs254TenthsOfAMillimetre, ()) {
  const Program program = *sie::programs();
  Writing writing = any_writing();
  writing.lengths = sie::Lengths::inch;
  const Result inch = result_of(program, writing);
  writing.lengths = sie::Lengths::inch_in_mm;
  const Result other = result_of(program, writing);
  expect_same_end(other, inch);
  expect_near(other.trace, inch.trace);
}

RC_GTEST_PROP(SinumerikSymmetry, ParametersAndExpressionsStandForNumbers, ()) {
  const Program program = *sie::programs();
  Writing writing = any_writing();
  const Result numbers = result_of(program, writing);
  for (const sie::Values values : {sie::Values::parameters, sie::Values::expressions}) {
    writing.values = values;
    const Result other = result_of(program, writing);
    RC_ASSERT(other.alarm == numbers.alarm);
    // Poles have their assignments in a block before.
    expect_near(without_blocks(other.trace), without_blocks(numbers.trace));
  }
}

RC_GTEST_PROP(SinumerikSymmetry, APathWalkedBackwardsIsThePathReversed, ()) {
  const Program program = *sie::two_way_programs();
  const Writing writing = any_writing();
  const Result there = result_of(program, writing);
  const Result back = result_of(sie::reversed(program), writing);
  RC_ASSERT(there.alarm.empty());
  RC_ASSERT(back.alarm.empty());
  expect_near(without_blocks(motions_of(back.trace)), reversed(there.trace, program.start));
}

}  // namespace
}  // namespace gonogo::expanders::testing
