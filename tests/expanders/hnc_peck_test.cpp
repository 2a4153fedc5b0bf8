// SPDX-License-Identifier: GPL-3.0-or-later
// G74 and G75. Words X are diameters; e (R) and dK (Q) are true lengths.
#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <string_view>

#include "expanders/registry.hpp"
#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

// Turns "F-4 R-3" into records along `axis`, with the feed 50.
std::string path(char axis, std::initializer_list<const char*> moves) {
  std::string text;
  for (const std::string move : moves) {
    const bool feeds = move[0] == 'F';
    text += std::string(feeds ? "feed " : "rapid ") + axis + "=" + move.substr(1) +
            (feeds ? " f=50\n" : "\n");
  }
  return text;
}

TEST(HncG74, Pecks) {
  // A (0, 2): bottoms at -4, -10, -16, -17.
  EXPECT_EQ(after_first(run_hnc("G00 Z2\nG74 Z-17 R1 Q6 F50\n")),
            path('z', {"F-4", "R-3", "F-10", "R-9", "F-16", "R-15", "F-17", "R2"}));
}

TEST(HncG74, WithoutWithdrawalStraightToTheBottom) {
  EXPECT_EQ(after_first(run_hnc("G00 Z2\nG74 Z-17 Q6 F50\n")), path('z', {"F-17", "R2"}));
  EXPECT_EQ(after_first(run_hnc("G00 Z2\nG74 Z-17 R0 F50\n")), path('z', {"F-17", "R2"}));
}

TEST(HncG74, ExactMultipleHasNoPeckWithoutLength) {
  EXPECT_EQ(run_hnc("G74 Z-1 R0.05 Q0.5 F50\n").motions(),
            path('z', {"F-0.5", "R-0.45", "F-1", "R0"}));
  EXPECT_EQ(run_hnc("G74 Z-1 R0.05 Q1 F50\n").motions(), path('z', {"F-1", "R0"}));
  EXPECT_EQ(run_hnc("G74 Z-1 R0.05 Q9 F50\n").motions(), path('z', {"F-1", "R0"}));
  // 10 pecks, 9 withdrawals, the return.
  EXPECT_EQ(run_hnc("G74 Z-1 R0.05 Q0.1 F50\n").records.size(), 21u);
}

TEST(HncG74, LongExample) {
  // A (0, 10), depth 70 in steps of 5: 14 pecks, 13 withdrawals, the return and the end.
  const Outcome outcome = run_hnc("G00 Z10\nG74 Z-60 R1 Q5 F50\n");
  EXPECT_EQ(outcome.records.size(), 1u + 14 + 13 + 1 + 1);
  EXPECT_EQ(outcome.records[1], "feed z=5 f=50");
  EXPECT_EQ(outcome.records[2], "rapid z=6");
  EXPECT_EQ(outcome.records[26], "rapid z=-54");
  EXPECT_EQ(outcome.records[27], "feed z=-60 f=50");
}

TEST(HncG74, UpwardsAndIncremental) {
  EXPECT_EQ(run_hnc("G74 W5 R1 Q3 F50\n").motions(), path('z', {"F3", "R2", "F5", "R0"}));
}

// Counts records and keeps none.
struct Counter {
  std::size_t records = 0;
  std::string middle;
  std::string last_feed;

  static int take(void* context, const gonogo_record_v1* record) {
    auto& counter = *static_cast<Counter*>(context);
    ++counter.records;
    const gonogo_text z = record->to[GONOGO_Z].text;
    if (counter.records == 1'000'001) counter.middle.assign(z.data, z.size);
    if (record->kind == GONOGO_FEED) counter.last_feed.assign(z.data, z.size);
    return 0;
  }
};

