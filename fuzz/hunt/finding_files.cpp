// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/finding_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "corpus/io/recheck.hpp"
#include "fuzz/hunt/judged_sheet.hpp"
#include "fuzz/hunt/program_files.hpp"
#include "fuzz/hunt/program_vector.hpp"
#include "fuzz/program/in_force.hpp"
#include "oracle/differential/differential.hpp"
#include "oracle/records/finding_text.hpp"
#include "oracle/records/output_file.hpp"
#include "oracle/records/text.hpp"
#include "oracle/steps/step_text.hpp"

namespace gonogo::hunt {
namespace {

namespace fs = std::filesystem;

std::string verdict_text(const Finding& finding, const oracle::Case& test) {
  oracle::FindingFacts facts = oracle::finding_facts(finding.verdict);
  facts.profile = reference::profile_json(test.profile);
  facts.blocks = oracle::marked_blocks(test.program, finding.verdict.block);
  facts.in_force = program::in_force_text(test.profile, test.program, facts.block.value_or(0));
  return fmt::format("{}: {}\n{}{:<10} {}\n", test.id, finding.signature.text(),
                     oracle::finding_text(facts, ""), "from", test.provenance);
}

std::string trace_of(const JudgedRun& judged) {
  std::string text;
  for (const reference::Record& record : judged.records) {
    text += oracle::record_text(record) + "\n";
  }
  if (judged.end.kind == oracle::RunEnd::Kind::alarm) {
    text += oracle::alarm_text(judged.end.alarm) + "\n";
  }
  return text;
}

void write_manifest(const fs::path& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder / "vectors")) {
    if (!entry.is_regular_file() || entry.path().extension() != ".json") continue;
    files.push_back(fs::relative(entry.path(), folder).generic_string());
  }
  std::ranges::sort(files);
  std::string list;
  for (const std::string& file : files) {
    list += fmt::format("{}\n  \"{}\"", list.empty() ? "" : ",", file);
  }
  oracle::write_file(
      folder / "manifest.json",
      fmt::format("{{\n \"format\": 1,\n \"version\": \"{}\",\n \"license\": \"CC0-1.0\",\n "
                  "\"files\": [{}\n ],\n \"retired\": []\n}}\n",
                  oracle::kUnreleased, list));
}

void write_beside(const fs::path& folder, const Finding& finding, const JudgedRun& judged,
                  const oracle::Case& test) {
  fs::create_directories(folder);
  oracle::write_file(folder / "program.nc", test.program);
  oracle::write_file(folder / "profile.json", oracle::profile_text(test.profile));
  oracle::write_file(folder / "trace.jsonl", trace_of(judged));
  oracle::write_file(folder / "verdict.txt", verdict_text(finding, test));
  const JudgedSheet sheet =
      judged_sheet({test.profile, test.id, test.program, finding.verdict, judged.records});
  if (!sheet.svg.empty()) oracle::write_file(folder / "sheet.svg", sheet.svg);
  for (std::size_t i = 0; i < finding.reproducer.before.size(); ++i) {
    const generate::GeneratedProgram& before = finding.reproducer.before[i];
    oracle::write_file(folder / fmt::format("before-{}.nc", i + 1), before.text);
    oracle::write_file(folder / fmt::format("before-{}.json", i + 1),
                       oracle::profile_text(before.profile));
  }
}

}  // namespace

oracle::Case case_of(const Finding& finding, const oracle::SubjectInfo& subject,
                     const Provenance& provenance) {
  oracle::Case test = vector_of(finding.reproducer.program, provenance.room);
  test.group = fmt::format("{}.{}.{}", provenance.room, test.dialect, finding.signature.hash());
  test.id = test.group + ".000001";
  test.comment = finding.signature.text();
  // The clause departed from is what it is about.
  if (!finding.signature.clause.empty()) test.clauses = {finding.signature.clause};
  test.provenance =
      fmt::format("{} hunt: {} ({} {}), seed {}, program {}", provenance.gonogo, provenance.subject,
                  subject.name, subject.version, provenance.seed, finding.program);
  return test;
}

std::string write_finding(const std::string& folder, const Finding& finding,
                          const JudgedRun& judged, const oracle::SubjectInfo& subject,
                          const Provenance& provenance) {
  oracle::Case test = case_of(finding, subject, provenance);
  const fs::path vectors = fs::path(folder) / "vectors" / test.dialect;
  fs::create_directories(vectors);
  fs::path file;
  for (int number = 1;; ++number) {
    test.id = fmt::format("{}.{:06}", test.group, number);
    file = vectors / (test.id + ".json");
    if (!fs::exists(file)) break;
    const std::vector<oracle::Case> known = oracle::read_vector_file(file.string());
    if (known.size() == 1 && known.front().program == test.program &&
        known.front().profile == test.profile) {
      break;
    }
  }
  // Groups of two files are two groups.
  oracle::Case numbered = test;
  numbered.group = test.id;
  oracle::write_file(file, oracle::vector_file_text(oracle::kUnreleased, {numbered}));
  const std::vector<oracle::Case> written = oracle::read_vector_file(file.string());
  if (auto fault = oracle::recheck(written.front())) {
    throw oracle::CorpusError(fmt::format("{}: {}", file.string(), *fault));
  }
  write_beside(fs::path(folder) / "findings" / test.id, finding, judged, numbered);
  write_manifest(folder);
  return test.id;
}

Reproducer read_reproducer(const std::string& folder, const std::string& dialect) {
  const fs::path in(folder);
  Reproducer reproducer{{}, read_program(in / "program.nc", in / "profile.json", dialect)};
  for (int i = 1; fs::exists(in / fmt::format("before-{}.nc", i)); ++i) {
    // Findings of before have no machine of their own for it.
    const fs::path own = in / fmt::format("before-{}.json", i);
    reproducer.before.push_back(read_program(in / fmt::format("before-{}.nc", i),
                                             fs::exists(own) ? own : in / "profile.json", dialect));
  }
  return reproducer;
}

}  // namespace gonogo::hunt
