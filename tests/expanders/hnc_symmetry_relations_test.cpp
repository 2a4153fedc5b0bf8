// SPDX-License-Identifier: GPL-3.0-or-later
// One HNC program elsewhere, mirrored, in radii, in increments, in inches, and with its repeats
// written out: the motions of the expander follow, within its own increment. The programs and their
// writings are those that the reference is tried on.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "harness.hpp"
#include "tests/reference/hnc21t/hnc_program.hpp"

namespace gonogo::expanders::testing {
namespace {

namespace hnc = reference::testing::hnc;
using hnc::Ends;
using hnc::Program;
using hnc::Writing;
using reference::testing::Lengths;
using reference::testing::Repeats;

constexpr double kTwoCounts = 2e-9;  // the records are rounded to 1e-9 mm

struct Motion {
  std::string kind;
  std::map<std::string, double> fields;  // the centre as cz and cx
};

std::vector<Motion> motions(const Outcome& outcome) {
  std::vector<Motion> all;
  for (const std::string& record : outcome.records) {
    std::istringstream text(record);
    Motion motion;
    text >> motion.kind;
    for (std::string field; text >> field;) {
      const std::size_t equals = field.find('=');
      const std::string key = equals == std::string::npos ? "" : field.substr(0, equals);
      const std::string value = equals == std::string::npos ? field : field.substr(equals + 1);
      if (key == "c" && value.find(',') != std::string::npos) {
        motion.fields["cz"] = std::stod(value);
        motion.fields["cx"] = std::stod(value.substr(value.find(',') + 1));
      } else {
        motion.fields[key] = std::stod(value);
      }
    }
    all.push_back(motion);
  }
  return all;
}

Outcome outcome(const Program& program, const Writing& writing) {
  return run_hnc(text(write(program, writing)), profile_json(machine(program, writing)));
}

// What becomes of the motions: signs, then a shift in thousandths, along X and Z.
struct Change {
  hnc::Place sign = {1, 1};
  hnc::Place shift = {0, 0};
  bool other_lines = false;

  double operator()(const std::string& key, double value) const {
    if (key == "rot") return value * static_cast<double>(sign[0] * sign[1]);
    const bool x = key == "x" || key == "cx";
    if (!x && key != "z" && key != "cz") return value;
    const std::size_t axis = x ? 0 : 1;
    return value * static_cast<double>(sign[axis]) + static_cast<double>(shift[axis]) / 1'000;
  }
};

void expect_related(const Outcome& other, const Outcome& plain, const Change& change) {
  RC_TAG(plain.alarm.empty() ? std::string("no alarm") : plain.alarm);
  RC_ASSERT(plain.create == GONOGO_OK);
  RC_ASSERT(other.alarm == plain.alarm);
  if (!change.other_lines) {
    RC_ASSERT(other.alarm_block == plain.alarm_block);
    RC_ASSERT(other.blocks == plain.blocks);
  }
  const std::vector<Motion> want = motions(plain);
  const std::vector<Motion> got = motions(other);
  RC_ASSERT(got.size() == want.size());
  for (std::size_t i = 0; i < want.size(); ++i) {
    RC_ASSERT(got[i].kind == want[i].kind);
    RC_ASSERT(got[i].fields.size() == want[i].fields.size());
    for (const auto& [key, value] : want[i].fields) {
      const double wanted = change(key, value);
      // The centre of a shallow arc is far.
      RC_ASSERT(std::abs(got[i].fields.at(key) - wanted) <= kTwoCounts * (1 + std::abs(wanted)));
    }
  }
}

Writing any_writing() {
  Writing writing;
  writing.ends = static_cast<Ends>(*rc::gen::inRange(0, 4));
  writing.diameter = *rc::gen::arbitrary<bool>();
  writing.by_code = *rc::gen::arbitrary<bool>();
  return writing;
}

RC_GTEST_PROP(HncSymmetryRelations, AnotherWorkOffsetMovesTheProgram, ()) {
  const Program program = *hnc::programs();
  const Writing writing = any_writing();
  Change change;
  change.shift = {*rc::gen::inRange<std::int64_t>(-90'000, 90'000),
                  *rc::gen::inRange<std::int64_t>(-90'000, 90'000)};
  expect_related(outcome(translated(program, change.shift), writing), outcome(program, writing),
                 change);
}

RC_GTEST_PROP(HncSymmetryRelations, TheMirrorImageInXOrZHasAllSignsTurned, ()) {
  const Program program = *hnc::programs();
  const Writing writing = any_writing();
  for (std::size_t axis = 0; axis < 2; ++axis) {
    Change change;
    change.sign[axis] = -1;
    expect_related(outcome(mirrored(program, axis), writing), outcome(program, writing), change);
  }
}

RC_GTEST_PROP(HncSymmetryRelations, ADiameterIsTwiceTheRadius, ()) {
  const Program program = *hnc::programs();
  Writing writing = any_writing();
  writing.diameter = true;
  const Outcome diameter = outcome(program, writing);
  writing.diameter = false;
  expect_related(outcome(program, writing), diameter, {});
}

RC_GTEST_PROP(HncSymmetryRelations, IncrementsLeadWhereAbsoluteWordsLead, ()) {
  const Program program = *hnc::programs();
  Writing writing = any_writing();
  writing.ends = Ends::absolute;
  const Outcome absolute = outcome(program, writing);
  for (const Ends ends : {Ends::letters, Ends::g91, Ends::mixed}) {
    writing.ends = ends;
    expect_related(outcome(program, writing), absolute, {});
  }
}

RC_GTEST_PROP(HncSymmetryRelations, AnInchIs254TenthsOfAMillimetre, ()) {
  const Program program = *hnc::programs();
  Writing writing = any_writing();
  writing.lengths = Lengths::inch;
  const Outcome inch = outcome(program, writing);
  writing.lengths = Lengths::inch_in_mm;
  expect_related(outcome(program, writing), inch, {});
}

RC_GTEST_PROP(HncSymmetryRelations, ARepeatHasTheCodeAndTheRetainedWordsWithoutWritingThem, ()) {
  const Program program = *hnc::programs();
  Writing writing = any_writing();
  const Outcome repeated = outcome(program, writing);
  writing.repeats = Repeats::spelled_out;
  expect_related(outcome(program, writing), repeated, {});
}

RC_GTEST_PROP(HncSymmetryRelations, ARepeatIsACycleOfItsOwn, ()) {
  const Program program = *hnc::programs();
  RC_PRE(!program.reads("hnc.missing-axis", "keep"));
  Writing writing = any_writing();
  const Outcome repeated = outcome(program, writing);
  writing.repeats = Repeats::entered_anew;
  Change change;
  change.other_lines = true;
  expect_related(outcome(program, writing), repeated, change);
}

}  // namespace
}  // namespace gonogo::expanders::testing
