// SPDX-License-Identifier: GPL-3.0-or-later
//
// results_lines FILE: writes a results file with a case of each sort, for the test of its schema.
#include "campaign/results_writer.hpp"

using namespace gonogo::oracle;

namespace {

CaseResult case_of(const char* id, VerdictKind kind) {
  CaseResult result;
  result.id = id;
  result.dialect = "gsk988ta";
  result.cycle = "g94";
  result.clauses = {"GSK-G94-02"};
  result.verdict.kind = kind;
  result.profile = "{}";
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  ResultsHeader header;
  header.version = "0.1.0";
  header.corpus_version = "2026.1.0";
  header.corpus_sha256 = std::string(64, 'a');
  header.subject_spec = "builtin:gsk";
  header.subject.name = "gsk";
  header.subject.version = "1";
  header.readings = {"gsk.pocket.end=any"};
  header.only = {"a.*"};
  header.alarm_map_sha256 = std::string(64, 'b');
  header.argv = {"gonogo", "certify"};
  ResultsWriter writer(argv[1], header);
  CaseResult pass = case_of("a.000001", VerdictKind::pass_exact);
  pass.readings =
      OpenReadings{{"gsk.pocket.end"}, {"gsk.pocket.end=initial"}, VerdictKind::pass_exact, {}};
  writer.add(pass);
  CaseResult failure = case_of("a.000002", VerdictKind::fail_geometry);
  failure.verdict.clause = 0;
  failure.verdict.reading = "gsk.pocket.end=r-plane";
  failure.verdict.block = 2;
  failure.verdict.record = 1;
  failure.verdict.word = 'X';
  failure.verdict.want = R"({"k":"rapid","b":2,"to":{"z":"5"}})";
  failure.verdict.got = R"({"k":"rapid","b":2,"to":{"z":"6"}})";
  failure.verdict.deviation_exact = "1";
  failure.verdict.deviation_mm = "1";
  failure.verdict.witness = R"({"x":"0","y":"0","z":"6"})";
  failure.verdict.message = "The motion ends elsewhere.";
  failure.program = "G00 Z5 (\xbd\xe1)\n";
  failure.trace = {failure.verdict.got};
  failure.notes = "a note";
  failure.mapped = "PS0061";
  writer.add(failure);
  CaseResult gap = case_of("a.000003", VerdictKind::oracle_gap);
  gap.verdict.gap = GapReason::not_covered;
  gap.program = "G71\n";
  gap.expected_gap = true;
  writer.add(gap);
  CaseResult conflict = case_of("a.000004", VerdictKind::pass_exact);
  conflict.readings =
      OpenReadings{{"gsk.pocket.end"}, {"gsk.pocket.end=r-plane"}, VerdictKind::pass_exact, {}};
  conflict.program = "G00 X1\n";
  conflict.trace = {R"({"k":"rapid","b":1,"to":{"x":"0.5"}})"};
  writer.add(conflict);
  CaseResult known = case_of("a.000005", VerdictKind::xfail);
  known.verdict.departure = VerdictKind::fail_feed;
  known.verdict.known = "a known bug";
  writer.add(known);
  ResultsWriter::Ending ending;
  ending.alarms = {"PS0061", "PS0062"};
  writer.close(ending);
  return 0;
}
