// SPDX-License-Identifier: GPL-3.0-or-later
// The options of the machine: each reading against the standard outcome on one program. X is a
// diameter, and the tool begins at X0 Z0.
#include <gtest/gtest.h>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

Outcome run_as(const std::string& reading, const std::string& value, std::string_view program) {
  return run_hnc(program, R"({"readings":{")" + reading + "\":\"" + value + "\"}}");
}

TEST(HncReading, Rewrite) {
  const std::string program = "G80 X20 Z-10 I-5 F50\nG80 X20 Z-10\n";
  EXPECT_EQ(run_as("hnc.rewrite", "keep", program).records[4], "rapid x=5");
  EXPECT_EQ(run_as("hnc.rewrite", "clear", program).records[4], "rapid x=10");
  const std::string thread = "G82 X20 Z-10 F2\nG82 X20 Z-10\n";
  EXPECT_EQ(run_as("hnc.rewrite", "keep", thread).answer, GONOGO_OK);
  EXPECT_EQ(run_as("hnc.rewrite", "clear", thread).alarm, "lead-missing");
}

TEST(HncReading, ModalWords) {
  const std::string turn = "G80 X20 Z-10 I-5 F50\n";
  const auto fifth = [](const char* value, const std::string& program) {
    return run_as("hnc.modal.words", value, program).records[4];
  };
  for (const char* code : {"G00", "G01", "G32", "G00\nG80 F50\nG01"}) {
    const std::string program = turn + code + "\nG80 X20 Z-10\n";
    EXPECT_EQ(fifth("forgotten", program), "rapid x=10") << code;
    EXPECT_EQ(fifth("kept", program), "rapid x=5") << code;
  }
  EXPECT_EQ(fifth("kept", turn + "G00\nG80 X20 Z-10 I-4\n"), "rapid x=6");
  const std::string other = turn + "G00\nG81 X20 Z-10\nG00\nG80 X20 Z-10\n";
  EXPECT_EQ(run_as("hnc.modal.words", "kept", other).records[4], "rapid z=-10");
  EXPECT_EQ(run_as("hnc.modal.words", "kept", other).records[8], "rapid x=10");
  const std::string thread = "G82 X20 Z-10 F2\nG00\nG82 X20 Z-10\n";
  EXPECT_EQ(run_as("hnc.modal.words", "forgotten", thread).alarm, "lead-missing");
  EXPECT_EQ(run_as("hnc.modal.words", "kept", thread).answer, GONOGO_OK);
  EXPECT_EQ(run_as("hnc.modal.words", "kept", turn + "G00\nG80 X18\n").alarm, "missing-word");
}

TEST(HncReading, LeadOfG32) {
  for (const char* code : {"G00 Z0", "G01 Z0 F100", "G82 X20 Z-10 F3"}) {
    const std::string program = std::string("G32 Z-10 F2\n") + code + "\nG32 Z-20\n";
    EXPECT_EQ(run_as("hnc.g32.lead", "alarm", program).alarm, "lead-missing") << code;
    EXPECT_NE(run_as("hnc.g32.lead", "kept", program).motions().find("thread z=-20 lead=2 start=0"),
              std::string::npos)
        << code;
  }
  EXPECT_EQ(run_as("hnc.g32.lead", "kept", "G01 Z-10 F2\nG32 Z-20\n").alarm, "lead-missing");
}

TEST(HncReading, FIsOneWord) {
  const auto last = [](const char* profile, const char* program) {
    return run_hnc(program, profile).records.rbegin()[1];  // before the end
  };
  const char* one = R"({"readings":{"hnc.g32.lead":"feed"}})";
  EXPECT_EQ(last(one, "F70\nG32 Z-10 F2\nG01 X50\n"), "feed x=25 f=2");
  EXPECT_EQ(last(one, "F70\nG82 X20 Z-10 F2\nG01 X50\n"), "feed x=25 f=2");
  EXPECT_EQ(last(one, "G01 Z-10 F80\nG32 Z-20\n"), "thread z=-20 lead=80 start=0");
  EXPECT_EQ(last(one, "G20 F0.1\nG32 Z-1\n"), "thread z=-25.4 lead=0.1 start=0");
  EXPECT_EQ(run_hnc("G32 Z-10\n", one).alarm, "lead-missing");
  EXPECT_EQ(run_hnc("G32 Z-10 J0.1\nG01 X50\n", one).alarm, "feed-missing");
  EXPECT_EQ(run_hnc("F80\nG82 X20 Z-10\n", one).alarm, "lead-missing");
  const char* units = R"({"readings":{"hnc.g32.lead":"feed","hnc.lead.unit":"units"}})";
  EXPECT_EQ(last(units, "G20 F0.1\nG32 Z-1\n"), "thread z=-25.4 lead=2.54 start=0");
  const char* both = R"({"readings":{"hnc.g32.lead":"feed","hnc.modal.f":"forgotten"}})";
  EXPECT_EQ(last(both, "F70\nG82 X20 Z-10 F2\nG01 X50\n"), "feed x=25 f=70");
  EXPECT_EQ(last(both, "F70\nG32 Z-10 F2\nG01 X50\n"), "feed x=25 f=2");
}

