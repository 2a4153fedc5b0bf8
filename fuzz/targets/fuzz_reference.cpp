// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reference invariants on raw text: it ends, each record and alarm names its clause, a cycle of G94
// ends where it began, block numbers go back for an O word only, and the reference judged as its
// own subject is GO; in every dialect. Cost cap: 512 bytes and 5,000 records, since a tiny Q over a
// great depth is a long program.
#include "fuzz/targets/target.hpp"
#include "oracle/differential/reference_run.hpp"
#include "reference/dialect.hpp"

namespace {

using namespace gonogo;
using namespace gonogo::reference;

void check_names(const oracle::ReferenceRun& run, std::string_view program) {
  // NGC-OWD-01: loops and subroutines run blocks again.
  const bool may_go_back = program.find_first_of("oO") != std::string_view::npos;
  std::uint64_t block = 0;
  for (const Record& record : run.records) {
    if (record.kind == RecordKind::end) continue;
    if (record.clause == kNoClause) fuzz::fail("a record names no clause", program);
    if (record.block < block && !may_go_back) fuzz::fail("a block number goes back", program);
    block = record.block;
  }
  for (const Alarm& alarm : run.alarms) {
    if (alarm.clause == kNoClause) fuzz::fail("an alarm names no clause", program);
  }
}

void expand_and_judge(const Profile& profile, std::string_view program) {
  constexpr std::size_t kMostRecords = 5'000;
  oracle::ReferenceRun run = oracle::run_reference(profile, program, kMostRecords);
  check_names(run, program);
  if (!run.is_told()) return;
  if (fuzz::planted_fault() == "record-lost" && !run.records.empty()) {
    run.records.erase(run.records.begin());
  }
  const oracle::Verdict verdict = judge_reference(profile, program, run);
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
