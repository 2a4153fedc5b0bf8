// SPDX-License-Identifier: GPL-3.0-or-later
//
// The picture of an error: the line as it is shown and the cell of the caret.
#include <sstream>

#include "grammar/line_source.hpp"
#include "tests/grammar/trees.hpp"

namespace gonogo::grammar {
namespace {

struct Picture {
  std::string head;
  std::string line;
  std::string caret;
};

Picture picture(const SyntaxError& error, std::string_view line) {
  std::istringstream text(render(error, "a.nc", 7, line));
  Picture out;
  std::getline(text, out.head);
  std::getline(text, out.line);
  std::getline(text, out.caret);
  EXPECT_EQ(text.peek(), std::istringstream::traits_type::eof());
  return out;
}

Picture picture(std::string_view line) {
  return picture(fault(kLathes, line), line);
}

std::string carets(std::size_t cells) {
  return std::string(4 + cells, ' ') + "^";
}

constexpr const char* kReplacement = "\xEF\xBF\xBD";

TEST(Render, NamesFileLineAndByteColumn) {
  const Picture shown = picture("G1 X Z5");
  EXPECT_EQ(shown.head, "a.nc:7:6: error: " + message(fault("G1 X Z5")));
  EXPECT_EQ(shown.line, "    G1 X Z5");
  EXPECT_EQ(shown.caret, carets(5));
}

TEST(Render, TheCaretMayStandBehindTheLine) {
  EXPECT_EQ(picture("X").caret, carets(1));
  EXPECT_EQ(picture("(").caret, carets(0));
}

TEST(Render, AChineseCharacterIsTwoCellsWide) {
  // (轮廓) is 8 bytes and 6 cells; the fault is the eighth cell, byte 10.
  const std::string line = "(\xE8\xBD\xAE\xE5\xBB\x93) z";
  const Picture shown = picture(line);
  EXPECT_NE(shown.head.find(":10: "), std::string::npos);
  EXPECT_EQ(shown.line, "    " + line);
  EXPECT_EQ(shown.caret, carets(7));
}

TEST(Render, BytesThatAreNotUtf8AreOneReplacementSignEach) {
  const Picture shown = picture("(\xC2\xD6\xFF)z");
  EXPECT_EQ(shown.line, std::string("    (") + kReplacement + kReplacement + kReplacement + ")z");
  EXPECT_EQ(shown.caret, carets(5));
}

TEST(Render, ControlCharactersNeverReachTheTerminal) {
  // NOLINTNEXTLINE(misc-misleading-bidirectional): that it misleads is the point.
  const std::string override = "\xE2\x80\xAE";  // U+202E turns the line round
  const Picture shown = picture(std::string("(\x1B[31m\0)", 8) + "(" + override + ")\tz");
  EXPECT_EQ(shown.line, std::string("    (") + kReplacement + "[31m" + kReplacement + ")(" +
                            kReplacement + ") z");
  EXPECT_EQ(shown.caret, carets(12));
}

TEST(Render, AHundredCellsAreShownWhole) {
  const std::string line = "(" + std::string(97, '-') + ")z";
  EXPECT_EQ(picture(line).line, "    " + line);
  EXPECT_EQ(picture(line).caret, carets(99));
}

TEST(Render, ALongLineIsCutAroundTheFault) {
  // Fault in cell 500 of 1001: cells 450 to 549 are shown, the fault behind 3 + 50 of them.
  const std::string line = "(" + std::string(498, '-') + ")z" + std::string(500, ' ');
  const Picture shown = picture(line);
  EXPECT_EQ(shown.line, "    ..." + std::string(49, '-') + ")z" + std::string(49, ' ') + "...");
  EXPECT_EQ(shown.caret, carets(53));
}

TEST(Render, ALongLineIsCutBehindAFaultAtItsHead) {
  const Picture shown = picture("z" + std::string(200, '-'));
  EXPECT_EQ(shown.line, "    z" + std::string(99, '-') + "...");
  EXPECT_EQ(shown.caret, carets(0));
}

std::string wide(int count) {
  std::string out;
  for (int i = 0; i < count; ++i) out += "\xE8\xBD\xAE";
  return out;
}

TEST(Render, AWideCharacterAcrossTheLeftEdgeIsLeftOut) {
  // 304 cells; the last 100 begin at 204, within the character of the cells 203 and 204. From 205
  // on there are 48 wide characters, '-', ')' and the fault in cell 303.
  const Picture shown = picture("(" + wide(150) + "-)z");
  EXPECT_EQ(shown.line, "    ..." + wide(48) + "-)z");
  EXPECT_EQ(shown.caret, carets(3 + 303 - 205));
}

TEST(Render, AWideCharacterAcrossTheRightEdgeIsLeftOut) {
  // Cell 0 is the fault; wide characters begin at odd cells, the one at 99 would end behind 100.
  EXPECT_EQ(picture("z" + wide(100)).line, "    z" + wide(49) + "...");
}

TEST(Render, ALineThatWasTooLongShowsTheEndOfWhatIsThere) {
  const Picture shown = picture(line_too_long(), std::string(kMaximumLine, '-'));
  EXPECT_EQ(shown.line, "    ..." + std::string(100, '-'));
  EXPECT_EQ(shown.caret, carets(103));
}

}  // namespace
}  // namespace gonogo::grammar
