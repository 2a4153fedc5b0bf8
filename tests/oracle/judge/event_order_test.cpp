// SPDX-License-Identifier: GPL-3.0-or-later
//
// R5, J-CMP-12. M functions and dwells are events of one order with the motions,
// whether the subject tells line numbers or not.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "word_trace.hpp"

namespace gonogo::oracle {
namespace {

// A program, what the reference shows of it, and where one word of that is put (wrong, or right).
struct Moved {
  std::size_t from;
  std::size_t to;
};
struct OrderCase {
  std::string_view dialect;
  std::string program;
  WordTrace right;
  std::vector<Moved> wrong;
  std::vector<Moved> free = {};
};

void expect_order(const OrderCase& one) {
  for (const bool blocks : {true, false}) {
    const Judging judging = {.blocks = blocks, .m = true, .dialect = one.dialect};
    ASSERT_EQ(judged_trace(one.program, one.right, judging).kind, VerdictKind::pass_exact)
        << judged_trace(one.program, one.right, judging).message;
    for (const Moved& moved : one.wrong) {
      const WordTrace trace = with_word_moved(one.right, moved.from, moved.to);
      EXPECT_EQ(judged_trace(one.program, trace, judging).kind, VerdictKind::fail_order)
          << one.dialect << ' ' << moved.from << " to " << moved.to << ", blocks " << blocks;
    }
    for (const Moved& moved : one.free) {
      const Verdict verdict =
          judged_trace(one.program, with_word_moved(one.right, moved.from, moved.to), judging);
      EXPECT_EQ(verdict.kind, VerdictKind::pass_exact)
          << one.dialect << ' ' << moved.from << " to " << moved.to << ": " << verdict.message;
    }
  }
}

// X of the lathes is a diameter.
TEST(EventOrder, AnMFunctionOfABlockOfItsOwnStandsBetweenTheBlocksRoundIt) {
  const std::string program = "G00 X50 Z5\nM3\nG01 X40 F100\nM5\nG00 X60\n";
  const WordTrace right = {"R1,25,5", "M2,3", "F3,20,5", "M4,5", "R5,30,5"};
  for (const std::string_view dialect : {"gsk988ta", "hnc21t"}) {
    expect_order({dialect, program, right, {{1, 0}, {1, 2}, {1, 3}, {1, 4}, {3, 2}, {3, 4}}});
  }
  const std::string mill = "G0 X25 Z5\nM3\nG1 X20 F100\nM5\nG0 X30\n";
  for (const std::string_view dialect : {"rs274", "sinumerik840d", "sinumerik802s"}) {
    const std::string end = dialect == "rs274" ? "" : "M30\n";
    WordTrace trace = right;
    if (!end.empty()) trace.emplace_back("M6,30");
    expect_order({dialect, mill + end, trace, {{1, 0}, {1, 2}, {1, 3}, {1, 4}, {3, 2}, {3, 4}}});
  }
}

TEST(EventOrder, WhatStartsSomethingComesBeforeACut) {
  for (const char* function : {"3", "4", "6", "7", "8"}) {
    const std::string m = function;
    for (const std::string_view dialect : {"gsk988ta", "hnc21t", "sinumerik840d"}) {
      expect_order({dialect,
                    "G01 X0 Z5 F100 M" + m + "\nG00 Z9 M" + m + "\n",
                    {"M1," + m, "F1,0,5", "M2," + m, "R2,0,9"},
                    {{0, 1}, {2, 1}},
                    {{2, 3}}});
    }
  }
}

TEST(EventOrder, WhatStopsSomethingComesBehindACut) {
  for (const char* function : {"5", "9", "0", "1"}) {
    const std::string m = function;
    for (const std::string_view dialect : {"gsk988ta", "hnc21t"}) {
      expect_order({dialect,
                    "G01 X0 Z5 F100 M" + m + "\nG00 Z9 M" + m + "\n",
                    {"F1,0,5", "M1," + m, "R2,0,9", "M2," + m},
                    {{1, 0}, {1, 2}, {1, 3}},
                    {{3, 2}}});
    }
  }
}

// J-CMP-12: what departs is the motion. Z9 is 4 from where line 1 leaves the tool.
TEST(EventOrder, AMotionTooManyBeforeAnMFunctionIsWhatDeparts) {
  const std::string program = "G01 X0 Z5 F100\nM5\nG00 Z2\n";
  for (const bool blocks : {true, false}) {
    const Verdict verdict = judged_trace(program, {"F1,0,5", "R1,0,9", "M2,5", "R3,0,2"},
                                         {.blocks = blocks, .m = true, .dialect = "gsk988ta"});
    EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry) << verdict.message;
    EXPECT_EQ(verdict.message, "The subject moves where an M function is due, and no motion.");
    EXPECT_EQ(verdict.record, 1U);
    EXPECT_EQ(verdict.deviation_exact, "4");
    EXPECT_EQ(verdict.witness, R"({"x":"0","y":"0","z":"9"})");
    if (blocks) {
      EXPECT_EQ(verdict.block, 1U);
    }
  }
}

// One that leads on as the program does, without the M function: this is missing, or late.
TEST(EventOrder, AnMFunctionThatIsLeftOutIsWhatDeparts) {
  const std::string program = "G01 X0 Z5 F100\nM5\nG00 Z2\n";
  for (const bool blocks : {true, false}) {
    const Verdict verdict = judged_trace(program, {"F1,0,5", "R3,0,2"},
                                         {.blocks = blocks, .m = true, .dialect = "gsk988ta"});
    EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry) << verdict.message;
    EXPECT_EQ(verdict.block, 2U);
  }
}

