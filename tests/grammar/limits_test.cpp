// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every byte, long lines and many words; and that a block which is reused allocates nothing.
#include <algorithm>

#include "grammar/line_source.hpp"
#include "tests/grammar/counting_new.hpp"
#include "tests/grammar/trees.hpp"

namespace gonogo::grammar {
namespace {

TEST(EveryByte, AloneInALine) {
  // A blank, a tab, '%', '/', ';' make a block; everything else is an error in the first column,
  // or, where an address or a bracket lacks what follows, behind it.
  for (int value = 0; value < 256; ++value) {
    const std::string line(1, static_cast<char>(value));
    const bool capital = value >= 'A' && value <= 'Z';
    const bool lower_case = value >= 'a' && value <= 'z';
    if (std::string_view(" \t%/;").find(line[0]) != std::string_view::npos) {
      parsed(line);
      continue;
    }
    if (value == '#') {  // a parameter of rs274, which has a number
      parsed(kLathes, line);
      EXPECT_EQ(fault(Dialect::rs274, line).code, SyntaxCode::number_expected);
      continue;
    }
    for (const Dialect dialect : kLetterAddress) {
      const bool any_case = dialect == Dialect::rs274;
      if (any_case && (value == 'o' || value == 'O')) {
        EXPECT_TRUE(parsed(dialect, line).outside);
        continue;
      }
      const bool polar = any_case && (value == '@' || value == '^');  // NGC-POL-01
      const bool letter = capital || (any_case && lower_case) || polar;
      const SyntaxError error = fault(dialect, line);
      EXPECT_EQ(error.where.begin, letter ? 1U : 0U) << value;
      EXPECT_EQ(error.code, letter         ? SyntaxCode::number_expected
                            : value == '(' ? SyntaxCode::unclosed_comment
                                           : SyntaxCode::unexpected_character)
          << value;
    }
  }
}

TEST(EveryByte, InsideComments) {
  for (int value = 0; value < 256; ++value) {
    const std::string byte(1, static_cast<char>(value));
    EXPECT_EQ(parsed("X1;" + byte).comments, (std::vector<Comment>{line_comment(byte)})) << value;
    if (byte == ")") continue;
    const Block block = parsed("(" + byte + ")X1");
    EXPECT_EQ(block.comments, (std::vector<Comment>{comment(byte)})) << value;
    EXPECT_EQ(block.words.size(), 1U) << value;
  }
}

TEST(EveryByte, BehindAnAddressIsANumberOrLocated) {
  for (int value = 0; value < 256; ++value) {
    const std::string line = "X" + std::string(1, static_cast<char>(value)) + "5";
    const bool number = value == ' ' || value == '\t' || value == '+' || value == '-' ||
                        value == '.' || (value >= '0' && value <= '9');
    if (number) {
      parsed(line);
    } else if (value == '#') {
      parsed(kLathes, line);
      parsed(Dialect::rs274, line);
    } else {
      for (const Dialect dialect : kLetterAddress) {
        const SyntaxError error = fault(dialect, line);
        EXPECT_EQ(error.where.begin, value == '[' ? 3U : 1U) << value;  // X[5 lacks its bracket
      }
    }
  }
}

TEST(Limits, TenThousandWords) {
  std::string line;
  for (int i = 0; i < 10000; ++i) line += "X" + std::to_string(i) + (i % 2 == 0 ? " " : "");
  const Block block = parsed(line);
  ASSERT_EQ(block.words.size(), 10000U);
  EXPECT_EQ(block.words[9999], word('X', 9999));
}

TEST(Limits, ANumberOfTenThousandDigits) {
  const std::string digits = "7" + std::string(9999, '3');
  const Decimal value =
      parsed("X-" + digits.substr(0, 4000) + "." + digits.substr(4000)).words[0].value;
  EXPECT_EQ(value, (Decimal{true, 6000, 0, digits}));
}

TEST(Limits, AMebibyteOfBracketsNeedsNoStack) {
  std::string line = "X" + std::string(kMaximumLine - 1, '[');
  EXPECT_EQ(fault(kLathes, line).expected, "']'");
  // A value of rs274 has at most 64 in each other.
  EXPECT_EQ(fault(Dialect::rs274, line).where.begin, 66U);
  std::fill(line.begin() + 1 + kMaximumLine / 2, line.end(), ']');
  EXPECT_EQ(fault(kLathes, line).where.begin, kMaximumLine);  // one bracket too few
  line.pop_back();
  line.erase(1, 1);
  line += ']';
  EXPECT_TRUE(parsed(kLathes, line).outside);
}

TEST(Limits, AMebibyteOfComments) {
  std::string line;
  while (line.size() + 2 <= kMaximumLine) line += "()";
  EXPECT_EQ(parsed(line).comments.size(), kMaximumLine / 2);
}

TEST(Allocation, ABlockThatIsReusedAllocatesNothing) {
  Block block;
  const auto run = [&block](Dialect dialect) {
    bool good = true;
    for (const char* line : {"N10 G01 X12.345 Z-6.789 F200", "/G110 X50 Z50 Y20 R-5 (short)", "",
                             "N1234 ; tail", "%", "X0000000000000000000001.5"}) {
      good = !parse_block(dialect, line, block) && good;
    }
    return good;
  };
  for (const Dialect dialect : kLetterAddress) {
    ASSERT_TRUE(run(dialect));
    const std::size_t before = allocation_count();
    const bool good = run(dialect);
    const std::size_t after = allocation_count();
    EXPECT_TRUE(good);
    EXPECT_EQ(after - before, 0U);
  }
}

TEST(Allocation, IsCounted) {
  const std::size_t before = allocation_count();
  const Block block = parsed("X1");
  EXPECT_GT(allocation_count(), before);
}

}  // namespace
}  // namespace gonogo::grammar
