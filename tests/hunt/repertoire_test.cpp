// SPDX-License-Identifier: GPL-3.0-or-later
#include "hunt/repertoire.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "hunting.hpp"
#include "program/features.hpp"

namespace gonogo::hunt::testing {
namespace {

using Features = std::set<std::string>;

// A built-in expander that does these features on the default machine and no others, as a vendor's
// does; it may say so when it starts, or keep it to itself.
class PartialSubject : public oracle::Subject {
 public:
  PartialSubject(std::unique_ptr<oracle::Subject> whole, Features does, bool says_so)
      : whole_(std::move(whole)), does_(std::move(does)), info_(whole_->info()) {
    if (says_so) {
      info_.dialects = {{"gsk988ta", does_}};
      info_.everything = false;
    } else {
      info_.dialects.clear();
      info_.everything = true;
    }
  }
  const oracle::SubjectInfo& info() const override { return info_; }
  void configure(const reference::Profile& profile) override {
    profile_ = profile;
    whole_->configure(profile);
  }
  oracle::RunEnd run(std::string_view id, std::string_view program,
                     const oracle::RecordSink& sink) override {
    const auto needed = program::features_needed({profile_, program});
    if (!std::ranges::includes(does_, needed) || !(profile_ == defaults("gsk988ta"))) {
      oracle::RunEnd end;
      end.kind = oracle::RunEnd::Kind::skip;
      end.message = "not this";
      return end;
    }
    return whole_->run(id, program, sink);
  }
  void renew() override { whole_->renew(); }

 private:
  std::unique_ptr<oracle::Subject> whole_;
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

TEST(Repertoire, ASubjectThatDoesAPartAndDoesNotSaySoIsJudgedOnNineOfTenPrograms) {
  const std::vector<Features> parts = {{"basic", "g94"}, {"basic", "g90", "g92"}, {"basic"}};
  for (const Features& does : parts) {
    Hunt hunt(partial(does, false), {}, hunting("gsk988ta"));
    EXPECT_GE(judged_part(hunt, 4'000), 0.9)
        << *does.rbegin() << ": left out " << hunt.repertoire().left_out();
  }
}

TEST(Repertoire, ASubjectThatDeclaresAPartIsJudgedOnNineOfTenPrograms) {
  Hunt hunt(partial({"basic", "g94"}, true), {}, hunting("gsk988ta"));
  EXPECT_GE(judged_part(hunt, 4'000), 0.9) << hunt.repertoire().left_out();
}

TEST(Repertoire, TheFaultOfAPartIsFound) {
  for (const bool says_so : {false, true}) {
    Hunt hunt(partial({"basic", "g94"}, says_so, "taper-sign"), {}, hunting("gsk988ta"));
    bool found = false;
    for (std::size_t i = 0; i < 4'000 && !found; ++i) {
      const auto finding = hunt.step();
      found = finding && finding->exhibit.program.text.find("94") != std::string::npos;
    }
    EXPECT_TRUE(found) << (says_so ? "declared" : "not declared");
  }
}

TEST(Repertoire, LeavesTheProgramsOfASubjectThatDoesEverythingAlone) {
  oracle::SubjectInfo info;
  info.everything = true;
  Repertoire repertoire(info, "gsk988ta");
  const auto program = gsk("(any) G0 X1 Z2 Q9\nG115 X10 Z-5 ?\n");
  repertoire.ran(program);
  EXPECT_EQ(repertoire.fitted(program)->text, program.text);
}

// The first program is skipped for its G94 or its G90; the ones behind it show which.
TEST(Repertoire, LeavesOutWhatAloneWasToBlame) {
  oracle::SubjectInfo info;
  info.everything = true;
  Repertoire repertoire(info, "gsk988ta");
  for (int i = 0; i < 3; ++i) repertoire.skipped(gsk("G1 X9 (all of it)\n"));
  const auto with_g90 = gsk("G0 X9 Z9\nG90 X5 Z-1 F100\nM30\n");
  repertoire.skipped(gsk("G0 X9 Z9\nG94 X5 Z-1 F100\nG90 X5 Z-1 F100\nM30\n"));
  EXPECT_EQ(repertoire.left_out(), "");
  repertoire.ran(with_g90);
  repertoire.skipped(gsk("G0 X9 Z9\nG94 X5 Z-1 F100\nM30\n"));
  EXPECT_EQ(repertoire.left_out(), "code G94");
  repertoire.ran(gsk("G0 X9 Z9\nG94 X5 Z-1 F100\nM30\n"));
  EXPECT_EQ(repertoire.left_out(), "");
}

}  // namespace
}  // namespace gonogo::hunt::testing