TEST(HncG74, MillionPecksStream) {
  const gonogo_subject_v1* subject = find("hnc");
  Counter counter;
  gonogo_sink_v1 sink{};
  sink.struct_size = sizeof sink;
  sink.context = &counter;
  sink.record = &Counter::take;
  void* handle = nullptr;
  const std::string_view profile = R"({"dialect":"hnc21t"})";
  ASSERT_EQ(subject->create({profile.data(), profile.size()}, &sink, &handle), GONOGO_OK);
  const std::string_view program = "G74 Z-1000 R0.001 Q0.001 F50\n";
  EXPECT_EQ(subject->run(handle, {program.data(), program.size()}), GONOGO_OK);
  subject->destroy(handle);
  // 1,000,000 pecks, 999,999 withdrawals, the return, the end. Record 1,000,001 is peck 500,001.
  EXPECT_EQ(counter.records, 2'000'001u);
  EXPECT_EQ(counter.middle, "-500.001");
  EXPECT_EQ(counter.last_feed, "-1000");
}

TEST(HncG74, IgnoresX) {
  EXPECT_EQ(run_hnc("G74 X8 U2 Z-1 F50\n").alarm, "conflicting-words");
  EXPECT_EQ(run_hnc("G74 X8 Z-1 F50\n").motions(), path('z', {"F-1", "R0"}));
  EXPECT_EQ(run_hnc("G74 X8 F50\n").alarm, "missing-word");
}

TEST(HncG74, WithdrawalMayRiseAboveTheStart) {
  EXPECT_EQ(run_hnc("G74 Z-2 R3 Q1 F50\n").motions(), path('z', {"F-1", "R2", "F-2", "R0"}));
  EXPECT_EQ(run_hnc("G74 Z-2 R3 Q1 F50\n", R"({"readings":{"hnc.peck.clamp":"start"}})").motions(),
            path('z', {"F-1", "R0", "F-2", "R0"}));
}

TEST(HncG74, PecksFromTheWithdrawnPoint) {
  const char* withdrawn = R"({"readings":{"hnc.peck.from":"withdrawn"}})";
  // Net 2: 3, 5, 7, then the bottom at 8.
  EXPECT_EQ(run_hnc("G74 Z-8 R1 Q3 F50\n", withdrawn).motions(),
            path('z', {"F-3", "R-2", "F-5", "R-4", "F-7", "R-6", "F-8", "R0"}));
  EXPECT_EQ(run_hnc("G74 Z-7 R1 Q3 F50\n", withdrawn).motions(),
            path('z', {"F-3", "R-2", "F-5", "R-4", "F-7", "R0"}));
  const Outcome never = run_hnc("G74 Z-8 R3 Q3 F50\n", withdrawn);
  EXPECT_EQ(never.alarm, "value-out-of-range");
  EXPECT_EQ(never.alarm_word, 'R');
}

TEST(HncG74, WithdrawalsAtFeed) {
  EXPECT_EQ(
      run_hnc("G74 Z-2 R0.5 Q1 F50\n", R"({"readings":{"hnc.peck.withdraw":"feed"}})").motions(),
      path('z', {"F-1", "F-0.5", "F-2", "R0"}));
}

// To Z-17 at rapid, 6 further, and out to Z2.
TEST(HncG74, ApproachMode) {
  const char* on = R"({"readings":{"hnc.g74.mode3":"on"}})";
  EXPECT_EQ(after_first(run_hnc("G00 Z2\nG74 Z-17 Q6 F50\n", on)),
            path('z', {"R-17", "F-23", "R2"}));
  EXPECT_EQ(run_hnc("G74 W7 R0 Q3 F50\n", on).motions(), path('z', {"R7", "F10", "R0"}));
  EXPECT_EQ(run_hnc("G74 Z-17 F50\n", on).motions(), path('z', {"F-17", "R0"}));
  EXPECT_EQ(run_hnc("G74 Z-2 R0.5 Q1 F50\n", on).motions(),
            path('z', {"F-1", "R-0.5", "F-2", "R0"}));
  EXPECT_EQ(run_hnc("G74 Z0 Q6 F50\n", on).alarm, "direction-conflict");
}

constexpr const char* kAtFifty = "G00 X50 Z-20\n";

