// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a judge keeps does not grow with the program. Each test measures the peak of its process.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "oracle/judge/program_judge.hpp"
#include "reference/expander.hpp"

namespace gonogo::oracle {
namespace {

// A sanitizer keeps what has been freed.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool kSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif
#else
constexpr bool kSanitized = false;
#endif

long peak_kib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

// Judges a program of `count` times `blocks` by its own records, one at a time.
Verdict judged_as_it_goes(const std::string& blocks, int count) {
  reference::Profile profile = std::get<reference::Profile>(reference::default_profile("rs274"));
  reference::set_reading(profile, "ngc.program-end", "free");
  std::string program = "F100\n";
  for (int i = 0; i < count; ++i) program += blocks;
  SubjectInfo subject;
  subject.features = {"blocks", "m"};
  const Tolerances tolerances = make_tolerances(subject, profile);
  ProgramJudge judge(profile, program, tolerances);
  ProgramInput input(program);
  reference::Expander expander(profile, input.lines, reference::OpenPaths::shown);
  while (const reference::Item* item = expander.next()) judge.record(std::get<Record>(*item));
  return judge.finish(RunEnd{});
}

class JudgeMemory : public testing::TestWithParam<const char*> {};

TEST_P(JudgeMemory, AHundredTimesTheBlocksTakeTheMemoryOfTheFew) {
  if (kSanitized) GTEST_SKIP() << "a sanitizer's memory is not the judge's";
  const std::string blocks = GetParam();
  ASSERT_EQ(judged_as_it_goes(blocks, 400).kind, VerdictKind::pass_exact);
  const long before = peak_kib();
  ASSERT_EQ(judged_as_it_goes(blocks, 40'000).kind, VerdictKind::pass_exact);
  // The program itself is up to 1 MiB; a step that is kept takes more than 200 bytes.
  EXPECT_LT(peak_kib() - before, 4096);
}

INSTANTIATE_TEST_SUITE_P(OfPrograms, JudgeMemory,
                         testing::Values("G1 X1\nG1 X2\n", "G1 X1\nG4 P1\nG1 X2\n", "G4 P1\n",
                                         "M8\nG1 X1\nM9\nG1 X2\n", "G82 X1 Y1 Z-2 R1 P1\nX2\n"));

}  // namespace
}  // namespace gonogo::oracle
