// SPDX-License-Identifier: GPL-3.0-or-later
#include "subjects/line_buffer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "oracle/records/text.hpp"

namespace gonogo::oracle {
namespace {

void put(LineBuffer& buffer, std::string_view text) {
  while (!text.empty()) {
    const auto room = buffer.room();
    const std::size_t size = std::min(room.size(), text.size());
    std::copy_n(text.begin(), size, room.begin());
    buffer.commit(size);
    text.remove_prefix(size);
  }
}

TEST(LineBuffer, JoinsPiecesAndCutsLines) {
  LineBuffer buffer(100);
  put(buffer, "ab");
  EXPECT_FALSE(buffer.next());
  put(buffer, "c\n\nde\nf");
  EXPECT_EQ(buffer.next(), "abc");
  EXPECT_EQ(buffer.next(), "");
  EXPECT_EQ(buffer.next(), "de");
  EXPECT_FALSE(buffer.next());
  EXPECT_EQ(buffer.rest(), "f");
}

TEST(LineBuffer, ALineOfTheLimitPassesAndOneMoreDoesNot) {
  LineBuffer fits(3);
  put(fits, "abc\n");
  EXPECT_EQ(fits.next(), "abc");
  EXPECT_FALSE(fits.too_long());
  LineBuffer whole(3);
  put(whole, "abcd\n");
  EXPECT_FALSE(whole.next());
  EXPECT_TRUE(whole.too_long());
  LineBuffer coming(3);
  put(coming, "abcd");
  EXPECT_FALSE(coming.next());
  EXPECT_TRUE(coming.too_long());
}

TEST(LineBuffer, ManyShortLinesAreNotOneLongLine) {
  LineBuffer buffer(3);
  put(buffer, "ab\ncd\nef\n");
  EXPECT_EQ(buffer.next(), "ab");
  EXPECT_FALSE(buffer.too_long());
}

TEST(LineBuffer, KeepsALineLongerThanItsChunks) {
  LineBuffer buffer(10'000'000);
  const std::string text(5'000'000, 'a');
  put(buffer, "x\n" + text + "\ny\n");
  EXPECT_EQ(buffer.next(), "x");
  EXPECT_EQ(buffer.next(), text);
  EXPECT_EQ(buffer.next(), "y");
  EXPECT_TRUE(buffer.empty());
}

TEST(Text, Base64OfTheRfc) {  // RFC 4648 section 10
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Text, BadBytesBecomeReplacementCharactersOneByOne) {
  const std::string bad = "\xEF\xBF\xBD";
  EXPECT_EQ(readable("a\xFFz"), "a" + bad + "z");
  EXPECT_EQ(readable("\xE4\xB8\xAD"), "\xE4\xB8\xAD");
  EXPECT_EQ(readable("\xE4\xB8"), bad + bad);                      // cut
  EXPECT_EQ(readable("\xC0\xAF"), bad + bad);                      // overlong
  EXPECT_EQ(readable("\xED\xA0\x80"), bad + bad + bad);            // surrogate
  EXPECT_EQ(readable("\xF4\x90\x80\x80"), bad + bad + bad + bad);  // above U+10FFFF
}

TEST(Text, AnExcerptNeverCutsACharacter) {
  EXPECT_EQ(excerpt("ab\xE4\xB8\xAD", 3), "ab...");
  EXPECT_EQ(excerpt("ab", 2), "ab");
  EXPECT_EQ(excerpt("a\nb"), "a\\nb");
}

TEST(Text, ShellWordsAreQuoted) {
  EXPECT_EQ(shell_quoted("a'b $c"), "'a'\\''b $c'");
}

// ESC is U+001B; U+202E turns the writing, U+200B has no width, U+009B begins a sequence as ESC [.
TEST(Visible, WritesOutWhatMovesTheCursorTurnsTheWritingOrHides) {
  EXPECT_EQ(visible("a\nGO\r\t\x1B[2J"), "a\\nGO\\r\\t\\u{1b}[2J");
  // The sign stands in two parts, so that it does not turn the text of this file.
  const std::string turns = std::string("\xE2\x80") + "\xAE";
  EXPECT_EQ(visible(turns + "\u200B\u009B\x7F"), "\\u{202e}\\u{200b}\\u{9b}\\u{7f}");
  EXPECT_EQ(visible("\xC3\xA4 \xE4\xB8\xAD \xFF"), "\xC3\xA4 \xE4\xB8\xAD \xEF\xBF\xBD");
  EXPECT_EQ(visible("a\n\tb\x1B", Lines::kept), "a\n\tb\\u{1b}");
}

}  // namespace
}  // namespace gonogo::oracle
