// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a pocket of one level costs the gauge as a whole, all GO: its recorded trace is read and
// judged against the program as `gonogo judge` does it. The judge of the region alone is
// pocket_region_bench.
#include <fmt/format.h>

#include <cstdlib>
#include <sstream>

#include "oracle/judge/judge_session.hpp"
#include "oracle/records/trace_reader.hpp"
#include "pocket_bench.hpp"

namespace gonogo::oracle {
namespace {

// About (0, 0), from Z0; Z-3 is the floor, in one infeed. The tool has a radius of 5.
constexpr int kCycleBlock = 4;
std::string program_of(const region::Job& job) {
  return fmt::format(
      "G17 G90 S300 M3 T1 D1\nR101=5 R102=2 R103=0 R104=-3 R116=0 R117=0 R118={} R119={} R120=8\n"
      "R121=4 R122=120 R123=300 R124=0.75 R125=0 R126=3 R127=1\nLCYC75\nM2\n",
      job.length, job.width);
}

reference::Profile machine() {
  auto profile = std::get<reference::Profile>(reference::default_profile("sinumerik802s"));
  profile.tools["1"].radius = reference::Number(5);
  return profile;
}

void append(const reference::Record& record, std::string& trace) {
  append_json(record, trace);
  trace += '\n';
}

reference::Record along(reference::RecordKind kind, const char* z) {
  reference::Record record;
  record.kind = kind;
  record.block = kCycleBlock;
  record.axes.add(reference::Axis::z);
  record.to[reference::Axis::z] = reference::Number::parse(z).value();
  record.feed = reference::Number(120);
  return record;
}

reference::Record in_plane(const region::PlanePoint& to) {
  reference::Record record = along(reference::RecordKind::feed, "0");
  record.axes = {reference::Axis::x, reference::Axis::y};
  record.to[reference::Axis::x] = to.p;
  record.to[reference::Axis::y] = to.q;
  record.feed = reference::Number(300);
  return record;
}

// The recorded trace of the cycle: approach, plunge, the level, back to the centre, up.
std::string trace_of(const region::Job& job) {
  std::string trace;
  append(along(reference::RecordKind::rapid, "5"), trace);
  append(along(reference::RecordKind::rapid, "2"), trace);
  append(along(reference::RecordKind::feed, "-3"), trace);
  for (const region::LevelMotion& motion : job.pocket.motions) {
    reference::Record record = in_plane(motion.to);
    if (motion.is_arc) {
      record.kind = reference::RecordKind::arc;
      record.plane = reference::Plane::g17;
      record.centre = {motion.centre.p, motion.centre.q};
      record.rot = motion.rot;
    }
    append(record, trace);
  }
  append(in_plane({}), trace);
  append(along(reference::RecordKind::rapid, "5"), trace);
  return trace;
}

void judge_trace(const std::string& program, const reference::Profile& profile,
                 const std::string& trace) {
  SubjectInfo subject;
  subject.features = {"blocks"};
  const Tolerances tolerances = make_tolerances(subject, profile);
  JudgeSession session(profile, program, tolerances);
  TraceReader reader;
  std::istringstream lines(trace);
  for (std::string line; std::getline(lines, line);) {
    TraceLine read = reader.read(line);
    const auto* record = std::get_if<reference::Record>(&read);
    if (record == nullptr || !session.record(*record)) break;
  }
  const Verdict verdict = session.finish({}).verdict;
  if (decision(verdict.kind) == Decision::go) return;
  fmt::print("{}: {}\n", name(verdict.kind), verdict.message);
  std::exit(1);
}

}  // namespace
}  // namespace gonogo::oracle

int main() {
  using namespace gonogo::oracle;
  const gonogo::reference::Profile profile = machine();
  region::run_all([&](const region::Job& job) {
    const std::string program = program_of(job);
    const std::string trace = trace_of(job);
    return region::processor_milliseconds([&] { judge_trace(program, profile, trace); });
  });
}
