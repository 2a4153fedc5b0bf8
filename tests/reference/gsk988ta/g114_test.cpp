// SPDX-License-Identifier: GPL-3.0-or-later
//
// G114 to G117 as `expand` shows them. G18: p = Z, q = X (a diameter in words), d = Y. r is the
// radius of a pass, rho_0 that of its start.
#include <gtest/gtest.h>

#include "expanding.hpp"

namespace gonogo::reference::testing {
namespace {

// The manual's examples: rho_0 = 18 and 4.5, passes 17.5 and 17, 5 and 5.5, four turns.
constexpr const char* kExternal =
    "G0 X140 Z70 Y20\nG18\nG114 X0 Z0 V-20 R-5 I5 J2 K30 E30 P1 Q0.5 D3 F900";
constexpr const char* kInternal =
    "G0 X140 Z70 Y30\nG18\nG116 X140 Z70 V-20 R-5 I5 J2 K30 E15 P1 Q0.5 D3 F900";

std::vector<Record> records(std::string_view program, const Profile& profile = {}) {
  std::vector<Record> found;
  for (const Item& item : expand(program, profile)) found.push_back(std::get<Record>(item));
  return found;
}

// A thread of 10 mm on the bar or in the bore of 40 mm, radius 2 of the tool, one pass of 1 mm:
// r = 21 external, 19 internal.
// Without J in the words there is no run-out.
std::string thread(const std::string& code, const std::string& words) {
  const bool has_length = words.find('J') != std::string::npos;
  return "G00 Y10\n" + code + " X0 Z0 Y0 E40 D2 P1 F100 " + words + (has_length ? "" : " J0");
}

// The helix of the first pass, and the run-out that follows it.
Record first_helix(const std::string& program, const Profile& profile = {}) {
  return records(program, profile).at(5);
}
Record first_run_out(const std::string& program, const Profile& profile = {}) {
  return records(program, profile).at(6);
}

TEST(G114, MillsTheManualsExample) {
  Lines got = lines(kExternal);
  got.at(6) = got.at(12) = "run-out";  // GSK-G114-11, tested apart
  got.at(9) = "semicircle";            // from where the run-out ended
  EXPECT_EQ(got,
            (Lines{"rapid x70 y20 z70", "rapid x0 z0", "rapid y15", "arc x0 z18 c9,0 rot-1 f900",
                   "feed z17.5 f900", "arc x0 y-5 z17.5 c0,0 rot-4 f900", "run-out", "rapid y15",
                   "rapid z20", "semicircle", "feed z17 f900", "arc x0 y-5 z17 c0,0 rot-4 f900",
                   "run-out", "rapid y15", "rapid z20", "rapid y20"}));
}

TEST(G116, MillsTheManualsExample) {
  Lines got = lines(kInternal);
  got.at(6) = got.at(12) = "run-out";
  got.at(9) = "semicircle";
  EXPECT_EQ(got, (Lines{"rapid x70 y30 z70", "rapid x70 z70", "rapid y25",
                        "arc x70 z74.5 c72.25,70 rot-1 f900", "feed z75 f900",
                        "arc x70 y5 z75 c70,70 rot-4 f900", "run-out", "rapid y25", "rapid z72.5",
                        "semicircle", "feed z75.5 f900", "arc x70 y5 z75.5 c70,70 rot-4 f900",
                        "run-out", "rapid y25", "rapid z72.5", "rapid y30"}));
}

TEST(G114, NamesTheClauseOfEachMotion) {
  const std::string six = "GSK-G114-06";
  EXPECT_EQ(clauses_of(thread("G114", "I5 J2 K30")),
            (Lines{"GSK-COM-05", "GSK-G114-05", "GSK-G114-05", six, six, six, "GSK-G114-11", six,
                   six, "GSK-G114-07"}));
}

// The reading's numbers: polar radius r + J at 30 degrees clockwise, (r + J)(cos 30, -sin 30):
// 39/4 sqrt 3 = 16.887495..., 19/2 sqrt 3 = 16.454482...
TEST(G114, RunsOutToThePolarPointOfTheManualsExample) {
  const auto all = records(kExternal);
  EXPECT_EQ(all.at(6).to[Axis::z], Number::root(0, num("39/4"), 3));
  EXPECT_EQ(all.at(6).to[Axis::x], num("-9.75"));
  EXPECT_EQ(all.at(12).to[Axis::z], Number::root(0, num("19/2"), 3));
  EXPECT_EQ(all.at(12).to[Axis::x], num("-9.5"));
}

// Internal r - J: 70 + 3 cos 30 = 72.598076..., 70 - 1.5; 70 + 3.5 cos 30 = 73.031088..., 70
// - 1.75.
TEST(G116, RunsOutToThePolarPointOfTheManualsExample) {
  const auto all = records(kInternal);
  EXPECT_EQ(all.at(6).to[Axis::z], Number::root(70, num("1.5"), 3));
  EXPECT_EQ(all.at(6).to[Axis::x], num("68.5"));
  EXPECT_EQ(all.at(12).to[Axis::z], Number::root(70, num("1.75"), 3));
  EXPECT_EQ(all.at(12).to[Axis::x], num("68.25"));
}

// The semicircle of the second pass: on the chord from (Z20, X-9.75) to (Z18, X0).
TEST(G114, EntersALaterPassByASemicircleFromWhereTheToolStands) {
  EXPECT_EQ(lines(kExternal).at(9), "arc x0 z18 c19,-4.875 rot-1 f900");
}

TEST(G114, EndsAtTheSafePositionOfTheLastPass) {
  EXPECT_EQ(ending(kExternal), "end x-9.5 y20 z20 a0 c0");
}

// rho_0 = 40/2 - 2 = 18 and the pass at 19, J 20: the run-out leads to 1 beyond the axis, and the
// safe position, at rho_0 - J = -2, lies there too.
TEST(G116, HasItsRunOutAndSafePositionBeyondTheAxisWhereJIsLonger) {
  const std::string program = thread("G116", "I5 J20 K0");
  EXPECT_EQ(records(program).at(6).to[Axis::z], Number(-1));
  EXPECT_EQ(lines(program).at(8), "rapid z-2");
}

TEST(G115, TurnsTheOtherWay) {
  EXPECT_EQ(first_helix(thread("G115", "I5 J2 K30")).rot, 2);
  EXPECT_EQ(first_helix(thread("G117", "I5 J2 K30")).rot, 2);
  EXPECT_EQ(first_run_out(thread("G115", "I5 J2 K90")).to[Axis::x], Number(23));
  EXPECT_EQ(first_run_out(thread("G117", "I5 J2 K90")).to[Axis::x], Number(17));
}

// For any K: the arc passes through both ends, its centre lies on the radius vector of the start
// (Z r, X 0) so that it leaves tangentially, and it leaves in the direction of the cutting feed:
// with the centre inside as the thread turns, with the centre outside the other way.
void expect_tangential_arc(const std::string& code, int k) {
  const bool external = code == "G114" || code == "G115";
  const int sense = code == "G114" || code == "G116" ? -1 : 1;
  const Number r = external ? 21 : 19;
  const Record arc = first_run_out(thread(code, "I5 J2 K" + std::to_string(k)));
  ASSERT_EQ(arc.kind, RecordKind::arc) << code << " K" << k;
  const auto [cosine, sine] = exact::cos_sin_degrees(k);
  const Number end = external ? 23 : 17;
  EXPECT_EQ(arc.to[Axis::z], end * cosine) << code << " K" << k;
  EXPECT_EQ(arc.to[Axis::x], end * sine * sense) << code << " K" << k;
  EXPECT_EQ(arc.centre[1], Number(0)) << code << " K" << k;
  const Number along = arc.to[Axis::z] - arc.centre[0];
  const Number across = arc.to[Axis::x];
  EXPECT_EQ(along * along + across * across, (r - arc.centre[0]) * (r - arc.centre[0]))
      << code << " K" << k;
  EXPECT_EQ(arc.rot, arc.centre[0] < r ? sense : -sense) << code << " K" << k;
}

TEST(G114, LeavesTheHelixTangentially) {
  for (const char* code : {"G114", "G115", "G116", "G117"}) {
    for (int k : {0, 30, 45, 60, 90, 120, 135, 180, 210, 270, 300, 360}) {
      expect_tangential_arc(code, k);
    }
  }
}

// (r + J) cos K = r with r = 21, J = 21, K = 60: the end lies on the tangent, 21 sqrt 3 along it.
TEST(G114, RunsOutStraightWhereTheArcIsStraight) {
  const Record straight = first_run_out(thread("G114", "I5 J21 K60"));
  EXPECT_EQ(straight.kind, RecordKind::feed);
  EXPECT_EQ(straight.to[Axis::z], Number(21));
  EXPECT_EQ(straight.to[Axis::x], Number::root(0, -21, 3));
}

// An angle that has no exact cosine: 23 cos 37 = 18.3686..., -23 sin 37 = -13.8417...
TEST(G114, RunsOutAtAnyAngle) {
  const Record arc = first_run_out(thread("G114", "I5 J2 K37"));
  EXPECT_EQ(arc.to[Axis::z].decimal_text(3), "18.369");
  EXPECT_EQ(arc.to[Axis::x].decimal_text(3), "-13.842");
  EXPECT_EQ(arc.to[Axis::z].form(), Number::Form::enclosure);
}

// Straight run-outs of length J = 2 from (Z r, X 0), K = 30; clockwise the feed points to -X.
TEST(G114, RunsOutStraightUnderItsReadings) {
  const Profile radial = profile_with({{"gsk.thread.runout", "radial"}});
  const Record out = first_run_out(thread("G114", "I5 J2 K30"), radial);
  EXPECT_EQ(out.kind, RecordKind::feed);
  EXPECT_EQ(out.to[Axis::z], Number::root(21, 1, 3));  // 21 + 2 cos 30
  EXPECT_EQ(out.to[Axis::x], Number(-1));
  const Record in = first_run_out(thread("G116", "I5 J2 K30"), radial);
  EXPECT_EQ(in.to[Axis::z], Number::root(19, -1, 3));
  EXPECT_EQ(in.to[Axis::x], Number(-1));

  const Profile tangent = profile_with({{"gsk.thread.runout", "tangent"}});
  const Record along = first_run_out(thread("G114", "I5 J2 K30"), tangent);
  EXPECT_EQ(along.to[Axis::z], Number(22));  // 21 + 2 sin 30
  EXPECT_EQ(along.to[Axis::x], Number::root(0, -1, 3));
  EXPECT_EQ(first_run_out(thread("G116", "I5 J2 K30"), tangent).to[Axis::z], Number(18));
}

// 10 mm with a lead of 3: three whole turns and a third. Clockwise the end lies at -120 degrees.
TEST(G114, EndsInAPartialTurn) {
  const Record helix = first_helix(thread("G114", "I3"));
  EXPECT_EQ(helix.rot, -4);
  EXPECT_EQ(helix.to[Axis::y], Number(0));
  EXPECT_EQ(helix.to[Axis::z], num("-10.5"));
  EXPECT_EQ(helix.to[Axis::x], Number::root(0, num("-10.5"), 3));
  EXPECT_EQ(first_helix(thread("G117", "I3")).to[Axis::x], Number::root(0, num("9.5"), 3));
}

// Less than one turn: 10 mm with a lead of 40 is a quarter.
TEST(G114, MillsLessThanATurn) {
  const Record helix = first_helix(thread("G114", "I40"));
  EXPECT_EQ(helix.rot, -1);
  EXPECT_EQ(helix.to[Axis::z], Number(0));
  EXPECT_EQ(helix.to[Axis::x], Number(-21));
}

// The run-out starts where the partial turn ended: a quarter, and a quarter more.
TEST(G114, RunsOutFromTheEndOfAPartialTurn) {
  const Record arc = first_run_out(thread("G114", "I40 J2 K90"));
  EXPECT_EQ(arc.to[Axis::z], Number(-23));
  EXPECT_EQ(arc.to[Axis::x], Number(0));
}

// P1 Q0.4: passes of 0.4, 0.8 and 1; radii 22 - t.
TEST(G114, TakesWhatRemainsInTheLastPass) {
  const Lines got = lines(thread("G114", "I5 Q0.4"));
  EXPECT_EQ(got.at(4), "feed z21.6 f100");
  EXPECT_EQ(got.at(8), "feed z21.2 f100");
  EXPECT_EQ(got.at(12), "feed z21 f100");
  EXPECT_EQ(got.size(), 17U);
}

// Without a run-out and with whole turns the tool is back at the start: no arc into later passes.
TEST(G114, HasNoSecondEntryWhereItStandsAtTheStart) {
  EXPECT_EQ(lines(thread("G114", "I5 Q0.5")),
            (Lines{"rapid y10", "rapid x0 z0", "rapid y10", "arc x0 z22 c11,0 rot-1 f100",
                   "feed z21.5 f100", "arc x0 y0 z21.5 c0,0 rot-2 f100", "rapid y10", "rapid z22",
                   "feed z21 f100", "arc x0 y0 z21 c0,0 rot-2 f100", "rapid y10", "rapid z22",
                   "rapid y10"}));
}

TEST(G114, MillsInOnePassWithoutQ) {
  const Lines one = lines(thread("G114", "I5"));
  EXPECT_EQ(one.size(), 9U);
  EXPECT_EQ(lines(thread("G114", "I5 Q0")), one);
  EXPECT_EQ(lines(thread("G114", "I5 Q1")), one);
  EXPECT_EQ(lines(thread("G114", "I5 Q7")), one);
}

TEST(G114, TakesJAndKFromTheParameters) {
  Profile profile;
  profile.parameters["5921"] = 2;
  profile.parameters["5920"] = 90;
  const std::string words = "G00 Y10\nG114 X0 Z0 Y0 E40 D2 P1 F100 I5";
  EXPECT_EQ(first_run_out(words, profile).to[Axis::x], Number(-23));
  EXPECT_EQ(first_run_out(words + " J1", profile).to[Axis::x], Number(-22));
  EXPECT_EQ(first_run_out(words + " K180", profile).to[Axis::z], Number(-23));
}

// What the block lacks and the profile too is not assumed: the message has the line to write.
TEST(G114, SaysWhichParameterTheProfileLacks) {
  const std::string words = "G00 Y10\nG114 X0 Z0 Y0 E40 D2 P1 F100 I5";
  const auto told = [](const std::string& program, const Profile& profile) {
    const std::vector<Item> items = expand(program, profile);
    const auto* outside = std::get_if<NotCovered>(&items.back());
    return outside == nullptr ? std::string() : outside->message;
  };
  EXPECT_NE(told(words, {}).find(R"(parameters = { "5920" = "30", "5921" = "2" })"),
            std::string::npos);
  EXPECT_NE(told(words + " K30", {}).find(R"(parameters = { "5921" = "2" })"), std::string::npos);
  EXPECT_NE(told(words + " J2", {}).find(R"(parameters = { "5920" = "30" })"), std::string::npos);
  EXPECT_EQ(told(words + " J0", {}), "");
  Profile profile;
  profile.parameters["5921"] = 0;
  EXPECT_EQ(told(words, profile), "");
  EXPECT_NE(told(words + " J2", profile).find("5920"), std::string::npos);
}

TEST(G114, CountsTheDepthIncrementFromTheRPlaneUnlessAReadingSaysNot) {
  const std::string program = "G00 Y20\nG114 X0 Z0 V-20 R-5 I5 E40 D2 P1 J0 F100";
  EXPECT_EQ(first_helix(program).to[Axis::y], Number(-5));
  EXPECT_EQ(first_helix(program, profile_with({{"gsk.thread.v-from", "initial"}})).to[Axis::y],
            Number(0));
}

TEST(G114, NeedsItsFourWords) {
  EXPECT_EQ(ending("G114 X0 Z0 Y-5 F100"),
            "alarm b1 missing-word missing-word missing-word missing-word");
  EXPECT_EQ(ending("G114 F100"), "end x0 y0 z0 a0 c0");
}

TEST(G114, NeedsThemAboveZero) {
  EXPECT_EQ(ending("G114 X0 Z0 Y-5 I0 P1 D3 E30 F100"), "alarm b1 value-out-of-range");
  EXPECT_EQ(ending("G114 X0 Z0 Y-5 I5 P0 D3 E30 F100"), "alarm b1 value-out-of-range");
  EXPECT_EQ(ending("G114 X0 Z0 Y-5 I5 P1 D3 E0 F100"), "alarm b1 value-out-of-range");
  EXPECT_EQ(ending("G114 X0 Z0 Y-5 I5 P1 D0 E30 F100"),
            "alarm b1 depth-exceeds-tool value-out-of-range");
}

TEST(G114, NeedsAToolRadiusNoSmallerThanTheThread) {
  EXPECT_EQ(lines("G114 X0 Z0 Y-5 I5 P3 D3 E30 J0 F100").size(), 8U);
  EXPECT_EQ(ending("G114 X0 Z0 Y-5 I5 P3.001 D3 E30 F100"), "alarm b1 depth-exceeds-tool");
}

TEST(G116, NeedsALargerBoreThanTool) {
  EXPECT_EQ(lines("G116 X0 Z0 Y-5 I5 P1 D3 E6.002 J0 F100").size(), 8U);
  EXPECT_EQ(ending("G116 X0 Z0 Y-5 I5 P1 D3 E6 F100"), "alarm b1 tool-too-large");
  EXPECT_EQ(lines("G114 X0 Z0 Y-5 I5 P1 D3 E6 J0 F100").size(), 8U);
}

TEST(G114, TakesKFrom0To360) {
  EXPECT_EQ(lines(thread("G114", "I5 J2 K360")).size(), 10U);
  EXPECT_EQ(ending(thread("G114", "I5 J2 K360.001")), "alarm b2 value-out-of-range");
  EXPECT_EQ(ending(thread("G114", "I5 J2 K-1")), "alarm b2 value-out-of-range");
  EXPECT_EQ(ending("G114 K361"), "alarm b1 value-out-of-range");
  const Profile table = profile_with({{"gsk.thread.k-range", "table"}});
  EXPECT_EQ(first_run_out(thread("G114", "I5 J2 K450"), table).to[Axis::x], Number(-23));
  EXPECT_EQ(lines(thread("G114", "I5 J2 K999999.999"), table).size(), 10U);
  EXPECT_EQ(ending(thread("G114", "I5 J2 K1000000"), table), "alarm b2 value-out-of-range");
}

TEST(G114, TakesNoSignOnP) {
  EXPECT_EQ(ending("G114 X0 Z0 Y-5 I5 P-1 D3 E30 F100"),
            "alarm b1 value-out-of-range value-out-of-range");
  EXPECT_EQ(ending("G114 P-1"), "alarm b1 value-out-of-range");
}

TEST(G114, RefusesAnRThatLeadsAwayUnlessItIsFree) {
  const std::string program = "G114 X0 Z0 Y-5 R1 I5 P1 D3 E30 J0 F100";
  EXPECT_EQ(ending(program), "alarm b1 direction-conflict");
  const Profile free = profile_with({{"gsk.thread.direction", "free"}});
  EXPECT_EQ(first_helix("G00 Y0\n" + program, free).to[Axis::y], Number(-5));
}

TEST(G116, NeedsRUnderItsReading) {
  const Profile required = profile_with({{"gsk.thread.r", "required"}});
  EXPECT_EQ(ending("G116 X0 Z0 Y-5 I5 P1 D3 E30 F100", required), "alarm b1 missing-word");
  EXPECT_EQ(lines("G116 X0 Z0 Y-5 R0 I5 P1 D3 E30 J0 F100", required).size(), 8U);
  EXPECT_EQ(lines("G114 X0 Z0 Y-5 I5 P1 D3 E30 J0 F100", required).size(), 8U);
}

TEST(G114, PositionsOverAThreadWithoutDepthAndNeedsNoFeed) {
  EXPECT_EQ(lines("G114 X20 Z5 Y-5 R-5 I5 P1 D3 E30"),
            (Lines{"rapid x10 z5", "rapid y-5", "rapid y0"}));
  EXPECT_EQ(ending("G114 X20 Z5 Y-5 I5 P1 D3 E30"), "alarm b1 feed-missing");
}

TEST(G114, StaysInForceButRetainsNoWord) {
  EXPECT_EQ(lines(thread("G114", "I5") + "\nX0 Z0 Y0 I5 P1 D2 E40 J0").size(), 17U);
  EXPECT_EQ(ending(thread("G114", "I5") + "\nX0 Z0 Y0"),
            "alarm b3 missing-word missing-word missing-word missing-word");
}

// MOD-04, as in G110: the words stay, R and the positions do not.
TEST(G114, RetainsItsWordsUnderItsReading) {
  const Profile words = profile_with({{"gsk.thread.modal", "words"}});
  const std::string whole = thread("G114", "I5 Q0.4");
  const Lines once = lines(whole, words);
  Lines twice = lines(whole + "\nX0 Z0 Y0", words);
  ASSERT_EQ(twice.size(), once.size() * 2 - 1);  // without the G00 at the beginning
  EXPECT_EQ(Lines(twice.begin() + static_cast<std::ptrdiff_t>(once.size()), twice.end()),
            Lines(once.begin() + 1, once.end()));
  // Another mode, and G80, begin without them.
  const std::string missing = "alarm b3 missing-word missing-word missing-word missing-word";
  EXPECT_EQ(ending(whole + "\nG116 X0 Z0 Y0", words), missing);
  EXPECT_EQ(ending(whole + " M8\nG80\nG114 X0 Z0 Y0", words),
            "alarm b4 missing-word missing-word missing-word missing-word");
}

TEST(G114, FeedsBackUnderItsReading) {
  const std::string block = thread("G114", "I5 R-1");
  EXPECT_EQ(lines(block, profile_with({{"gsk.thread.return", "rapid"}})).back(), "rapid y10");
  EXPECT_EQ(lines(block, profile_with({{"gsk.thread.return", "feed"}})).back(), "feed y10 f100");
  // Where R is the initial plane there is no way back.
  EXPECT_EQ(lines(thread("G114", "I5"), profile_with({{"gsk.thread.return", "feed"}})).back(),
            "rapid y10");
}

TEST(G114, HoldsForItsBlockUnderItsReading) {
  const Profile none = profile_with({{"gsk.thread.modal", "none"}});
  EXPECT_EQ(lines(thread("G114", "I5") + "\nX10 Z5 Y3", none).back(), "rapid x5 y3 z5");
}

TEST(G114, IsLeftByGroup01AndG80) {
  EXPECT_EQ(lines(thread("G114", "I5") + "\nG01 X10").back(), "feed x5 f100");
  EXPECT_EQ(lines(thread("G114", "I5") + "\nG80 X10").back(), "rapid x5");
  EXPECT_EQ(ending("G01 G114 F100"), "alarm b1 conflicting-words");
}

TEST(G114, GivesTheJudgeItsPassesAsOneItem) {
  EXPECT_EQ(
      lines(kExternal, {}, OpenPaths::judged),
      (Lines{"rapid x70 y20 z70", "rapid x0 z0", "rapid y15",
             "threads external d15..-5 c0,0 lead5 from18 P1 Q0.5 J2 K30 -1 f900", "rapid y20"}));
}

TEST(G116, GivesTheJudgeItsPassesAsOneItem) {
  EXPECT_EQ(lines(kInternal, {}, OpenPaths::judged).at(3),
            "threads internal d25..5 c70,70 lead5 from4.5 P1 Q0.5 J2 K30 -1 f900");
}

TEST(G114, TellsTheJudgeWhichPartIsOpen) {
  auto item = [](const Profile& profile) {
    return std::get<ThreadMilling>(expand(kExternal, profile, OpenPaths::judged).at(3));
  };
  EXPECT_EQ(item({}).runout, ThreadRunOut::open);
  EXPECT_FALSE(item({}).arc_path);
  EXPECT_TRUE(item(profile_with({{"gsk.thread.path", "arc"}})).arc_path);
  EXPECT_EQ(item(profile_with({{"gsk.thread.runout", "tangent"}})).runout, ThreadRunOut::tangent);
}

TEST(G114, GivesTheJudgeAPathThatIsNamedWhole) {
  const Profile named = profile_with({{"gsk.thread.path", "arc"}, {"gsk.thread.runout", "polar"}});
  EXPECT_EQ(lines(kExternal, named, OpenPaths::judged), lines(kExternal));
  const Profile arc = profile_with({{"gsk.thread.path", "arc"}});
  EXPECT_EQ(lines(thread("G114", "I5"), arc, OpenPaths::judged), lines(thread("G114", "I5")));
}

// The subject left the plane elsewhere: the next increments and the end start from there, at the
// initial plane.
TEST(G114, GoesOnFromWhereTheSubjectStands) {
  const std::string program = std::string(kExternal) + "\nG00 U2 W1";
  grammar::MemorySource bytes(program);
  grammar::LineSource source(bytes);
  const Profile profile;
  Expander expander(profile, source, OpenPaths::judged);
  Position there;
  there[Axis::x] = 7;
  there[Axis::y] = 15;
  there[Axis::z] = -3;
  std::string last;
  while (const Item* item = expander.next()) {
    if (std::holds_alternative<ThreadMilling>(*item)) expander.stand_at(there);
    last = line_of(*item);
  }
  EXPECT_EQ(last, "end x8 y20 z-2 a0 c0");
}

// A million passes come one by one.
TEST(G114, StreamsItsPasses) {
  grammar::MemorySource bytes("G114 X0 Z0 Y-5 I5 P1 Q0.000001 D3 E30 J0 F100");
  grammar::LineSource source(bytes);
  const Profile profile;
  Expander expander(profile, source, OpenPaths::shown);
  for (int i = 0; i < 3; ++i) ASSERT_NE(expander.next(), nullptr);
  EXPECT_EQ(line_of(*expander.next()), "feed z17.999999 f100");
}

TEST(G114, DoesNotCoverMoreTurnsThanItCounts) {
  EXPECT_EQ(ending("G00 Y999999\nG114 X0 Z0 Y-999999 I0.0001 P1 D3 E30 J0 F100"),
            "not-covered b2 G114");
}

}  // namespace
}  // namespace gonogo::reference::testing
