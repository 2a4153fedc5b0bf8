// SPDX-License-Identifier: GPL-3.0-or-later
//
// SIE-LC75-03, -08, -09: each rule at its boundary. The tool's radius is 5, the allowance 0.75, the
// depth 8.
#include <gtest/gtest.h>

#include <algorithm>

#include "s802_expanding.hpp"

namespace gonogo::reference::testing::sie {
namespace {

std::string pocket_outcome(std::string_view changes, const Profile& profile = s802()) {
  return outcome_of_program(pocket_program(changes), profile);
}
std::string pocket_clause(std::string_view changes, const Profile& profile = s802()) {
  return clauses(pocket_program(changes), profile).back();
}

TEST(Lcyc75Rules, TheCycleOfTheTestsRuns) {
  EXPECT_EQ(pocket_outcome(""), "end");
  EXPECT_EQ(pocket_outcome("R127=2"), "end");
}

TEST(Lcyc75Rules, PlanesLieInOrder) {
  EXPECT_EQ(pocket_outcome("R101=2"), "end");
  EXPECT_EQ(pocket_outcome("R101=1.999"), "reference-plane R101");
  EXPECT_EQ(pocket_outcome("R102=-0.001"), "value-sign R102");
  EXPECT_EQ(pocket_outcome("R104=0"), "reference-plane R104");
  EXPECT_EQ(pocket_outcome("R104=-0.001 R125=0"), "end");
  EXPECT_EQ(pocket_clause("R101=1"), "SIE-LC82-04");
}

TEST(Lcyc75Rules, LengthAndWidthAreAboveZero) {
  EXPECT_EQ(pocket_outcome("R118=0"), "pocket-size R118");
  EXPECT_EQ(pocket_outcome("R119=-1"), "pocket-size R119");
  EXPECT_EQ(pocket_clause("R118=0"), "SIE-LC75-09");
}

// Roughing needs 2 (5 + 0.75) between the walls, finishing 10.
TEST(Lcyc75Rules, TheToolFitsBetweenTheWalls) {
  EXPECT_EQ(pocket_outcome("R118=11.5"), "end");
  EXPECT_EQ(pocket_outcome("R118=11.499"), "tool-too-large R118");
  EXPECT_EQ(pocket_outcome("R119=11.5"), "end");
  EXPECT_EQ(pocket_outcome("R119=11.499"), "tool-too-large R119");
  EXPECT_EQ(pocket_outcome("R127=2 R118=10"), "end");
  EXPECT_EQ(pocket_outcome("R127=2 R118=9.999"), "tool-too-large R118");
  EXPECT_EQ(pocket_clause("R119=5"), "SIE-LC75-08");
}

TEST(Lcyc75Rules, ACornerSmallerThanTheToolIsAllowed) {
  EXPECT_EQ(pocket_outcome("R120=0"), "end");
  EXPECT_EQ(pocket_outcome("R120=-0.001"), "value-sign R120");
}

TEST(Lcyc75Rules, ACornerLargerThanFitsIsAReading) {
  const Profile reject = s802({{"sie.corner", "reject"}});
  EXPECT_EQ(pocket_outcome("R120=20.001"), "end");
  EXPECT_EQ(pocket_outcome("R120=20", reject), "end");
  EXPECT_EQ(pocket_outcome("R120=20.001", reject), "pocket-size R120");
  const auto touches = [](std::string_view changes) {
    const Lines names = touched(pocket_program(changes), s802());
    return std::ranges::find(names, "sie.corner") != names.end();
  };
  EXPECT_FALSE(touches("R120=20"));
  EXPECT_TRUE(touches("R120=20.001"));
}

TEST(Lcyc75Rules, TheInfeedIsAboveZero) {
  EXPECT_EQ(pocket_outcome("R121=0"), "value-sign R121");
  EXPECT_EQ(pocket_outcome("R121=-4"), "value-sign R121");
  EXPECT_EQ(pocket_outcome("R121=0.001 R104=-0.503"), "end");
}

TEST(Lcyc75Rules, FeedsAreAboveZero) {
  EXPECT_EQ(pocket_outcome("R122=0"), "feed-missing R122");
  EXPECT_EQ(pocket_outcome("R123=0"), "feed-missing R123");
  EXPECT_EQ(pocket_outcome("R122=-1"), "feed-missing R122");
  EXPECT_EQ(pocket_outcome("R122=0.001 R123=0.001"), "end");
}

TEST(Lcyc75Rules, TheAllowanceIsSmallerThanTheTool) {
  EXPECT_EQ(pocket_outcome("R124=9.999"), "end");
  EXPECT_EQ(pocket_outcome("R124=10"), "allowance-too-large R124");
  EXPECT_EQ(pocket_outcome("R124=10 R127=2"), "allowance-too-large R124");
  EXPECT_EQ(pocket_outcome("R124=-0.001"), "value-sign R124");
  EXPECT_EQ(pocket_outcome("R124=0"), "end");
}

TEST(Lcyc75Rules, TheAllowanceInDepthLeavesSomething) {
  EXPECT_EQ(pocket_outcome("R125=7.999"), "end");
  EXPECT_EQ(pocket_outcome("R125=8"), "allowance-too-large R125");
  EXPECT_EQ(pocket_outcome("R125=8 R127=2"), "end");
  EXPECT_EQ(pocket_outcome("R125=-0.001"), "value-sign R125");
}

TEST(Lcyc75Rules, TheDirectionIsTwoOrThree) {
  EXPECT_EQ(pocket_outcome("R126=3"), "end");
  for (const std::string_view value : {"0", "1", "2.001", "4", "-2"}) {
    EXPECT_EQ(pocket_outcome("R126=" + std::string(value)), "direction-parameter R126") << value;
  }
  EXPECT_EQ(ending(circle_program("0"), s802()), "alarm b6 direction-parameter");
}

TEST(Lcyc75Rules, TheTypeIsOneOrTwo) {
  for (const std::string_view value : {"0", "1.5", "3", "-1"}) {
    EXPECT_EQ(pocket_outcome("R127=" + std::string(value)), "machining-type R127") << value;
  }
}

TEST(Lcyc75Rules, NeedsATool) {
  EXPECT_EQ(pocket_outcome("T0"), "no-tool T");
  EXPECT_EQ(pocket_outcome("D0"), "no-tool T");
  EXPECT_EQ(pocket_outcome("D0\nD1"), "end");
  EXPECT_EQ(pocket_outcome("D0\nT1 R118=90 R119=90"), "end");
  EXPECT_EQ(pocket_clause("T0"), "SIE-LC75-03");
}

// No alarm of the machine: it has the tool, and nobody has said how thick it is.
TEST(Lcyc75Rules, AToolThatTheProfileDoesNotDescribeIsWhatTheProfileLacks) {
  EXPECT_EQ(pocket_outcome("T5"), "not-covered profile");
  Profile blunt = s802();
  blunt.tools["4"].radius = 0;
  EXPECT_EQ(pocket_outcome("", blunt), "not-covered profile");
  const std::vector<Item> items = expand(pocket_program("T5"), s802());
  const auto& lacking = std::get<NotCovered>(items.back());
  EXPECT_EQ(lacking.lacks, R"(tools = { "5" = { radius = "5" } })");
  EXPECT_NE(lacking.message.find(lacking.lacks), std::string::npos);
  // The line, written into a profile, is what was lacking.
  const auto written = profile_from_toml("dialect = \"sinumerik802s\"\n" + lacking.lacks);
  ASSERT_TRUE(std::holds_alternative<Profile>(written));
  EXPECT_EQ(std::get<Profile>(written).tools.at("5").radius, Number(5));
}

// Each edge of a tool has a radius of its own, and a profile has one.
TEST(Lcyc75Rules, OfAnotherEdgeThanTheFirstTheRadiusIsNotKnown) {
  for (const char* edge : {"D2", "D9", "D0\nD2", "T4 D2"}) {
    EXPECT_EQ(pocket_outcome(edge), "not-covered D") << edge;
  }
  EXPECT_EQ(pocket_outcome("D2\nT4"), "end");
  EXPECT_EQ(pocket_outcome("D2\nD1"), "end");
  EXPECT_EQ(pocket_outcome("D2 R126=5"), "direction-parameter R126, no-tool T");
}

TEST(Lcyc75Rules, WhatIsWrongWhateverTheToolIsAnAlarm) {
  EXPECT_EQ(pocket_outcome("T5 R126=0"), "direction-parameter R126, no-tool T");
}

// The second example of the text has R126=0.
TEST(Lcyc75Rules, NoDirectionIsAReading) {
  const Profile g2 = s802({{"sie.lc75.no-sense", "g2"}});
  const Profile g3 = s802({{"sie.lc75.no-sense", "g3"}});
  EXPECT_EQ(pockets(pocket_program("R126=0"), g2).at(0).sense, -1);
  EXPECT_EQ(pockets(pocket_program("R126=0"), g3).at(0).sense, +1);
  EXPECT_EQ(pockets(pocket_program("R126=3"), g2).at(0).sense, +1);
  EXPECT_EQ(pocket_outcome("R126=0", s802({{"sie.lc75.no-sense", "alarm"}})),
            "direction-parameter R126");
  EXPECT_EQ(pocket_outcome("R126=1", g2), "direction-parameter R126");
  const auto touches = [](std::string_view changes) {
    const Lines names = touched(pocket_program(changes), s802());
    return std::ranges::find(names, "sie.lc75.no-sense") != names.end();
  };
  EXPECT_TRUE(touches("R126=0"));
  EXPECT_FALSE(touches(""));
  EXPECT_FALSE(touches("R126=1"));
}

// The text says of roughing that the allowance is to be smaller than the tool.
TEST(Lcyc75Rules, TheLimitOfTheAllowanceInFinishingIsAReading) {
  const Profile none = s802({{"sie.lc75.finish-limit", "none"}});
  EXPECT_EQ(pocket_outcome("R124=10 R127=2", none), "end");
  EXPECT_EQ(pockets(pocket_program("R124=12 R127=2"), none).at(0).allowance, Number(12));
  EXPECT_EQ(pocket_outcome("R124=10", none), "allowance-too-large R124");
  const auto touches = [](std::string_view changes) {
    const Lines names = touched(pocket_program(changes), s802());
    return std::ranges::find(names, "sie.lc75.finish-limit") != names.end();
  };
  EXPECT_TRUE(touches("R124=10 R127=2"));
  EXPECT_FALSE(touches("R124=9.999 R127=2"));
  EXPECT_FALSE(touches("R124=10"));
}

// Inches of 25.4 mm; the tool's diameter is 10 mm.
TEST(Lcyc75Rules, InInchesTheSentencesHaveTheNumbersOfTheProgram) {
  const Profile inch = s802({{"sie.lcyc.unit", "inch"}, {"sie.corner", "reject"}});
  const auto message = [&](const std::string& changes) {
    const std::vector<Item> items = expand(pocket_program("R124=0 R125=0 " + changes, "G70"), inch);
    return std::get<AlarmReport>(items.back()).alarms.front().message;
  };
  EXPECT_EQ(message("R118=-1"), "R118 = -1 is not above zero.");
  EXPECT_EQ(message("R120=-0.5"), "R120 = -0.5 is below zero.");
  EXPECT_EQ(message("R120=21"), "The corner radius R120 = 21 is larger than half the pocket, 20.");
  EXPECT_EQ(message("R121=-1"), "The infeed R121 = -1 is not above zero.");
  EXPECT_EQ(message("R124=0.5"),
            "The allowance R124 = 0.5 (12.7 mm) is not smaller than the tool's diameter 10.");
  EXPECT_EQ(message("R125=9"),
            "The allowance R125 = 9 leaves nothing of the depth 8 to be roughed.");
  EXPECT_EQ(message("R118=0.25 R120=0"),
            "The tool, with the allowance 10 wide, does not fit into R118 = 0.25 (6.35 mm).");
}

// 120 and 300 inches per minute are 3048 and 7620 mm/min, whatever F counts; R121 is 101.6 mm.
TEST(Lcyc75Rules, UnderG70ItsFeedsMayBeInchesToo) {
  const auto feeds = [](std::string_view unit) {
    const Profile profile = s802({{"sie.lcyc.unit", unit}, {"sie.g70.f", "inch"}});
    const PocketMilling pocket = pockets(pocket_program("R124=0 R125=0", "G70"), profile).at(0);
    return fmt::format("{} {} {}", pocket.infeed.text(), pocket.depth_feed.text(),
                       pocket.plane_feed.text());
  };
  EXPECT_EQ(feeds("mm"), "4 120 300");
  EXPECT_EQ(feeds("inch"), "101.6 120 300");
  EXPECT_EQ(feeds("inch-with-feeds"), "101.6 3048 7620");
  const Profile metric = s802({{"sie.lcyc.unit", "inch-with-feeds"}});
  EXPECT_EQ(pockets(pocket_program(), metric).at(0).plane_feed, Number(300));
}

TEST(Lcyc75Rules, NeedsATurningSpindle) {
  EXPECT_EQ(pocket_outcome("M5"), "spindle-stopped S");
  EXPECT_EQ(pocket_outcome("S0"), "spindle-stopped S");
  EXPECT_EQ(pocket_outcome("M4 S0.1"), "end");
  Profile turning = s802();
  turning.initial.spindle = 3;
  EXPECT_EQ(pocket_outcome("", turning), "end");
}

TEST(Lcyc75Rules, NeedsNoFeedOfItsOwn) {
  EXPECT_EQ(pocket_outcome("F0"), "end");
}

// F200 was in force, R123 is 300; the inch counts 25.4.
TEST(Lcyc75Rules, WhichFeedIsInForceBehindItIsAReading) {
  const auto behind = [](std::string_view blocks, const Profile& profile) {
    return path(pocket_program() + std::string(blocks), profile).back();
  };
  const Profile kept = s802({{"sie.lc75.feed-after", "kept"}, {"sie.g70.f", "inch"}});
  const Profile of_cycle = s802({{"sie.lc75.feed-after", "of-cycle"}, {"sie.g70.f", "inch"}});
  EXPECT_EQ(behind("G1 X1", kept), "feed x1 f200");
  EXPECT_EQ(behind("G1 X1", of_cycle), "feed x1 f300");
  EXPECT_EQ(behind("G1 X1 F50\nX2", of_cycle), "feed x2 f50");
  EXPECT_EQ(behind("G70\nG1 X1", kept), "feed x25.4 f5080");
  EXPECT_EQ(behind("G70\nG1 X1", of_cycle), "feed x25.4 f300");
  EXPECT_EQ(behind("G70\nG1 X1\nX2 F10", of_cycle), "feed x50.8 f254");
  // A feed that has changed to revolutions since is a new one.
  const Profile deletes =
      s802({{"sie.lc75.feed-after", "of-cycle"}, {"sie.feed-change", "deleted"}});
  EXPECT_EQ(outcome_of_program(pocket_program() + "G95 G1 X1", deletes), "feed-missing F");
  EXPECT_EQ(path(pocket_program("G95") + "G1 X1", deletes).back(), "feed x1 f300/rev");
}

TEST(Lcyc75Rules, TheFeedBehindItIsAskedForByACutThatHasNone) {
  const auto touches = [](std::string_view blocks) {
    const Lines names = touched(pocket_program() + std::string(blocks), s802());
    return std::ranges::find(names, "sie.lc75.feed-after") != names.end();
  };
  EXPECT_TRUE(touches("G1 X1"));
  EXPECT_TRUE(touches("G0 X1\nLCYC82"));
  EXPECT_FALSE(touches("G0 X1"));
  EXPECT_FALSE(touches("G1 X1 F50\nX2"));
  EXPECT_FALSE(touches("LCYC75"));
  // F200 is what R123 is; in inches and behind G95 they part again.
  EXPECT_FALSE(touches("R123=200\nLCYC75\nG1 X1\nG2 I5"));
  EXPECT_TRUE(touches("R123=200\nLCYC75\nG1 X1\nG70 X2"));
  EXPECT_TRUE(touches("R123=200\nLCYC75\nG1 X1\nR123=300\nLCYC75\nX2"));
}

TEST(Lcyc75Rules, AllBrokenRulesAreReportedInTheOrderOfTheirParameters) {
  EXPECT_EQ(pocket_outcome("R127=0 R126=0 R101=0"),
            "reference-plane R101, direction-parameter R126, machining-type R127");
  EXPECT_EQ(pocket_outcome("R121=0 R118=9"), "tool-too-large R118, value-sign R121");
  EXPECT_EQ(outcome_of_program("LCYC75", s802()),
            "reference-plane R104, pocket-size R118, pocket-size R119, value-sign R121, "
            "feed-missing R122, feed-missing R123, direction-parameter R126, machining-type R127, "
            "no-tool T, spindle-stopped S");
}

// SIE-MOD-09: the spindle of the program turns; a control that refuses it behind these may.
TEST(Lcyc75Rules, ASpindleThatWasBroughtToAPlaceOrGotAToolMayBeRefused) {
  const auto accepts = [](std::string_view changes) {
    const Profile profile = s802();
    const std::string program = pocket_program(changes);
    grammar::MemorySource bytes(program);
    grammar::LineSource source(bytes);
    Expander expander(profile, source, OpenPaths::shown);
    std::size_t found = 0;
    expander.on_acceptance([&](std::uint64_t, ClauseId clause) {
      if (clause_name(clause) == "SIE-MOD-09") ++found;
    });
    while (expander.next() != nullptr) {
    }
    return found;
  };
  EXPECT_EQ(accepts(""), 0U);
  for (const char* placed : {"SPOS=0", "SPOSA=90", "M19", "M70", "M6"}) {
    EXPECT_EQ(accepts(placed), 1U) << placed;
    EXPECT_EQ(accepts(std::string(placed) + "\nM3"), 0U) << placed;
    EXPECT_EQ(pocket_outcome(placed), "end");
    EXPECT_EQ(pocket_outcome(std::string("M5\n") + placed), "spindle-stopped S");
  }
}

// Where T changes the tool, T1 is in force behind the second line; where M6 does, T4 is. Their
// radii are 10 and 5.
TEST(Lcyc75Rules, WhetherTOrM6ChangesTheToolIsNotCovered) {
  const auto behind = [](std::string_view blocks) { return pocket_outcome(blocks); };
  EXPECT_EQ(behind("T4 M6\nT1\nM3"), "not-covered T");
  EXPECT_EQ(behind("M6\nT0\nM3"), "not-covered T");
  EXPECT_EQ(behind("T4 M6\nT1\nM3\nR121=0"), "not-covered T");
  // Without an M6 the maker's examples have T change it.
  for (const char* known : {"T1", "T1\nM6\nM3", "M6 T4\nM3", "T4 M6\nT1\nM6\nM3", "T4 M6\nT4\nM3",
                            "T4 M6\nT1\nT4\nM3"}) {
    EXPECT_EQ(behind(known), "end") << known;
  }
}

TEST(Lcyc75Rules, StandsAlone) {
  EXPECT_EQ(outcome_of_program(pocket_program("LCYC75 G1"), s802()), "conflicting-words G");
  EXPECT_EQ(outcome_of_program(pocket_program("R127=2 LCYC75"), s802()), "conflicting-words R127");
}

}  // namespace
}  // namespace gonogo::reference::testing::sie
