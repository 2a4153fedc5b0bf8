// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <set>

#include "publish/report/clauses.hpp"
#include "publish/site/page.hpp"

namespace gonogo::oracle::site {
namespace {

// Those of the catalog in its order, then those that it does not have.
std::vector<std::string> clauses_in_order(const Gathered& gathered) {
  std::set<std::string> met;
  for (const Run& run : gathered.runs) {
    for (const auto& [clause, counts] : run.clauses) met.insert(clause);
  }
  std::vector<std::string> order;
  for (const reference::Clause& clause : reference::clauses()) {
    if (met.erase(std::string(clause.id)) > 0) order.emplace_back(clause.id);
  }
  order.insert(order.end(), met.begin(), met.end());
  return order;
}

std::string hint(const Run& run, const std::string& clause, const ClauseCounts& counts) {
  return fmt::format("{}, {}: {} passed, {} depart here, {} at another clause, {} undecided",
                     run.title(), clause, grouped(counts.passed), grouped(counts.departed),
                     grouped(counts.elsewhere), grouped(counts.undecided));
}

std::string row_of(const SiteView& site, const std::string& id) {
  const reference::Clause* clause = report::find_clause(id);
  std::string row = fmt::format(
      "<tr id=\"{0}\"><th scope=\"row\" class=\"stay\"><span class=\"mono\">{0}</span><span "
      "class=\"level\">{1}</span></th><td class=\"says\">{2}</td>",
      text(id), clause == nullptr ? "" : text(reference::name(clause->level)),
      clause == nullptr ? "not in the catalog" : text(clause->text));
  for (const Run& run : site.gathered->runs) {
    const auto found = run.clauses.find(id);
    const ClauseCounts counts = found == run.clauses.end() ? ClauseCounts{} : found->second;
    row += share_cell(counts.passed, counts.passed + counts.departed, hint(run, id, counts));
  }
  return row + "</tr>\n";
}

}  // namespace

std::string clause_page(const SiteView& site) {
  std::string rows;
  for (const std::string& clause : clauses_in_order(*site.gathered)) rows += row_of(site, clause);
  const std::string head =
      "<th class=\"stay\">Clause</th><th>What the manual says</th>" + run_heads(site);
  return page(
      site, kPages[1],
      section("clauses", "Implementations and clauses",
              "<p class=\"note\">Cases that test the clause and passed, of them and those "
              "that depart at it.</p>\n" +
                  filter(site, "clause-table", false) + table("clause-table", head, rows, true)));
}

}  // namespace gonogo::oracle::site
