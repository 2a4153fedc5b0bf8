// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/report/escape.hpp"

#include <gtest/gtest.h>

#include "oracle/records/text.hpp"

namespace gonogo::oracle::report {
namespace {

TEST(MarkupText, has_no_markup_left) {
  EXPECT_EQ(markup_text("<b a='\"'>&"), "&lt;b a=&#39;&quot;&#39;&gt;&amp;");
}

TEST(MarkupText, keeps_utf8) {
  EXPECT_EQ(markup_text("\xE5\x88\x80"), "\xE5\x88\x80");
}

// A GBK byte pair, an overlong '/', a control character and a cut sequence.
TEST(MarkupText, replaces_what_xml_cannot_hold) {
  const std::string lost = "\xEF\xBF\xBD";
  EXPECT_EQ(markup_text("\xB5\xB6"), lost + lost);
  EXPECT_EQ(markup_text("\xC0\xAF"), lost + lost);
  EXPECT_EQ(markup_text("\x01"), "\\u{1}");
  EXPECT_EQ(markup_text("a\xE2\x80\x8B"), "a\\u{200b}");
  EXPECT_EQ(markup_text("\xE5\x88"), lost + lost);
}

TEST(ScriptJson, cannot_end_the_script_element) {
  EXPECT_EQ(script_json(R"("</script><!--&")"), R"("\u003c/script\u003e\u003c!--\u0026")");
}

TEST(Shortened, counts_characters_not_bytes) {
  EXPECT_EQ(shortened("\xE5\x88\x80xyz", 2), "\xE5\x88\x80x\xE2\x80\xA6");
  EXPECT_EQ(shortened("abc", 3), "abc");
}

// RFC 4648 section 10.
TEST(DecodeBase64, reads_the_vectors_of_the_rfc) {
  EXPECT_EQ(decode_base64(""), "");
  EXPECT_EQ(decode_base64("Zg=="), "f");
  EXPECT_EQ(decode_base64("Zm8="), "fo");
  EXPECT_EQ(decode_base64("Zm9vYmFy"), "foobar");
}

TEST(DecodeBase64, refuses_what_is_not_base64) {
  EXPECT_FALSE(decode_base64("Zg="));
  EXPECT_FALSE(decode_base64("Z*=="));
  EXPECT_FALSE(decode_base64("===="));
}

// "foob" is 66 6f 6f 62.
TEST(Base64OfHex, writes_what_the_rfc_says) {
  EXPECT_EQ(base64_of_hex("666f6f62"), "Zm9vYg==");
  EXPECT_EQ(base64_of_hex("666F6F626172"), "Zm9vYmFy");
}

}  // namespace
}  // namespace gonogo::oracle::report
