// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo selftest: the gauge gauged. Subjects that do nothing, always alarm, crash, hang, flood,
// answer garbage or late must each get their own verdict and never a pass; the reference as its own
// subject must pass everything.
#include <fmt/format.h>

#include <filesystem>

#include "campaign/case_judge.hpp"
#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "oracle/records/text.hpp"

namespace gonogo::cli {
namespace {

using oracle::VerdictKind;

// One program of each kind that a subject can meet.
struct SelftestProgram {
  const char* name;
  const char* text;
};
constexpr std::array<SelftestProgram, 3> kPrograms = {{
    {"path", "G00 X130 Z5\nG94 X120 Z-110 R-10 F300\nX108\nM30\n"},
    {"pocket", "G18 G0 X70 Z70 Y50\nG110 X50 Z50 Y20 R-5 I16 L3 Q5 P1 D4 F800\n"},
    {"alarm", "G00 X130 Z5\nG94 X120 Z-10 R20 F300\n"},
}};

// What a subject must get, program by program; programs without an entry are not run with it.
struct SubjectVerdicts {
  const char* subject;
  std::array<std::optional<VerdictKind>, 3> expected;
};

constexpr auto kTrials = std::to_array<SubjectVerdicts>({
    {"reference", {VerdictKind::pass_exact, VerdictKind::pass_properties, VerdictKind::pass_exact}},
    {"empty", {VerdictKind::fail_geometry, VerdictKind::fail_geometry, VerdictKind::fail_geometry}},
    {"always-alarm",
     {VerdictKind::fail_alarm_spurious, VerdictKind::fail_alarm_spurious,
      VerdictKind::fail_alarm_spurious}},
    {"crash", {VerdictKind::crash, VerdictKind::crash, VerdictKind::crash}},
    {"half-line", {VerdictKind::crash, VerdictKind::crash, VerdictKind::crash}},
    {"garbage", {VerdictKind::protocol, VerdictKind::protocol, VerdictKind::protocol}},
    {"wrong-seq", {VerdictKind::protocol, VerdictKind::protocol, VerdictKind::protocol}},
    {"flood", {VerdictKind::fail_geometry, VerdictKind::fail_geometry, VerdictKind::fail_geometry}},
    {"hang", {VerdictKind::timeout, std::nullopt, std::nullopt}},
    {"late", {VerdictKind::timeout, std::nullopt, std::nullopt}},
    {"leak", {VerdictKind::pass_exact, VerdictKind::state_leak, std::nullopt}},
});

oracle::Case make_case(const SelftestProgram& program) {
  oracle::Case test;
  test.id = fmt::format("selftest.{}", program.name);
  test.dialect = "gsk988ta";
  test.program = program.text;
  return test;
}

int selftest() {
  oracle::CampaignOptions options;
  options.limits.run = std::chrono::milliseconds(250);
  const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
  Output output;
  std::size_t wrong = 0;
  for (const SubjectVerdicts& trial : kTrials) {
    const oracle::SubjectMaker maker = [&] {
      return oracle::make_pipe_subject(
          fmt::format("exec {} misbehave {}", oracle::shell_quoted(self), trial.subject),
          options.limits);
    };
    oracle::CaseJudge judge(options, maker);
    for (std::size_t i = 0; i < kPrograms.size(); ++i) {
      if (!trial.expected[i]) continue;
      const oracle::CaseResult result = judge.judge(make_case(kPrograms[i]));
      const bool right = result.verdict.kind == *trial.expected[i];
      wrong += right ? 0 : 1;
      output.text() += fmt::format(
          "{:<14} {:<8} {:<20} {}\n", trial.subject, kPrograms[i].name, name(result.verdict.kind),
          right ? "as it must be"
                : fmt::format("WRONG, must be {}: {}", name(*trial.expected[i]),
                              result.verdict.message));
      output.flush();
    }
  }
  output.text() += wrong == 0 ? "The gauge judges its own subjects as it must.\n"
                              : fmt::format("{} verdicts are wrong.\n", wrong);
  output.flush();
  return wrong == 0 ? kGo : kNoGo;
}

}  // namespace

void add_selftest(Command& program) {
  Command command = program.add_command(
      "selftest", "Gauge the gauge: empty, alarming, crashing, hanging, ... subjects");
  command.run([] { return selftest(); });
}

}  // namespace gonogo::cli