TEST(HncG75, SingleGroove) {
  // Diameters 46 47 42 43 38 39 34 35 30 50.
  EXPECT_EQ(
      after_first(run_hnc(std::string(kAtFifty) + "G75 X30 R0.5 Q2 F50\n")),
      path('x', {"F23", "R23.5", "F21", "R21.5", "F19", "R19.5", "F17", "R17.5", "F15", "R25"}));
  // 45 46 40 41 38 50.
  EXPECT_EQ(after_first(run_hnc(std::string(kAtFifty) + "G75 X38 R0.5 Q2.5 F50\n")),
            path('x', {"F22.5", "R23", "F20", "R20.5", "F19", "R25"}));
}

TEST(HncG75, Bore) {
  // A (30, -10): 34 33 38 37 40 30.
  EXPECT_EQ(after_first(run_hnc("G00 X30 Z-10\nG75 X40 R0.5 Q2 F50\n")),
            path('x', {"F17", "R16.5", "F19", "R18.5", "F20", "R15"}));
}

TEST(HncG75, WideWithPecks) {
  const std::string plunge = path('x', {"F22", "R22.5", "F21", "R25"});
  EXPECT_EQ(after_first(run_hnc(std::string(kAtFifty) + "G75 X42 Z-26 R0.5 Q3 I3 F50\n")),
            plunge + "rapid z=-22\n" + plunge + "rapid z=-24\n" + plunge + "rapid z=-26\n" +
                plunge + "rapid z=-20\n");
}

TEST(HncG75, WideWithoutWithdrawal) {
  const std::string plunge = path('x', {"F15", "R25"});
  EXPECT_EQ(after_first(run_hnc(std::string(kAtFifty) + "G75 X30 W-6 I3 F50\n")),
            plunge + "rapid z=-22\n" + plunge + "rapid z=-24\n" + plunge + "rapid z=-26\n" +
                plunge + "rapid z=-20\n");
}

TEST(HncG75, PlacesAreRoundedOnceFromTheQuotient) {
  // 1/3, 2/3, and exactly 1; W-1/7: 3/7 = 0.428571428(571).
  const Outcome thirds = run_hnc("G75 X-2 Z1 I3 F50\n");
  EXPECT_EQ(thirds.records[2], "rapid z=0.333333333");
  EXPECT_EQ(thirds.records[5], "rapid z=0.666666667");
  EXPECT_EQ(thirds.records[8], "rapid z=1");
  const Outcome sevenths = run_hnc("G75 X-2 W-1 I7 F50\n");
  EXPECT_EQ(sevenths.records[8], "rapid z=-0.428571429");
  EXPECT_EQ(sevenths.records[20], "rapid z=-1");
}

TEST(HncG75, ApproachMode) {
  const char* on = R"({"readings":{"hnc.g75.mode3":"on"}})";
  const std::string plunge = path('x', {"R17", "F15", "R25"});
  EXPECT_EQ(after_first(run_hnc(std::string(kAtFifty) + "G75 X34 Z-26 Q2 I3 F50\n", on)),
            plunge + "rapid z=-22\n" + plunge + "rapid z=-24\n" + plunge + "rapid z=-26\n" +
                plunge + "rapid z=-20\n");
  // A bore, and no width beside a depth.
  EXPECT_EQ(after_first(run_hnc("G00 X30\nG75 X34 W0 Q2 I1 F50\n", on)),
            path('x', {"R17", "F19", "R15", "R17", "F19", "R15"}));
  EXPECT_EQ(run_hnc("G75 X0 Z-1 Q2 I1 F50\n", on).alarm, "direction-conflict");
  EXPECT_EQ(after_first(run_hnc("G00 X30\nG75 X34 Q2 F50\n", on)), path('x', {"F17", "R15"}));
  EXPECT_EQ(run_hnc("G75 X0 Q2 F50\n", on).alarm, "");
  EXPECT_EQ(run_hnc("G75 X-2 F50\n", on).motions(), path('x', {"F-1", "R0"}));
}

