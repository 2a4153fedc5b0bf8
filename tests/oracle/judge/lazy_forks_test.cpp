// SPDX-License-Identifier: GPL-3.0-or-later
//
// Open readings: each alternative is right, one that makes no difference is none, and only those
// that are still followed count.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "oracle/steps/different_assignments.hpp"
#include "own_outcome.hpp"

namespace gonogo::oracle {
namespace {

struct Followed {
  std::string_view dialect;
  std::string_view reading;
  std::string_view value;
  std::string_view program;
};

// Also what is not open by default.
reference::Profile all_open(std::string_view dialect) {
  auto profile = std::get<reference::Profile>(reference::default_profile(dialect));
  for (const reference::Reading& reading : reference::readings()) {
    if (reading.belongs_to(dialect)) profile.readings.set(reading.key, "any");
  }
  return profile;
}

constexpr std::string_view kFlatHelix =
    "G17 G00 X40 Y30 Z10\nG112 X20 Y10 W-4 R-1 I6 L2 D4 F200\nG00 X0\n";
constexpr std::string_view kOpenPocket =
    "G17 G00 X40 Y30 Z10\nG110 X20 Y10 W-4 R-1 I10 L3 Q2 P8 D2 F200\nG00 X0\n";
constexpr std::string_view kThreads =
    "G17 G00 X40 Y30 Z10\nG114 X20 Y10 W-4 R-1 I2 E24 P1 Q0.6 D3 J0 F200\nX60 Y10 W-4\n";

// A program for each alternative that was not open, or was not there.
constexpr auto kFollowed = std::to_array<Followed>({
    {"gsk988ta", "gsk.helix.flat", "on", kFlatHelix},
    {"gsk988ta", "gsk.pocket.end", "r-plane", kOpenPocket},
    {"gsk988ta", "gsk.thread.modal", "none", kThreads},
    {"gsk988ta", "gsk.missing-axis", "position",
     "G17 G00 X40 Y30 Z10\nG112 X20 Y10 W-4 R-1 I6 L2 D4 F200\nX9 Y8\n"},
    {"gsk988ta", "gsk.missing-axis", "current",
     "G17 G00 X40 Y30 Z10\nG112 X20 W-4 I6 D4 F200\nG00 X0\n"},
    {"gsk988ta", "gsk.arc.closed", "none", "G00 X50 Z10\nG02 X50 Z10 R5 F100\nG00 X60\n"},
    {"gsk988ta", "gsk.g80.motion", "kept", "G00 X50 Z5\nG01 Z-10 F100\nG80\nZ-20\n"},
    {"gsk988ta", "gsk.g94.rewrite", "clear-all", "G00 X100 Z5\nG94 X60 Z-10 R-5 F100\nG94 X40\n"},
    {"gsk988ta", "gsk.g94.still-axis", "ignored", "G00 X100 Z5\nG94 X60 Z-5 V0 F100\nG00 X90\n"},
    {"gsk988ta", "gsk.arc.no-centre", "line", "G00 X50 Z10\nG02 X40 Z0 F100\n"},
    {"gsk988ta", "gsk.arc.small-radius", "semicircle", "G17 G00 X0 Y0\nG02 Y20.01 R10 F100\n"},
    {"hnc21t", "hnc.modal.f", "forgotten",
     "G00 X50 Z2\nF200\nG80 X40 Z-9 F100\nG81 X40 Z-9\nG01 X0\n"},
    {"hnc21t", "hnc.g82.exit", "feed", "G00 X50 Z2\nG82 X40 Z-9 R-1 E1 F1\n"},
    {"hnc21t", "hnc.g32.lead", "kept", "G00 X50 Z5\nG32 Z-30 F1.5\nG01 Z5 F100\nG32 Z-30\n"},
    {"hnc21t", "hnc.g32.lead", "feed", "G00 X50 Z5\nG01 Z0 F100\nG32 Z-30 F1.5\nG01 X60\n"},
    {"hnc21t", "hnc.g32.lead", "feed", "G00 X50 Z5\nG01 Z0 F2\nG32 Z-30\n"},
    {"hnc21t", "hnc.arc.closed", "none", "G00 X40 Z0\nG02 X40 Z0 R5 F100\nG00 X50\n"},
    {"hnc21t", "hnc.arc.small-radius", "semicircle", "G00 X40 Z0\nG03 Z-20.01 R10 F100\n"},
    {"hnc21t", "hnc.modal.words", "kept",
     "G00 X50 Z5\nG80 X40 Z-20 I-3 F100\nG00 X52\nG80 X38 Z-20 F100\n"},
    {"hnc21t", "hnc.g74.mode3", "on", "G00 X0 Z2\nG74 Z-10 Q3 F50\n"},
    {"hnc21t", "hnc.g82.q", "alarm", "G00 X50 Z2\nG82 X40 Z-9 Q5 F1\n"},
    {"sinumerik840d", "sie.g70.f", "inch", "S400 M3\nG70 G1 X1 F5\n"},
    {"sinumerik840d", "sie.initial-motion", "g0", "S400 M3 F100\nX10\n"},
    {"rs274", "ngc.missing-tool", "alarm", "G0 X1\nT5\nM2\n"},
    {"rs274", "ngc.g94-feed", "none", "F100\nG94\nG1 X1\nM2\n"},
    {"rs274", "ngc.feed-units", "after", "G20 G1 X1 F10\nM2\n"},
    {"rs274", "ngc.lone-cr", "blank", "G0 X1\rY5\nX2\nM2\n"},
    {"rs274", "ngc.alarm-dwell", "dwells", "G0 X1\nG4 P1 G1 Y5\nM2\n"},
    {"rs274", "ngc.cycle.feed", "free", "G0 Z5\nG81 X1 Y1 Z-1 R2\nM2\n"},
    {"rs274", "ngc.cycle.retract-start", "initial", "G0 Z5\nG81 X1 Y1 Z-1 R2 F100\nM2\n"},
    {"rs274", "ngc.arc-tolerance", "linuxcnc", "G0 X0 Y0\nG2 X10.01 Y0 I5 J0 F100\nM2\n"},
});

// J-READ-01.
TEST(LazyForks, EachAlternativeOfAnOpenReadingIsRight) {
  for (const Followed& one : kFollowed) {
    const reference::Profile follows = profile_of(one.dialect, {{one.reading, one.value}});
    const OwnOutcome own = own_outcome(one.program, follows);
    const reference::Profile open = all_open(one.dialect);
    for (const Forking forking : {Forking::when_different, Forking::when_asked}) {
      const Tolerances tolerances = exact_terms(open);
      JudgeSession session(open, one.program, tolerances, forking);
      for (const Record& record : own.records) session.record(record);
      const SessionVerdict said = session.finish(own.end);
      EXPECT_EQ(decision(said.verdict.kind), Decision::go)
          << one.reading << "=" << one.value << ": " << said.verdict.message;
      const reference::ReadingKey key = reference::find_reading(one.reading)->key;
      EXPECT_TRUE(std::ranges::all_of(said.explaining, [&](const reference::ReadingChoice& choice) {
        return choice.is(key, one.value);
      })) << one.reading;
      EXPECT_FALSE(said.explaining.empty()) << one.reading;
    }
    // A profile that fixes another alternative does not admit it.
    const std::string_view first = reference::find_reading(one.reading)->alternatives.front();
    const reference::Profile fixed = profile_of(one.dialect, {{one.reading, first}});
    EXPECT_EQ(decision(judge_outcome(fixed, one.program, exact_terms(fixed), own.records, own.end)
                           .verdict.kind),
              Decision::no_go)
        << one.reading;
  }
}

// The end point along Z is where the tool stands, so that keeping and clearing it are the same.
TEST(LazyForks, AlternativesThatMakeTheSameRecordsAreOne) {
  const reference::Profile open = all_open("gsk988ta");
  const std::string_view program = "G18 G00 X100 Z10\nG94 X60 Z10 F100\nG94 X50\n";
  EXPECT_EQ(touched_by(open, program).size(), 1U);  // gsk.g94.rewrite
  const Assignments assignments = assignments_of(open, program);
  EXPECT_EQ(assignments.choices.size(), 1U);
  EXPECT_TRUE(assignments.open.empty());
  const OwnOutcome own = own_outcome(program, open);
  const SessionVerdict said = judge_outcome(open, program, exact_terms(open), own.records, own.end);
  EXPECT_EQ(said.verdict.kind, VerdictKind::pass_exact);
  EXPECT_TRUE(said.open.empty());
}

// GSK-G94-12: what no text lets a block do, no reading lets it do.
TEST(LazyForks, NoAlternativeRepeatsACycleInABlockWithoutAWordOfIt) {
  const reference::Profile open = all_open("gsk988ta");
  const std::string cycle = "G00 X100 Z5\nG94 X60 Z-5 R-2 F100\n";
  const OwnOutcome twice = own_outcome(cycle + "X60\n", open);
  const auto judged = [&](const std::string& block) {
    const SessionVerdict said =
        judge_outcome(open, cycle + block, exact_terms(open), twice.records, twice.end);
    return decision(said.verdict.kind);
  };
  for (const char* block : {"S300\n", "T0202\n", "G97\n"}) {
    EXPECT_EQ(judged(block), Decision::no_go) << block;
  }
  for (const char* block : {"F100\n", "G94\n"}) EXPECT_EQ(judged(block), Decision::go) << block;
}

// R9: two alternatives each of seven readings are 128 ways, of which a subject that follows
// one leaves the others behind block by block.
TEST(LazyForks, TheCapIsOnThoseThatAreStillFollowed) {
  const std::string program =
      "G17 G00 X40 Y30 Z10\n"
      "G112 X20 Y10 W-4 R-1 I6 L2 D4 F200\n"    // flat
      "X30 Y10 W-4 I6\n"                        // L retained, R retained
      "X9 W-4\n"                                // missing axis
      "G110 X20 Y10 W-4 R-1 I10 L3 Q2 P8 D2\n"  // end
      "X30 Y10 W0\n"                            // zero depth, and where it ends
      "G00 X0\n";
  const reference::Profile open = all_open("gsk988ta");
  EXPECT_TRUE(assignments_of(open, program).too_many);
  const OwnOutcome own = own_outcome(program, open);
  const SessionVerdict said = judge_outcome(open, program, exact_terms(open), own.records, own.end);
  EXPECT_EQ(decision(said.verdict.kind), Decision::go) << said.verdict.message;
  EXPECT_EQ(said.explaining.size(), 1U);
}

// J-READ-02: layers of 2 below the R plane at 9; the way back down ends 0.7 above the last one.
TEST(LazyForks, AnOpenLengthIsWhatTheSubjectShows) {
  const std::string_view program =
      "G17 G00 X40 Y30 Z10\nG110 X20 Y10 W-6 R-1 I10 L3 Q2 D2 F200\nG00 X0\n";
  const reference::Profile open = all_open("gsk988ta");
  const reference::ReadingKey key = reference::find_reading("gsk.pocket.p-omitted")->key;
  for (const std::string_view length : {"0", "0.7", "1.9"}) {
    const OwnOutcome own =
        own_outcome(program, profile_of("gsk988ta", {{"gsk.pocket.p-omitted", length}}));
    const SessionVerdict said =
        judge_outcome(open, program, exact_terms(open), own.records, own.end);
    EXPECT_EQ(decision(said.verdict.kind), Decision::go) << length << said.verdict.message;
    ASSERT_FALSE(said.explaining.empty()) << length;
    EXPECT_TRUE(said.explaining.front().is(key, length)) << length;
  }
  // One length for all layers.
  OwnOutcome own = own_outcome(program, profile_of("gsk988ta", {{"gsk.pocket.p-omitted", "0.7"}}));
  const auto last =
      std::ranges::find_if(own.records.rbegin(), own.records.rend(), [](const Record& record) {
        return reference::clause_name(record.clause) == "GSK-G110-11" &&
               record.kind == reference::RecordKind::rapid;
      });
  ASSERT_NE(last, own.records.rend());
  last->to[reference::Axis::z] = last->to[reference::Axis::z] + Number::millionths(100'000);
  EXPECT_EQ(
      decision(judge_outcome(open, program, exact_terms(open), own.records, own.end).verdict.kind),
      Decision::no_go);
}

// J-READ-02: layers at 7, 5 and 3 below the R plane at 9. What feeds down all the way has a
// clearance of 4 or more, in pieces too; what does so to the second layer alone has one of 2, and
// comes down to 7 before the third.
TEST(LazyForks, AnOpenLengthMayLeaveNoTraverse) {
  const std::string_view program =
      "G17 G00 X40 Y30 Z10\nG110 X20 Y10 W-6 R-1 I10 L3 Q2 D2 F200\nG00 X0\n";
  const reference::Profile open = all_open("gsk988ta");
  const OwnOutcome own = own_outcome(program, profile_of("gsk988ta", {}));
  const auto judged = [&](std::span<const std::optional<int>> traverses, bool in_pieces) {
    std::vector<Record> records;
    std::size_t layer = 0;
    for (const Record& record : own.records) {
      const bool is_infeed = reference::clause_name(record.clause) == "GSK-G110-11";
      if (is_infeed && record.kind == reference::RecordKind::rapid) {
        records.push_back(record);
        if (const auto height = traverses[layer++]) {
          records.back().to[reference::Axis::z] = *height;
        } else {
          records.pop_back();
        }
        continue;
      }
      if (is_infeed && in_pieces) {
        records.push_back(record);
        records.back().to[reference::Axis::z] += exact::Number(1) / exact::Number(2);
      }
      records.push_back(record);
    }
    return decision(judge_outcome(open, program, exact_terms(open), records, own.end).verdict.kind);
  };
  for (const bool in_pieces : {false, true}) {
    const std::optional<int> none;
    EXPECT_EQ(judged(std::array{none, none}, in_pieces), Decision::go) << in_pieces;
    EXPECT_EQ(judged(std::array{none, std::optional(7)}, in_pieces), Decision::go) << in_pieces;
    EXPECT_EQ(judged(std::array{none, std::optional(5)}, in_pieces), Decision::no_go) << in_pieces;
  }
}

TEST(ShownReadings, PreferTheAlternativeWithoutAnAlarm) {
  const auto ends_well = [](std::string_view dialect, std::string_view program) {
    const reference::Profile shown = profile_to_show(all_open(dialect), program);
    return own_outcome(program, shown).end.kind == RunEnd::Kind::ok;
  };
  EXPECT_TRUE(ends_well("rs274", "G00 G17 G21 G40 G49 G80 G90\nM2\n"));
  EXPECT_FALSE(ends_well("rs274", "G2 X1 F100\nM2\n"));
  // What the profile says is not asked.
  const reference::Profile fixed = profile_of("rs274", {{"ngc.g80-beside", "alarm"}});
  EXPECT_TRUE(profile_to_show(fixed, std::string_view("G00 G80\nM2\n")).readings == fixed.readings);
}

}  // namespace
}  // namespace gonogo::oracle
