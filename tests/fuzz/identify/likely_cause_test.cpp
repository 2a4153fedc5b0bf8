// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which mistake a report names, and what it says of it; most are tried on planted faults.
#include "fuzz/identify/likely_cause.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <utility>

#include "attributed.hpp"

namespace gonogo::identify {
namespace {

using testing::attribute_fault;
using testing::builtin;
using testing::case_of;
using testing::Planted;

// Programs of which the first depart.
Attribution seen_of(std::size_t departures, std::size_t passes) {
  Attribution found;
  found.departures = departures;
  for (std::size_t i = 0; i < departures + passes; ++i) {
    Observation seen;
    seen.id = fmt::format("p{}", i + 1);
    seen.verdict.kind =
        i < departures ? oracle::VerdictKind::fail_geometry : oracle::VerdictKind::pass_exact;
    found.programs.push_back(std::move(seen));
  }
  return found;
}

// A mistake that explains the first of the departures.
Cause explains(std::string name, std::size_t departures, std::size_t passes) {
  Cause cause{std::move(name), departures, 0, passes};
  for (std::size_t i = 0; i < departures; ++i) cause.explained.push_back(fmt::format("p{}", i + 1));
  return cause;
}

// A cause of which nothing has been counted.
LikelyCause called(std::string name) {
  return {std::move(name), {}, {}, 0, {}};
}

// Hand made: three departures of four are explained, then two of four, then all by two mistakes.
TEST(LikelyCause, IsNoneOverAMinorityAndNamesItsRivals) {
  Attribution found = seen_of(4, 2);
  found.partial = {explains("a", 3, 2), explains("b", 4, 1)};
  ASSERT_FALSE(likely_cause(found).empty());
  EXPECT_EQ(likely_cause(found).name, "a");
  EXPECT_EQ(likely_cause(found).evidence(),
            "It explains 3 of 4 departures that were tried (not: p4), and that 2 programs pass.");
  found.partial = {explains("a", 2, 2)};
  EXPECT_TRUE(likely_cause(found).empty());
  found.complete = {explains("c", 4, 2), explains("d", 4, 2)};
  EXPECT_EQ(likely_cause(found).evidence(),
            "It explains 4 of 4 departures that were tried, and that 2 programs pass. As much is "
            "explained by: d.");
}

TEST(LikelyCause, IsNoMisreadWordBelowThreeQuarters) {
  Attribution found = seen_of(5, 1);
  found.partial = {explains("a", 3, 1)};
  EXPECT_FALSE(likely_cause(found).empty());
  found.partial.front().is_misread = true;
  EXPECT_TRUE(likely_cause(found).empty());
  found = seen_of(4, 2);
  found.partial = {explains("a", 3, 2)};
  found.partial.front().is_misread = true;
  EXPECT_FALSE(likely_cause(found).empty());
}

TEST(LikelyCause, NamesThreeDeparturesThatItLeavesAndCountsTheOthers) {
  Attribution found = seen_of(9, 1);
  found.partial = {explains("a", 6, 1)};
  EXPECT_EQ(likely_cause(found).evidence(),
            "It explains 6 of 9 departures that were tried (not: p7, p8, p9), and that 1 program "
            "passes.");
  found = seen_of(12, 0);
  found.partial = {explains("a", 7, 0)};
  EXPECT_EQ(likely_cause(found).evidence(),
            "It explains 7 of 12 departures that were tried (not: p8, p9, p10 and 2 more).");
}

// The circle of one dialect, then that of the other.
TEST(LikelyCause, IsRecognisedInAnotherDialectAndCountsItsDepartures) {
  const auto subject = builtin("sinumerik", "cip-sense-flipped");
  const std::string name = "every CIP turns the other way";
  std::vector<LikelyCause> named = {{"another", {"x"}, {}, 1, {}},
                                    {name, {"s840.cip.000001"}, {}, 3, {"CIP is ignored"}}};
  std::vector<ProgramAsked> departures(4, case_of("s802.path.000013"));
  for (std::size_t i = 1; i < departures.size(); ++i) departures[i].id += fmt::format("-{}", i);
  const std::vector<ProgramAsked> others = {case_of("s802.path.000001"), departures.front()};
  const LikelyCause* const found = recognise(named, *subject, {departures, others}, {});
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->name, name);
  EXPECT_EQ(found->evidence(),
            "It explains 5 of 5 departures that were tried, and that 4 programs pass.");
  EXPECT_EQ(found->dialects, std::set<std::string>{"sinumerik802s"});
  const auto right = builtin("sinumerik");
  EXPECT_EQ(recognise(named, *right, {departures, others}, {}), nullptr);
}

// A first finding that has G2 alone tells nothing of G3.
TEST(LikelyCause, IsNamedAfterTheRivalThatExplainsAnotherFindingAsWell) {
  const auto subject = builtin("ngc", "inch-offsets-unscaled");
  std::vector<LikelyCause> named = {
      {"I J K of G2 is not converted from inches",
       {"first"},
       {},
       3,
       {"every arc turns the other way", "I J K of G2 G3 is not converted from inches"}}};
  const ProgramAsked asked{"second", "F100\nG20\nG3 X1 Y1 I0.5 J0.5\nM2\n",
                           testing::default_machine("rs274")};
  const LikelyCause* const found = recognise(named, *subject, {{&asked, 1}, {}}, {});
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->name, "I J K of G2 G3 is not converted from inches");
  EXPECT_EQ(found->evidence(),
            "It explains 2 of 2 departures that were tried, and that 3 programs pass.");
  // Where it leaves some, the rival may leave others.
  named.front() = {"I J K of G2 is not converted from inches",
                   {"a"},
                   {"b"},
                   3,
                   {"I J K of G2 G3 is not converted from inches"}};
  EXPECT_EQ(recognise(named, *subject, {{&asked, 1}, {}}, {}), nullptr);
}

