// SPDX-License-Identifier: GPL-3.0-or-later
//
// O words. The paths are those that LinuxCNC 2.9 prints.
#include <gtest/gtest.h>

#include "ngc_expanding.hpp"

namespace gonogo::reference::testing::ngc {
namespace {

TEST(NgcOWords, ASubroutineRunsWhenItIsCalled) {
  EXPECT_EQ(path("o1 sub\nG0 X#1\n#2=9\no1 endsub\n#2=5\no1 call [3]\nG0 Y#2 X#1"),
            (Lines{"rapid x3", "rapid x0 y5"}));
  EXPECT_EQ(path("o1 sub\nG0 X1\no1 return [7]\nG0 X2\no1 endsub [8]\no1 call\n"
                 "G0 X#<_value> Y#<_value_returned>"),
            (Lines{"rapid x1", "rapid x7 y1"}));
}

TEST(NgcOWords, LoopsComeAgain) {
  EXPECT_EQ(path("#1=0\no1 while [#1 LT 3]\n#1=[#1+1]\no2 if [#1 EQ 2]\no1 continue\no2 endif\n"
                 "G0 X#1\no1 endwhile"),
            (Lines{"rapid x1", "rapid x3"}));
  EXPECT_EQ(path("#1=0\no1 do\n#1=[#1+1]\no2 if [#1 EQ 2]\no1 continue\no2 endif\nG0 X#1\n"
                 "o1 while [#1 LT 4]"),
            (Lines{"rapid x1", "rapid x3", "rapid x4"}));
  EXPECT_EQ(path("o1 repeat [2]\nG91 G0 X1\no2 repeat [2]\nY1\no2 endrepeat\no1 endrepeat"),
            (Lines{"rapid x1", "rapid y1", "rapid y2", "rapid x2", "rapid y3", "rapid y4"}));
  EXPECT_EQ(path("o1 repeat [0]\nG0 X1\no1 endrepeat\nG0 X9"), Lines{"rapid x9"});
}

TEST(NgcOWords, OneBranchRuns) {
  for (const auto& [first, second, x] :
       {std::tuple(1, 1, "rapid x1"), {0, 1, "rapid x2"}, {0, 0, "rapid x3"}}) {
    EXPECT_EQ(path("o1 if [" + std::to_string(first) + "]\nG0 X1\no1 elseif [" +
                   std::to_string(second) + "]\nG0 X2\no1 else\nG0 X3\no1 endif"),
              Lines{x});
  }
  EXPECT_EQ(path("o1 if [0]\nGARBAGE ] X1\no1 else\nG0 X3\no1 endif"), Lines{"rapid x3"});
}

TEST(NgcOWords, LabelsBelongToWhatIsOpen) {
  for (const char* text : {"o1 endwhile", "o1 break", "o1 else", "o1 endif", "o1 endsub",
                           "o1 return", "o1 endrepeat"}) {
    EXPECT_EQ(ending_of(text), "alarm b1 syntax") << text;
  }
  EXPECT_EQ(ending_of("o1 if [1]\no1 if [1]"), "alarm b2 syntax");
  EXPECT_EQ(ending_of("o1 sub\no2 sub"), "alarm b2 syntax");
  EXPECT_EQ(ending_of("o1 sub\no1 endsub\no1 sub"), "alarm b3 syntax");
  EXPECT_EQ(ending_of("o1 repeat [2]\no1 continue\no1 endrepeat"), "alarm b2 syntax");
}

TEST(NgcOWords, NamesAreTheSubroutines) {
  EXPECT_EQ(ending_of("#<a>=1\no1 sub\nG0 X#<a>\no1 endsub\no1 call"),
            "alarm b3 value-out-of-range");
  EXPECT_EQ(path("o<foo> sub\nG0 X#1\no<foo> endsub\no<Foo> call [4]"), Lines{"rapid x4"});
}

TEST(NgcOWords, WhatIsFollowedHasBounds) {
  EXPECT_EQ(ending_of("o1 while [1]\no1 endwhile"), "not-covered b1 o-word");
  EXPECT_EQ(ending_of("o1 sub\no1 call\no1 endsub\no1 call"), "not-covered b2 o-word");
  EXPECT_EQ(ending_of("o9 call"), "not-covered b1 o-word");
  EXPECT_EQ(ending_of("o1 repeat [1.5]\no1 endrepeat"), "not-covered b1 o-word");
  std::string program = "o1 repeat [2]\n";
  for (int i = 0; i < 2'000; ++i) program += "(" + std::string(1'000, 'c') + ")\n";
  EXPECT_TRUE(ending_of(program + "o1 endrepeat").ends_with(" o-word"));
}

// A line that is behind the loop runs once, and one behind '/' not at all.
TEST(NgcOWords, LinesBehindALoopAreReadAsEver) {
  EXPECT_EQ(path("G91 G0\no1 repeat [2]\nX1\no1 endrepeat\nY1\no2 repeat [2]\nX2\no2 endrepeat"),
            (Lines{"rapid x1", "rapid x2", "rapid y1", "rapid x4", "rapid x6"}));
  Profile skips = ngc();
  skips.block_skip = true;
  EXPECT_EQ(path("o1 if [0]\n/o1 else\nG0 X1\no1 endif\nG0 X2", skips), Lines{"rapid x2"});
}

}  // namespace
}  // namespace gonogo::reference::testing::ngc
