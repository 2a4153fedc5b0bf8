// SPDX-License-Identifier: GPL-3.0-or-later
//
// Memory that comes to its end while a trace is read and judged.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "oracle/differential/reference_run.hpp"
#include "oracle/records/trace_reader.hpp"
#include "tests/hostile/every_failure.hpp"

namespace gonogo::hostile {
namespace {

using namespace oracle;

std::string text_of(const Verdict& verdict) {
  return fmt::format("{} {} {} {} {}", name(verdict.kind), verdict.block, verdict.deviation_exact,
                     verdict.witness, verdict.message);
}

struct Machine {
  reference::Profile profile;
  Tolerances tolerances;
};

Machine machine_of(const char* dialect) {
  Machine machine{std::get<reference::Profile>(reference::default_profile(dialect)), {}};
  machine.profile.readings = machine.profile.readings.shown();
  SubjectInfo subject;
  subject.features = {"blocks", "m"};
  machine.tolerances = make_tolerances(subject, machine.profile);
  return machine;
}

// A trace as a subject sends it, line by line.
std::string judged(const Machine& machine, std::string_view program, std::string_view trace) {
  JudgeSession session(machine.profile, program, machine.tolerances);
  TraceReader reader;
  while (!trace.empty()) {
    const std::size_t end = trace.find('\n');
    const TraceLine line = reader.read(trace.substr(0, end));
    if (!session.record(std::get<reference::Record>(line))) break;
    trace.remove_prefix(end + 1);
  }
  return text_of(session.finish(RunEnd{}).verdict);
}

std::string own_trace(const Machine& machine, std::string_view program) {
  std::string text;
  for (const reference::Record& record : run_reference(machine.profile, program, 1000).records) {
    if (record.kind == reference::RecordKind::end) continue;
    reference::append_json(record, text);
    text += '\n';
  }
  return text;
}

constexpr std::string_view kPocket =
    "G18 G0 X70 Z70 Y50\nG110 X50 Z50 Y40 R-5 I16 L3 Q5 P1 D4 F800\nM30\n";
constexpr std::string_view kPecks = "F100\nG0 Z2\nG98 G83 X1 Y2 Z-5 R0 Q2\nX2\nM2\n";

TEST(AllocationFailure, LeavesThePathOfAPocketRight) {
  const Machine machine = machine_of("gsk988ta");
  const std::string trace = own_trace(machine, kPocket);
  const auto work = [&] { return judged(machine, kPocket, trace); };
  ASSERT_TRUE(work().starts_with("pass")) << work();
  try_every_failure<NoError>(work);
}

// The bottom of the pocket is 1 mm too high.
TEST(AllocationFailure, LeavesTheDepartureInAPocketRight) {
  const Machine machine = machine_of("gsk988ta");
  std::string trace = own_trace(machine, kPocket);
  const std::string bottom = R"("y":"40")";
  for (std::size_t at = 0; (at = trace.find(bottom, at)) != std::string::npos; ++at)
    trace.replace(at, bottom.size(), R"("y":"41")");
  const auto work = [&] { return judged(machine, kPocket, trace); };
  ASSERT_TRUE(work().starts_with("fail")) << work();
  try_every_failure<NoError>(work);
}

TEST(AllocationFailure, LeavesPecksRight) {
  const Machine machine = machine_of("rs274");
  const std::string trace = own_trace(machine, kPecks);
  const auto work = [&] { return judged(machine, kPecks, trace); };
  ASSERT_TRUE(work().starts_with("pass")) << work();
  try_every_failure<NoError>(work);
}

// One peck goes 1 mm too deep.
TEST(AllocationFailure, LeavesTheDepartureOfAPeckRight) {
  const Machine machine = machine_of("rs274");
  std::string trace = own_trace(machine, kPecks);
  const std::string peck = R"("z":"-4")";
  ASSERT_NE(trace.find(peck), std::string::npos) << trace;
  trace.replace(trace.find(peck), peck.size(), R"("z":"-5")");
  const auto work = [&] { return judged(machine, kPecks, trace); };
  ASSERT_TRUE(work().starts_with("fail")) << work();
  try_every_failure<NoError>(work);
}

// A centre that only an enclosure holds.
TEST(AllocationFailure, LeavesATangentArcRight) {
  const Machine machine = machine_of("sinumerik840d");
  constexpr std::string_view kTangents =
      "G17 G0 X10 Y0\nG2 X20 Y10 CR=11 F100\nCT X30 Y31\nCT X35 Y47\nM30\n";
  const std::string trace = own_trace(machine, kTangents);
  const auto work = [&] { return judged(machine, kTangents, trace); };
  ASSERT_TRUE(work().starts_with("pass")) << work() << trace;
  try_every_failure<NoError>(work);
}

// The open readings of the default profile.
TEST(AllocationFailure, LeavesAJudgementUnderOpenReadingsRight) {
  Machine machine = machine_of("rs274");
  const std::string trace = own_trace(machine, kPecks);
  machine.profile = std::get<reference::Profile>(reference::default_profile("rs274"));
  try_every_failure<NoError>([&] { return judged(machine, kPecks, trace); });
}

std::string records_read(TraceReader& reader) {
  std::string text;
  for (
      const char* line :
      {R"({"k":"rapid","b":1,"to":{"x":"1","z":{"root":["0","1","2"]}}})",
       R"( {"k":"arc","b":2,"plane":"G17","c":{"x":"5","y":"0"},"rot":-1,"to":{"x":"10","y":"0"},"f":"100"})",
       R"({"k":"feed","b":3,"to":{"x":{"enclosure":["0.1","0.1000000000000001"]}},"f":"100"})"}) {
    const TraceLine read = reader.read(line);
    if (const auto* fault = std::get_if<TraceFault>(&read)) return fault->message;
    reference::append_json(std::get<reference::Record>(read), text);
  }
  return text;
}

TEST(AllocationFailure, LeavesRecordsRight) {
  try_every_failure<NoError>([] {
    TraceReader reader;
    return records_read(reader);
  });
}

TEST(AllocationFailure, LeavesAReaderOfRecordsInUse) {
  const std::string long_line =
      R"({"k":"rapid","b":1,"to":{"x":"1","z":"2"}} )" + std::string(5000, ' ');
  std::optional<TraceReader> reader(std::in_place);
  const std::string right = records_read(*reader);
  for (std::uint64_t number = 1; number < 20; ++number) {
    reader.emplace();
    auto work = [&] {
      return std::holds_alternative<reference::Record>(reader->read(long_line)) ? "" : "fault";
    };
    answer_where<NoError>(number, Failing::once, work);
    ASSERT_EQ(records_read(*reader), right) << "behind allocation " << number;
  }
}

}  // namespace
}  // namespace gonogo::hostile