TEST(EventOrder, AMotionThatIsMissingBeforeAnMFunctionIsWhatDeparts) {
  const std::string program = "G01 X0 Z5 F100\nG00 Z2\nM5\nG00 Z1\n";
  for (const bool blocks : {true, false}) {
    const Judging judging = {.blocks = blocks, .m = true, .dialect = "gsk988ta"};
    const Verdict missing = judged_trace(program, {"F1,0,5", "M3,5", "R4,0,1"}, judging);
    EXPECT_EQ(missing.kind, VerdictKind::fail_geometry) << missing.message;
    EXPECT_EQ(missing.message, "This motion is missing: an M function behind it comes.");
    EXPECT_EQ(missing.block, 2U);
    EXPECT_EQ(missing.witness, R"({"x":"0","y":"0","z":"5"})");
    const Verdict early = judged_trace(program, {"F1,0,5", "M3,5", "R2,0,2", "R4,0,1"}, judging);
    EXPECT_EQ(early.kind, VerdictKind::fail_order) << early.message;
    EXPECT_EQ(early.message, "An M function comes before it is due.");
    EXPECT_EQ(early.block, blocks ? 3U : 2U);
  }
}

// No text orders the M functions of a block of SINUMERIK among themselves.
TEST(EventOrder, MFunctionsOfOneBlockHaveNoOrderAmongThemselves) {
  for (const std::string_view dialect : {"sinumerik840d", "sinumerik802s"}) {
    expect_order({dialect,
                  "G0 X3 M3 M8 S100\nG1 X0 Z5 F100 M41 M7\nM30\n",
                  {"M1,3", "M1,8", "R1,3,0", "M2,41", "M2,7", "F2,0,5", "M3,30"},
                  {{4, 5}, {1, 3}, {0, 5}, {4, 2}, {6, 5}},
                  {{0, 1}, {0, 2}, {1, 2}, {3, 4}, {3, 5}}});
    const Judging judging = {.m = true, .dialect = dialect};
    const std::string program = "G1 X0 Z5 F100 M41 M7 M8\nM30\n";
    for (const WordTrace& trace : {WordTrace{"M1,8", "M1,41", "M1,7", "F1,0,5", "M2,30"},
                                   WordTrace{"M1,7", "M1,8", "M1,41", "F1,0,5", "M2,30"},
                                   WordTrace{"M1,8", "M1,7", "F1,0,5", "M1,41", "M2,30"}}) {
      EXPECT_EQ(judged_trace(program, trace, judging).kind, VerdictKind::pass_exact) << trace[1];
    }
    // One of them twice, and another not at all.
    const WordTrace twice = {"M1,8", "M1,8", "M1,41", "F1,0,5", "M2,30"};
    EXPECT_EQ(decision(judged_trace(program, twice, judging).kind), Decision::no_go);
  }
}

