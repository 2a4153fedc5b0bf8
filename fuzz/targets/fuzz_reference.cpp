// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reference invariants on raw text: it ends, each record and alarm names its clause, a cycle of G94
// ends where it began, block numbers never go back, and the reference judged as its own subject is
// GO; in every dialect. Cost cap: 512 bytes and 5,000 records, since a tiny Q over a great depth is a long program.
#include "fuzz/targets/target.hpp"
#include "oracle/judge/judge_session.hpp"
#include "reference/dialect.hpp"

namespace {

using namespace gonogo;
using namespace gonogo::reference;

void expand_and_judge(const Profile& profile, std::string_view program) {
  grammar::MemorySource bytes(program);
  grammar::LineSource lines(bytes);
  Expander expander(profile, lines, OpenPaths::shown);
  std::vector<Record> records;
  oracle::RunEnd end;
  std::uint64_t block = 0;
  while (const Item* item = expander.next()) {
    if (auto* record = std::get_if<Record>(item)) {
      if (record->kind != RecordKind::end) {
        if (record->clause == kNoClause) fuzz::fail("a record names no clause", program);
        if (record->block < block) fuzz::fail("a block number goes back", program);
        block = record->block;
      }
      records.push_back(*record);
      if (records.size() > 5'000) return;
    } else if (auto* report = std::get_if<AlarmReport>(item)) {
      if (report->alarms.empty() || report->alarms.front().clause == kNoClause) {
        fuzz::fail("an alarm names no clause", program);
      }
      end.kind = oracle::RunEnd::Kind::alarm;
      end.alarm.alarm_class = name(report->alarms.front().alarm);
      end.alarm.block = report->block;
    } else if (std::holds_alternative<NotCovered>(*item)) {
      return;
    }
  }
  if (fuzz::planted_fault() == "record-lost" && !records.empty()) records.erase(records.begin());
  oracle::SubjectInfo subject;
  subject.features = {"blocks", "m"};
  const oracle::JudgeTerms terms = make_terms(subject, profile, std::nullopt, std::nullopt);
  const oracle::Verdict verdict = judge_outcome(profile, program, terms, records, end).verdict;
  if (oracle::decision(verdict.kind) == oracle::Decision::no_go) {
    fuzz::fail("the reference is not GO under its own judge: " + verdict.message, program);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > 512) return 0;
  for (const Dialect& dialect : dialects()) {
    const auto profile = std::get<Profile>(default_profile(dialect.name));
    expand_and_judge(profile, fuzz::text_of(data, size));
  }
  return 0;
}
