// SPDX-License-Identifier: GPL-3.0-or-later
//
// The path that `expand` shows for LCYC75 is one that the judge admits, and so are the levels under
// each reading.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pocket_milling.hpp"

namespace gonogo::oracle {
namespace {

constexpr std::string_view kRectangle =
    "N10 G0 G17 G90 F200 S300 M3 T4 D1\nN20 X60 Y40 Z5\n"
    "N30 R101=5 R102=2 R103=0 R104=-17.5 R105=2\nN40 LCYC82\nN50\n"
    "N60 R116=60 R117=40 R118=60 R119=40 R120=8\n"
    "N70 R121=4 R122=120 R123=300 R124=0.75 R125=0.5\nN80 R126=2 R127=1\nN90 LCYC75\nN100\n"
    "N110 R127=2\nN120 LCYC75\nN130 M2\n";
constexpr std::string_view kCircle =
    "N10 G0 G19 G90 S200 M3 T1 D1\nN20 Z60 X40 Y5\n"
    "N30 R101=4 R102=2 R103=0 R104=-20 R116=50 R117=50\nN40 R118=50 R119=50 R120=50 R121=4 "
    "R122=100\nN50 R123=200 R124=0 R125=0R126=2 R127=1\nN60 LCYC75\nN70 M2\n";
constexpr std::string_view kSlots =
    "N10 G0 G19 G90 T10 D1 S400 M3\nN20 Y20 Z50 X5\n"
    "N30 R101=5 R102=1 R103=0 R104=-23 R116=35 R117=0\n"
    "N40 R118=30 R119=15 R120=15 R121=6 R122=200\nN50 R123=300 R124=0 R125=0 R126=2 R127=1\n"
    "N60 G158 Y40 Z45\nN70 G259 RPL45\nN80 LCYC75\nN90 G259 RPL90\nN100 LCYC75\nN110 G259 RPL90\n"
    "N120 LCYC75\nN130 G259 RPL90\nN140 LCYC75\nN150 G259 RPL45\nN160 G158 Y-40 Z-45\n"
    "N170 Y20 Z50 X5\nM2\n";

VerdictKind kind_of(std::string_view program, const reference::Profile& profile = profile_802s()) {
  const Verdict verdict = judge_shown(program, profile);
  EXPECT_EQ(verdict.message, "") << verdict.got << " " << verdict.witness;
  return verdict.kind;
}

TEST(PocketShown, TheThreeProgramsOfTheManualAreGo) {
  EXPECT_EQ(kind_of(kRectangle), VerdictKind::pass_properties);
  EXPECT_EQ(kind_of(kCircle), VerdictKind::pass_properties);
  EXPECT_EQ(kind_of(kSlots), VerdictKind::pass_properties);
}

TEST(PocketShown, WithoutLineNumbersTheyAreGoToo) {
  const reference::Profile profile = profile_802s();
  for (const std::string_view program : {kRectangle, kCircle, kSlots}) {
    const Verdict verdict = judge_records(program, shown(program, profile), {false, profile});
    EXPECT_EQ(verdict.kind, VerdictKind::pass_properties) << verdict.message << verdict.got;
  }
}

// 750 levels of equal motions are one region.
TEST(PocketShown, ManyLevelsAreGo) {
  Job job;
  job.infeed = "R121=0.01";
  EXPECT_EQ(judge_shown(job.program()).kind, VerdictKind::pass_properties);
}

TEST(PocketShown, TheyAreGoUnderEachReadingOfTheInfeed) {
  for (const std::string_view infeed : {"equal", "max-rest"}) {
    for (const std::string_view from : {"reference", "clearance"}) {
      for (const std::string_view finish : {"any", "split"}) {
        const reference::Profile profile = profile_802s(
            {{"sie.infeed", infeed}, {"sie.infeed-from", from}, {"sie.finish.levels", finish}});
        for (const std::string_view program : {kRectangle, kCircle, kSlots}) {
          EXPECT_EQ(kind_of(program, profile), VerdictKind::pass_properties)
              << infeed << ' ' << from << ' ' << finish;
        }
      }
    }
  }
}

TEST(PocketShown, ThePathThatAReadingNamesIsJudgedLiterally) {
  const reference::Profile profile = profile_802s({{"sie.pocket.path", "contour-parallel"}});
  EXPECT_EQ(kind_of(kRectangle, profile), VerdictKind::pass_exact);
  EXPECT_EQ(kind_of(kSlots, profile), VerdictKind::pass_exact);
}

// Shapes by length, width and corner; the tool's radius is 5: rectangle, slot, circle, sharp
// corners, where the tool reaches a line only (along, across), and a point.
TEST(PocketShown, EveryShapeIsGoInEveryFrame) {
  for (const std::string_view sizes :
       {"R118=60 R119=40 R120=8", "R118=60 R119=20 R120=10", "R118=30 R119=30 R120=15",
        "R118=40 R119=60 R120=0", "R118=33.3 R119=10 R120=5", "R118=10 R119=24 R120=0",
        "R118=10 R119=10 R120=5"}) {
    for (const std::string_view ways :
         {"R126=2 R127=1", "R126=3 R127=1", "R126=2 R127=2", "R126=3 R127=2"}) {
      for (const std::string_view angle : {"0", "45", "30", "17", "-163.5"}) {
        Job job;
        job.sizes = sizes;
        job.ways = ways;
        job.allowance = "R124=0 R125=0";
        job.frame = fmt::format("G158 X7 Y-3.5 Z1\nG259 RPL={}\n", angle);
        const Verdict verdict = judge_shown(job.program());
        EXPECT_EQ(decision(verdict.kind), Decision::go)
            << sizes << ' ' << ways << ' ' << angle << ": " << verdict.message;
      }
    }
  }
}

// From 2 mm above to 0.1 below by at most 0.1: the contour is milled in the air 20 times, which is
// more often than a level may be.
TEST(PocketShown, LevelsInTheAirAreLevels) {
  Job job;
  job.depth = "-0.1";
  job.infeed = "R121=0.1";
  job.allowance = "R124=0 R125=0";
  job.ways = "R126=3 R127=2";
  const reference::Profile profile = profile_802s({{"sie.infeed-from", "clearance"}});
  const Verdict verdict = judge_shown(job.program(), profile);
  EXPECT_EQ(decision(verdict.kind), Decision::go) << verdict.message;
}

TEST(PocketShown, FinishingWithAllowancesIsGo) {
  for (const std::string_view allowance :
       {"R124=0.75 R125=0", "R124=0.75 R125=0.5", "R124=0 R125=0.5", "R124=9.999 R125=0",
        "R124=9 R125=6", "R124=0.001 R125=100"}) {
    for (const std::string_view angle : {"0", "17"}) {
      Job job;
      job.allowance = allowance;
      job.ways = "R126=3 R127=2";
      job.frame = fmt::format("G258 RPL={}\n", angle);
      const Verdict verdict = judge_shown(job.program());
      EXPECT_EQ(decision(verdict.kind), Decision::go)
          << allowance << ' ' << angle << ": " << verdict.message;
    }
  }
}

}  // namespace
}  // namespace gonogo::oracle
