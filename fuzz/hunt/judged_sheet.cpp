// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/judged_sheet.hpp"

#include <nlohmann/json.hpp>

#include "campaign/encoding.hpp"
#include "campaign/results.hpp"
#include "oracle/steps/step_text.hpp"
#include "publish/report/case_detail.hpp"

namespace gonogo::hunt {

JudgedSheet judged_sheet(const JudgedProgram& judged) {
  oracle::CaseResult result;
  result.id = judged.name;
  result.dialect = judged.profile.dialect;
  result.verdict = judged.verdict;
  result.profile = reference::profile_json(judged.profile);
  auto line = nlohmann::ordered_json::parse(oracle::case_line(result, false));
  // The line of a pass has neither.
  line["program"] = oracle::program_json(judged.program);
  line["trace"] = nlohmann::ordered_json::array();
  for (const reference::Record& record : judged.records) {
    line["trace"].push_back(nlohmann::ordered_json::parse(oracle::record_text(record)));
  }
  const nlohmann::ordered_json detail = oracle::report::case_detail(line, "", true);
  JudgedSheet sheet{detail.value("svg", std::string()), {}};
  if (sheet.svg.empty()) sheet.note = detail.value("note", "There is nothing to draw.");
  return sheet;
}

}  // namespace gonogo::hunt
