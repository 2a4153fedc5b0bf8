// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs read whole: examples of the GSK manual, and programs in every form of line that programs
// for HNC controls were seen to have.
#include "grammar/line_source.hpp"
#include "tests/grammar/trees.hpp"

namespace gonogo::grammar {
namespace {

std::vector<Block> program(Dialect dialect, std::string_view text) {
  MemorySource bytes(text);
  LineSource lines(bytes);
  std::vector<Block> out;
  for (Line line; lines.next(line);) out.push_back(parsed(dialect, line.text));
  return out;
}

std::string addresses(const Block& block) {
  std::string out;
  for (const Word& word : block.words) out.push_back(word.address);
  return out;
}

TEST(GskPrograms, FaceAndTaperCycleG94) {
  const auto blocks = program(Dialect::gsk988ta,
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

TEST(GskPrograms, CircularPocketG110) {
  const auto blocks = program(Dialect::gsk988ta,
                              "N100 G18 G0 X70 Z70 Y50\r\n"
                              "N110 G110 X50 Z50 Y20 R-5 I16 L3 Q5 P1 D4 F800\r\n");
  ASSERT_EQ(blocks.size(), 2U);
  EXPECT_EQ(blocks[0].sequence_number, decimal(100));
  EXPECT_EQ(addresses(blocks[0]), "GGXZY");
  EXPECT_EQ(blocks[1].sequence_number, decimal(110));
  EXPECT_EQ(addresses(blocks[1]), "GXZYRILQPDF");
  EXPECT_EQ(blocks[1].words[4], word('R', -5));
}

TEST(GskPrograms, HelicalPocketG112) {
  const auto blocks =
      program(Dialect::gsk988ta, "G00 X70 Z70 Y30\nG18\nG112 X70 Z70 Y20 I8 L5 D4 F200");
  ASSERT_EQ(blocks.size(), 3U);
  EXPECT_EQ(blocks[2], block_of({word('G', 112), word('X', 70), word('Z', 70), word('Y', 20),
                                 word('I', 8), word('L', 5), word('D', 4), word('F', 200)}));
}

TEST(GskPrograms, ThreadMillingG114AndG116) {
  const auto blocks =
      program(Dialect::gsk988ta,
              "G0 X70 Z70 Y20\nG18\nG114 X0 Z0 V-20 R-5 I5 J2 K30 E30 P1 Q0.5 D3 F900\n"
              "G0 X70 Z70 Y30\nG18\nG116 X70 Z70 V-20 R-5 I5 J2 K30 E15 P1 Q0.5 D3 F900\n");
  ASSERT_EQ(blocks.size(), 6U);
  EXPECT_EQ(addresses(blocks[2]), "GXZVRIJKEPQDF");
  EXPECT_EQ(blocks[2].words[10], word('Q', 5, 1));
  EXPECT_EQ(blocks[5].words[8], word('E', 15));
}

TEST(GskPrograms, TypicalFrameOfAProgram) {
  const auto blocks = program(
      Dialect::gsk988ta,
      "%\nO0001(\xE7\xAB\xAF\xE9\x9D\xA2)\nN10 G50 X0 Z0\n/N20 M08\n\nM98 P[T123]\nM30\n%\n");
  ASSERT_EQ(blocks.size(), 8U);
  EXPECT_TRUE(blocks[0].tape_mark);
  EXPECT_EQ(blocks[1].program_number, decimal(1));
  EXPECT_TRUE(blocks[3].skip);
  EXPECT_EQ(blocks[4], Block{});
  EXPECT_EQ(blocks[5].outside->name, "file-name");
  EXPECT_TRUE(blocks[7].tape_mark);
}

struct Form {
  const char* line;
  const char* addresses;  // of its words, in their order
};

void expect_forms(const std::vector<Form>& program) {
  for (const Form& expected : program) {
    const Block block = parsed(Dialect::hnc21t, expected.line);
    EXPECT_EQ(addresses(block), expected.addresses) << expected.line;
    EXPECT_EQ(block.sequence_number.has_value(), expected.line[0] == 'N') << expected.line;
    EXPECT_FALSE(block.outside) << expected.line;
  }
}

TEST(HncPrograms, HeadsAreATapeMarkAndANumberOrANumberAlone) {
  const auto marked = program(Dialect::hnc21t, "%\nO0417\nT0101\nM30\n%\n");
  ASSERT_EQ(marked.size(), 5U);
  EXPECT_TRUE(marked[0].tape_mark);
  EXPECT_EQ(marked[1].program_number, decimal(417));
  EXPECT_TRUE(marked[4].tape_mark);
  const auto alone = program(Dialect::hnc21t, "%0417\r\nN1 T0101\r\nN2 M30\r\n");
  ASSERT_EQ(alone.size(), 3U);
  EXPECT_FALSE(alone[0].tape_mark);
  EXPECT_EQ(alone[0], marked[1]);
}

TEST(HncPrograms, TaperCycleRepeatedByItsAxisWords) {
  const auto blocks = program(Dialect::hnc21t,
                              "%2101\n"
                              "N2 G90 G00 X60 Z3 M03\n"
                              "N3 G80 X48.5 Z-20I-4.5 F150\n"
                              "N4 X46 Z-20I-4.5\n"
                              "N5 X44.25 Z-20 I-4.5\n"
                              "N6 X43 Z20I-4.5 F 60\n"
                              "N7 G00 X80 Z50\n");
  ASSERT_EQ(blocks.size(), 7U);
  EXPECT_EQ(blocks[2].words, (std::vector<Word>{word('G', 80), word('X', 485, 1), word('Z', -20),
                                                word('I', -45, 1), word('F', 150)}));
  EXPECT_EQ(blocks[3].words, (std::vector<Word>{word('X', 46), word('Z', -20), word('I', -45, 1)}));
  EXPECT_EQ(blocks[5].words,
            (std::vector<Word>{word('X', 43), word('Z', 20), word('I', -45, 1), word('F', 60)}));
}

TEST(HncPrograms, WordsRunTogetherInOneBlockAndNotInTheNext) {
  const auto blocks = program(Dialect::hnc21t,
                              "%18\nN1 G92X60Z120\nN2 G37G01X12W-30\nN3 U8Z40\nN4 G00X60Z120\n"
                              "N05 G55G00G91X4Z2\nN6 X-3Z11\nN7 X6Z7\nN8 X5W9\nN9 X-4Z-9\n"
                              "N010 G56\n");
  ASSERT_EQ(blocks.size(), 11U);
  EXPECT_EQ(addresses(blocks[1]), "GXZ");
  EXPECT_EQ(blocks[2].words,
            (std::vector<Word>{word('G', 37), word('G', 1), word('X', 12), word('W', -30)}));
  EXPECT_EQ(addresses(blocks[3]), "UZ");
  EXPECT_EQ(addresses(blocks[5]), "GGGXZ");
  EXPECT_EQ(blocks[10].sequence_number, decimal(10));
}

TEST(HncPrograms, FormsOfTurning) {
  expect_forms({{"N1 T0303", "T"},
                {"N2 M04 S650", "MS"},
                {"N3 G00 X72 Z6", "GXZ"},
                {"N3 G90 G00 X68 Z5", "GGXZ"},
                {"N4 X65", "X"},
                {"N5 Z2", "Z"},
                {"N6 G01 X24 Z1 F90", "GXZF"},
                {"N7 G01 X28 Z-4", "GXZ"},
                {"N8 Z-35", "Z"},
                {"N9 X40 Z-41", "XZ"},
                {"N10 G01 X-2 F70", "GXF"},
                {"N11 G01 Z1 F45", "GZF"},
                {"N12 G01 X33 F12", "GXF"},
                {"N13 G04 P2500", "GP"},
                {"N14 G01 X36", "GX"},
                {"N15 G00 Z4", "GZ"},
                {"N16 G01 Z-27", "GZ"},
                {"N17 X62 Z8", "XZ"},
                {"N18 U18", "U"},
                {"N19 W-13", "W"},
                {"N20 U-9", "U"},
                {"N21 U-7 W4", "UW"},
                {"N22 U12 W-6", "UW"},
                {"N23 G01 W-11", "GW"},
                {"N24 G01 U11 Z-3 F75", "GUZF"},
                {"N25 G00 X90 Z90 M05", "GXZM"},
                {"N26 G91", "G"},
                {"N27 M05", "M"},
                {"N28 M30", "M"}});
}

TEST(HncPrograms, FormsOfArcs) {
  expect_forms({{"N1 G03 U16 W-8 R8", "GUWR"},
                {"N2 G02 U-6 W3 R3", "GUWR"},
                {"N3 G03 U21 W-10.5 R11", "GUWR"},
                {"N4 G02 X32 Z-25 R6", "GXZR"},
                {"G91 G02 X20 Y20 R20 F250", "GGXYRF"},
                {"G91 G03 X20 Y20 R-20 F250", "GGXYRF"},
                {"G90 G02 X0 Y20 I20 J0 F250", "GGXYIJF"}});
}

TEST(HncPrograms, FormsOfSimpleCyclesAndThreads) {
  expect_forms({{"N1 G81 X18 Z31 K-5 F110", "GXZKF"},
                {"N2 X18 Z29 K-5", "XZK"},
                {"N3 X18 Z28 K-5 F55", "XZKF"},
                {"N4 G80 X42.25 Z-22 I-1.5 F95", "GXZIF"},
                {"N5 X38 Z-22 I-1.5", "XZI"},
                {"N6 X37 Z-22 I-1.5 F45", "XZIF"},
                {"N7 X36.5 Z-22I-1.5", "XZI"},
                {"N8 G82 X33.2 Z-38 F3", "GXZF"},
                {"N8 G82 X33 Z-38 F3", "GXZF"},
                {"N9 X32.6 Z-38", "XZ"},
                {"N10 X32 Z-38", "XZ"},
                {"N11 G00 X31.4 Z88.5", "GXZ"},
                {"N12 G32 Z21 F1.75", "GZF"},
                {"N13 Z88.5", "Z"},
                {"N14 X30.8", "X"},
                {"N15 U-13.24", "U"},
                {"N16 G32 W-67.5 F1.75", "GWF"}});
}

TEST(HncPrograms, FormsOfCompoundCycles) {
  expect_forms({{"N1 G71 U1 R2 P7 Q19 X0.6 Z0.2 F130", "GURPQXZF"},
                {"N2 G72 W1.2 R2 P7 Q19 X0.3 Z0.4 F130", "GWRPQXZF"},
                {"N3 G73 U4 W1.1 R5", "GUWR"},
                {"N4 G73 P7 Q19 U0.8 W0.2 F140", "GPQUWF"},
                {"N5 G70 P7 Q19", "GPQ"},
                {"N6 G76 P031260 Q90 R0.2", "GPQR"},
                {"N7 G76 X46.35 Z-19 R-0.75 P1.083 F3", "GXZRPF"}});
}

TEST(HncPrograms, FormsOfMilling) {
  expect_forms({{"N10 G92 X-12 Y-15 Z60", "GXYZ"},
                {"N20 G90 G17", "GG"},
                {"N30 G41 G00 X6 Y14 D02 Z3 M04 S700", "GGXYDZMS"},
                {"N40 G01 Z-8 F450", "GZF"},
                {"N50 G03 X35 Y25 I0 J12", "GXYIJ"},
                {"N60 G01 X12 Y18", "GXY"},
                {"N70 Y6", "Y"},
                {"N80 G00 Z55 M05", "GZM"},
                {"N90 G40 X-12 Y-15", "GXY"},
                {"N100 G00 G54 G90 X35 Y25 Z60 M03 S900", "GGGXYZMS"},
                {"N105 G00 G55 G90 X30 Y20 Z55 M04 S750;", "GGGXYZMS"},
                {"N110 G54 G90 G00 X-25 Y-18 Z12 M03 S900;", "GGGXYZMS"},
                {"N120 G42 D03 G01 X8 Y-12 F175;", "GDGXYF"},
                {"N130 G98 G81 X35 Y25 Z-7 R12 F95;", "GGXYZRF"},
                {"N140 G01 Y32;", "GY"},
                {"N150 G01 X18 Y42;", "GXY"},
                {"N160 G01 X24.6;", "GX"},
                {"N170 G02 X55.1 Y38 R18;", "GXYR"},
                {"N180 G03 X71 Y33.5 R18;", "GXYR"},
                {"N190 G01 X-6;", "GX"},
                {"N200 G01 X82;", "GX"},
                {"N210 G00 Z90;", "GZ"},
                {"N220 G40;", "G"},
                {"N230 M05;", "M"}});
}

TEST(Programs, ABadLineDoesNotTouchTheNext) {
  for (const Dialect dialect : kLetterAddress) {
    MemorySource bytes("G1 X1\nG1 (X\nG1 X2\n");
    LineSource lines(bytes);
    std::vector<bool> good;
    Block block;
    for (Line line; lines.next(line);) {
      good.push_back(!parse_block(dialect, line.text, block));
    }
    EXPECT_EQ(good, (std::vector<bool>{true, false, true}));
    EXPECT_EQ(block, block_of({word('G', 1), word('X', 2)}));
  }
}

}  // namespace
}  // namespace gonogo::grammar
