// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines of SINUMERIK that are not well formed: the code and the place of the fault, and what is
// expected there. SIE-LEX-01.
#include "grammar/line_source.hpp"
#include "tests/grammar/sinumerik_trees.hpp"

namespace gonogo::grammar {
namespace {

constexpr auto kNumber = SyntaxCode::number_expected;
constexpr auto kCharacter = SyntaxCode::unexpected_character;
constexpr auto kHead = SyntaxCode::misplaced_number_word;

struct SinumerikFaultCase {
  std::string line;
  SyntaxCode code;
  std::uint32_t begin;
  std::uint32_t end;
};

SyntaxError sinumerik_fault(std::string_view line) {
  return fault(Dialect::sinumerik, line);
}

// All of them expect the same.
void expect_faults(std::string_view expected, const std::vector<SinumerikFaultCase>& cases) {
  for (const SinumerikFaultCase& wanted : cases) {
    const SyntaxError error = sinumerik_fault(wanted.line);
    EXPECT_EQ(name(error.code), name(wanted.code)) << wanted.line;
    EXPECT_EQ(error.where, (Span{wanted.begin, wanted.end})) << wanted.line;
    EXPECT_EQ(error.expected, expected) << wanted.line;
  }
}

TEST(SinumerikFault, AnAddressWithoutANumber) {
  expect_faults("a number or '=' after X", {{"X", kNumber, 1, 1},
                                            {"G1 X Y2", kNumber, 5, 6},
                                            {"X-", kNumber, 2, 2},
                                            {"X-.", kNumber, 3, 3},
                                            {"X--5", kNumber, 2, 3},
                                            {"X- 5", kNumber, 2, 3},
                                            {"X(5)", kNumber, 1, 2},
                                            {"X;5", kNumber, 1, 2},
                                            {"X N10", kNumber, 2, 3}});
}

// What other languages begin a comment with.
TEST(SinumerikFault, ACommentBeginsWithASemicolon) {
  constexpr const char* kWord = "a word, ';' with a comment behind it, or the end of the block";
  expect_faults(kWord, {{"X5 (down)", kCharacter, 3, 4}});
  expect_faults("';', with which a comment begins; // begins none",
                {{"X5 // down", kCharacter, 3, 5},
                 {"X=5 // down", kCharacter, 4, 6},
                 {"//G1", kCharacter, 0, 2},
                 {"// down", kCharacter, 0, 2}});
  expect_faults(
      "';', with which a comment begins; \xE2\x80\xA6 begins none",
      {{"X5 \xE2\x80\xA6", kCharacter, 3, 6}, {"\xE2\x80\xA6\xE2\x80\xA6", kCharacter, 0, 3}});
}

TEST(SinumerikFault, OneLetterIsNoLabel) {
  expect_faults("a number or '=' after A", {{"A: X1", kNumber, 1, 2}});
}

TEST(SinumerikFault, GAndLTakeNoEqualsSign) {
  expect_faults("a number after G", {{"G=1", kNumber, 1, 2}, {"G X1", kNumber, 2, 3}});
  expect_faults("a number after l", {{"X1 l=1", kNumber, 4, 5}});
  expect_faults("a word, ';' with a comment behind it, or the end of the block",
                {{"G1=5", kCharacter, 2, 3}});
}

TEST(SinumerikFault, BlockNumbersAreWhole) {
  expect_faults("a whole number without a sign after N",
                {{"N", kNumber, 1, 1}, {"N-5", kNumber, 1, 2}, {"N=5", kNumber, 1, 2}});
  expect_faults("a whole number without a sign after ':'",
                {{":", kNumber, 1, 1}, {"/:X1", kNumber, 2, 3}});
}

TEST(SinumerikFault, BlockNumbersStandAtTheHead) {
  expect_faults("a word other than N", {{"G1 N10", kHead, 3, 4},
                                        {"N1 N2", kHead, 3, 4},
                                        {"X1 n", kHead, 3, 4},
                                        {"G1 :10", kHead, 3, 4},
                                        {"AB: N5", kHead, 4, 5}});
}

TEST(SinumerikFault, AnAddressOfSeveralLettersWithoutAnEqualsSign) {
  for (const std::string name : {"CR", "AR", "AP", "RP", "TURN"}) {
    const auto size = static_cast<std::uint32_t>(name.size());
    expect_faults("'=' after " + name, {{name + "5", kCharacter, size, size + 1},
                                        {name + "5=1", kCharacter, size, size + 1},
                                        {name + "-.5", kCharacter, size, size + 1},
                                        {name + " 5", kCharacter, size + 1, size + 2},
                                        {name + "(5)", kCharacter, size, size + 1},
                                        {name, kCharacter, size, size},
                                        {"G2" + name + "5", kCharacter, size + 2, size + 3}});
  }
}

TEST(SinumerikFault, AnRParameterOutsideAValueWithoutAnEqualsSign) {
  expect_faults("'=' after the R parameter", {{"R101", kCharacter, 4, 4},
                                              {"G1 R1 X5", kCharacter, 6, 7},
                                              {"R1.5=2", kCharacter, 2, 3},
                                              {"G2 X1 R20", kCharacter, 9, 9}});
  expect_faults("a whole number without a sign after R", {{"R", kNumber, 1, 1},
                                                          {"R-1=5", kNumber, 1, 2},
                                                          {"X=R", kNumber, 3, 3},
                                                          {"X=1+R+1", kNumber, 5, 6}});
}

TEST(SinumerikFault, AValueThatIsMissing) {
  expect_faults("a number, an R parameter, a function or '('", {{"X=", kNumber, 2, 2},
                                                                {"CR= F5", kNumber, 4, 5},
                                                                {"R1=5+", kNumber, 5, 5},
                                                                {"R1=5* Y2", kNumber, 6, 7},
                                                                {"X=()", kNumber, 3, 4},
                                                                {"X=SIN()", kNumber, 6, 7},
                                                                {"X=--5", kNumber, 3, 4},
                                                                {"X=-+R1", kNumber, 3, 4},
                                                                {"X==5", kNumber, 2, 3},
                                                                {"X=*5", kNumber, 2, 3},
                                                                {"X=.", kNumber, 2, 3},
                                                                {"X=Y5", kNumber, 2, 3},
                                                                {"X=AC()", kNumber, 5, 6},
                                                                {"TURN=;3", kNumber, 5, 6}});
}

TEST(SinumerikFault, BracketsThatAreNotClosedOrNotOpened) {
  expect_faults("')'", {{"X=(5", kCharacter, 4, 4},
                        {"X=((5)", kCharacter, 6, 6},
                        {"X=(5 Y3", kCharacter, 5, 6},
                        {"X=SIN(5;)", kCharacter, 7, 8},
                        {"X=AC(5", kCharacter, 6, 6},
                        {"CYCLE82(1,(2)", kCharacter, 13, 13},
                        {"MSG(\"a\";)", kCharacter, 7, 8}});
  expect_faults("'(' after SIN", {{"X=SIN 30", kCharacter, 6, 7}, {"X=1+SIN", kCharacter, 7, 7}});
  expect_faults("'(' after ac", {{"X=ac", kCharacter, 4, 4}, {"X=ac +5", kCharacter, 5, 6}});
  expect_faults("a word, ';' with a comment behind it, or the end of the block",
                {{"X=5)", kCharacter, 3, 4},
                 {"X5 (c)", kCharacter, 3, 4},
                 {"(c)", kCharacter, 0, 1},
                 {"MSG())", kCharacter, 5, 6}});
}

TEST(SinumerikFault, AStringThatIsNotClosed) {
  expect_faults("'\"' at the end of the string", {{"MSG(\"a) ;b", kCharacter, 10, 10},
                                                  {"T=\"", kCharacter, 3, 3},
                                                  {"GOTOF \"A", kCharacter, 8, 8}});
}

TEST(SinumerikFault, AcAndIcWhereTheyAreNotTheWholeValueOfAPosition) {
  const std::string_view expected =
      "a value without AC() and IC(), which are only the whole value of an axis, I J K, I1 J1 K1 "
      "or AP";
  expect_faults(expected, {{"F=AC(5)", kCharacter, 2, 3},
                           {"R1=IC(5)", kCharacter, 3, 4},
                           {"CR=ac(5)", kCharacter, 3, 4},
                           {"RP=IC(5)", kCharacter, 3, 4},
                           {"F1=AC(5)", kCharacter, 3, 4},
                           {"S2=AC(5)", kCharacter, 3, 4},
                           {"X=1+AC(5)", kCharacter, 4, 5},
                           {"X=-AC(5)", kCharacter, 3, 4},
                           {"X=(IC(5))", kCharacter, 3, 4},
                           {"X=AC(IC(5))", kCharacter, 5, 6}});
  expect_faults("a word, ';' with a comment behind it, or the end of the block",
                {{"X=AC(5)+1", kCharacter, 7, 8}});
}

TEST(SinumerikFault, WhatMayNotStandBetweenWords) {
  expect_faults("a word, ';' with a comment behind it, or the end of the block",
                {{"5", kCharacter, 0, 1},
                 {"X5 6", kCharacter, 3, 4},
                 {"X1.2.3", kCharacter, 4, 5},
                 {"X5+3", kCharacter, 2, 3},
                 {"X5,Y3", kCharacter, 2, 3},
                 {"=5", kCharacter, 0, 1},
                 {"G1 \"a\"", kCharacter, 3, 4},
                 {"G1 %", kCharacter, 3, 4},
                 {"N10 /G1", kCharacter, 4, 5},
                 {"/12 G1", kCharacter, 2, 3},
                 {"N10.5", kCharacter, 3, 4},
                 {"AB: CD:", kCharacter, 6, 7},
                 {"X1 ?", kCharacter, 3, 4},
                 {"X1&2", kCharacter, 3, 4},
                 {"X1\x01\xFC", kCharacter, 3, 4}});
}

TEST(SinumerikFault, BytesAbove127OutsideCommentsAndStrings) {
  expect_faults("a word, ';' with a comment behind it, or the end of the block",
                {
                    {"X5\xC3\xBC", kCharacter, 2, 4},      // ü
                    {"X5 \xFC", kCharacter, 3, 4},         // ü in Latin-1
                    {"\xE8\xBD\xAE X5", kCharacter, 0, 3}  // 轮
                });
  expect_faults("a number or '=' after X", {{"X\xFF", kCharacter, 1, 2}});
  expect_faults("')'", {{"MSG(\xC3\xA4)", kCharacter, 4, 6}});
  expect_faults("the name of the program or the end of the line after '%'",
                {{"%A\xC3\xA4", kCharacter, 2, 4}});
}

TEST(SinumerikFault, ADashInPlaceOfAMinusIsNamed) {
  // The lines of the manual's text as it is printed.
  struct Dashed {
    std::string line;
    std::uint32_t begin;
  };
  for (const Dashed& wanted : {Dashed{"N20 G3 X17.203 Y38.029 I\xE2\x80\x93"
                                      "17.5 J\xE2\x80\x93"
                                      "30.211 F500",
                                      24},
                               Dashed{"N20 G3 I\xE2\x80\x93"
                                      "17.5 J\xE2\x80\x93"
                                      "30.211 AR=140.134 F500",
                                      8},
                               Dashed{"CR=\xE2\x80\x93"
                                      "50",
                                      3},
                               Dashed{"R1=R2\xE2\x80\x93"
                                      "5",
                                      5},
                               Dashed{"X=5*(\xE2\x80\x93"
                                      "5",
                                      5}}) {
    const SyntaxError error = sinumerik_fault(wanted.line);
    EXPECT_EQ(error.code, kCharacter) << wanted.line;
    EXPECT_EQ(error.where, (Span{wanted.begin, wanted.begin + 3})) << wanted.line;
    EXPECT_EQ(error.expected, "'-' of ASCII and not U+2013, which looks like it") << wanted.line;
  }
}

TEST(SinumerikFault, OtherLookalikesAreNamed) {
  const auto hint = [](std::string_view line) { return sinumerik_fault(line).expected; };
  EXPECT_EQ(hint("X\xE2\x88\x92"
                 "5"),
            "'-' of ASCII and not U+2212, which looks like it");
  EXPECT_EQ(hint("X5 \xEF\xBC\xA6"
                 "100"),
            "'F' of ASCII and not U+FF26, which looks like it");
  EXPECT_EQ(hint("CR\xEF\xBC\x9D"
                 "5"),
            "'=' of ASCII and not U+FF1D, which looks like it");
  EXPECT_EQ(hint("MSG(\xE2\x80\x9C"
                 "a)"),
            "'\"' of ASCII and not U+201C, which looks like it");
}

TEST(SinumerikFault, InAnOutsideConstructBytesThatNoProgramHas) {
  EXPECT_EQ(sinumerik_fault("GOTOF A\xC3\xA4").where, (Span{7, 9}));
  EXPECT_EQ(sinumerik_fault("X=(POT(\xE2\x88\x92"
                            "5))")
                .expected,
            "'-' of ASCII and not U+2212, which looks like it");
}

TEST(SinumerikFault, ALineAboveTheLimit) {
  EXPECT_EQ(sinumerik_fault(std::string(kMaximumLine + 1, ' ')), line_too_long());
}

TEST(SinumerikMessage, IsAWholeSentence) {
  EXPECT_EQ(
      message(sinumerik_fault("G1 X1 // to the start")),
      "This cannot stand here; expected is ';', with which a comment begins; // begins none.");
  EXPECT_EQ(message(sinumerik_fault("G2 CR5")),
            "This cannot stand here; expected is '=' after CR.");
  EXPECT_EQ(message(sinumerik_fault("X=")),
            "A number is missing here; expected is a number, an R parameter, a function or '('.");
}

}  // namespace
}  // namespace gonogo::grammar
