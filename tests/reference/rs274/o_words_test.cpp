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

TEST(NgcOWords, ASubroutineMayStandBehindItsCall) {
  const std::string sub = "o2 sub\nG0 X#1\no2 endsub\n";
  EXPECT_EQ(path("o2 call [3]\nM2\n" + sub), Lines{"rapid x3"});
  EXPECT_EQ(path("o2 call [3]\nG0 Y1\n" + sub + "o2 call [4]\nG0 Y2"),
            (Lines{"rapid x3", "rapid y1", "rapid x4", "rapid y2"}));
  EXPECT_EQ(path("o1 repeat [2]\nG91 G0 Y1\no2 call [3]\no1 endrepeat\nG0 Z1\n" + sub + "Z2"),
            (Lines{"rapid y1", "rapid x3", "rapid y2", "rapid x6", "rapid z1", "rapid z3"}));
  EXPECT_EQ(path("o1 sub\no2 call [5]\no1 endsub\no1 call\nG0 Y1\nM2\n" + sub),
            (Lines{"rapid x5", "rapid y1"}));
  EXPECT_EQ(path("o2 call [3]\no1 sub\nG0 Z#1\no1 endsub\n" + sub + "o1 call [4]\no2 call [5]"),
            (Lines{"rapid x3", "rapid z4", "rapid x5"}));
  EXPECT_EQ(ending_of("o2 call\nG0 X1\no2 sub\nG0 X2\nM2"), "not-covered b1 o-word");
  EXPECT_EQ(ending_of("o2 call [1]\n" + sub + "o2 sub\no2 endsub"), "alarm b5 syntax");
}

// The documents: the label of a return need not be that of the subroutine.
TEST(NgcOWords, AReturnOfAnyLabelReturns) {
  EXPECT_EQ(path("o1 sub\nG0 X1\no7 return [4]\nG0 X2\no1 endsub\no1 call\nG0 Y#<_value>"),
            (Lines{"rapid x1", "rapid y4"}));
  EXPECT_EQ(ending_of("o1 sub\nG0 X1\no7 endsub\no1 endsub\no1 call"), "alarm b3 syntax");
  EXPECT_EQ(ending_of("o7 return"), "alarm b1 syntax");
}

// In binary64 0.1 + 0.1 + 0.1 is above 0.3, and ten tenths are below 1.
TEST(NgcOWords, WhatDoublesDecideOtherwiseIsNotDecided) {
  EXPECT_EQ(ending_of("#1=0\no1 while [#1 LT 0.3]\n#1=[#1+0.1]\no1 endwhile"),
            "not-covered b2 expression");
  EXPECT_EQ(ending_of("#1=[0.3-0.1-0.2]\no1 if [#1]\no1 endif"), "not-covered b2 expression");
  EXPECT_EQ(ending_of("o1 repeat [0.3/0.1]\no1 endrepeat"), "not-covered b1 o-word");
  EXPECT_EQ(path("#1=0\no1 while [#1 LT 1]\n#1=[#1+0.5]\nG0 X#1\no1 endwhile"),
            (Lines{"rapid x0.5", "rapid x1"}));
  EXPECT_EQ(path("#1=0\no1 while [#1 LT 0.25]\n#1=[#1+0.1]\nG0 X#1\no1 endwhile"),
            (Lines{"rapid x0.1", "rapid x0.2", "rapid x0.3"}));
}

