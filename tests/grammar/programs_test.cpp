// SPDX-License-Identifier: GPL-3.0-or-later
//
// The example programs of the maker's manual, read whole.
#include "grammar/line_source.hpp"
#include "tests/grammar/trees.hpp"

namespace gonogo::grammar {
namespace {

std::vector<Block> program(std::string_view text) {
  MemorySource bytes(text);
  LineSource lines(bytes);
  std::vector<Block> out;
  for (Line line; lines.next(line);) out.push_back(parsed(line.text));
  return out;
}

std::string addresses(const Block& block) {
  std::string out;
  for (const Word& word : block.words) out.push_back(word.address);
  return out;
}

TEST(ManualPrograms, FaceAndTaperCycleG94) {
  const auto blocks = program(
      "G00 X130 Z5 M3 S500;\n"
      "G94 X0 Z0 F200;\n"
      "X120 Z-110 F300;\n"
      "G00 X120 Z0;\n"
      "G94 X108 Z-30 R-10;\n"
      "X96 R-20;\n"
      "X84 R-30;\n"
      "X72 R-40;\n"
      "X60 R-50;\n"
      "M30;\n");
  ASSERT_EQ(blocks.size(), 10U);
  EXPECT_EQ(blocks[0],
            block_of({word('G', 0), word('X', 130), word('Z', 5), word('M', 3), word('S', 500)}));
  EXPECT_EQ(blocks[5], block_of({word('X', 96), word('R', -20)}));
  EXPECT_EQ(blocks[9], block_of({word('M', 30)}));
}

TEST(ManualPrograms, CircularPocketG110) {
  const auto blocks = program(
      "N100 G18 G0 X70 Z70 Y50\r\n"
      "N110 G110 X50 Z50 Y20 R-5 I16 L3 Q5 P1 D4 F800\r\n");
  ASSERT_EQ(blocks.size(), 2U);
  EXPECT_EQ(blocks[0].sequence_number, decimal(100));
  EXPECT_EQ(addresses(blocks[0]), "GGXZY");
  EXPECT_EQ(blocks[1].sequence_number, decimal(110));
  EXPECT_EQ(addresses(blocks[1]), "GXZYRILQPDF");
  EXPECT_EQ(blocks[1].words[4], word('R', -5));
}

TEST(ManualPrograms, HelicalPocketG112) {
  const auto blocks = program("G00 X70 Z70 Y30\nG18\nG112 X70 Z70 Y20 I8 L5 D4 F200");
  ASSERT_EQ(blocks.size(), 3U);
  EXPECT_EQ(blocks[2], block_of({word('G', 112), word('X', 70), word('Z', 70), word('Y', 20),
                                 word('I', 8), word('L', 5), word('D', 4), word('F', 200)}));
}

TEST(ManualPrograms, ThreadMillingG114AndG116) {
  const auto blocks = program(
      "G0 X70 Z70 Y20\nG18\nG114 X0 Z0 V-20 R-5 I5 J2 K30 E30 P1 Q0.5 D3 F900\n"
      "G0 X70 Z70 Y30\nG18\nG116 X70 Z70 V-20 R-5 I5 J2 K30 E15 P1 Q0.5 D3 F900\n");
  ASSERT_EQ(blocks.size(), 6U);
  EXPECT_EQ(addresses(blocks[2]), "GXZVRIJKEPQDF");
  EXPECT_EQ(blocks[2].words[10], word('Q', 5, 1));
  EXPECT_EQ(blocks[5].words[8], word('E', 15));
}

TEST(ManualPrograms, TypicalFrameOfAProgram) {
  const auto blocks = program(
      "%\nO0001(\xE7\xAB\xAF\xE9\x9D\xA2)\nN10 G50 X0 Z0\n/N20 M08\n\nM98 P[T123]\nM30\n%\n");
  ASSERT_EQ(blocks.size(), 8U);
  EXPECT_TRUE(blocks[0].tape_mark);
  EXPECT_EQ(blocks[1].program_number, decimal(1));
  EXPECT_TRUE(blocks[3].skip);
  EXPECT_EQ(blocks[4], Block{});
  EXPECT_EQ(blocks[5].outside->name, "file-name");
  EXPECT_TRUE(blocks[7].tape_mark);
}

TEST(ManualPrograms, ABadLineDoesNotTouchTheNext) {
  MemorySource bytes("G1 X1\nG1 (X\nG1 X2\n");
  LineSource lines(bytes);
  std::vector<bool> good;
  Block block;
  for (Line line; lines.next(line);) {
    good.push_back(!parse_block(Dialect::gsk988ta, line.text, block));
  }
  EXPECT_EQ(good, (std::vector<bool>{true, false, true}));
  EXPECT_EQ(block, block_of({word('G', 1), word('X', 2)}));
}

}  // namespace
}  // namespace gonogo::grammar
