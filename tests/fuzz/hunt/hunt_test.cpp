// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/hunt.hpp"
#include "reference/reading_literal.hpp"

#include <gtest/gtest.h>

#include "fuzz/program/text.hpp"
#include "hunting.hpp"

namespace gonogo::hunt::testing {
namespace {

// Findings of so many programs, reduced.
std::vector<Finding> hunted(const char* expander, const char* fault, HuntOptions options,
                            std::size_t programs) {
  Hunt hunt(builtin(expander, fault), {}, std::move(options));
  std::vector<Finding> findings;
  while (hunt.count().programs < programs) {
    if (std::optional<Finding> finding = hunt.step()) {
      hunt.reduce(*finding, {});
      findings.push_back(std::move(*finding));
    }
  }
  return findings;
}

std::string text(const std::vector<Finding>& findings) {
  std::string all;
  for (const Finding& finding : findings) {
    all += std::to_string(finding.program) + " " + finding.signature.text() + "\n" +
           reference::profile_json(finding.reproducer.program.profile) + "\n" +
           finding.reproducer.program.text;
  }
  return all;
}

TEST(Hunt, TheSameSeedFindsTheSameInTheSameOrder) {
  const auto first = hunted("gsk", "inch-feed", hunting("gsk988ta", 7), 400);
  ASSERT_GE(first.size(), 2U);
  EXPECT_EQ(text(first), text(hunted("gsk", "inch-feed", hunting("gsk988ta", 7), 400)));
}

TEST(Hunt, AnotherSeedTriesOtherPrograms) {
  EXPECT_NE(text(hunted("gsk", "inch-feed", hunting("gsk988ta", 7), 400)),
            text(hunted("gsk", "inch-feed", hunting("gsk988ta", 8), 400)));
}

TEST(Hunt, NoSignatureIsFoundTwice) {
  std::set<Signature> signatures;
  for (const Finding& finding : hunted("hnc", "increment-as-radius", hunting("hnc21t"), 600)) {
    EXPECT_TRUE(signatures.insert(finding.signature).second) << finding.signature.text();
  }
  EXPECT_FALSE(signatures.empty());
}

// One G94 with a taper shows it; only what sets its start may stand before it.
TEST(Hunt, AFindingIsReducedToItsBlocks) {
  const auto findings = hunted("gsk", "taper-sign", hunting("gsk988ta"), 100);
  ASSERT_FALSE(findings.empty());
  EXPECT_LE(program::count_blocks(findings[0].reproducer.program.text), 2U);
  EXPECT_TRUE(findings[0].is_reduced);
}

TEST(Hunt, AReducedFindingShowsTheSameAlone) {
  for (const Finding& finding : hunted("ngc", "inch-feed-unscaled", hunting("rs274"), 300)) {
    Trial trial(builtin("ngc", "inch-feed-unscaled"), {});
    oracle::Verdict verdict;
    const auto again = finding_of(trial, finding.reproducer.program, verdict);
    ASSERT_TRUE(again) << finding.reproducer.program.text;
    EXPECT_EQ(again->signature, finding.signature);
  }
}

TEST(Hunt, StateThatLeaksIsFoundWithTheProgramBefore) {
  const auto findings = hunted("gsk", "feed-survives-reset", hunting("gsk988ta"), 1'500);
  ASSERT_FALSE(findings.empty());
  EXPECT_EQ(findings[0].verdict.kind, oracle::VerdictKind::state_leak);
  ASSERT_EQ(findings[0].reproducer.before.size(), 1U);
  EXPECT_NE(findings[0].reproducer.before[0].text.find('F'), std::string::npos);
}

TEST(Hunt, AFlickerOfOnePercentIsFoundAndToldAsSuch) {
  for (const bool keeps_state : {true, false}) {
    std::size_t runs = 0;
    Hunt hunt([&] { return std::make_unique<Flickering>(builtin("gsk")(), keeps_state, runs); }, {},
              hunting("gsk988ta"));
    std::vector<Finding> findings;
    while (hunt.count().programs < 1'000) {
      if (auto finding = hunt.step()) findings.push_back(*std::move(finding));
    }
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_EQ(findings[0].verdict.kind, oracle::VerdictKind::state_leak);
    EXPECT_EQ(findings[0].signature.what, "flicker");
    const std::string& message = findings[0].verdict.message;
    EXPECT_NE(message.find("flickers"), std::string::npos) << message;
    EXPECT_EQ(message.find(" 0 were not"), std::string::npos) << message;
  }
}

// The programs are generated. Mutants may be what two readers of the same manual read differently.
TEST(Hunt, AFaultFreeExpanderIsNotFound) {
  auto generated = [](const char* expander, const char* dialect) {
    HuntOptions options = hunting(dialect);
    options.guided = false;
    return text(hunted(expander, "", options, 1'500));
  };
  EXPECT_EQ(generated("gsk", "gsk988ta"), "");
  EXPECT_EQ(generated("hnc", "hnc21t"), "");
  EXPECT_EQ(generated("ngc", "rs274"), "");
}

TEST(Hunt, AProfileIsThatOfEveryProgram) {
  HuntOptions options = hunting("gsk988ta");
  options.profile = defaults("gsk988ta");
  for (const Finding& finding : hunted("gsk", "taper-sign", options, 200)) {
    EXPECT_EQ(reference::profile_json(finding.reproducer.program.profile), "{}");
  }
}

TEST(Hunt, AReadingThatIsGivenIsThatOfEveryFinding) {
  HuntOptions options = hunting("gsk988ta");
  options.readings = {{"gsk.zero-depth"_key, "alarm"}};
  const auto findings = hunted("gsk", "taper-sign", options, 100);
  ASSERT_FALSE(findings.empty());
  for (const Finding& finding : findings) {
    EXPECT_TRUE(finding.reproducer.program.profile.readings.is("gsk.zero-depth=alarm"_reading));
  }
}

// What is skipped is tried block by block, on the machine of the hunt still.
TEST(Hunt, SingleBlocksHaveTheMachineThatIsGiven) {
  class Skipping : public WrappedSubject {
   public:
    explicit Skipping(std::size_t& machines)
        : WrappedSubject(builtin("gsk")()), machines_(machines) {}
    void configure(const reference::Profile& profile) override {
      ++machines_;
      EXPECT_EQ(reference::profile_json(profile), R"({"block_skip":true})");
    }
    oracle::RunEnd run(std::string_view, std::string_view, const oracle::RecordSink&) override {
      return oracle::RunEnd::of(oracle::RunEnd::Kind::skip, "");
    }

   private:
    std::size_t& machines_;
  };
  std::size_t machines = 0;
  HuntOptions options = hunting("gsk988ta");
  options.profile = defaults("gsk988ta");
  options.profile->block_skip = true;
  Hunt hunt([&] { return std::make_unique<Skipping>(machines); }, {}, options);
  while (hunt.count().programs < 60) hunt.step();
  EXPECT_GT(machines, 0U);
}

TEST(Hunt, ASubjectRunsNothingThatNeedsWhatItDoesNotDeclare) {
  Hunt hunt(builtin("gsk"), {}, hunting("gsk988ta"));
  EXPECT_EQ(hunt.count().skipped, 0U);
  // A subject that declares the basic words only.
  class Basic : public WrappedSubject {
   public:
    Basic() : WrappedSubject(builtin("gsk")()), info_(WrappedSubject::info()) {
      info_.everything = false;
      info_.dialects = {{"gsk988ta", {"basic"}}};
    }
    const oracle::SubjectInfo& info() const override { return info_; }
    oracle::RunEnd run(std::string_view id, std::string_view program,
                       const oracle::RecordSink& sink) override {
      EXPECT_EQ(program.find("G110"), std::string_view::npos) << program;
      return WrappedSubject::run(id, program, sink);
    }

   private:
    oracle::SubjectInfo info_;
  };
  Hunt basic([] { return std::make_unique<Basic>(); }, {}, hunting("gsk988ta"));
  while (basic.count().programs < 300) basic.step();
  EXPECT_GT(basic.count().judged, 150U);
}

}  // namespace
}  // namespace gonogo::hunt::testing
