// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/property_hunt.hpp"

#include <gtest/gtest.h>

#include "fuzz/hunt/kill_matrix.hpp"
#include "fuzz/program/text.hpp"
#include "hunting.hpp"

namespace gonogo::hunt::testing {
namespace {

PropertyOptions property_hunting(const std::string& dialect) {
  PropertyOptions options;
  options.dialect = dialect;
  return options;
}

std::optional<PropertyFinding> first_finding(PropertyHunt& hunt, std::size_t programs) {
  for (std::size_t i = 0; i < programs; ++i) {
    if (auto finding = hunt.step()) return finding;
  }
  return std::nullopt;
}

TEST(PropertyHunt, FindsNothingWhereThereIsNoFault) {
  for (const generate::Generator& generator : generate::generators()) {
    PropertyHunt hunt(builtin(std::string(generator.expander).c_str()),
                      property_hunting(std::string(generator.dialect)));
    const auto finding = first_finding(hunt, 300);
    EXPECT_FALSE(finding) << generator.dialect << " " << finding->signature() << "\n"
                          << finding->program.text << "\n"
                          << finding->other.text << "\n"
                          << finding->difference.want << "\n"
                          << finding->difference.got;
    EXPECT_GT(hunt.count().pairs, 1'000U);
  }
}

// I J K as absolute: an arc elsewhere has another radius, or none.
TEST(PropertyHunt, FindsWhatDependsOnThePlaceAndMakesItSmall) {
  PropertyHunt hunt(builtin("ngc", "offsets-absolute"), property_hunting("rs274"));
  auto finding = first_finding(hunt, 2'000);
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->relation->name, "translation");
  const std::string signature = finding->signature();
  hunt.reduce(*finding, {});
  EXPECT_EQ(finding->signature(), signature);
  EXPECT_LE(program::count_blocks(finding->program.text), 3U);
}

// A program that shows a planted fault by a relation alone, without the reference.
struct Shown {
  const char* expander;
  const char* fault;
  const char* dialect;
  const char* program;
  const char* relation;
  std::size_t variant;
};

bool shows(const Shown& shown, const char* fault) {
  PropertyHunt hunt(builtin(shown.expander, fault), property_hunting(shown.dialect));
  return hunt.differs({defaults(shown.dialect), shown.program},
                      *relations::find_relation(shown.relation), shown.variant);
}

// J-PROP-11: F10 under G20 is F254 under G21. J-PROP-11: the arc of G17 in G18. J-PROP-11: X4
// behind X10 is U-6. J-PROP-11: the halves of line 3 say
// line 3. J-PROP-11: L2 is two blocks.
TEST(PropertyHunt, FindsPlantedFaultsByEachRewriting) {
  for (const Shown& shown : std::to_array<Shown>({
           {"gsk", "inch-feed", "gsk988ta", "G20\nG01 X1 F10\nM30\n", "units", 0},
           {"ngc", "inch-feed-unscaled", "rs274", "G20\nG1 X1 F10\nM2\n", "units", 0},
           {"ngc", "inch-r-unscaled", "rs274", "G81 X1 R2 Z-3 F9\nM2\n", "units", 1},
           {"ngc", "g18-sense-flipped", "rs274", "G17 G2 X1 R4 F9\nM2\n", "planes", 1},
           {"sinumerik", "g18-sense-flipped", "sinumerik840d", "G17\nG2 X1 Y0 CR=4 F9\nM30\n",
            "planes", 1},
           {"gsk", "increment-as-radius", "gsk988ta", "G00 X10 Z5\nG01 X4 F9\nM30\n", "increments",
            0},
           {"hnc", "blank-lines-not-counted", "hnc21t", "\nG00 X10\nG01 Z-5 F9\nS500\nM30\n",
            "halves", 0},
           {"ngc", "l-ignored", "rs274", "G98\nG91 G81 X1 R-2 Z-3 L2 F9\nM2\n", "repeats", 0},
           {"ngc", "l-in-place", "rs274", "G98\nG91 G81 X1 R-2 Z-3 L2 F9\nM2\n", "repeats", 0},
       })) {
    EXPECT_TRUE(shows(shown, shown.fault)) << shown.expander << "+" << shown.fault;
    EXPECT_FALSE(shows(shown, "")) << shown.expander << " " << shown.relation;
  }
}

TEST(PropertyHunt, TellsOneSignatureOnce) {
  PropertyHunt hunt(builtin("ngc", "offsets-absolute"), property_hunting("rs274"));
  std::set<std::string> signatures;
  for (int i = 0; i < 500; ++i) {
    const auto finding = hunt.step();
    if (!finding) continue;
    EXPECT_TRUE(signatures.insert(finding->signature()).second);
  }
  EXPECT_GT(hunt.count().different, signatures.size());
}

TEST(PropertyHunt, IsAMethodOfTheKillMatrix) {
  MatrixOptions options;
  options.methods = {Method::properties};
  options.most_seconds = 1;
  options.clean_programs = 50;
  const MatrixTarget faulty{"ngc+offsets-absolute",
                            "NGC-ARC-02",
                            {"rs274"},
                            builtin("ngc", "offsets-absolute"),
                            builtin("ngc")};
  const MatrixTarget sound{"ngc", "", {"rs274"}, builtin("ngc"), builtin("ngc")};
  EXPECT_TRUE(matrix_row(faulty, options).kills.at(Method::properties).killed);
  EXPECT_FALSE(matrix_row(sound, options).kills.at(Method::properties).killed);
  options.blind = true;
  const MatrixRow blind = matrix_row(faulty, options);
  EXPECT_FALSE(blind.kills.at(Method::properties).killed);
  EXPECT_FALSE(complaints({blind}, options.methods).empty());
}

}  // namespace
}  // namespace gonogo::hunt::testing
