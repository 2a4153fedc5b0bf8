// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/supported_features.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <sstream>

#include "fuzz/program/features.hpp"
#include "hunting.hpp"

namespace gonogo::hunt::testing {
namespace {

using Features = std::set<std::string>;

// Of a subject that does not say what it does.
oracle::SubjectInfo silent(oracle::SubjectInfo info) {
  info.dialects.clear();
  info.everything = true;
  return info;
}

// A built-in expander that does these features on the default machine and no others, as a vendor's
// does; it may say so when it starts, or keep it to itself.
class PartialSubject : public WrappedSubject {
 public:
  PartialSubject(std::unique_ptr<oracle::Subject> whole, Features does, bool says_so)
      : WrappedSubject(std::move(whole)),
        does_(std::move(does)),
        info_(silent(WrappedSubject::info())) {
    if (says_so) info_.dialects = {{"gsk988ta", does_}};
    info_.everything = !says_so;
  }
  const oracle::SubjectInfo& info() const override { return info_; }
  void configure(const reference::Profile& profile) override {
    profile_ = profile;
    WrappedSubject::configure(profile);
  }
  oracle::RunEnd run(std::string_view id, std::string_view program,
                     const oracle::RecordSink& sink) override {
    const auto needed = program::features_needed({profile_, program});
    if (!std::ranges::includes(does_, needed) || !(profile_ == defaults("gsk988ta"))) {
      return oracle::RunEnd::of(oracle::RunEnd::Kind::skip, "not this");
    }
    return WrappedSubject::run(id, program, sink);
  }

