// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/judged_sheet.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "campaign/encoding.hpp"
#include "campaign/results.hpp"
#include "cli/program_file.hpp"
#include "oracle/records/output_file.hpp"
#include "oracle/steps/step_text.hpp"
#include "publish/report/case_detail.hpp"

namespace gonogo::cli {

void write_judged_sheet(const std::string& path, const JudgedProgram& judged) {
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
  const std::string drawing = detail.value("svg", std::string());
  if (drawing.empty()) {
    throw UsageError(fmt::format("--sheet: {}", detail.value("note", "There is nothing to draw.")));
  }
  oracle::write_file(path, drawing);
}

}  // namespace gonogo::cli
