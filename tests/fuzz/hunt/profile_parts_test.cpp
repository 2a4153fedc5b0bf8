// SPDX-License-Identifier: GPL-3.0-or-later
//
// Machines that a hunt tries, and programs for which no path is right.
#include "fuzz/hunt/profile_parts.hpp"
#include "reference/reading_literal.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "hunting.hpp"
#include "oracle/differential/differential.hpp"
#include "oracle/differential/reference_run.hpp"

namespace gonogo::hunt {
namespace {

using reference::Profile;
using reference::Reading;
using testing::defaults;

std::size_t readings_changed(const Profile& a, const Profile& b) {
  return static_cast<std::size_t>(
      std::ranges::count_if(reference::readings(), [&](const Reading& reading) {
        return a.readings.get(reading.key) != b.readings.get(reading.key);
      }));
}

TEST(MutateProfile, ChangesAReadingOrTakesASetting) {
  const Profile before = defaults("gsk988ta");
  Profile other = before;
  other.parameters["5920"] = reference::Number(30);
  other.x_diameter = false;
  std::size_t readings = 0;
  std::size_t parameters = 0;
  std::size_t scales = 0;
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    program::Dice dice(seed);
    Profile after = before;
    mutate_profile(dice, after, other);
    const bool has_parameter = after.parameters == other.parameters;
    const bool has_scale = !after.x_diameter;
    const std::size_t changed = readings_changed(before, after);
    EXPECT_LE(changed + has_parameter + has_scale, 1U) << "seed " << seed;
    readings += changed;
    parameters += has_parameter;
    scales += has_scale;
  }
  EXPECT_GT(readings, 50U);
  EXPECT_GT(parameters, 5U);
  EXPECT_GT(scales, 5U);
}

TEST(MutateProfile, ChoosesAmongTheReadingsOfTheDialect) {
  for (const char* dialect : {"gsk988ta", "hnc21t", "rs274", "sinumerik840d", "sinumerik802s"}) {
    const Profile before = defaults(dialect);
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
      program::Dice dice(seed);
      Profile after = before;
      mutate_profile(dice, after, before);
      for (const Reading& reading : reference::readings()) {
        const auto value = after.readings.get(reading.key);
        if (value == before.readings.get(reading.key)) continue;
        EXPECT_TRUE(reading.belongs_to(dialect)) << dialect << ' ' << reading.name;
        EXPECT_NE(std::ranges::find(reading.alternatives, value), reading.alternatives.end())
            << reading.name << '=' << value;
      }
    }
  }
}

// The verdict on the reference's own thread in a bore of radius 2.5, by a tool of radius 1 (below).
oracle::VerdictKind own_thread(std::string_view run_out, std::string_view length, int angle) {
  Profile profile = defaults("gsk988ta");
  profile.initial.plane = reference::Plane::g17;
  profile.readings.set("gsk.thread.runout"_key, run_out);
  const std::string text =
      fmt::format("F100\nG116 X0 Y0 Z-4 I1 E5 P0.5 D1 J{} K{}\n", length, angle);
  return oracle::judge_reference(profile, text, oracle::run_reference(profile, text, 1'000)).kind;
}

// The pass of a thread 0.5 high in a bore of radius 2.5, by a tool of radius 1, has radius 2. Run
// out along its tangent for 4, the tool stands sqrt(2^2 + 4^2) = 4.47 from the middle: deeper than
// its pass, which GSK-G114-10 forbids. Without a run-out it does not.
// That run-out is led into the wall by its reading: the judge itself says that no path is right.
TEST(ContradictsItself, NotAThreadWhoseRunOutGouges) {
  const std::string text = "F100\nG116 X0 Y0 Z-4 I1 E5 P0.5 D1 J4 K0\n";
  Profile profile = defaults("gsk988ta");
  profile.initial.plane = reference::Plane::g17;
  profile.readings.set("gsk.thread.runout=tangent"_reading);
  EXPECT_FALSE(oracle::contradicts_itself(profile, text, 1'000));
  EXPECT_EQ(
      oracle::judge_reference(profile, text, oracle::run_reference(profile, text, 1'000)).kind,
      oracle::VerdictKind::oracle_gap);
  EXPECT_FALSE(
      oracle::contradicts_itself(profile, "F100\nG116 X0 Y0 Z-4 I1 E5 P0.5 D1 J0 K0\n", 1'000));
}

// In the same bore the passes begin at radius 1.5. A run-out of 3.7 along the normal leads through
// the axis to 1.7 beyond it: nearer than the pass, but the way back up is in uncut material there,
// which GSK-G114-10 forbids. One of 3.4 ends at 1.4, in the bore. Found by generated program
// 30,292,182.
TEST(ContradictsItself, NotAThreadWhoseRunOutEndsInTheFarWall) {
  EXPECT_EQ(own_thread("radial", "3.7", 0), oracle::VerdictKind::oracle_gap);
  EXPECT_EQ(own_thread("radial", "3.4", 0), oracle::VerdictKind::pass_properties);
}

// Under the reading polar the end of the run-out is 2 - J from the middle: 2.1 on the far side with
// a J of 4.1, deeper than the pass; 1.6 with one of 3.6, above which the bore is uncut; 1.4 with
// one of 3.4. Found by generated program 31,495,361.
TEST(ContradictsItself, NotAThreadWhosePolarRunOutEndsBeyondTheAxis) {
  EXPECT_EQ(decision(own_thread("polar", "4.1", 30)), oracle::Decision::undecided);
  EXPECT_EQ(decision(own_thread("polar", "3.6", 30)), oracle::Decision::undecided);
  EXPECT_EQ(decision(own_thread("polar", "3.4", 30)), oracle::Decision::go);
}

TEST(ContradictsItself, NotWhatAlarmsOrIsNotCovered) {
  const Profile profile = defaults("gsk988ta");
  EXPECT_FALSE(oracle::contradicts_itself(profile, "G01 X10\n", 1'000));
  EXPECT_FALSE(oracle::contradicts_itself(profile, "G00 X10\nG71 U1\n", 1'000));
  EXPECT_FALSE(oracle::contradicts_itself(profile, "G00 X10 Z5\nX20\n", 1'000));
}

}  // namespace
}  // namespace gonogo::hunt