// SIE-MOD-02 puts M5 out before the motion; no text says that it stands there.
TEST(EventOrder, WhatTheReferenceHasBeforeACutMayComeBehindIt) {
  expect_order({"sinumerik840d",
                "G1 X0 Z5 F100 M5\nG0 Z9\n",
                {"M1,5", "F1,0,5", "R2,0,9"},
                {{0, 2}},
                {{0, 1}}});
  const Judging judging = {.m = true, .dialect = "sinumerik840d"};
  const WordTrace within = {"F1,0,2", "M1,5", "F1,0,5", "R2,0,9"};
  EXPECT_EQ(judged_trace("G1 X0 Z5 F100 M5\nG0 Z9\n", within, judging).kind,
            VerdictKind::fail_order);
}

// Nothing runs behind it.
TEST(EventOrder, TheEndOfTheProgramComesLast) {
  for (const char* end : {"2", "17", "30"}) {
    const std::string m = end;
    for (const std::string_view dialect : {"gsk988ta", "hnc21t", "sinumerik840d"}) {
      expect_order({dialect,
                    "G01 Z5 F100\nG00 Z9 M" + m + "\n",
                    {"F1,0,5", "R2,0,9", "M2," + m},
                    {{2, 1}, {2, 0}}});
    }
  }
  expect_order({"rs274", "G1 Z5 F100\nG0 Z9 M2\n", {"F1,0,5", "R2,0,9", "M2,2"}, {{2, 1}, {2, 0}}});
}

// NGC-MOD-01: M3 to M9, then the dwell, then the motion, then the stops.
TEST(EventOrder, TheTextOfRs274OrdersABlock) {
  expect_order(
      {"rs274",
       "F100\nG1 X1 Z5 G4 P1 M3 M8\nG0 Z9 M5\nG1 X3 M0\nG0 X4 M8\n",
       {"M2,3", "M2,8", "D2,1", "F2,1,5", "M3,5", "R3,1,9", "F4,3,9", "M4,0", "M5,8", "R5,4,9"},
       {{0, 1}, {1, 2}, {1, 3}, {2, 3}, {2, 1}, {2, 0}, {4, 5}, {7, 6}, {8, 9}}});
}

TEST(EventOrder, ADwellWaitsForWhatItsBlockStarts) {
  for (const std::string_view dialect : {"gsk988ta", "hnc21t"}) {
    const std::string dwell = dialect == "gsk988ta" ? "G04 X2" : "G04 P2000";
    expect_order({dialect,
                  "G00 Z1\n" + dwell + " M3\nM8\n" + dwell + "\n" + dwell + " M5\n",
                  {"R1,0,1", "M2,3", "D2,2", "M3,8", "D4,2", "D5,2", "M5,5"},
                  {{1, 2}, {3, 4}, {3, 2}, {0, 2}, {1, 0}},
                  {{6, 5}}});
  }
}

