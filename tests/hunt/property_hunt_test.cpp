// SPDX-License-Identifier: GPL-3.0-or-later
#include "hunt/property_hunt.hpp"

#include <gtest/gtest.h>

#include "expanders/registry.hpp"
#include "hunt/kill_matrix.hpp"
#include "oracle/subject.hpp"
#include "program/text.hpp"

namespace gonogo::hunt::testing {
namespace {

SubjectMaker subject_of(const char* name, const char* fault = "") {
  const gonogo_subject_v1* subject = expanders::find(name, fault);
  return [subject] { return oracle::make_interface_subject(*subject); };
}

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
    PropertyHunt hunt(subject_of(std::string(generator.expander).c_str()),
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
  PropertyHunt hunt(subject_of("ngc", "offsets-absolute"), property_hunting("rs274"));
  auto finding = first_finding(hunt, 2'000);
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->relation->name, "translation");
  const std::string signature = finding->signature();
  hunt.reduce(*finding, {});
  EXPECT_EQ(finding->signature(), signature);
  EXPECT_LE(program::count_blocks(finding->program.text), 3U);
}

TEST(PropertyHunt, TellsOneSignatureOnce) {
  PropertyHunt hunt(subject_of("ngc", "offsets-absolute"), property_hunting("rs274"));
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
                            subject_of("ngc", "offsets-absolute"),
                            subject_of("ngc")};
  const MatrixTarget sound{"ngc", "", {"rs274"}, subject_of("ngc"), subject_of("ngc")};
  EXPECT_TRUE(matrix_row(faulty, options).kills.at(Method::properties).killed);
  EXPECT_FALSE(matrix_row(sound, options).kills.at(Method::properties).killed);
  options.blind = true;
  const MatrixRow blind = matrix_row(faulty, options);
  EXPECT_FALSE(blind.kills.at(Method::properties).killed);
  EXPECT_FALSE(complaints({blind}, options.methods).empty());
}

}  // namespace
}  // namespace gonogo::hunt::testing