class LikelyCauseOf : public ::testing::TestWithParam<Planted> {};

TEST_P(LikelyCauseOf, APlantedFaultIsNamed) {
  const Planted& planted = GetParam();
  const Attribution found = attribute_fault(planted);
  EXPECT_EQ(likely_cause(found).name, planted.cause) << attribution_text(found);
}

INSTANTIATE_TEST_SUITE_P(
    Expanders, LikelyCauseOf,
    ::testing::Values(
        // Beyond the limit no path is left.
        Planted{"ngc", "g76-equal-k-passed", "ngc.threading.v1-t2f2-s1.000037",
                "K on a limit counts as a trifle larger, < for <= or the other way round"},
        // The limit refuses its own value.
        Planted{"gsk", "taper-equality-refused", "gsk.g90.alarm.000017",
                "R on a limit counts as a trifle larger, < for <= or the other way round"},
        Planted{"gsk", "home-direct", "gsk.basic.000046", "G28 leaves out the point of its words"},
        // A CT behind the CIP goes on from it, so that more departs than the CIP itself.
        Planted{"sinumerik", "cip-sense-flipped", "s840.cip.000001",
                "every CIP turns the other way"},
        Planted{"gsk", "end-point-lost", "gsk.g94.000088",
                "an axis that a later block of all cycles does not name does not move"},
        Planted{"sinumerik", "dwell-feed-kept", "s840.modes.000055",
                "F of a dwell becomes the feed"},
        // A way of no length is no motion, so that the path shows nothing of the end of some.
        Planted{"sinumerik", "drill-retract-to-clearance", "s802.lcyc82.000003",
                "the end of LCYC82 is where its cut began"},
        Planted{"sinumerik", "pocket-retract-to-clearance", "s802.lcyc75.000037",
                "the end of LCYC75 is where its cut began"},
        // A word out of place is no word misread.
        Planted{"ngc", "unused-alone-passed", "ngc.amendments.000017", ""}),
    testing::name_of);

// Runs another program in place of the one that it is given, as long in lines; or one of a machine
// whose reference point is its zero point.
class Misreading : public testing::ReferenceSubject {
 public:
  Misreading(std::string written, std::string read)
      : written_(std::move(written)), read_(std::move(read)) {}
  void configure(const Profile& profile) override {
    Profile own = profile;
    if (written_ == read_) own.reference_point = {};
    ReferenceSubject::configure(own);
  }
  oracle::RunEnd run(std::string_view id, std::string_view program,
                     const oracle::RecordSink& sink) override {
    std::string text(program);
    const std::size_t at = text.find(written_);
    if (at != std::string::npos) text.replace(at, written_.size(), read_);
    return ReferenceSubject::run(id, text, sink);
  }

 private:
  std::string written_;
  std::string read_;
};