// The steps of a cycle by hand: G94 goes to Z-10, cuts to X40, back to Z2 at the feed, and returns.
TEST(EventOrder, NoneStandsBetweenTheMotionsOfACycle) {
  const WordTrace motions = {"R1,30,2", "R2,30,-10", "F2,20,-10", "F2,20,2", "R2,30,2"};
  const auto with = [&](std::size_t place, const char* m) {
    WordTrace trace = motions;
    trace.insert(trace.begin() + static_cast<std::ptrdiff_t>(place), m);
    return trace;
  };
  const std::string start = "G00 X60 Z2\nG94 X40 Z-10 F100";
  expect_order({"gsk988ta", start + " M5\n", with(5, "M2,5"), {{5, 4}, {5, 3}, {5, 2}, {5, 1}}});
  expect_order({"gsk988ta", start + " M8\n", with(1, "M2,8"), {{1, 2}, {1, 3}, {1, 4}, {1, 5}}});
  // One of the machine's maker: before the cycle or behind it.
  expect_order(
      {"gsk988ta", start + " M77\n", with(1, "M2,77"), {{1, 2}, {1, 3}, {1, 4}, {1, 0}}, {{1, 5}}});
  // Nor within the pieces of its traverse.
  const std::string program = start + " M77\n";
  const WordTrace pieces = {"R1,30,2",   "R2,30,-4", "M2,77",  "R2,30,-10",
                            "F2,20,-10", "F2,20,2",  "R2,30,2"};
  for (const bool blocks : {true, false}) {
    EXPECT_EQ(judged_trace(program, pieces, {.blocks = blocks, .m = true}).kind,
              VerdictKind::fail_order);
  }
}

// R5. A cut is one event, in pieces too: an M function stands before or behind it.
TEST(EventOrder, NoMFunctionStandsBetweenThePiecesOfACut) {
  const std::string program = "G00 X0 Z0\nG01 Z10 F100 M77\nG01 Z20 M5\nG00 Z30 M8\n";
  const auto kind = [&](const WordTrace& trace, bool blocks) {
    return judged_trace(program, trace, {.blocks = blocks, .m = true}).kind;
  };
  for (const bool blocks : {true, false}) {
    const WordTrace right = {"R1,0,0",  "M2,77", "F2,0,4",  "F2,0,10", "F3,0,15",
                             "F3,0,20", "M3,5",  "R4,0,25", "M4,8",    "R4,0,30"};
    EXPECT_EQ(kind(right, blocks), VerdictKind::pass_exact);
    EXPECT_EQ(kind(with_word_moved(right, 1, 2), blocks), VerdictKind::fail_order) << "M77 within";
    EXPECT_EQ(kind(with_word_moved(right, 1, 3), blocks), VerdictKind::pass_exact) << "M77 behind";
    EXPECT_EQ(kind(with_word_moved(right, 6, 5), blocks), VerdictKind::fail_order) << "M5 within";
  }
}

// R5. The second record may be the first cut again, that leads nowhere, before the renaming; then
// M8 stands before the cut of its block.
TEST(EventOrder, WithoutLineNumbersARenamingIsWhereItFits) {
  const std::string trace = R"({"k":"feed","to":{"x":"10"},"f":"100"}
{"k":"feed","to":{"x":"10"},"f":"100"}
{"k":"m","m":8}
{"k":"feed","to":{"x":"10","z":"5"},"f":"100"})";
  const Judging hnc{.blocks = false, .m = true, .dialect = "hnc21t"};
  const auto said = [&](const std::string& records) {
    return decision(judge_trace("G94 F100\nG01 X20\nG92 X0 Z5\nG01 X20 M8\n", records, hnc).kind);
  };
  EXPECT_EQ(said(trace), Decision::go);
  EXPECT_EQ(said(trace.substr(0, trace.rfind('\n'))), Decision::no_go);
}

// R6. G01 has no feed: its own M9 may have come, what a comment names and what comes before the M8
// that is due may not.
TEST(EventOrder, BeforeAnAlarmOnlyWhatTheBlockNamesComesBesideWhatIsDue) {
  const std::string begin = R"({"k":"rapid","b":1,"to":{"x":"5"}}
)";
  const std::string m8 = R"({"k":"m","b":1,"m":8}
)";
  const std::string m9 = R"({"k":"m","b":2,"m":9}
)";
  const std::string alarm = R"({"k":"alarm","b":2,"class":"feed-missing"})";
  for (const bool blocks : {true, false}) {
    const auto said = [&](std::string_view program, const std::string& trace) {
      return decision(judge_trace(program, trace, {.blocks = blocks, .m = true}).kind);
    };
    constexpr std::string_view kNamed = "G00 X10 M8\nG01 X20 M9\nM30\n";
    EXPECT_EQ(said(kNamed, begin + m8 + m9 + alarm), Decision::go);
    EXPECT_EQ(said(kNamed, begin + m8 + alarm), Decision::go);
    EXPECT_EQ(said(kNamed, begin + m9 + m8 + alarm), Decision::no_go);
    EXPECT_EQ(said("G00 X10 M8\nG01 X20 (M9)\nM30\n", begin + m8 + m9 + alarm), Decision::no_go);
  }
}