 private:
  Features does_;
  oracle::SubjectInfo info_;
  reference::Profile profile_;
};

SubjectMaker partial(Features does, bool says_so, const char* fault = "") {
  return [does = std::move(does), says_so, make = builtin("gsk", fault)] {
    return std::make_unique<PartialSubject>(make(), does, says_so);
  };
}

double judged_part(Hunt& hunt, std::size_t programs) {
  for (std::size_t i = 0; i < programs; ++i) hunt.step();
  const HuntCount& count = hunt.count();
  return static_cast<double>(count.judged) / static_cast<double>(count.programs);
}

TEST(SupportedFeatures, ASubjectThatDoesAPartAndDoesNotSaySoIsJudgedOnNineOfTenPrograms) {
  const std::vector<Features> parts = {{"basic", "g94"}, {"basic", "g90", "g92"}, {"basic"}};
  for (const Features& does : parts) {
    Hunt hunt(partial(does, false), {}, hunting("gsk988ta"));
    EXPECT_GE(judged_part(hunt, 4'000), 0.9)
        << *does.rbegin() << ": left out " << hunt.supported().left_out();
  }
}

TEST(SupportedFeatures, ASubjectThatDeclaresAPartIsJudgedOnNineOfTenPrograms) {
  Hunt hunt(partial({"basic", "g94"}, true), {}, hunting("gsk988ta"));
  EXPECT_GE(judged_part(hunt, 4'000), 0.9) << hunt.supported().left_out();
}

// What stands around a cycle is asked of a subject that declares the cycle alone.
TEST(SupportedFeatures, ACycleAloneIsHuntedInItsOwnPrograms) {
  Hunt hunt(partial({"g94"}, true, "taper-sign"), {}, hunting("gsk988ta"));
  EXPECT_GE(judged_part(hunt, 1'000), 0.9) << hunt.supported().left_out();
  EXPECT_GT(hunt.count().no_go, 0U);
}

TEST(SupportedFeatures, TheFaultOfAPartIsFound) {
  for (const bool says_so : {false, true}) {
    Hunt hunt(partial({"basic", "g94"}, says_so, "taper-sign"), {}, hunting("gsk988ta"));
    bool found = false;
    for (std::size_t i = 0; i < 4'000 && !found; ++i) {
      const auto finding = hunt.step();
      found = finding && finding->reproducer.program.text.find("94") != std::string::npos;
    }
    EXPECT_TRUE(found) << (says_so ? "declared" : "not declared") << ", left out "
                       << hunt.supported().left_out();
  }
}

TEST(SupportedFeatures, LeavesTheProgramsOfASubjectThatDoesEverythingAlone) {
  SupportedFeatures supported(silent({}), "gsk988ta");
  const auto program = gsk("(any) G0 X1 Z2 Q9\nG115 X10 Z-5 ?\n");
  supported.ran(program);
  EXPECT_EQ(supported.fitted(program)->text, program.text);
}

// What a first subject in a few lines of shell takes: G0 and G1 with their words in one order and
// one blank between them, F with G1 alone and whole, M2 alone; on the default machine. It says so
// of nothing.
bool is_line(const std::string& line) {
  static const std::regex kMove(
      R"((G0|G1)( X-?\d+(\.\d+)?)?( Y-?\d+(\.\d+)?)?( Z-?\d+(\.\d+)?)?( F[1-9]\d*)?)");
  if (line.find_first_not_of(" \t") == std::string::npos || line == "M2") return true;
  const std::size_t feed = line.find(" F");
  const bool is_cut = line.starts_with("G1");
  return std::regex_match(line, kMove) && is_cut == (feed != std::string::npos) &&
         line.size() > 2 && feed != 2;
}

class LineSubject : public WrappedSubject {
 public:
  explicit LineSubject(std::unique_ptr<oracle::Subject> whole)
      : WrappedSubject(std::move(whole)), info_(silent(WrappedSubject::info())) {}
  const oracle::SubjectInfo& info() const override { return info_; }
  void configure(const reference::Profile& profile) override {
    is_default_ = profile == defaults("rs274");
    WrappedSubject::configure(profile);
  }
  oracle::RunEnd run(std::string_view id, std::string_view program,
                     const oracle::RecordSink& sink) override {
    if (is_default_ && takes(program)) return WrappedSubject::run(id, program, sink);
    return oracle::RunEnd::of(oracle::RunEnd::Kind::skip, "not supported");
  }

 private:
  // Up to its M2.
  static bool takes(std::string_view program) {
    std::istringstream lines{std::string(program)};
    for (std::string line; std::getline(lines, line);) {
      if (!is_line(line)) return false;
      if (line == "M2") return true;
    }
    return true;
  }

  oracle::SubjectInfo info_;
  bool is_default_ = true;
};

SubjectMaker lines_only(const char* fault = "") {
  return [make = builtin("ngc", fault)] { return std::make_unique<LineSubject>(make()); };
}

TEST(SupportedFeatures, ASubjectThatTakesItsWordsInOneOrderOnlyIsJudgedOnNineOfTenPrograms) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    Hunt hunt(lines_only(), {}, hunting("rs274", seed));
    EXPECT_GE(judged_part(hunt, 5'000), 0.9)
        << "seed " << seed << ": left out " << hunt.supported().left_out();
    const HuntCount& count = hunt.count();
    EXPECT_GE(count.moved * 2, count.programs) << "seed " << seed;
    EXPECT_EQ(count.no_go, 0U) << "seed " << seed;
  }
}

// Each of G0 and G1 is skipped with what the other needs: both have to come in for the fault.
TEST(SupportedFeatures, TheFaultOfASubjectThatTakesItsWordsInOneOrderOnlyIsFound) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
    Hunt hunt(lines_only("feed-after-motion"), {}, hunting("rs274", seed));
    bool found = false;
    for (std::size_t i = 0; i < 10'000 && !found; ++i) {
      const auto finding = hunt.step();
      found = finding && finding->signature.code == "G1";
    }
    EXPECT_TRUE(found) << "seed " << seed << ": left out " << hunt.supported().left_out();
  }
}

generate::GeneratedProgram program(const char* text) {
  return {defaults("rs274"), text};
}

// A subject that says nothing of itself has skipped enough for what it does to be learned.
SupportedFeatures that_saw_much_skipped() {
  SupportedFeatures supported(silent({}), "rs274");
  for (int i = 0; i < 3; ++i) supported.skipped(program("N5 G1 X9 (all of it)\n"));
  return supported;
}

// G1 with F runs and G1 alone does not: neither is to blame, but that they do not stand together.
TEST(SupportedFeatures, LeavesOutWhatMayNotStandTogether) {
  SupportedFeatures supported = that_saw_much_skipped();
  supported.ran(program("G0 X1\nG1 X9 F100\nM2\n"));
  for (int i = 0; i < 2; ++i) supported.skipped(program("G1 X9\nM2\n"));
  for (int i = 0; i < 61; ++i) supported.ran(program("G0 X1\nG1 X9 F100\nM2\n"));
  EXPECT_EQ(supported.fitted(program("G0 X1\nG1 X9\nG1 X7 F50\nM2\n"))->text,
            "G0 X1\nG1 X7 F50\nM2\n");
}

// Ways to write that a subject skips are written otherwise: no word is lost for them.
TEST(SupportedFeatures, WritesPlainlyWhatASubjectDoesNotRead) {
  SupportedFeatures supported = that_saw_much_skipped();
  for (int i = 0; i < 64; ++i) supported.ran(program("G1 X9 Y8 F100\nM2\n"));
  for (const char* text : {" G1 X9 Y8 F100\nM2\n", "G1  X9 Y8 F100\nM2\n", "G1 X9Y8 F100\nM2\n",
                           "G1 X9 Y8 F100 \nM2\n", "X9 Y8 G1 F100\nM2\n"}) {
    supported.skipped(program(text));
  }
  EXPECT_EQ(supported.fitted(program("  Y8 G1  X9F100\t\nM2\n"))->text, "G1 X9 Y8 F100\nM2\n");
}

// The first program is skipped for its G94 or its G90; the ones behind it show which.
TEST(SupportedFeatures, LeavesOutWhatAloneWasToBlame) {
  SupportedFeatures supported(silent({}), "gsk988ta");
  for (int i = 0; i < 3; ++i) supported.skipped(gsk("G1 X9 (all of it)\n"));
  const auto with_g90 = gsk("G0 X9 Z9\nG90 X5 Z-1 F100\nM30\n");
  supported.skipped(gsk("G0 X9 Z9\nG94 X5 Z-1 F100\nG90 X5 Z-1 F100\nM30\n"));
  EXPECT_EQ(supported.left_out(), "");
  supported.ran(with_g90);
  supported.skipped(gsk("G0 X9 Z9\nG94 X5 Z-1 F100\nM30\n"));
  EXPECT_EQ(supported.left_out(), "code G94");
  supported.ran(gsk("G0 X9 Z9\nG94 X5 Z-1 F100\nM30\n"));
  EXPECT_EQ(supported.left_out(), "");
}

}  // namespace
}  // namespace gonogo::hunt::testing
