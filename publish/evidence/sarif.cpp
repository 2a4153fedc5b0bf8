// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/sarif.hpp"

#include <fmt/format.h>

#include <cctype>

#include "campaign/encoding.hpp"
#include "oracle/records/text.hpp"
#include "publish/evidence/certificate_files.hpp"
#include "publish/evidence/run_state.hpp"
#include "publish/evidence/text.hpp"
#include "publish/evidence/verdict_meaning.hpp"
#include "publish/report/case_paths.hpp"
#include "publish/report/clauses.hpp"
#include "publish/report/command.hpp"
#include "publish/report/json_value.hpp"
#include "reference/dialect.hpp"

namespace gonogo::oracle::evidence {

using report::text_of;

namespace {

// The folder of the report, from which the programs are named.
constexpr const char* kReportBase = "REPORT";
// What an entry of the subject's files that is no longer true departs from.
constexpr const char* kStaleRule = "stale";

// The first dialect that has the clause.
std::string_view dialect_of(std::string_view id) {
  for (const reference::Dialect& dialect : reference::dialects()) {
    for (const reference::Clause& clause : dialect.clauses) {
      if (clause.id == id) return dialect.name;
    }
  }
  return {};
}

// The place of a clause, which is an anchor on the page of its dialect, or that of the verdicts.
std::string page_of(const std::string& rule, std::string_view address) {
  const std::string_view dialect = dialect_of(rule);
  if (dialect.empty()) return fmt::format("{}/docs/judging.md", address);
  std::string anchor;
  for (const char c : rule) {
    anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return fmt::format("{}/docs/dialects/{}.md#{}", address, dialect, anchor);
}

Json text_json(std::string_view text) {
  return {{"text", visible(text, Lines::kept)}};
}

// The clause, but not where the case did not come so far as to depart from one.
std::string rule_of(const CaseRow& facts) {
  return facts.clause.empty() ? std::string(facts.verdict()) : facts.clause;
}

// The same finding in two runs has the same: case and rule say what is at fault, numbers may move.
std::string fingerprint(const CaseRow& facts) {
  return sha256_of_text(facts.id + "\n" + rule_of(facts) + "\n");
}

Json location(const CaseRow& facts) {
  Json place;
  if (facts.program) {
    place["physicalLocation"] = {
        {"artifactLocation",
         {{"uri", "programs/" + file_stem(facts.id) + ".nc"}, {"uriBaseId", kReportBase}}},
        {"region", {{"startLine", facts.block.value_or(1)}}}};
  }
  place["logicalLocations"] =
      Json::array({{{"name", facts.id}, {"fullyQualifiedName", facts.dialect + "/" + facts.id}}});
  return place;
}

std::string message(const CaseRow& facts) {
  std::string text =
      fmt::format("{}: {}", facts.verdict(), facts.message.empty() ? "No message." : facts.message);
  if (facts.kind == VerdictKind::advice && !facts.departure.empty()) {
    text += fmt::format("\nIt would be {} if a text of the manual stated it.", facts.departure);
  } else if (facts.kind == VerdictKind::xfail) {
    text += fmt::format("\nIt is known to fail with {}: {}", facts.departure, facts.known);
  }
  auto put = [&](std::string_view what, const std::string& value) {
    if (!value.empty()) text += fmt::format("\n{}: {}", what, value);
  };
  put("Rule", rule_text(facts.rule));
  put("Undecided for", facts.gap);
  put("Want", facts.want);
  put("Got", facts.got);
  put("Deviation", deviation_text(facts));
  put("GO under the reading", facts.reading);
  return text;
}

Json properties(const Json& header, const CaseRow& facts) {
  Json bag = {{"case", facts.id},
              {"dialect", facts.dialect},
              {"cycle", facts.cycle},
              {"verdict", facts.verdict()}};
  auto put = [&](const char* key, const std::string& value) {
    if (!value.empty()) bag[key] = value;
  };
  put("clause", facts.clause);
  put("departure", facts.departure);
  put("basis", facts.basis);
  put("rule", facts.rule);
  put("gap", facts.gap);
  put("known", facts.known);
  put("want", facts.want);
  put("got", facts.got);
  if (!facts.deviation_exact.empty()) {
    bag["deviation"] = {{"exact", facts.deviation_exact}, {"mm", facts.deviation_mm}};
  }
  put("reading", facts.reading);
  bag["command"] = again_command(header, facts);
  return bag;
}

Json rule_json(const std::string& id, std::string_view address) {
  Json rule = {{"id", id}};
  if (const reference::Clause* clause = report::find_clause(id)) {
    rule["shortDescription"] = text_json(clause->text);
    rule["fullDescription"] = text_json(fmt::format("{} ({})", clause->text, clause->source));
    rule["help"] =
        text_json(fmt::format("{}: {} ({}). `gonogo spec --dialect {}` prints it beside "
                              "the readings that it leaves open.",
                              id, clause->text, clause->source, dialect_of(id)));
    rule["properties"] = {{"document", clause->source}, {"level", reference::name(clause->level)}};
  } else if (id == kStaleRule) {
    const Json text = text_json("An entry of the subject's files is no longer true.");
    rule["shortDescription"] = text;
    rule["help"] = text;
  } else if (const auto kind = verdict_kind(id)) {
    rule["shortDescription"] = text_json(meaning_of(*kind));
    rule["help"] = text_json(meaning_of(*kind));
  }
  if (!address.empty()) rule["helpUri"] = page_of(id, address);
  return rule;
}

}  // namespace

std::string_view address_of_pages() {
  return GONOGO_ADDRESS;
}

SarifWriter::SarifWriter(const std::filesystem::path& path, const Json& header,
                         std::string_view address)
    : out_(path), header_(header), address_(address) {
  // The results come first, so that they need not be kept until the rules are known.
  out_.write(R"({"$schema":"https://json.schemastore.org/sarif-2.1.0.json","version":"2.1.0",)"
             "\n\"runs\":[{\"results\":[");
}

std::size_t SarifWriter::rule_index(const std::string& id) {
  const auto [place, added] = indices_.try_emplace(id, rules_.size());
  if (added) rules_.push_back(id);
  return place->second;
}

Json SarifWriter::result(const CaseRow& facts, const Finding* finding) {
  const std::string rule = rule_of(facts);
  const bool undecided = facts.decision() == Decision::undecided;
  const bool advice = facts.kind == VerdictKind::advice;
  Json result = {{"ruleId", rule},
                 {"ruleIndex", rule_index(rule)},
                 {"kind", undecided ? "open" : "fail"},
                 {"level", undecided ? "none"
                           : advice  ? "note"
                                     : "error"},
                 {"message", text_json(message(facts))},
                 {"locations", Json::array({location(facts)})},
                 {"partialFingerprints", {{"caseAndRule/v1", fingerprint(facts)}}}};
  if (facts.kind == VerdictKind::xfail) {
    result["suppressions"] = Json::array(
        {{{"kind", "external"}, {"status", "accepted"}, {"justification", facts.known}}});
  }
  result["properties"] = properties(header_, facts);
  if (finding != nullptr) {
    result["properties"]["finding"] = finding->text();
    if (!finding->cause.empty()) result["properties"]["cause"] = finding->cause.text();
  }
  return result;
}

void SarifWriter::add(const CaseRow& facts, const Finding* finding) {
  const bool told = facts.decision() == Decision::no_go || facts.kind == VerdictKind::xfail ||
                    facts.kind == VerdictKind::advice || facts.is_unexpected_gap();
  if (told) write_result(result(facts, finding));
}

void SarifWriter::write_result(const Json& result) {
  out_.write(any_ ? ",\n" : "\n");
  out_.write(dump(result));
  any_ = true;
}

void SarifWriter::add_stale(const std::string& entry) {
  Json name = Json::object();
  name["name"] = visible(entry);
  Json place = Json::object();
  place["logicalLocations"] = Json::array({name});
  const std::string hash = sha256_of_text(entry + "\n" + kStaleRule + "\n");
  write_result({{"ruleId", kStaleRule},
                {"ruleIndex", rule_index(kStaleRule)},
                {"kind", "fail"},
                {"level", "error"},
                {"message", text_json(stale_sentence(entry))},
                {"locations", Json::array({place})},
                {"partialFingerprints", {{"caseAndRule/v1", hash}}}});
}

void SarifWriter::finish(const std::string& unfinished) {
  const Json subject = header_.value("subject", Json::object());
  Json driver = {{"name", "gonogo"}};
  if (!address_.empty()) driver["informationUri"] = address_;
  if (const std::string version = text_of(header_, "gonogo"); !version.empty()) {
    driver["version"] = version;
  }
  driver["rules"] = Json::array();
  for (const std::string& id : rules_) driver["rules"].push_back(rule_json(id, address_));
  Json invocation = {{"executionSuccessful", unfinished.empty()}};
  if (header_.contains("argv")) invocation["arguments"] = header_["argv"];
  if (!unfinished.empty()) {
    invocation["toolExecutionNotifications"] =
        Json::array({{{"level", "error"}, {"message", text_json(unfinished)}}});
  }
  out_.write("\n],\n\"tool\":" + dump({{"driver", driver}}));
  const Json base = {{kReportBase, {{"description", text_json("The folder of the report.")}}}};
  out_.write(",\n\"originalUriBaseIds\":" + dump(base));
  out_.write(",\n\"invocations\":" + dump(Json::array({invocation})));
  const Json details = {{"id", "gonogo/" + text_of(subject, "name") + "/"}};
  out_.write(",\n\"automationDetails\":" + dump(details));
  Json bag = {{"subject", subject}, {"corpus", header_.value("corpus", Json::object())}};
  out_.write(",\n\"properties\":" + dump(bag) + "}]}\n");
  out_.commit();
}

}  // namespace gonogo::oracle::evidence