TEST(HncG75, OtherReadings) {
  const auto with = [](const char* key, const char* value) {
    return std::string(R"({"readings":{")") + key + R"(":")" + value + R"("}})";
  };
  const std::string plunge = path('x', {"F-1", "R0"});
  // i plunges over the whole width.
  const std::string steps = with("hnc.g75.steps", "i");
  EXPECT_EQ(run_hnc("G75 X-2 Z-6 I3 F50\n", steps).motions(),
            plunge + "rapid z=-3\n" + plunge + "rapid z=-6\n" + plunge + "rapid z=0\n");
  EXPECT_EQ(run_hnc("G75 X-2 Z-6 I1 F50\n", steps).motions(),
            "rapid z=-6\n" + plunge + "rapid z=0\n");
  EXPECT_EQ(run_hnc("G75 X-2 Z-6 I1 F50\n", with("hnc.g75.end", "last")).motions(),
            plunge + "rapid z=-6\n" + plunge);
  EXPECT_EQ(run_hnc("G75 X-2 Z-6 P1 I7.5 F50\n", with("hnc.g75.i", "P")).motions(),
            plunge + "rapid z=-6\n" + plunge + "rapid z=0\n");
  // e and dK as diameters, under G36 only.
  const std::string scale = with("hnc.g75.depth-scale", "diameter");
  EXPECT_EQ(run_hnc("G75 X-4 R1 Q2 F50\n", scale).motions(),
            path('x', {"F-1", "R-0.5", "F-2", "R0"}));
  EXPECT_EQ(run_hnc("G37 G75 X-4 R1 Q2 F50\n", scale).motions(),
            path('x', {"F-2", "R-1", "F-4", "R0"}));
}

TEST(HncG75, CountAndWidthBelongTogether) {
  EXPECT_EQ(run_hnc("G75 X-2 Z-6 F50\n").alarm, "missing-word");
  EXPECT_EQ(run_hnc("G75 X-2 I2 F50\n").alarm, "missing-word");
  EXPECT_EQ(run_hnc("G75 X-2 Z-6 I0 F50\n").alarm, "not-an-integer");
  EXPECT_EQ(run_hnc("G75 X-2 Z-6 I-1 F50\n").alarm, "not-an-integer");
  EXPECT_EQ(run_hnc("G75 X-2 Z-6 I1.5 F50\n").alarm, "not-an-integer");
  EXPECT_EQ(run_hnc("G75 I1.5\n").alarm, "not-an-integer");
  // An inherited count rests in a block without a width.
  EXPECT_EQ(run_hnc("G75 I1\nX-2 F50\nX-2 Z-6\n").motions(),
            path('x', {"F-1", "R0", "F-1", "R0"}) + "rapid z=-6\n" + path('x', {"F-1", "R0"}) +
                "rapid z=0\n");
}

TEST(HncG75, WidthZeroPlungesAtOnePlace) {
  const std::string plunge = path('x', {"F-1", "R0"});
  EXPECT_EQ(run_hnc("G75 X-2 W0 I2 F50\n").motions(), plunge + plunge + plunge);
}

TEST(HncPecks, SignsAreRules) {
  for (const char* code : {"G74 Z-2 ", "G75 X-2 "}) {
    const auto alarm = [&](const char* words) {
      return run_hnc(std::string(code) + words + " F9\n").alarm;
    };
    EXPECT_EQ(alarm("R-1 Q1"), "value-sign");
    EXPECT_EQ(alarm("Q0"), "value-sign");
    EXPECT_EQ(alarm("R0 Q-1"), "value-sign");
    EXPECT_EQ(alarm("R1"), "missing-word");
    EXPECT_EQ(alarm("R0"), "");
  }
  EXPECT_EQ(run_hnc("G74 R-1\n").alarm, "value-sign");
  EXPECT_EQ(run_hnc("G74 R1\n").alarm, "");
}

}  // namespace
}  // namespace gonogo::expanders::testing