// What the names say, written by hand.
TEST(LikelyCause, OfAWayToAReferencePointOfRs274) {
  using reference::Axis;
  Profile machine = testing::default_machine("rs274");
  ASSERT_FALSE(reference::set_reading(machine, "ngc.g28-axes", "named"));
  machine.reference_point[Axis::x] = 5;
  machine.reference_point[Axis::y] = 6;
  machine.reference_point[Axis::z] = 7;
  const auto cause_of = [&](const std::string& written, const std::string& read) {
    std::vector<LikelyCause> named;
    for (const char* name :
         {"G28 takes all axes to the reference point", "G28 leaves out the point of its words",
          "G28 without a word of an axis moves none",
          "the reference point is the zero point of the machine"}) {
      named.push_back(called(name));
    }
    const ProgramAsked asked{"home", "G0 X1 Y2 Z3\nG91\n" + written + "\nG90 G1 X9 Y9 F100\nM2\n",
                             machine};
    Misreading subject(written, read);
    const LikelyCause* const found = recognise(named, subject, {{&asked, 1}, {}}, {});
    return found == nullptr ? std::string() : found->name;
  };
  EXPECT_EQ(cause_of("G28 Z-4", "G28 Z0"), "G28 leaves out the point of its words");
  EXPECT_EQ(cause_of("G28 Z-4", "G28 X0 Y0 Z-4 A0 C0"),
            "G28 takes all axes to the reference point");
  EXPECT_EQ(cause_of("G28", "G4 P0"), "G28 without a word of an axis moves none");
  EXPECT_EQ(cause_of("G28 Z-4", "G28 Z-4"), "the reference point is the zero point of the machine");
  EXPECT_EQ(cause_of("G28 Z-4", "G28 Z5"), "");
}

TEST(LikelyCause, IsNotRecognisedWhereAProgramPassesThatWouldNot) {
  const Profile machine = testing::default_machine("rs274");
  const ProgramAsked asked{"departs", "G0 X1 Z3\nG91\nG28 Z4\nM2\n", machine};
  const ProgramAsked passes{"passes", "G0 X1 Z3\nG91\nG28 Z5\nM2\n", machine};
  Misreading subject("G28 Z4", "G28 Z0");
  std::vector<LikelyCause> named = {called("G28 leaves out the point of its words")};
  EXPECT_EQ(recognise(named, subject, {{&asked, 1}, {&passes, 1}}, {}), nullptr);
  EXPECT_NE(recognise(named, subject, {{&asked, 1}, {}}, {}), nullptr);
}

// Its words go without a check as well as they come from the cycle before.
TEST(LikelyCause, IsTheOneThatSaysWhatTheSubjectDoesRatherThanWhatItDoesNotCheck) {
  Attribution found = seen_of(1, 2);
  found.complete = {explains("R is not checked", 1, 2), explains("R stays in force", 1, 2)};
  found.complete.front().is_by_path = false;
  EXPECT_EQ(likely_cause(found).name, "R stays in force");
  EXPECT_EQ(likely_cause(found).rivals, std::vector<std::string>{"R is not checked"});
  found.complete.back().is_misread = true;
  EXPECT_NE(likely_cause(found).name, "R stays in force");
}

// Among the hundreds of ways to misread a word there is one for nearly every single departure.
TEST(LikelyCause, IsNoWordMisreadWhereOneProgramDeparts) {
  Attribution found;
  found.programs.resize(108);
  found.departures = 1;
  found.complete = {{"L in G17 is ignored but under G91", 1, 0, 107, {}, true}};
  EXPECT_TRUE(likely_cause(found).empty());
  found.complete.front().is_misread = false;
  EXPECT_FALSE(likely_cause(found).empty());
}

TEST(LikelyCause, IsNoneWhereAMistakeAndItsOppositeExplainAsMuch) {
  Attribution found;
  found.programs.resize(6);
  found.departures = 3;
  const std::string opposite = "I of G3 is converted from inches";
  found.complete = {{"I of G3 is not converted from inches", 3, 0, 3, opposite},
                    {opposite, 3, 0, 3}};
  EXPECT_TRUE(likely_cause(found).empty());
  found.complete[1].name = "J of G3 is converted from inches";
  EXPECT_EQ(likely_cause(found).name, "I of G3 is not converted from inches");
}

}  // namespace
}  // namespace gonogo::identify