TEST(HncReading, ConstantOfTheRunOut) {
  const std::string thread = "G82 X20 Z-10 R-1 E1 F2";
  EXPECT_EQ(run_as("hnc.g82.q", "alarm", thread + "\n").answer, GONOGO_OK);
  EXPECT_EQ(run_as("hnc.g82.q", "read", thread + " Q20\n").answer, GONOGO_OK);
  EXPECT_EQ(run_as("hnc.g82.q", "read", thread + " Q-1\n").alarm, "value-sign");
  for (const char* word : {" Q20\n", " Q-1\n"}) {
    const Outcome refused = run_as("hnc.g82.q", "alarm", thread + word);
    EXPECT_EQ(refused.alarm, "undefined-code") << word;
    EXPECT_EQ(refused.alarm_word, 'Q') << word;
  }
  EXPECT_EQ(run_as("hnc.g82.q", "alarm", "G74 Z-10 R1 Q3 F50\n").answer, GONOGO_OK);
}

TEST(HncReading, EmptyBlock) {
  const std::string program = "G80 X20 Z-10 F50\nG80 F60\n";
  const std::string once = "rapid x=10\nfeed x=10 z=-10 f=50\nfeed x=0 f=50\nrapid z=0\n";
  const std::string again = "rapid x=10\nfeed x=10 z=-10 f=60\nfeed x=0 f=60\nrapid z=0\n";
  EXPECT_EQ(run_as("hnc.empty-block", "none", program).motions(), once);
  EXPECT_EQ(run_as("hnc.empty-block", "repeat", program).motions(), once + again);
  EXPECT_EQ(run_as("hnc.empty-block", "repeat", "G80 F50\n").motions(), "");
}

TEST(HncReading, DrillX) {
  const std::string program = "G74 X20 Z-10 F50\n";
  EXPECT_EQ(run_as("hnc.g74.x", "none", program).motions(), "feed z=-10 f=50\nrapid z=0\n");
  EXPECT_EQ(run_as("hnc.g74.x", "first", program).motions(),
            "rapid x=10\nfeed z=-10 f=50\nrapid z=0\n");
}

TEST(HncReading, ZeroWidth) {
  const std::string plunge = "feed x=-10 f=50\nrapid x=0\n";
  const std::string program = "G75 X-20 W0 I1 F50\n";
  EXPECT_EQ(run_as("hnc.g75.zero-width", "each", program).motions(), plunge + plunge);
  EXPECT_EQ(run_as("hnc.g75.zero-width", "once", program).motions(), plunge);
}

TEST(HncReading, OrderOfStarts) {
  const std::string program = "G82 X20 Z-10 C2 P90 F2\n";
  const auto first = [&](const char* value) {
    return run_as("hnc.g82.order", value, program).records[1];
  };
  EXPECT_NE(first("rising").find("start=0"), std::string::npos) << first("rising");
  EXPECT_NE(first("falling").find("start=90"), std::string::npos) << first("falling");
}

// F4 of inches is 101.6 mm; F254 of millimetres is 6451.6 in inches. One of power-on has no number.
TEST(HncReading, FeedUnits) {
  const auto feeds = [](const char* value, const char* program) {
    return run_as("hnc.feed-units", value, program).motions();
  };
  EXPECT_EQ(feeds("length", "G20 F4\nG21 G1 X40\n"), "feed x=20 f=101.6\n");
  EXPECT_EQ(feeds("number", "G20 F4\nG21 G1 X40\n"), "feed x=20 f=4\n");
  EXPECT_EQ(feeds("number", "F254\nG20 G1 X2\n"), "feed x=25.4 f=6451.6\n");
}

// I-0.1 of inches is 2.54 mm; B lies I before C at a radius of 10.
TEST(HncReading, Retained) {
  const std::string program = "G20 G80 X1 Z-1 I-0.1 F4\nG21 X20 Z-10\n";
  EXPECT_EQ(run_as("hnc.retained", "length", program).records[4], "rapid x=7.46");
  EXPECT_EQ(run_as("hnc.retained", "number", program).records[4], "rapid x=9.9");
  const std::string behind = "G20 G80 X1 Z-1 I-0.1 F4\nG21 G00\nG80 X20 Z-10\n";
  const char* kept = R"({"readings":{"hnc.retained":"number","hnc.modal.words":"kept"}})";
  EXPECT_EQ(run_hnc(behind, kept).records[4], "rapid x=9.9");
}

TEST(HncReading, FeedChange) {
  const std::string program = "F50\nG95 G1 X20\n";
  EXPECT_EQ(run_as("hnc.feed-change", "kept", program).answer, GONOGO_OK);
  EXPECT_EQ(run_as("hnc.feed-change", "deleted", program).alarm, "feed-missing");
  EXPECT_EQ(run_as("hnc.feed-change", "deleted", "F50\nG95 G1 X20 F0.2\n").answer, GONOGO_OK);
  EXPECT_EQ(run_as("hnc.feed-change", "deleted", "F50\nG94 G1 X20\n").answer, GONOGO_OK);
}

}  // namespace
}  // namespace gonogo::expanders::testing
