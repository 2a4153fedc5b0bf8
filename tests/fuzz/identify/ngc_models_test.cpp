// SPDX-License-Identifier: GPL-3.0-or-later
//
// Machines whose canned cycles are known, told from their answers alone. Each model is an expander
// with the readings and the features of that machine, by its sources; what it must be found to
// follow is written down here reading by reading.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "fuzz/identify/identify.hpp"
#include "pools.hpp"
#include "reference/reading_literal.hpp"
#include "secret_subject.hpp"

namespace gonogo::identify {
namespace {

using reference::ReadingChoice;
using testing::builtin;
using testing::pool_of;
using testing::SecretSubject;

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
  EXPECT_EQ(values_of(found, "ngc.cycle.g91-r"_key), (Values{"current", "initial"}));
  EXPECT_EQ(values_of(found, "ngc.cycle.approach"_key), (Values{"current-level", "initial-level"}));
  EXPECT_EQ(values_of(found, "ngc.cycle.initial-kept"_key), (Values{"place", "number"}));
}

// LinuxCNC 2.9, as its stand-alone interpreter runs.
const Traits kLinuxcnc = {
    {"ngc.arc-tolerance"_key, "linuxcnc"},
    {"ngc.whole"_key, "linuxcnc"},
    {"ngc.g80-beside"_key, "ignored"},
    {"ngc.unused-words"_key, "alarm"},
    {"ngc.line-number"_key, "decimal"},
    {"ngc.o-name"_key, "passed-over"},
    {"ngc.program-end"_key, "needed"},
    {"ngc.bare-motion"_key, "nothing"},
    {"ngc.arc-words-alone"_key, "arc"},
    {"ngc.cycle.initial"_key, "series"},
    {"ngc.cycle.g91-r"_key, "initial"},
    {"ngc.cycle.sticky"_key, "number"},
    {"ngc.cycle.approach"_key, "initial-level"},
    {"ngc.cycle.initial-kept"_key, "number"},
    {"ngc.cycle.retract-start"_key, "r-plane"},
    {"ngc.cycle.feed"_key, "needed"},
    {"ngc.cycle.alarm-at"_key, "late"},
    {"ngc.g83.retract"_key, "r-plane"},
    {"ngc.g83.return"_key, "rapid"},
    {"ngc.peck.clearance"_key, "ten-thou"},
    {"ngc.peck.d"_key, "barred"},
    {"ngc.peck.dwell"_key, "none"},
    {"ngc.g85.out"_key, "r-plane"},
    {"ngc.tap.p"_key, "last"},
    {"ngc.g74.l"_key, "barred"},
    {"ngc.g33.k"_key, "free"},
    {"ngc.g76.checks"_key, "linuxcnc"},
    {"ngc.g76.slide"_key, "start"},
    {"ngc.g76.entry"_key, "thread"},
    {"ngc.missing-tool"_key, "alarm"},
    {"ngc.g94-feed"_key, "none"},
    {"ngc.feed-units"_key, "before"},
    {"ngc.lone-cr"_key, "blank"},
    {"ngc.alarm-dwell"_key, "dwells"},
};

// NIST's interpreter, version 3: no G73, G74 and threads.
const Traits kNist = {
    {"ngc.arc-tolerance"_key, "nist"},
    {"ngc.whole"_key, "nist"},
    {"ngc.g80-beside"_key, "alarm"},
    {"ngc.unused-words"_key, "alarm"},
    {"ngc.line-number"_key, "whole"},
    {"ngc.o-name"_key, "syntax"},
    {"ngc.program-end"_key, "needed"},
    {"ngc.bare-motion"_key, "missing-word"},
    {"ngc.arc-words-alone"_key, "alarm"},
    {"ngc.cycle.initial"_key, "block"},
    {"ngc.cycle.sticky"_key, "number"},
    {"ngc.cycle.retract-start"_key, "r-plane"},
    {"ngc.cycle.feed"_key, "free"},
    {"ngc.cycle.alarm-at"_key, "late"},
    {"ngc.g83.retract"_key, "clear"},
    {"ngc.g83.return"_key, "rapid"},
    {"ngc.peck.clearance"_key, "ten-thou"},
    {"ngc.peck.d"_key, "barred"},
    {"ngc.peck.dwell"_key, "none"},
    {"ngc.g85.out"_key, "clear"},
    {"ngc.tap.p"_key, "barred"},
    {"ngc.missing-tool"_key, "taken"},
    {"ngc.g94-feed"_key, "kept"},
    {"ngc.feed-units"_key, "before"},
    {"ngc.lone-cr"_key, "blank"},
};

// grblHAL: no motion for G85, G86 and G89.
const Traits kGrblhal = {
    {"ngc.g80-beside"_key, "alarm"},        {"ngc.unused-words"_key, "alarm"},
    {"ngc.program-end"_key, "free"},        {"ngc.cycle.initial"_key, "block"},
    {"ngc.cycle.sticky"_key, "level"},      {"ngc.cycle.retract-start"_key, "initial"},
    {"ngc.cycle.feed"_key, "needed"},       {"ngc.cycle.alarm-at"_key, "block"},
    {"ngc.g83.retract"_key, "clear"},       {"ngc.g83.return"_key, "feed"},
    {"ngc.peck.clearance"_key, "tenth-mm"}, {"ngc.peck.d"_key, "barred"},
    {"ngc.peck.dwell"_key, "quarter"},      {"ngc.tap.p"_key, "needed"},
    {"ngc.g33.k"_key, "positive"},          {"ngc.g76.checks"_key, "text"},
    {"ngc.g76.slide"_key, "end"},           {"ngc.g76.entry"_key, "rapid"},
    {"ngc.feed-units"_key, "after"},        {"ngc.lone-cr"_key, "blank"},
};

TEST(IdentifyCycles, NamesTheReadingsOfLinuxcnc) {
  Traits traits = kLinuxcnc;
  traits.push_back({"ngc.g73.end"_key, "clear"});
  Model subject(traits, {});
  const Identification found = identify_readings(subject, pool_of("rs274"), {});
  expect_named(found, kLinuxcnc);
  // Out to R and on to the clear level is one way to the judge.
  EXPECT_EQ(values_of(found, "ngc.g73.end"_key), (std::vector<std::string>{"clear", "both"}));
  EXPECT_FALSE(subject.told_a_reading());
}

TEST(IdentifyCycles, NamesTheReadingsOfNist) {
  Model subject(kNist, {"g73", "g74", "g33", "g33.1", "g76"});
  const Identification found = identify_readings(subject, pool_of("rs274"), {});
  expect_named(found, kNist);
  expect_level_of_the_block(found);
  EXPECT_EQ(values_of(found, "ngc.g73.end"_key).size(), 3U) << "it has no G73";
}

TEST(IdentifyCycles, NamesTheReadingsOfGrblhal) {
  Traits traits = kGrblhal;
  traits.push_back({"ngc.g73.end"_key, "clear"});
  Model subject(traits, {"g85", "g86"});
  const Identification found = identify_readings(subject, pool_of("rs274"), {});
  expect_named(found, kGrblhal);
  expect_level_of_the_block(found);
  EXPECT_EQ(values_of(found, "ngc.g85.out"_key).size(), 2U) << "it has no G85";
}

}  // namespace
}  // namespace gonogo::identify