// Without line numbers motions are joined over blocks; not over an M function.
TEST(EventOrder, NoMotionLeadsOverAnMFunction) {
  const std::string program = "G00 X0 Z0\nG01 Z10 F100\nM8\nG01 Z20\nG01 Z30 M5\nG01 Z40\n";
  const auto kind = [&](const WordTrace& trace) {
    return judged_trace(program, trace, {.blocks = false, .m = true}).kind;
  };
  EXPECT_EQ(kind({"F2,0,10", "M3,8", "F4,0,30", "M5,5", "F6,0,40"}), VerdictKind::pass_exact);
  EXPECT_EQ(kind({"F2,0,20", "M3,8", "F4,0,30", "M5,5", "F6,0,40"}), VerdictKind::fail_order);
  EXPECT_EQ(kind({"F2,0,10", "M3,8", "F4,0,40", "M5,5"}), VerdictKind::fail_order);
  EXPECT_EQ(kind({"F2,0,40", "M3,8", "M5,5"}), VerdictKind::fail_order);
}

// What departs before an M function that is due departs first.
TEST(EventOrder, AMotionThatDepartsIsNoMissingMFunction) {
  const auto kind = [](const std::string& program, const WordTrace& trace) {
    return judged_words(program, trace).kind;
  };
  const std::string thread = "M3\nG33 X3 Z4 K5\nM2\n";
  EXPECT_EQ(kind(thread, {"M1,3", "T2,3,4,4", "M3,2"}), VerdictKind::pass_exact);
  EXPECT_EQ(kind(thread, {"M1,3", "T2,3,4,5", "M3,2"}), VerdictKind::fail_feed);
  const std::string cut = "F100\nG1 Z4\nM8\nG1 Z9\nM2\n";
  EXPECT_EQ(kind(cut, {"F2,0,5", "M3,8", "F4,0,9", "M5,2"}), VerdictKind::fail_geometry);
  EXPECT_EQ(kind(cut, {"F2,0,3", "M3,8", "F4,0,9", "M5,2"}), VerdictKind::fail_geometry);
}

// O words of rs274: the lines come again, each time with the M functions between the same motions.
TEST(EventOrder, HoldsInLoops) {
  const std::string program =
      "F100\nG0 Z5\no1 repeat [3]\nG91 G0 X1\nM8\nG1 Z-1\nM9\nG0 Z1\no1 endrepeat\nM2\n";
  WordTrace right = {"R2,0,5"};
  for (int i = 1; i <= 3; ++i) {
    const std::string x = std::to_string(i);
    right.insert(right.end(),
                 {"R4," + x + ",5", "M5,8", "F6," + x + ",4", "M7,9", "R8," + x + ",5"});
  }
  right.emplace_back("M10,2");
  expect_order({"rs274",
                program,
                right,
                {{2, 3}, {2, 1}, {4, 3}, {4, 5}, {7, 8}, {9, 8}, {12, 15}, {14, 15}, {16, 15}}});
  // Behind all cuts of a round, and of the program.
  WordTrace late = right;
  std::erase_if(late, [](const std::string& word) { return word[0] == 'M'; });
  for (int i = 0; i < 3; ++i) late.insert(late.end(), {"M5,8", "M7,9"});
  late.emplace_back("M10,2");
  for (const bool blocks : {true, false}) {
    EXPECT_EQ(judged_words(program, late, {.blocks = blocks, .m = true}).kind,
              VerdictKind::fail_order);
  }
}

