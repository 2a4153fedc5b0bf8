// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/run_state.hpp"

#include <fmt/format.h>

#include "oracle/records/run_conditions.hpp"
#include "publish/report/json_value.hpp"

namespace gonogo::oracle::evidence {

using report::text_of;

namespace {

// "acme 3.2", or how it was named.
std::string subject_title(const Json& header) {
  const Json subject = header.value("subject", Json::object());
  const std::string name = text_of(subject, "name");
  const std::string version = text_of(subject, "version");
  if (name.empty()) return text_of(subject, "spec");
  return version.empty() ? name : name + " " + version;
}

}  // namespace

std::string run_title(const Json& header) {
  const std::string conditions = conditions_of(header).short_text();
  return conditions.empty() ? subject_title(header)
                            : fmt::format("{} ({})", subject_title(header), conditions);
}

std::string stale_sentence(const std::string& entry) {
  return "An entry of the subject's files is stale: " + entry;
}

RunState run_state(const report::Summary& summary, const Json& header, const Json* footer) {
  RunState state;
  state.subject = subject_title(header);
  state.summary = summary.finish(header, footer, 0);
  if (footer == nullptr) {
    state.unfinished = "The run did not come to its end: the results file has no footer.";
    const bool failed = state.summary["headline"]["noGo"] > 0;
    state.decision = failed ? "NO-GO" : "INCOMPLETE";
    state.head = summary.scope().head(state.decision) + conditions_of(header).text();
    return state;
  }
  state.footer = *footer;
  state.decision = text_of(*footer, "decision");
  if (state.decision.empty()) state.decision = text_of(state.summary["headline"], "decision");
  state.stale = report::texts_of(*footer, "stale");
  state.head = summary.scope().head(state.decision, RunScope::kAll, state.stale) +
               conditions_of(header, *footer).text();
  return state;
}

}  // namespace gonogo::oracle::evidence
