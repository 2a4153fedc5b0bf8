// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/statement.hpp"

#include <fmt/format.h>

#include <map>
#include <tuple>

#include "campaign/encoding.hpp"
#include "oracle/records/fresh_counts.hpp"
#include "publish/evidence/counted_ids.hpp"
#include "publish/evidence/markdown.hpp"
#include "publish/evidence/run_state.hpp"
#include "publish/evidence/text.hpp"
#include "publish/evidence/verdict_meaning.hpp"
#include "publish/report/case_paths.hpp"
#include "publish/report/json_value.hpp"

namespace gonogo::oracle::evidence {

using report::text_of;

namespace {

constexpr std::size_t kNamedCases = 20;

// Cases that are known to fail, by reason.
Json waivers_json(const std::map<std::string, CountedIds>& waivers) {
  Json list = Json::array();
  for (const auto& [reason, cases] : waivers) {
    if (cases.count == 0) continue;
    list.push_back({{"reason", reason}, {"cases", cases.count}, {"first_cases", cases.first}});
  }
  return list;
}

// The cases that make a NO-GO, by verdict, with the first of each.
Json findings_json(const std::map<VerdictKind, CountedIds>& findings, const Json& totals) {
  Json list = Json::array();
  for (const auto& [kind, cases] : findings) {
    list.push_back({{"verdict", name(kind)},
                    {"cases", totals.value(std::string(name(kind)), std::size_t{0})},
                    {"first_cases", cases.first}});
  }
  return list;
}

// Only names: the statement has to stay short.
Json not_checked_json(const RunState& state) {
  const Json& gaps = state.summary["notChecked"];
  Json unhit = Json::array();
  for (const Json& clause : state.summary["catalog"]) {
    if (!state.summary["matrix"].contains(text_of(clause, "id"))) unhit.push_back(clause["id"]);
  }
  return {{"rapid_paths", true},          {"m", gaps["m"]},
          {"blocks", gaps["blocks"]},     {"clauses_not_hit", unhit},
          {"open_clauses", gaps["open"]}, {"skips", gaps["skips"]},
          {"outside", gaps["outside"]}};
}

Json statement_json(const Json& header, const RunState& state, const Json& waivers,
                    const Json& findings, const std::vector<std::string>& files,
                    const TraceFiles& traces) {
  Json root = {{"format", 1}, {"decision", state.decision}, {"head", state.head}};
  for (const char* key :
       {"subject",   "gonogo",    "gauge",   "corpus",          "profile",   "readings",
        "machine",   "tolerance", "chord",   "feed_resolution", "blend",     "feed_tolerance",
        "show_ids",  "strict",    "sandbox", "capped",          "selection", "known_failures",
        "alarm_map", "seed",      "shard"}) {
    if (header.contains(key)) root[key] = header[key];
  }
  for (const char* key : {"cases", "judged", "left_out", "totals", "assignments", "coordinates",
                          "stale", "unused_alarms", "fresh"}) {
    if (state.footer.contains(key)) root[key] = state.footer[key];
  }
  const Json& scope = state.summary["scope"];
  for (const char* key : {"features", "not_claimed", "declared_but_skipped", "advices"}) {
    root[key] = scope[key];
  }
  root["findings"] = findings;
  root["waivers"] = waivers;
  root["not_checked"] = not_checked_json(state);
  root["results_sha256"] = text_of(state.footer, "sha256");
  root["files"] = files;
  root["traces"] = traces.files == 0 ? Json(nullptr)
                                     : Json({{"files", traces.files}, {"sha256", traces.sha256}});
  return root;
}

// What the subject says that it has, and how exact it is.
std::string declared_text(const Json& subject) {
  const Json dialects = subject.value("dialects", Json(nullptr));
  const std::string what =
      dialects.is_object() ? "" : "no dialects or features: what it skips it does not claim; ";
  Json words = Json::object();
  if (dialects.is_object()) words["dialects"] = dialects;
  words["features"] = subject.value("features", Json::array());
  words["numeric"] = subject.value("numeric", Json::object());
  return what + markdown_code(dump(words));
}

std::string gauge_text(const Json& header) {
  const Json gauge = header.value("gauge", Json::object());
  std::string text = "gonogo " + markdown_text(text_of(header, "gonogo"));
  const std::string commit = text_of(gauge, "commit");
  const std::string sha256 = text_of(gauge, "sha256");
  if (!commit.empty()) text += ", commit " + markdown_code(commit);
  if (!sha256.empty()) text += ", SHA-256 of the program " + markdown_code(sha256);
  return text;
}

// "4,912 of gsk988ta judged (5,000 asked, 6,984 wanted)"
std::string fresh_text(const Json& footer) {
  if (!footer.contains("fresh")) return {};
  std::string text;
  for (const auto& [dialect, count] : fresh_from_json(footer["fresh"])) {
    text += fmt::format("{}{} of {} judged ({} asked, {} wanted)", text.empty() ? "" : "; ",
                        grouped(count.judged), markdown_text(dialect), grouped(count.programs),
                        grouped(count.wanted));
  }
  return text.empty() ? "none asked" : text;
}

std::string facts_of_run(const Json& header, const RunState& state) {
  std::string text;
  auto put = [&](std::string_view what, const std::string& value) {
    if (!value.empty()) text += fmt::format("- {}: {}\n", what, value);
  };
  const Json subject = header.value("subject", Json::object());
  const Json corpus = header.value("corpus", Json::object());
  put("Subject", markdown_text(state.subject));
  put("connected as", markdown_code(text_of(subject, "spec")));
  put("declares", declared_text(subject));
  for (const Json& one : header.value("capped", Json::array())) {
    put("Not granted",
        fmt::format("{} {} of {}: {} counts", markdown_text(text_of(one, "what")),
                    markdown_text(text_of(one, "declared")), markdown_text(text_of(one, "dialect")),
                    markdown_text(text_of(one, "counts"))));
  }
  put("Gauge", gauge_text(header));
  put("Corpus", fmt::format("version {}, SHA-256 {}", markdown_text(text_of(corpus, "version")),
                            markdown_code(text_of(corpus, "sha256"))));
  const Json profile = header.value("profile", Json::object());
  put("Profile", profile.empty() ? "that of each case" : markdown_code(dump(profile)));
  const Json readings = header.value("readings", Json::array());
  if (!readings.empty()) put("Readings asked for", markdown_code(dump(readings)));
  const std::string tolerance = text_of(header, "tolerance");
  put("Tolerance", tolerance.empty() ? "as the subject and the profile declare it"
                                     : markdown_text(tolerance) + " mm, granted by the certifier");
  for (const auto& [key, title, unit] :
       {std::tuple("chord", "Chord", " mm"), std::tuple("feed_resolution", "Feed resolution", ""),
        std::tuple("blend", "Blend", " mm"),
        std::tuple("feed_tolerance", "Feed tolerance", " %")}) {
    const std::string granted = text_of(header, key);
    if (!granted.empty()) put(title, markdown_text(granted) + unit + ", granted by the certifier");
  }
  if (header.value("show_ids", Json(false)) == true) {
    put("Names of cases", "are told to the subject (--show-ids): it may look answers up by them");
  }
  put("Sandbox", text_of(header, "sandbox"));
  put("Advices", header.value("strict", Json(false)) == true ? "are NO-GO (--strict)"
                                                             : "are listed, and are no NO-GO");
  if (header.contains("selection")) {
    put("Cases asked for", markdown_code(dump(header["selection"])));
  }
  put("Fresh programs", fresh_text(state.footer));
  put("Seed of the order and of the fresh programs", dump(header.value("seed", Json(0))));
  put("Shard", markdown_text(text_of(header, "shard")));
  put("SHA-256 of the case lines", markdown_code(text_of(state.footer, "sha256")));
  return text;
}

std::string statement_text(const Json& header, const RunState& state, const Json& root) {
  std::string text = fmt::format(
      "# {}\n\nThe gauge GoNoGo judged the subject below case by case against the reference. This "
      "statement says what was judged and what came of it; `gonogo verify` on this folder checks "
      "it.\n\n## What was judged\n\n{}\n## What came of it\n\n**{}**\n\n{}",
      state.decision, facts_of_run(header, state), markdown_text(state.head),
      totals_table(state.footer.value("totals", Json::object())));
  for (const Json& finding : root["findings"]) {
    const auto kind = verdict_kind(text_of(finding, "verdict"));
    text += fmt::format("\n- {}: {} {}", text_of(finding, "verdict"), kind ? meaning_of(*kind) : "",
                        named_cases(finding));
  }
  const Json& scope = state.summary["scope"];
  auto put = [&](std::string_view title, const std::string& list) {
    if (!list.empty()) text += fmt::format("\n## {}\n\n{}", title, list);
  };
  put("Declared, but skipped", declared_but_skipped_list(scope));
  put(kAdvicesTitle, advice_list(scope));
  put(kNotClaimedTitle, not_claimed_list(scope));
  text += "\n## Readings\n\n";
  const std::string followed = markdown_text(text_of(state.summary, "follows"));
  text += followed.empty() ? "No case that passed depended on an open reading.\n"
                           : "Everything that passed follows " + followed + ".\n";
  put(kCoordinatesTitle, coordinates_list(state));
  text += "\n## Waivers\n\n";
  if (root["waivers"].empty()) text += "None.\n";
  for (const Json& waiver : root["waivers"]) {
    text += fmt::format("- {} ({}): {}\n", markdown_text(text_of(waiver, "reason")),
                        waiver["cases"].dump(), named_cases(waiver));
  }
  for (const std::string& entry : state.stale) {
    text += "- stale: " + markdown_code(entry) + "\n";
  }
  text += "\n## What was not checked\n\n" + not_checked_list(state);
  const Json& traces = root["traces"];
  text += "\n## Traces\n\n";
  text += traces.is_null()
              ? std::string("None are kept: a pass is proven by running the subject again.\n")
              : fmt::format(
                    "What the subject sent for {} cases lies in `{}`: every verdict that "
                    "hangs on it can be derived again without the subject.\n",
                    grouped(traces["files"].get<std::size_t>()), kTraces);
  return text;
}

}  // namespace

std::string unnamed_dialect(const Json& header) {
  const Json selection = header.value("selection", Json::object());
  const Json dialects = selection.value("dialects", Json::array());
  return dialects.size() == 1 ? dialects.front().get<std::string>() : std::string();
}

Statement make_statement(const std::string& results, const std::vector<std::string>& reasons,
                         const std::vector<std::string>& files, const TraceFiles& traces) {
  ResultsReader reader(results);
  report::Summary summary(reader.header());
  std::map<std::string, CountedIds> waivers;
  for (const std::string& reason : reasons) waivers[reason];
  std::map<VerdictKind, CountedIds> findings;
  CaseHead head;
  while (reader.next(head)) {
    summary.add(head);
    const CaseRow row = case_row(head);
    if (row.kind == VerdictKind::xfail) {
      const auto waiver = waivers.find(row.known);
      if (waiver == waivers.end()) {
        throw ResultsError(fmt::format(
            "{}: the case {} is known to fail, but the file of known failures that was given does "
            "not hold its reason.",
            results, row.id));
      }
      waiver->second.add(row.id, kNamedCases);
    }
    if (row.decision() == Decision::no_go || row.is_unexpected_gap()) {
      findings[row.kind].add(row.id, kNamedCases);
    }
  }
  if (!reader.footer()) {
    throw ResultsError(fmt::format(
        "{} has no footer: the run did not come to its end, and there is nothing to certify.",
        results));
  }
  const RunState state = run_state(summary, reader.header(), &*reader.footer());
  const Json root = statement_json(
      reader.header(), state, waivers_json(waivers),
      findings_json(findings, state.footer.value("totals", Json::object())), files, traces);
  return {dump(root, 1) + "\n", statement_text(reader.header(), state, root)};
}

}  // namespace gonogo::oracle::evidence