TEST(EventOrder, KindsSayWhetherAnEventComesElsewhere) {
  const std::string program = "G00 X0 Z5\nM8\nG04 X1\nG01 Z1 F100\nG04 X2\nM9\n";
  const WordTrace right = {"R1,0,5", "M2,8", "D3,1", "F4,0,1", "D5,2", "M6,9"};
  const auto kind = [&](std::size_t at, const char* instead) {
    WordTrace trace = right;
    trace.erase(trace.begin() + static_cast<std::ptrdiff_t>(at));
    if (*instead != 0) trace.insert(trace.begin() + static_cast<std::ptrdiff_t>(at), instead);
    return judged_trace(program, trace, {.m = true}).kind;
  };
  const auto with = [&](std::size_t at, const char* more) {
    WordTrace trace = right;
    trace.insert(trace.begin() + static_cast<std::ptrdiff_t>(at), more);
    return judged_trace(program, trace, {.m = true}).kind;
  };
  for (const std::size_t missing : {1U, 2U, 4U, 5U}) {
    EXPECT_EQ(kind(missing, ""), VerdictKind::fail_geometry) << missing;
  }
  EXPECT_EQ(kind(1, "M2,7"), VerdictKind::fail_geometry);
  EXPECT_EQ(kind(2, "D3,1.5"), VerdictKind::fail_feed);
  EXPECT_EQ(with(1, "M1,8"), VerdictKind::fail_geometry);
  EXPECT_EQ(with(2, "M2,8"), VerdictKind::fail_geometry);
  EXPECT_EQ(with(3, "D3,1"), VerdictKind::fail_geometry);
  EXPECT_EQ(with(3, "D5,2"), VerdictKind::fail_order);
  for (const auto& [from, to] : std::vector<std::pair<std::size_t, std::size_t>>{
           {2, 3}, {2, 1}, {4, 3}, {4, 5}, {5, 4}, {5, 2}}) {
    EXPECT_EQ(judged_trace(program, with_word_moved(right, from, to), {.m = true}).kind,
              VerdictKind::fail_order)
        << from << " to " << to;
  }
}

// J-CMP-12: what does not come within 200 records is taken for missing.
TEST(EventOrder, LooksTwoHundredRecordsAhead) {
  const auto kind = [](int motions) {
    std::string program = "M8\n";
    WordTrace trace;
    for (int i = 1; i <= motions; ++i) {
      program += "G01 X0 Z" + std::to_string(i) + " F100\n";
      trace.push_back("F" + std::to_string(i + 1) + ",0," + std::to_string(i));
    }
    trace.emplace_back("M1,8");
    return judged_trace(program, trace, {.m = true}).kind;
  };
  EXPECT_EQ(kind(200), VerdictKind::fail_order);
  EXPECT_EQ(kind(201), VerdictKind::fail_geometry);
}

// R3: motions too small to see on either side stand in no M function's way.
TEST(EventOrder, MotionsTooSmallToSeeComeBeforeOrBehind) {
  const std::string program = "G00 X0 Z5\nG01 Z5.0002 F100\nM8\nG01 Z5.0004\nG01 Z1 M5\n";
  const std::vector<WordTrace> all = {
      {"R1,0,5", "M3,8", "F5,0,1", "M5,5"},
      {"R1,0,5", "F2,0,5.0002", "M3,8", "F4,0,5.0004", "F5,0,1", "M5,5"},
      {"R1,0,5", "M3,8", "F4,0,5.0004", "F5,0,1", "M5,5"},
      {"R1,0,5", "F2,0,5.0002", "M3,8", "F5,0,1", "F5,0,1.0002", "M5,5"},
  };
  for (const WordTrace& trace : all) {
    for (const bool blocks : {true, false}) {
      const Verdict verdict = judged_trace(program, trace, {.blocks = blocks, .m = true});
      EXPECT_EQ(decision(verdict.kind), Decision::go) << verdict.message;
      const std::size_t m5 = trace.size() - 1;
      EXPECT_EQ(decision(judged_trace(program, with_word_moved(trace, m5, 2),
                                      {.blocks = blocks, .m = true})
                             .kind),
                Decision::no_go);
    }
  }
}

}  // namespace
}  // namespace gonogo::oracle
