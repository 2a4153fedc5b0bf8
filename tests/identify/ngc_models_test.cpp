// SPDX-License-Identifier: GPL-3.0-or-later
//
// Machines whose canned cycles are known, told from their answers alone. Each model is an expander
// with the readings and the features of that machine, by its sources; what it must be found to
// follow is written down here reading by reading.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "identify/identify.hpp"
#include "pools.hpp"
#include "secret_subject.hpp"

namespace gonogo::identify {
namespace {

using reference::ReadingChoice;
using testing::builtin;
using testing::pool_of;
using testing::SecretSubject;
using enum ReadingKey;

struct Trait {
  ReadingKey key;
  std::string_view value;
};
using Traits = std::vector<Trait>;

// A machine with some of the expander's cycles.
class Model : public SecretSubject {
 public:
  Model(const Traits& traits, const std::set<std::string>& lacks)
      : SecretSubject(builtin("ngc"), readings_of(traits)), info_(SecretSubject::info()) {
    for (auto& [dialect, features] : info_.dialects) {
      std::erase_if(features, [&](const std::string& one) { return lacks.contains(one); });
    }
  }
  const oracle::SubjectInfo& info() const override { return info_; }

 private:
  static ReadingChoice readings_of(const Traits& traits) {
    ReadingChoice choice;
    for (const Trait& trait : traits) choice.set(trait.key, trait.value);
    return choice;
  }
  oracle::SubjectInfo info_;
};

const std::vector<std::string>& values_of(const Identification& found, ReadingKey key) {
  return std::ranges::find(found.readings, key, &ReadingFound::key)->values;
}

void expect_named(const Identification& found, const Traits& traits) {
  EXPECT_TRUE(found.contradiction.empty());
  for (const Trait& trait : traits) {
    EXPECT_EQ(values_of(found, trait.key), std::vector<std::string>{std::string(trait.value)})
        << reference::reading(trait.key).name;
  }
}

// Where each block has an initial level of its own, it is where the tool stands: so R under G91
// counts from the same place by both, the way to the hole is one, and nothing is kept over a change
// of units.
void expect_level_of_the_block(const Identification& found) {
  using Values = std::vector<std::string>;
  EXPECT_EQ(values_of(found, ngc_cycle_g91_r), (Values{"current", "initial"}));
  EXPECT_EQ(values_of(found, ngc_cycle_approach), (Values{"current-level", "initial-level"}));
  EXPECT_EQ(values_of(found, ngc_cycle_initial_kept), (Values{"place", "number"}));
}

// LinuxCNC 2.9, as its stand-alone interpreter runs.
const Traits kLinuxcnc = {
    {ngc_arc_tolerance, "linuxcnc"},
    {ngc_whole, "linuxcnc"},
    {ngc_g80_beside, "ignored"},
    {ngc_unused_words, "alarm"},
    {ngc_line_number, "decimal"},
    {ngc_o_name, "passed-over"},
    {ngc_program_end, "needed"},
    {ngc_bare_motion, "nothing"},
    {ngc_arc_words_alone, "arc"},
    {ngc_cycle_initial, "series"},
    {ngc_cycle_g91_r, "initial"},
    {ngc_cycle_sticky, "number"},
    {ngc_cycle_approach, "initial-level"},
    {ngc_cycle_initial_kept, "number"},
    {ngc_cycle_retract_start, "r-plane"},
    {ngc_cycle_feed, "needed"},
    {ngc_cycle_alarm_at, "late"},
    {ngc_g83_retract, "r-plane"},
    {ngc_g83_return, "rapid"},
    {ngc_peck_clearance, "ten-thou"},
    {ngc_peck_d, "barred"},
    {ngc_peck_dwell, "none"},
    {ngc_g85_out, "r-plane"},
    {ngc_tap_p, "last"},
    {ngc_g74_l, "barred"},
    {ngc_g33_k, "free"},
    {ngc_g76_checks, "linuxcnc"},
    {ngc_g76_slide, "start"},
    {ngc_g76_entry, "thread"},
    {ngc_missing_tool, "alarm"},
    {ngc_g94_feed, "none"},
    {ngc_feed_units, "before"},
    {ngc_lone_cr, "blank"},
    {ngc_alarm_dwell, "dwells"},
};

// NIST's interpreter, version 3: no G73, G74 and threads.
const Traits kNist = {
    {ngc_arc_tolerance, "nist"},
    {ngc_whole, "nist"},
    {ngc_g80_beside, "alarm"},
    {ngc_unused_words, "alarm"},
    {ngc_line_number, "whole"},
    {ngc_o_name, "syntax"},
    {ngc_program_end, "needed"},
    {ngc_bare_motion, "missing-word"},
    {ngc_arc_words_alone, "alarm"},
    {ngc_cycle_initial, "block"},
    {ngc_cycle_sticky, "number"},
    {ngc_cycle_retract_start, "r-plane"},
    {ngc_cycle_feed, "free"},
    {ngc_cycle_alarm_at, "late"},
    {ngc_g83_retract, "clear"},
    {ngc_g83_return, "rapid"},
    {ngc_peck_clearance, "ten-thou"},
    {ngc_peck_d, "barred"},
    {ngc_peck_dwell, "none"},
    {ngc_g85_out, "clear"},
    {ngc_tap_p, "barred"},
    {ngc_missing_tool, "taken"},
    {ngc_g94_feed, "kept"},
    {ngc_feed_units, "before"},
    {ngc_lone_cr, "blank"},
};

// grblHAL: no motion for G85, G86 and G89.
const Traits kGrblhal = {
    {ngc_g80_beside, "alarm"},        {ngc_unused_words, "alarm"},
    {ngc_program_end, "free"},        {ngc_cycle_initial, "block"},
    {ngc_cycle_sticky, "level"},      {ngc_cycle_retract_start, "initial"},
    {ngc_cycle_feed, "needed"},       {ngc_cycle_alarm_at, "block"},
    {ngc_g83_retract, "clear"},       {ngc_g83_return, "feed"},
    {ngc_peck_clearance, "tenth-mm"}, {ngc_peck_d, "barred"},
    {ngc_peck_dwell, "quarter"},      {ngc_tap_p, "needed"},
    {ngc_g33_k, "positive"},          {ngc_g76_checks, "text"},
    {ngc_g76_slide, "end"},           {ngc_g76_entry, "rapid"},
    {ngc_feed_units, "after"},        {ngc_lone_cr, "blank"},
};

TEST(IdentifyCycles, NamesTheReadingsOfLinuxcnc) {
  Traits traits = kLinuxcnc;
  traits.push_back({ngc_g73_end, "clear"});
  Model subject(traits, {});
  const Identification found = identify_readings(subject, pool_of("rs274"), {});
  expect_named(found, kLinuxcnc);
  // Out to R and on to the clear level is one way to the judge.
  EXPECT_EQ(values_of(found, ngc_g73_end), (std::vector<std::string>{"clear", "both"}));
  EXPECT_FALSE(subject.told_a_reading());
}

TEST(IdentifyCycles, NamesTheReadingsOfNist) {
  Model subject(kNist, {"g73", "g74", "g33", "g33.1", "g76"});
  const Identification found = identify_readings(subject, pool_of("rs274"), {});
  expect_named(found, kNist);
  expect_level_of_the_block(found);
  EXPECT_EQ(values_of(found, ngc_g73_end).size(), 3U) << "it has no G73";
}

TEST(IdentifyCycles, NamesTheReadingsOfGrblhal) {
  Traits traits = kGrblhal;
  traits.push_back({ngc_g73_end, "clear"});
  Model subject(traits, {"g85", "g86"});
  const Identification found = identify_readings(subject, pool_of("rs274"), {});
  expect_named(found, kGrblhal);
  expect_level_of_the_block(found);
  EXPECT_EQ(values_of(found, ngc_g85_out).size(), 2U) << "it has no G85";
}

}  // namespace
}  // namespace gonogo::identify