TEST(NgcOWords, ACommentBetweenValuesIsNotRead) {
  EXPECT_EQ(ending_of("o1 sub\no1 endsub\no1 call [1] (a) [2]"), "not-covered b3 o-word");
  EXPECT_EQ(path("o1 sub\nG0 X#1\no1 endsub\no1 call [1] (a)"), Lines{"rapid x1"});
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

// The documents' example of nested subprograms: 5 times, and 5 times in each; #1 ends at 5.25.
TEST(NgcOWords, M98CallsWhatStandsBehindIt) {
  EXPECT_EQ(path("O1\n#1=0\nM98 P100 L5\nG0 X#1\nM30\nO100\n#1=[#1+1]\nM98 P200 L5\nM99\n"
                 "O200\n#1=[#1+0.01]\nM99"),
            Lines{"rapid x5.25"});
  EXPECT_EQ(path("G91\nG0 X1\nM98 P2\nM98 P0002 L0\nM98 P2 L2\nM2\nO0002\nY1\nM99"),
            (Lines{"rapid x1", "rapid y1", "rapid y2", "rapid y3"}));
  EXPECT_EQ(path("G0 X1\nM98 P1\nX3\nM2\nO1\no2 if [1]\nX2\nM99\no2 endif\nX9\nM99"),
            (Lines{"rapid x1", "rapid x2", "rapid x3"}));
}

TEST(NgcOWords, StylesOfSubprogramsDoNotMix) {
  EXPECT_EQ(ending_of("M98 P1\nM2\nO1 sub\nO1 endsub"), "alarm b1 syntax");
  EXPECT_EQ(ending_of("O1 sub\nG0 X1\nO1 endsub\nM98 P1\nM2"), "alarm b4 syntax");
  EXPECT_EQ(ending_of("M98 P1\nM2\nO1\nG0 X1\nO1 endsub"), "alarm b1 syntax");
  EXPECT_EQ(ending_of("O1 call\nM2\nO1\nG0 X1\nM99"), "alarm b1 syntax");
  EXPECT_EQ(ending_of("O1 sub\nM99\nO1 endsub\nO1 call\nM2"), "alarm b2 syntax");
  // No return ends what M98 has called, whatever its label and wherever it stands.
  EXPECT_EQ(ending_of("#1=4\nM98 P100\nG0 X#1\nM30\nO100\nG0 Y1\no5 return\nM99"),
            "alarm b7 syntax");
  EXPECT_EQ(ending_of("M98 P1\nM2\nO1\no2 if [1]\no2 return [7]\no2 endif\nM99"),
            "alarm b5 syntax");
  EXPECT_EQ(ending_of("o5 sub\nM98 P1\no5 endsub\no5 call\nM2\nO1\no5 return\nM99"),
            "alarm b7 syntax");
  EXPECT_EQ(ending_of("M98 P1\nM2\nO1\nG0 X1\no5 endsub\nM99"), "alarm b5 syntax");
  EXPECT_EQ(ending_of("M98 P1\nM2\nO1\nG0 X1\no1 return\nM99"), "alarm b1 syntax");
  // One that it calls in the other style returns to it.
  EXPECT_EQ(path("o5 sub\nG0 X#1\no5 return\no5 endsub\n#1=4\nM98 P1\nG0 Z#1\nM2\nO1\n"
                 "o5 call [3]\nG0 Y#1\nM99"),
            (Lines{"rapid x3", "rapid y4", "rapid z4"}));
  EXPECT_EQ(ending_of("M98"), "alarm b1 missing-word");
  EXPECT_EQ(ending_of("M98 P1 L-1"), "alarm b1 value-sign");
  EXPECT_EQ(ending_of("M98 P1.5"), "alarm b1 not-an-integer");
  EXPECT_EQ(ending_of("M98 P1\nM2"), "not-covered b1 M98");
  EXPECT_EQ(ending_of("G0 X1\nM99"), "not-covered b2 M99");
  EXPECT_EQ(ending_of("G0 X1 M98 P1\nM2\nO1\nM99"), "not-covered b1 M");
}

// As LinuxCNC 2.9 prints it: what has a name stays in the subprogram, #1 to #30 are those of the
// lines that call.
TEST(NgcOWords, ASubprogramHasNamesOfItsOwnAndTheNumbersOfItsCaller) {
  EXPECT_EQ(ending_of("#<a>=3\nM98 P1\nM2\nO1\nG0 X#<a>\nM99"), "alarm b5 value-out-of-range");
  EXPECT_EQ(ending_of("M98 P1\nG0 X#<a>\nM2\nO1\n#<a>=3\nM99"), "alarm b2 value-out-of-range");
  EXPECT_EQ(path("#<a>=3 #<_b1>=4\nM98 P1\nG0 X#<a> Y#<_b1>\nM2\nO1\n#<a>=5 #<_b1>=6\nG0 X#<a>\n"
                 "M99"),
            (Lines{"rapid x5", "rapid x3 y6"}));
  // Each pass of L has its own.
  EXPECT_EQ(path("M98 P1 L2\nM2\nO1\nG91 G0 X[2+EXISTS[#<a>]]\n#<a>=5\nM99"),
            (Lines{"rapid x2", "rapid x4"}));
  EXPECT_EQ(path("o5 sub\nG0 X#1\nM98 P2\nG0 X#1\no5 endsub\n#1=1\no5 call [3]\nG0 Z#1\nM30\n"
                 "O2\n#1=9\nG0 Y#1\nM99"),
            (Lines{"rapid x3", "rapid y9", "rapid x9", "rapid z1"}));
}

// The documents: both are cleared just before the next call, and M98 returns no value.
TEST(NgcOWords, M98ClearsTheValueThatWasReturned) {
  const std::string returns = "o5 sub\no5 endsub [7]\no5 call\nG0 Z#<_value>\n";
  EXPECT_EQ(path(returns + "M98 P1\nG0 X[2+#<_value>] Y[2+#<_value_returned>]\nM2\nO1\nM99"),
            (Lines{"rapid z7", "rapid x2 y2"}));
  EXPECT_EQ(path(returns + "M98 P1\nM2\nO1\nG0 X[2+#<_value>] Y[2+#<_value_returned>]\nM99"),
            (Lines{"rapid z7", "rapid x2 y2"}));
  // None is called.
  EXPECT_EQ(path(returns + "M98 P1 L0\nG0 X#<_value>\nM2\nO1\nM99"),
            (Lines{"rapid z7", "rapid x7"}));
}

// The documents have a subprogram behind the line that calls it, else an alarm; LinuxCNC 2.9 runs
// one that has run already.
TEST(NgcOWords, ASubprogramBeforeItsCallRunsOrAlarms) {
  const std::string first = "M98 P100\nM30\nO200\nG0 X1\nM99\nO100\nM98 P200\nM99";
  const std::string again = "M98 P200\nM98 P100\nM30\nO200\nG91 G0 X1\nM99\nO100\nM98 P200\nM99";
  const Profile runs = ngc({{"ngc.m98-before", "runs"}});
  const Profile alarms = ngc({{"ngc.m98-before", "syntax"}});
  EXPECT_EQ(path(first, runs), Lines{"rapid x1"});
  EXPECT_EQ(ending_of(first, alarms), "alarm b7 syntax");
  EXPECT_EQ(path(again, runs), (Lines{"rapid x1", "rapid x2"}));
  EXPECT_EQ(ending_of(again, alarms), "alarm b8 syntax");
  EXPECT_EQ(touched(first), Lines{"ngc.m98-before"});
  // Behind every call of it.
  EXPECT_EQ(touched("M98 P100\nM98 P200\nM30\nO100\nM98 P200\nM99\nO200\nG0 X1\nM99"), Lines{});
}

}  // namespace
}  // namespace gonogo::reference::testing::ngc
