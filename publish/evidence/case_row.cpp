// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/case_row.hpp"

#include "fuzz/program/in_force.hpp"
#include "oracle/records/fresh_counts.hpp"
#include "oracle/records/point_text.hpp"
#include "oracle/records/text.hpp"
#include "publish/report/case_detail.hpp"
#include "publish/report/command.hpp"
#include "publish/report/json_value.hpp"

namespace gonogo::oracle::evidence {

CaseRow case_row(const Json& line) {
  using report::text_of;
  CaseRow facts;
  facts.id = text_of(line, "id");
  facts.dialect = text_of(line, "dialect");
  facts.cycle = text_of(line, "cycle");
  facts.kind = verdict_kind(text_of(line, "verdict")).value_or(VerdictKind::oracle_error);
  facts.clause = text_of(line, "clause");
  facts.departure = text_of(line, "departure");
  facts.rule = text_of(line, "rule");
  facts.gap = text_of(line, "gap");
  facts.known = text_of(line, "known");
  facts.basis = text_of(line, "basis");
  facts.reading = text_of(line, "reading");
  facts.block = report::count_of(line, "b");
  facts.record = report::count_of(line, "record");
  facts.want = text_of(line, "want");
  facts.got = text_of(line, "got");
  if (line.contains("witness")) facts.witness = point_for_people(line["witness"].dump());
  const Json deviation = line.value("deviation", Json::object());
  facts.deviation_exact = text_of(deviation, "exact");
  facts.deviation_mm = text_of(deviation, "mm");
  facts.message = text_of(line, "message");
  if (facts.kind == VerdictKind::xfail && facts.known.empty()) {
    split_known_message(facts.departure, facts.known, facts.message);
  }
  facts.against = text_of(line.value("readings", Json::object()), "against");
  facts.microseconds = report::count_of(line, "us").value_or(0);
  const auto expected = line.find("expected");
  facts.expected = expected != line.end() && *expected == true;
  facts.program = report::program_bytes(line);
  const auto line_departing = facts.block ? facts.block : line_wanted(facts.want);
  facts.blocks = marked_blocks(facts.program.value_or(""), line_departing.value_or(0));
  if (const auto profile = line.find("profile"); profile != line.end()) {
    facts.profile = profile->dump();
  }
  return facts;
}

CaseRow case_row(const CaseHead& line) {
  CaseRow facts;
  facts.id = line.id;
  facts.dialect = line.dialect;
  facts.cycle = line.cycle;
  facts.kind = verdict_kind(line.verdict).value_or(VerdictKind::oracle_error);
  facts.clause = line.clause;
  facts.departure = line.departure;
  facts.rule = line.rule;
  facts.gap = line.gap;
  facts.known = line.known;
  facts.message = line.message;
  facts.against = line.against;
  facts.microseconds = line.microseconds;
  facts.expected = line.expected;
  return facts;
}

std::string in_force_of(const CaseRow& row) {
  if (row.decision() == Decision::go || !row.program) return {};
  const auto profile = report::case_profile(
      row.dialect, row.profile.empty() ? Json::object() : Json::parse(row.profile));
  const auto* const machine = std::get_if<reference::Profile>(&profile);
  const auto block = row.block ? row.block : line_wanted(row.want);
  if (machine == nullptr || !block) return {};
  return program::in_force_text(*machine, *row.program, *block);
}

std::string again_command(const Json& header, const CaseRow& facts) {
  // Alone it shows nothing.
  const bool is_leak =
      facts.kind == VerdictKind::state_leak || facts.departure == name(VerdictKind::state_leak);
  if (is_leak) return report::command_for_run(header);
  const report::CaseOf of = is_fresh(facts.id) ? report::CaseOf::fresh : report::CaseOf::corpus;
  const std::string own = report::command_for_case(header, of) + shell_quoted(facts.id);
  if (facts.against.empty()) return own;
  return own + " --case " + shell_quoted(facts.against);
}

}  // namespace gonogo::oracle::evidence
