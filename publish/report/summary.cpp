// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/report/summary.hpp"

#include <algorithm>

#include "oracle/records/cycle_table.hpp"
#include "oracle/records/followed_readings.hpp"
#include "oracle/records/rounding_census.hpp"
#include "publish/report/command.hpp"
#include "publish/report/json_value.hpp"
#include "reference/dialect.hpp"

namespace gonogo::oracle::report {
namespace {

Json clause_json(const reference::Clause& clause) {
  return {{"id", clause.id},
          {"level", reference::name(clause.level)},
          {"source", clause.source},
          {"text", clause.text}};
}

bool has_feature(const Json& header, std::string_view feature) {
  const auto features = texts_of(header.value("subject", Json::object()), "features");
  return std::ranges::count(features, feature) > 0;
}

// The readings that the certifier chose, in the profile or on the command line.
Json chosen_readings(const Json& header) {
  Json chosen = header.value("/profile/readings"_json_pointer, Json::object());
  for (const std::string& choice : texts_of(header, "readings")) {
    const std::size_t equals = choice.find('=');
    if (equals == std::string::npos || !chosen.is_object()) continue;
    chosen[choice.substr(0, equals)] = choice.substr(equals + 1);
  }
  return chosen;
}

// Readings that depend on a clause, with the value that the certifier chose.
Json readings_of(std::string_view clause, const Json& header) {
  Json list = Json::array();
  const Json chosen = chosen_readings(header);
  for (const reference::Reading& reading : reference::readings()) {
    if (reference::clause_name(reading.clause) != clause) continue;
    const std::string set = text_of(chosen, std::string(reading.name).c_str());
    list.push_back({{"name", reading.name},
                    {"text", reading.text},
                    {"value", set.empty() ? std::string(reading.fallback) : set},
                    {"default", set.empty()}});
  }
  return list;
}

// Whether the footer's totals are these, in any order.
bool same_totals(const Json& told, const std::map<std::string, std::uint64_t>& own) {
  return told.is_object() && told.size() == own.size() &&
         std::ranges::all_of(own, [&](const auto& total) {
           const auto found = told.find(total.first);
           return found != told.end() && *found == total.second;
         });
}

Json group_json(const RunScope::Group& group, Json about) {
  about["cases"] = group.cases;
  about["first_cases"] = group.first;
  return about;
}

bool contains_no_go(const Json& totals) {
  if (!totals.is_object()) return false;
  return std::ranges::any_of(totals.items(), [](const auto& total) {
    return decision_of(total.key()) == Decision::no_go && total.value() != 0;
  });
}

// The groups of a scope: what was not claimed, what was declared and skipped, the advices.
Json scope_json(const RunScope& scope) {
  Json features = Json::object();
  for (const auto& [dialect, seen] : scope.features()) {
    for (const auto& [feature, cases] : seen) {
      if (cases.all() == cases.skipped && cases.cases == 0) continue;
      features[dialect][feature] = {{"judged", cases.cases},
                                    {"no_go", cases.no_go},
                                    {"skipped", cases.skipped},
                                    {"unsettled", cases.unsettled},
                                    {"go", cases.is_go()}};
    }
  }
  Json not_claimed = Json::array();
  for (const auto& [key, group] : scope.not_claimed()) {
    Json about = {{"dialect", key.dialect}};
    if (!key.feature.empty()) about["feature"] = key.feature;
    if (!key.message.empty()) about["reason"] = key.message;
    not_claimed.push_back(group_json(group, about));
  }
  Json broken = Json::array();
  for (const auto& [key, group] : scope.broken()) {
    broken.push_back(group_json(
        group, {{"dialect", key.dialect}, {"cycle", key.cycle}, {"reason", key.message}}));
  }
  Json advices = Json::array();
  for (const auto& [key, group] : scope.advices()) {
    advices.push_back(group_json(group, {{"clause", key.clause}, {"departure", key.departure}}));
  }
  const CycleTable table = cycle_table(scope);
  Json cycles = {{"columns", CycleTable::kColumns},
                 {"used", table.used},
                 {"rows", Json::array()},
                 {"others", table.others},
                 {"counting", table.counts_otherwise ? CycleTable::kCounting : ""}};
  for (const CycleTable::Row& row : table.rows) {
    cycles["rows"].push_back(
        {{"cycle", row.cycle}, {"name", table.name(row)}, {"cases", row.cases}});
  }
  return {{"features", features},
          {"cycles", cycles},
          {"not_claimed", not_claimed},
          {"declared_but_skipped", broken},
          {"advices", advices}};
}

// The findings in their order, for the page.
Json findings_json(const Findings& findings) {
  Json list = Json::array();
  for (const Finding* finding : findings.list()) {
    Json cycles = Json::object();
    for (const auto& [cycle, cases] : finding->by_cycle) cycles[cycle] = cases;
    Json verdicts = Json::object();
    for (const auto& [kind, cases] : finding->kinds) verdicts[std::string(name(kind))] = cases;
    Json one = {{"number", finding->number},
                {"text", finding->text()},
                {"line", finding->line()},
                {"verdicts", verdicts},
                {"dialect", finding->shown.dialect},
                {"clause", finding->shown.clause},
                {"cases", finding->cases},
                {"cycles", cycles},
                {"smallest",
                 {{"id", finding->smallest.id},
                  {"blocks", finding->smallest.blocks},
                  {"message", finding->smallest.message}}}};
    if (!finding->cause.empty()) {
      one["cause"] = finding->cause.name;
      one["causeText"] = finding->cause.text();
    }
    list.push_back(std::move(one));
  }
  return list;
}

// What is said of the coordinates of each dialect.
Json coordinates_json(const Json* footer) {
  Json texts = Json::object();
  if (footer == nullptr || !footer->contains("coordinates")) return texts;
  const Json& told = (*footer)["coordinates"];
  if (!told.is_object()) return texts;
  for (const auto& [dialect, source] : told.items()) {
    if (const auto census = RoundingCensus::from_json(source)) texts[dialect] = census->text();
  }
  return texts;
}

}  // namespace

Decision decision_of(const std::string& verdict) {
  const auto kind = verdict_kind(verdict);
  return kind ? decision(*kind) : Decision::no_go;
}

Summary::Summary(const Json& header) : scope_(declared_in(header)) {}

const Finding* Summary::add(const CaseHead& line) {
  const VerdictKind kind = verdict_kind(line.verdict).value_or(VerdictKind::oracle_error);
  scope_.add(line, kind);
  ++cases_;
  ++totals_[line.verdict];
  std::uint64_t& judged = judged_[line.dialect];
  const Decision its = decision_of(line.verdict);
  if (line.verdict == "skip") return nullptr;
  cycles_.insert(line.cycle);
  if (is_judged(kind)) ++judged;
  auto hit = [&](const std::string& clause) {
    MatrixCell& cell = cells_[clause][line.cycle];
    switch (its) {
      case Decision::go:
        ++cell.passed;
        break;
      case Decision::no_go:
        ++(clause == line.clause ? cell.failed : cell.elsewhere);
        break;
      case Decision::undecided:
        ++cell.undecided;
        break;
      case Decision::neither:
        ++cell.elsewhere;
        break;
    }
  };
  if (!line.clause.empty()) hit(line.clause);
  for (auto clause = line.clauses.begin(); clause != line.clauses.end(); ++clause) {
    // Each clause counts once a case.
    if (*clause != line.clause && std::find(line.clauses.begin(), clause, *clause) == clause) {
      hit(*clause);
    }
  }
  return findings_.add(line, kind);
}

// Whether all of the corpus was judged, under the subject's own numbers (J-RUN-01).
bool Summary::is_whole(const RunConditions& conditions, const Json* footer) const {
  const std::size_t unjudged =
      scope_.skipped() + scope_.advised() + scope_.known() + scope_.undecided();
  return unjudged == 0 && conditions.are_none() && footer != nullptr &&
         footer->value("left_out", std::size_t{0}) == 0;
}

Json Summary::headline(const Json& header, const Json* footer, std::uint64_t bad_lines) const {
  std::uint64_t count[kDecisions] = {};
  for (const auto& [verdict, cases] : totals_) {
    count[static_cast<std::size_t>(decision_of(verdict))] += cases;
  }
  Json reasons = Json::array();
  if (footer == nullptr) {
    reasons.push_back(
        "The results file has no footer: the run did not come to its end, and cases are missing.");
  }
  if (bad_lines > 0) reasons.push_back("The results file has lines that cannot be read.");
  const Json totals = footer != nullptr ? footer->value("totals", Json::object()) : Json::object();
  if (footer != nullptr && !same_totals(totals, totals_)) {
    reasons.push_back("The totals of the footer are not those of the cases in the file.");
  }
  const bool whole = reasons.empty();
  if (cases_ == 0) reasons.push_back("No case was run.");
  for (const auto& [dialect, judged] : judged_) {
    if (judged == 0) reasons.push_back("No case of dialect " + dialect + " was judged.");
  }
  if (totals_.contains("oracle-error")) {
    reasons.push_back("The gauge itself failed on at least one case (oracle-error).");
  }
  const RunConditions conditions = conditions_of(header, footer == nullptr ? Json() : *footer);
  const std::string hardly = hardly_answered(conditions.fresh.value_or(FreshCounts()));
  if (!hardly.empty()) {
    reasons.push_back("Hardly any fresh program of dialect " + hardly + " was judged.");
  }
  const std::string said = footer != nullptr ? text_of(*footer, "decision") : "";
  const bool undecided = said == "UNDECIDED" && whole;
  if (undecided && reasons.empty()) {
    reasons.push_back("The gauge could not judge a case that the corpus expects it to judge.");
  }
  const auto no_go = static_cast<std::size_t>(Decision::no_go);
  const bool failed = count[no_go] > 0 || contains_no_go(totals) || said == "NO-GO";
  const char* decision = failed            ? "NO-GO"
                         : undecided       ? "UNDECIDED"
                         : reasons.empty() ? "GO"
                                           : "INCOMPLETE";
  const std::vector<std::string> stale =
      footer == nullptr ? std::vector<std::string>() : texts_of(*footer, "stale");
  const std::string granted = conditions.short_text();
  return {{"decision", decision},
          {"head", scope_.head(decision, RunScope::kAll, stale) + conditions.text()},
          {"short",
           scope_.short_head(decision, stale) + (granted.empty() ? "" : " \xC2\xB7 " + granted)},
          {"incomplete", reasons},
          {"judged", scope_.judged()},
          {"advices", scope_.advised()},
          {"notClaimed", scope_.skipped()},
          {"known", scope_.known()},
          {"whole", is_whole(conditions, footer)},
          {"cases", cases_},
          {"go", count[static_cast<std::size_t>(Decision::go)]},
          {"noGo", count[no_go]},
          {"undecided", scope_.undecided()},
          {"notCovered", scope_.not_covered()}};
}

Json Summary::matrix() const {
  Json cells = Json::object();
  for (const auto& [clause, by_cycle] : cells_) {
    for (const auto& [cycle, cell] : by_cycle) {
      cells[clause][cycle] = {cell.passed, cell.failed, cell.undecided, cell.elsewhere};
    }
  }
  return cells;
}

Json Summary::not_checked(const Json& header) const {
  Json open = Json::array();
  for (const reference::Clause& clause : reference::clauses()) {
    if (clause.level != reference::ClauseLevel::open) continue;
    if (!cells_.contains(std::string(clause.id))) continue;
    open.push_back({{"clause", clause.id}, {"readings", readings_of(clause.id, header)}});
  }
  Json outside = Json::object();
  for (const auto& [dialect, judged] : judged_) {
    const reference::Dialect* known = reference::find_dialect(dialect);
    if (known == nullptr) continue;
    for (const reference::OutsideCode& code : reference::outside_codes(*known->descriptor)) {
      outside[dialect].push_back({{"code", code.code}, {"title", code.title}});
    }
  }
  Json skips = Json::object();
  for (const auto& [key, group] : scope_.not_claimed()) {
    const std::string& what = key.feature.empty() ? key.message : key.feature;
    skips[what] = skips.value(what, std::size_t{0}) + group.cases;
  }
  return {{"m", !has_feature(header, "m")},
          {"blocks", !has_feature(header, "blocks")},
          {"open", open},
          {"skips", skips},
          {"outside", outside}};
}

std::string Summary::follows(const Json* footer) {
  return followed_readings(footer == nullptr ? std::vector<std::string>()
                                             : texts_of(*footer, "assignments"));
}

Json Summary::finish(const Json& header, const Json* footer, std::uint64_t bad_lines) const {
  // For the dialects that were judged, and what else was hit.
  std::set<std::string_view> shown;
  for (const auto& [dialect, judged] : judged_) {
    const reference::Dialect* known = reference::find_dialect(dialect);
    if (judged == 0 || known == nullptr) continue;
    for (const reference::Clause& clause : known->clauses) shown.insert(clause.id);
  }
  for (const auto& [clause, by_cycle] : cells_) shown.insert(clause);
  Json catalog = Json::array();
  std::uint64_t others = 0;
  for (const reference::Clause& clause : reference::clauses()) {
    if (shown.contains(clause.id)) {
      catalog.push_back(clause_json(clause));
    } else {
      ++others;
    }
  }
  Json decisions = Json::object();
  for (const auto& [verdict, cases] : totals_) {
    constexpr const char* kNames[kDecisions] = {"go", "no-go", "undecided", "neither"};
    decisions[verdict] = kNames[static_cast<std::size_t>(decision_of(verdict))];
  }
  return {{"header", header},
          {"footer", footer != nullptr ? *footer : Json(nullptr)},
          {"coordinates", coordinates_json(footer)},
          {"follows", follows(footer)},
          {"headline", headline(header, footer, bad_lines)},
          {"totals", totals_},
          {"decisions", decisions},
          {"judged", judged_},
          {"cycles", cycles_},
          {"catalog", catalog},
          {"otherClauses", others},
          {"matrix", matrix()},
          {"findings", findings_json(findings_)},
          {"scope", scope_json(scope_)},
          {"notChecked", not_checked(header)},
          {"command", command_for_case(header)},
          {"freshCommand", command_for_case(header, CaseOf::fresh)},
          {"runCommand", command_for_run(header)}};
}

}  // namespace gonogo::oracle::report
