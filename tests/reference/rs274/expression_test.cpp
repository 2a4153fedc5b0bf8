// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parameters and expressions. Values are the documents' examples, or what LinuxCNC 2.9 prints.
#include <gtest/gtest.h>

#include "ngc_expanding.hpp"

namespace gonogo::reference::testing::ngc {
namespace {

// Where G0 goes along X by this value.
std::string value(const std::string& text, const Profile& profile = ngc()) {
  const Lines lines = path("G0 X1000\nX" + text, profile);
  constexpr std::string_view kBefore = "rapid x";
  const std::string& last = lines.back();
  return last.starts_with(kBefore) ? last.substr(kBefore.size()) : last;
}

TEST(NgcExpression, HasTheDocumentsGroups) {
  EXPECT_EQ(value("[2.0/3*1.5-5.5/11.0]"), "0.5");
  EXPECT_EQ(value("[2**3**2]"), "64");
  EXPECT_EQ(value("[-2**2]"), "4");
  EXPECT_EQ(value("[1 OR 1 AND 0]"), "0");
  EXPECT_EQ(value("[1 AND 0 OR 1]"), "1");
  EXPECT_EQ(value("[1+1 EQ 2]"), "1");
}

// NIST 3.3.2.3: AND, OR and XOR are of the group of + and -, the left one first.
TEST(NgcExpression, LogicIsLastOrAmongTheSums) {
  const Profile last = ngc({{"ngc.logic-order", "last"}});
  const Profile among = ngc({{"ngc.logic-order", "among-sums"}});
  struct Row {
    const char* value;
    const char* last;
    const char* among;
  };
  for (const Row& row :
       {Row{"1 OR 0 + 20", "rapid x1", "rapid x21"}, Row{"1 OR 0 + 2 * 3", "rapid x1", "rapid x7"},
        Row{"1 AND 4 - 3", "rapid x1", "rapid x-2"},
        Row{"5 + [1 AND 1 + 4]", "rapid x6", "rapid x10"},
        // 1 OR -3, XOR 4; ((2 - 1 OR 0) - 3 XOR 0) + 4.
        Row{"7 + [2 - 1 OR 0 - 3 XOR 0 + 4]", "rapid x7", "rapid x12"},
        Row{"ABS[0 XOR 1 - 7]", "rapid x1", "rapid x6"}}) {
    const std::string program = "G0 X[" + std::string(row.value) + "]\nM2";
    EXPECT_EQ(path(program, last), Lines{row.last}) << row.value;
    EXPECT_EQ(path(program, among), Lines{row.among}) << row.value;
    EXPECT_EQ(touched(program), Lines{"ngc.logic-order"}) << row.value;
  }
  for (const char* value : {"1 OR [0 + 20]", "5 + 1 AND 3", "5 - 4 + 1 XOR 0", "2 * 3 OR 1",
                            "1 GT 0 AND 3 + 2", "0 OR 3 + 2 GT 4", "1 AND -3"}) {
    const std::string program = "G0 X[" + std::string(value) + "]\nM2";
    EXPECT_EQ(path(program, among), Lines{"rapid x1"}) << value;
    EXPECT_EQ(touched(program), Lines{}) << value;
  }
}

TEST(NgcExpression, HasTheDocumentsFunctions) {
  EXPECT_EQ(value(" FIX[2.8]"), "2");
  EXPECT_EQ(value(" FIX[-2.8]"), "-3");
  EXPECT_EQ(value(" FUP[2.8]"), "3");
  EXPECT_EQ(value(" FUP[-2.8]"), "-2");
  EXPECT_EQ(value(" SIN[30]"), "0.5");
  EXPECT_EQ(value(" ATAN[1]/[-1]"), "135");
  EXPECT_EQ(value(" ATAN[-1]/[-1]"), "-135");
  EXPECT_EQ(value("[1+ACOS[0]-[2**[4.0/2]]]"), "87");
  EXPECT_EQ(value(" ROUND[-2.5]"), "-3");
  EXPECT_EQ(value("[-7 MOD 3]"), "2");
  EXPECT_EQ(value("[7 MOD -3]"), "1");
}

TEST(NgcExpression, IsExact) {
  EXPECT_EQ(value("[1/3*3]"), "1");
  EXPECT_EQ(value("[1/3]"), "1/3");
  EXPECT_EQ(value("[SQRT[2]*SQRT[2]]"), "2");
  EXPECT_EQ(value("[0.1+0.2 EQ 0.3]"), "1");
}

TEST(NgcExpression, EqualityHasATolerance) {
  EXPECT_EQ(value("[1 EQ 1.0000005]"), "1");
  EXPECT_EQ(value("[1 EQ 1.00001]", ngc({{"ngc.equal", "millionth"}})), "0");
  EXPECT_EQ(value("[1 EQ 1.00001]", ngc({{"ngc.equal", "ten-thousandth"}})), "1");
  EXPECT_EQ(value("[1 EQ 1.0002]", ngc({{"ngc.equal", "ten-thousandth"}})), "0");
  // In binary64 they differ by less than 0.0001.
  EXPECT_EQ(value("[1 EQ 1.0001]"), "not-covered b2 expression");
  EXPECT_EQ(value("[1 GE 1.0000005]"), "0");
}

// SIN[30] is below a half in binary64, and 0.1*3*10 above 3.
TEST(NgcExpression, IsNotDecidedWhereDoublesMayDecideOtherwise) {
  for (const char* text : {" FIX[0.1*3*10]", " FUP[0.1*3*10]", " ROUND[SIN[30]]", "[0.3 MOD 0.1]",
                           "[0.1+0.2 GT 0.3]", "[0.1+0.2-0.3 OR 0]", "[1/[0.1+0.2-0.3]]",
                           " SQRT[0.1+0.2-0.3]", " ASIN[0.1*10]", "[0.300001-0.3 EQ 0]"}) {
    EXPECT_EQ(value(text), "not-covered b2 expression") << text;
  }
  EXPECT_EQ(value("[0.1+0.2 GT 0.29]"), "1");
  EXPECT_EQ(value("[7/2 GT 3.5]"), "0");
  EXPECT_EQ(value(" FIX[2.7]"), "2");
  EXPECT_EQ(value("[2.7 MOD 2]"), "0.7");
}

TEST(NgcExpression, HasNoValueWithoutANumber) {
  for (const char* text : {"[1/0]", " SQRT[-1]", " ACOS[2]", "[0**-1]", "#<a>", "#5603", "#0"}) {
    EXPECT_EQ(value(text), "alarm b2 value-out-of-range") << text;
  }
  EXPECT_EQ(value(" EXP[1]"), "not-covered b2 EXP");
  EXPECT_EQ(value("[2**0.5]"), "not-covered b2 **");
  EXPECT_EQ(value("#5161"), "not-covered b2 #5161");
}

TEST(NgcExpression, ASignBelongsToDigitsInTheTexts) {
  EXPECT_EQ(path("#1=3\nG0 X-#1", ngc({{"ngc.sign-of-value", "taken"}})), Lines{"rapid x-3"});
  EXPECT_EQ(ending_of("#1=3\nG0 X-#1", ngc({{"ngc.sign-of-value", "syntax"}})), "alarm b2 syntax");
}

// The documents: #3=6 G1 X#3 goes to 15, where #3 was.
TEST(NgcParameters, SettingsTakeEffectBehindTheirLine) {
  EXPECT_EQ(path("#3=15\n#3=6 G0 X#3\nX#3"), (Lines{"rapid x15", "rapid x6"}));
  EXPECT_EQ(path("#1=2\n#2=3\n#1=#2 #2=#1\nG0 X#1 Y#2"), Lines{"rapid x3 y2"});
  EXPECT_EQ(path("#3=15 #3=6\nG0 X#3"), Lines{"rapid x6"});
}

TEST(NgcParameters, NamesHaveNoCaseAndNoBlanks) {
  EXPECT_EQ(path("#<P a R am>=2\nG0 X#<param>"), Lines{"rapid x2"});
  EXPECT_EQ(value("[EXISTS[#<a>]]"), "0");
}

TEST(NgcParameters, SayWhereTheProgramIs) {
  EXPECT_EQ(path("G0 X4\nG92 X7\nG20\nG1 F1 Y[#5420*25.4]").back(), "feed y177.8 f25.4");
}

// LinuxCNC's table of named parameters, and what its interpreter makes of them.
TEST(NgcParameters, SayWhatIsInForce) {
  EXPECT_EQ(path("G18\nG0 Y#<_plane>"), Lines{"rapid y180"});
  EXPECT_EQ(path("G0 X#<_coord_system>\nG59.3\nX#<_coord_system>"),
            (Lines{"rapid x540", "rapid x593"}));
  EXPECT_EQ(path("G90.1\nG0 X[2+#<_ijk_absolute_mode>]"), Lines{"rapid x3"});
  EXPECT_EQ(path("G95\nG0 X[2+#<_units_per_rev>] Y[2+#<_units_per_minute>]"), Lines{"rapid x3 y2"});
  EXPECT_EQ(path("G93\nG0 X[2+#<_inverse_time>] Y[2+#<_units_per_minute>]"), Lines{"rapid x3 y2"});
  EXPECT_EQ(path("M4 M7\nG0 X[2+#<_spindle_on>] Y[2+#<_spindle_cw>] Z[2+#<_mist>]"),
            Lines{"rapid x3 y2 z3"});
  EXPECT_EQ(path("F123\nG0 X#<_feed>"), Lines{"rapid x123"});
  EXPECT_EQ(ending_of("F123\nG20\nG0 X#<_feed>"), "not-covered b3 #<_feed>");
}

// It says whether messages are shown, which moves nothing.
TEST(NgcParameters, TheSwitchOfMessagesIsTheProgramsOwn) {
  EXPECT_EQ(path("G0 X[2+#5599]\n#5599=0\nX[5+#5599]"), (Lines{"rapid x3", "rapid x5"}));
}

TEST(NgcParameters, GrowNoFurtherThanTheGaugeKeeps) {
  std::string program = "#1=3\n";
  for (int i = 0; i < 20; ++i) program += "#1=[#1*#1]\n";
  EXPECT_TRUE(ending_of(program).ends_with(" expression"));
}

}  // namespace
}  // namespace gonogo::reference::testing::ngc
