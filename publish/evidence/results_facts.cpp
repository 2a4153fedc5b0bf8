// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/results_facts.hpp"

#include <fmt/format.h>

#include "campaign/case_roll.hpp"
#include "campaign/results.hpp"
#include "publish/report/json_value.hpp"

namespace gonogo::oracle::evidence {

std::vector<std::string> texts_in(const Json& object, const char* key) {
  std::vector<std::string> texts;
  for (const Json& item : object.value(key, Json::array())) {
    if (item.is_string()) texts.push_back(item.get<std::string>());
  }
  return texts;
}

ResultsFacts read_results(const std::string& path) {
  ResultsReader reader(path);
  ResultsFacts facts;
  facts.header = reader.header();
  Tally tally(declared_in(facts.header));
  for (CaseHead head; reader.next(head);) {
    const CaseFacts line = facts_of(reader.text());
    if (!line.mapped.empty()) facts.mapped.insert(line.mapped);
    const VerdictKind kind = tally.add(line);
    if (!is_fresh(head.id)) {
      if (is_judged(line.verdict)) ++facts.judged[line.dialect];
      facts.is_no_go = facts.is_no_go || decision(line.verdict) == Decision::no_go;
      facts.is_known = facts.is_known || line.verdict == VerdictKind::xfail;
    }
    const std::string against = tally.conflict() ? tally.conflict()->against : std::string();
    if (!head.against.empty() && head.against != against) {
      facts.inconsistent.push_back(fmt::format(
          "{}: the line is held against {}, but by the readings of the whole run against "
          "{}.",
          head.id, head.against, against.empty() ? "none" : against));
    }
    if (name(kind) == head.verdict) continue;
    facts.inconsistent.push_back(
        fmt::format("{}: the line says {}, but with the readings of the whole run it is {}.",
                    head.id, head.verdict, name(kind)));
  }
  if (!reader.footer()) {
    throw ResultsError(fmt::format("{} has no footer: it is incomplete.", path));
  }
  facts.footer = *reader.footer();
  facts.answer =
      tally.finish(texts_in(facts.footer, "stale"), conditions_of(facts.header, facts.footer));
  return facts;
}

}  // namespace gonogo::oracle::evidence
