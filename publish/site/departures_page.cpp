// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "publish/report/clauses.hpp"
#include "publish/site/page.hpp"

namespace gonogo::oracle::site {
namespace {

// The cases of one run that depart so.
std::string share(const SiteView& site, std::size_t run, const Departure& departure) {
  const auto found = departure.shares.find(run);
  if (found == departure.shares.end()) return "<td></td>";
  const Departure::Share& share = found->second;
  const std::string cases = grouped(share.cases);
  const Run& one = site.gathered->runs[run];
  std::string cell =
      fmt::format("<td class=\"has{}\" title=\"{}, first: {}\">",
                  share.known == share.cases ? " known" : "", text(one.title()), text(share.first));
  cell += site.reports ? fmt::format("<a href=\"runs/{}/index.html#case={}\">{}</a>", one.stem,
                                     text(share.first), cases)
                       : cases;
  if (share.known > 0 && share.known < share.cases) {
    cell += fmt::format("<span class=\"level\">{} known</span>", grouped(share.known));
  }
  return cell + "</td>";
}

std::string row_of(const SiteView& site, const Departure& departure) {
  const reference::Clause* clause = report::find_clause(departure.key.clause);
  std::string runs;
  for (const auto& [run, share] : departure.shares) {
    runs += fmt::format("{}{}", runs.empty() ? "" : " ", run);
  }
  std::string row = fmt::format(
      "<tr data-who=\"{}\"><th scope=\"row\"><span class=\"badge {}\">{}</span> <span "
      "class=\"mono\">{}</span><span class=\"level\">{} {}</span></th><td class=\"says\">{}<div "
      "class=\"level\">{}: {}</div></td><td class=\"number\">{}</td><td class=\"number\">{}</td>",
      runs, decision(departure.key.kind) == Decision::no_go ? "no-go" : "undecided",
      name(departure.key.kind), text(departure.key.clause), text(departure.key.dialect),
      text(departure.text().substr(std::min(departure.text().size(), departure.text().find('(')))),
      clause == nullptr ? "" : text(clause->text),
      case_link(site, departure.smallest.run, departure.smallest.id),
      text(departure.smallest.message), grouped(departure.shares.size()), grouped(departure.cases));
  for (std::size_t i = 0; i < site.gathered->runs.size(); ++i) row += share(site, i, departure);
  return row + "</tr>\n";
}

}  // namespace

std::string departures_page(const SiteView& site) {
  std::string rows;
  for (const Departure* departure : site.gathered->departures.list()) {
    rows += row_of(site, *departure);
  }
  if (rows.empty()) {
    return page(site, kPages[2],
                section("departures", "Departures", "<p>No run departs from the reference.</p>\n"));
  }
  const std::string head =
      "<th>Departure</th><th>What the manual says, and a small case</th><th class=\"number\">Runs"
      "</th><th class=\"number\">Cases</th>" +
      run_heads(site);
  return page(
      site, kPages[2],
      section(
          "departures", "Departures, each once",
          "<p class=\"note\">Cases that depart in the same way, whoever does: dialect, verdict, "
          "clause and what it is about are the same. Those that most runs have stand first. "
          "Yellow: known, by the run's own file of known failures.</p>\n" +
              filter(site, "departure-table", true) + table("departure-table", head, rows, true)));
}

}  // namespace gonogo::oracle::site
