// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pockets of LCYC75 whose room, depth or infeed is about as small as the tolerance (0.001 mm): what
// the path judge would drop are their levels.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <string>

#include "pocket_milling.hpp"

namespace gonogo::oracle {
namespace {

// A tool of radius 3 above (-9.001, 18). Room for its centre: half of 6.002 less 3 is 0.001.
struct SmallPocket {
  std::string_view planes = "R101=4.358 R102=0 R103=0";
  std::string_view depth = "R104=-3";
  std::string_view sizes = "R118=6.002 R119=6.002 R120=0";
  std::string_view infeed = "R121=2.725";
  std::string_view allowance = "R124=0 R125=0.1";
  std::string_view ways = "R126=3 R127=1";
  std::string_view frame = {};

  std::string program() const {
    return fmt::format(
        "T1 S1200 M3\n{}{} {} R116=-9.001 R117=18\n{} {} R122=61 R123=57\n{} {}\nLCYC75\n"
        "G0 X0 Y0\nM2\n",
        frame, planes, depth, sizes, infeed, allowance, ways);
  }
};

reference::Profile profile_of_three(ReadingsOf readings = {}) {
  reference::Profile profile = profile_802s(readings);
  profile.tools = {{"1", {3, 0}}};
  return profile;
}

std::vector<Record> path_of(const SmallPocket& pocket, ReadingsOf readings = {}) {
  return shown(pocket.program(), profile_of_three(readings));
}
Verdict judge(const SmallPocket& pocket, const std::vector<Record>& records,
              ReadingsOf readings = {}) {
  return judge_records(pocket.program(), records, {true, profile_of_three(readings)});
}

void expect_go(const SmallPocket& pocket, ReadingsOf readings = {}) {
  for (const bool blocks : {true, false}) {
    const Verdict verdict = judge_records(pocket.program(), path_of(pocket, readings),
                                          {blocks, profile_of_three(readings)});
    EXPECT_EQ(decision(verdict.kind), Decision::go)
        << pocket.program() << blocks << ' ' << verdict.message << ' ' << verdict.got << ' '
        << verdict.witness;
  }
}

// The tool stands above the centre, so that approach and plunge are one line down, and M3 waits in
// front of it. Room: 5.998 less twice 1.999 is the tool.
TEST(SmallPockets, PlungeOfTheToleranceIsSeenBehindAnMFunction) {
  const std::string program =
      "T1 S300 M3\nR101=-12.875 R102=0 R103=-12.895 R104=-12.896 R116=0 R117=0\n"
      "R118=5.998 R119=5.998 R120=0 R121=1 R122=20 R123=20 R124=1.999 R125=0 R126=2 R127=1\n"
      "LCYC75\nM2\n";
  reference::Profile profile = profile_802s({});
  profile.tools = {{"1", {1, 0}}};
  for (const bool blocks : {true, false}) {
    const Verdict verdict = judge_records(program, shown(program, profile), {blocks, profile});
    EXPECT_EQ(decision(verdict.kind), Decision::go) << verdict.message;
    // Without the plunge the pocket is not milled.
    std::vector<Record> records = shown(program, profile);
    std::erase_if(records, [](const Record& record) { return record.kind == RecordKind::feed; });
    EXPECT_EQ(decision(judge_records(program, records, {blocks, profile}).kind), Decision::no_go);
  }
}

// Two levels, -1.45 and -2.9, a square of half side 0.001 in each.
TEST(SmallPockets, RoomOfTheToleranceIsGo) {
  expect_go({});
}

// As wide as its tool, the pocket is a hole: nothing shows where a level is, so that the tool may
// rise at feed and sink again from anywhere (SIE-LC75-13), and does not stop before the floor.
TEST(SmallPockets, InRoomOfTheToolAloneLevelsLeaveNoTrace) {
  for (const auto& [allowance, ways] : {std::pair("R124=0 R125=0", "R126=3 R127=1"),
                                        std::pair("R124=0.5 R125=0", "R126=3 R127=2")}) {
    SmallPocket pocket;
    pocket.sizes = "R118=6 R119=6 R120=3";
    pocket.allowance = allowance;
    pocket.ways = ways;
    const std::vector<Record> shown = path_of(pocket);
    const auto first = std::ranges::find(shown, RecordKind::feed, &Record::kind);
    const auto last = std::ranges::find_if(
        first, shown.end(), [](const Record& record) { return record.kind != RecordKind::feed; });
    const auto with_feeds_to = [&](std::initializer_list<int> heights) {
      std::vector<Record> records(shown.begin(), first);
      for (const int height : heights) {
        records.push_back(*first);
        records.back().to[Axis::z] = height;
      }
      records.insert(records.end(), last, shown.end());
      return decision(judge(pocket, records).kind);
    };
    EXPECT_EQ(with_feeds_to({-3}), Decision::go) << ways;
    EXPECT_EQ(with_feeds_to({-2, -1, -3}), Decision::go) << ways;
    EXPECT_EQ(with_feeds_to({-1, -2, -2, 0, -3}), Decision::go) << ways;
    EXPECT_EQ(with_feeds_to({-2, -1, -2}), Decision::no_go) << ways;
    EXPECT_EQ(with_feeds_to({-4, -3}), Decision::no_go) << ways;
  }
}

// J-PKT-09
TEST(SmallPockets, DepthOfTheToleranceIsGo) {
  for (const std::string_view ways : {"R126=3 R127=1", "R126=2 R127=2"}) {
    for (const std::string_view sizes : {"R118=6.002 R119=6.002 R120=0", "R118=6 R119=6.002 R120=0",
                                         "R118=6 R119=6 R120=3", "R118=20 R119=14 R120=4"}) {
      for (const std::string_view frame : {"", "G258 RPL=17\n"}) {
        SmallPocket pocket;
        pocket.depth = "R104=-0.001";
        pocket.allowance = "R124=0 R125=0";
        pocket.sizes = sizes;
        pocket.ways = ways;
        pocket.frame = frame;
        expect_go(pocket);
        pocket.planes = "R101=1 R102=1 R103=0";
        expect_go(pocket);
        pocket.planes = "R101=0 R102=0 R103=0";
        expect_go(pocket);
      }
    }
  }
}

// An allowance of 4 left no room for the tool in roughing: the infeed to the floor, 0.001 below the
// reference plane, cuts.
TEST(SmallPockets, DepthOfTheToleranceIsGoWhereNothingWasRoughed) {
  SmallPocket pocket;
  pocket.planes = "R101=1 R102=0.5 R103=0";
  pocket.depth = "R104=-0.001";
  pocket.sizes = "R118=20 R119=12 R120=3";
  pocket.allowance = "R124=4 R125=0";
  pocket.ways = "R126=2 R127=2";
  expect_go(pocket);
}

TEST(SmallPockets, InfeedsOfTheToleranceAreGo) {
  for (const std::string_view infeed : {"R121=0.001", "R121=0.0007", "R121=0.002", "R121=0.004"}) {
    for (const std::string_view reading : {"any", "equal", "max-rest"}) {
      for (const std::string_view ways : {"R126=3 R127=1", "R126=2 R127=2"}) {
        SmallPocket pocket;
        pocket.depth = "R104=-0.005";
        pocket.sizes = "R118=20 R119=14 R120=4";
        pocket.allowance = "R124=0 R125=0";
        pocket.infeed = infeed;
        pocket.ways = ways;
        expect_go(pocket, {{"sie.infeed", reading}});
      }
    }
  }
}

// Where roughing left no strip, levels of finishing may be left out, but need not be: each is
// milled whole, as in roughing.
TEST(SmallPockets, LevelsOfFinishingNoFartherApartThanTheToleranceAreGo) {
  for (const std::string_view infeed : {"R121=0.001", "R121=0.0015", "R121=0.002"}) {
    for (const std::string_view reading : {"any", "equal", "max-rest"}) {
      const ReadingsOf readings = {{"sie.infeed", reading}};
      SmallPocket pocket;
      pocket.depth = "R104=-0.02";
      pocket.sizes = "R118=8 R119=8 R120=3";
      pocket.infeed = infeed;
      pocket.allowance = "R124=0 R125=0";
      pocket.ways = "R126=2 R127=1";
      const std::vector<Record> path = path_of(pocket, readings);
      pocket.allowance = "R124=0 R125=0.02";
      pocket.ways = "R126=2 R127=2";
      const Verdict verdict = judge(pocket, path, readings);
      EXPECT_EQ(decision(verdict.kind), Decision::go)
          << infeed << ' ' << reading << ' ' << verdict.message << ' ' << verdict.witness;
    }
  }
}

// Infeeds of 2.999 from 0 leave 0.001 to the floor at -3: a strip at -2.999, and the floor.
TEST(SmallPockets, AFloorTheToleranceBelowTheLastStripIsGo) {
  SmallPocket pocket;
  pocket.sizes = "R118=20 R119=14 R120=4";
  pocket.infeed = "R121=2.999";
  pocket.ways = "R126=3 R127=2";
  for (const std::string_view allowance : {"R124=0.5 R125=0.001", "R124=0.5 R125=0.5"}) {
    pocket.allowance = allowance;
    expect_go(pocket, {{"sie.infeed", "max-rest"}, {"sie.finish.levels", "split"}});
  }
}

// The same except for the cuts in the plane at one depth.
std::vector<Record> without_cuts_at(const std::vector<Record>& records, const Number& depth) {
  std::vector<Record> kept;
  Number at = 100;
  for (const Record& record : records) {
    const bool named = record.axes.has(Axis::z);
    if (named) at = record.to[Axis::z];
    const bool in_plane =
        record.kind == RecordKind::arc || (record.kind == RecordKind::feed && !named);
    if (in_plane && at == depth) continue;
    kept.push_back(record);
  }
  return kept;
}

TEST(SmallPockets, AFloorThatIsNotClearedIsNoGo) {
  SmallPocket pocket;
  pocket.depth = "R104=-0.001";
  pocket.allowance = "R124=0 R125=0";
  pocket.sizes = "R118=20 R119=14 R120=4";
  for (const std::string_view ways : {"R126=3 R127=1", "R126=2 R127=2"}) {
    pocket.ways = ways;
    const std::vector<Record> path = path_of(pocket);
    const std::vector<Record> none = without_cuts_at(path, *Number::parse("-0.001"));
    ASSERT_LT(none.size(), path.size());
    EXPECT_EQ(decision(judge(pocket, none).kind), Decision::no_go);
  }
}

TEST(SmallPockets, AFloorBelowTheLastStripThatIsNotClearedIsNoGo) {
  SmallPocket pocket;
  pocket.sizes = "R118=20 R119=14 R120=4";
  pocket.infeed = "R121=2.999";
  pocket.ways = "R126=3 R127=2";
  pocket.allowance = "R124=0.5 R125=0.5";
  const ReadingsOf readings = {{"sie.infeed", "max-rest"}, {"sie.finish.levels", "split"}};
  const std::vector<Record> path = path_of(pocket, readings);
  const std::vector<Record> none = without_cuts_at(path, -3);
  ASSERT_LT(none.size(), path.size());
  EXPECT_EQ(decision(judge(pocket, none, readings).kind), Decision::no_go);
}

// A floor 0.003 deep, milled 0.002 above it: more than the tolerance.
TEST(SmallPockets, ALevelMoreThanTheToleranceAboveTheFloorIsNoGo) {
  SmallPocket pocket;
  pocket.sizes = "R118=20 R119=14 R120=4";
  pocket.allowance = "R124=0 R125=0";
  pocket.depth = "R104=-0.001";
  const std::vector<Record> shallow = path_of(pocket);
  pocket.depth = "R104=-0.003";
  EXPECT_EQ(decision(judge(pocket, shallow).kind), Decision::no_go);
  pocket.depth = "R104=-0.002";
  EXPECT_EQ(decision(judge(pocket, shallow).kind), Decision::go);
}

// Two levels 0.002 deep each; with an infeed of 0.002 neither may be left out.
TEST(SmallPockets, ALevelOfMoreThanTheToleranceLeftOutIsNoGo) {
  SmallPocket pocket;
  pocket.sizes = "R118=20 R119=14 R120=4";
  pocket.allowance = "R124=0 R125=0";
  pocket.depth = "R104=-0.004";
  pocket.infeed = "R121=0.004";
  const std::vector<Record> one = path_of(pocket);
  pocket.infeed = "R121=0.002";
  EXPECT_EQ(decision(judge(pocket, one).kind), Decision::no_go);
  pocket.infeed = "R121=0.003";
  EXPECT_EQ(decision(judge(pocket, one).kind), Decision::go);
}

// Half the corners of the square of half side 0.004 are left out: 0.004 * sqrt 2 - 0.001 from the
// centre is more than a tolerance from what the plunge clears.
TEST(SmallPockets, RoomOfMoreThanTheToleranceHasToBeCleared) {
  SmallPocket pocket;
  pocket.sizes = "R118=6.008 R119=6.008 R120=0";
  expect_go(pocket);
  const std::vector<Record> path = path_of(pocket);
  EXPECT_EQ(decision(judge(pocket, without_cuts_at(path, *Number::parse("-1.45"))).kind),
            Decision::no_go);
  EXPECT_EQ(decision(judge(pocket, without_cuts_at(path, *Number::parse("-2.9"))).kind),
            Decision::no_go);
}

// The border of the square is passed 0.002 beside where it is: more than the tolerance outside.
TEST(SmallPockets, ACutThatLeavesTheSmallRoomIsNoGo) {
  const SmallPocket pocket;
  std::vector<Record> path = path_of(pocket);
  bool changed = false;
  for (Record& record : path) {
    if (record.kind != RecordKind::feed || !record.axes.has(Axis::x)) continue;
    if (record.to[Axis::x] != Number(-9)) continue;
    record.to[Axis::x] = *Number::parse("-8.998");
    changed = true;
  }
  ASSERT_TRUE(changed);
  EXPECT_EQ(decision(judge(pocket, path).kind), Decision::no_go);
}

}  // namespace
}  // namespace gonogo::oracle
