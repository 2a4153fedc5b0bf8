// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "publish/report/clauses.hpp"
#include "publish/site/page.hpp"

namespace gonogo::oracle::site {
namespace {

std::string ballots(const SiteView& site) {
  const Votes& votes = site.gathered->votes;
  std::string rows;
  for (std::size_t i = 0; i < kBallots; ++i) {
    const auto ballot = static_cast<Ballot>(i);
    const auto found = votes.ballots().find(ballot);
    rows += fmt::format(
        "<tr><th scope=\"row\">{}</th><td class=\"number\" id=\"{}\">{}</td></tr>\n", title(ballot),
        key(ballot), found == votes.ballots().end() ? "0" : grouped(found->second));
  }
  rows += fmt::format(
      "<tr><th scope=\"row\">fewer than two answered</th><td class=\"number\" id=\"alone\">{}</td>"
      "</tr>\n",
      grouped(votes.alone()));
  return "<p class=\"note\">One vote an implementation, that of its last version: " +
         who(site, site.gathered->voters) + "</p>\n" +
         table("ballot-table", "<th>They vote</th><th class=\"number\">Cases</th>", rows);
}

std::string pairs(const SiteView& site) {
  const std::vector<std::size_t>& voters = site.gathered->voters;
  std::string head = "<th></th>";
  std::string rows;
  for (const std::size_t one : voters) {
    head += "<th scope=\"col\" class=\"like\">" + text(site.gathered->runs[one].title()) + "</th>";
    rows += "<tr><th scope=\"row\">" + text(site.gathered->runs[one].title()) + "</th>";
    for (const std::size_t other : voters) {
      const Pair pair = site.gathered->votes.pair(one, other);
      if (one == other || pair.both == 0) {
        rows += "<td class=\"like\">&ndash;</td>";
        continue;
      }
      rows += fmt::format(
          "<td class=\"like\" title=\"{} of {} alike\">{}<div class=\"level\">{} against the "
          "reference</div></td>",
          grouped(pair.alike), counted(pair.both, "case", "cases"), percent(pair.alike, pair.both),
          grouped(pair.depart_alike));
    }
    rows += "</tr>\n";
  }
  return "<p class=\"note\">Cases that both answered alike, and how many of them are against "
         "the reference.</p>\n" +
         table("pair-table", head, rows);
}

std::string row_of(const SiteView& site, const Agreement& one) {
  const reference::Clause* clause = report::find_clause(one.key.clause);
  std::string more;
  if (one.cases > one.first.size()) {
    more = fmt::format(" and {} more", grouped(one.cases - one.first.size()));
  }
  return fmt::format(
      "<tr><td>{}</td><td><span class=\"badge no-go\">{}</span> <span class=\"mono\">{}</span><div "
      "class=\"level\">{}: {}</div></td><td>{}</td><td>{}</td><td>{}</td><td class=\"number\">{}"
      "</td><td class=\"ids\">{}{}<div class=\"level\">{}</div></td></tr>\n",
      title(one.key.ballot), text(one.key.verdict), text(one.key.clause), text(one.key.dialect),
      clause == nullptr ? "" : text(clause->text), who(site, one.key.alike),
      who(site, one.key.with), who(site, one.key.other), grouped(one.cases),
      case_links(site, one.key.alike.front(), one.first), more, text(one.message));
}

std::string agreements(const SiteView& site) {
  std::string rows;
  for (const Agreement* one : site.gathered->votes.list()) rows += row_of(site, *one);
  if (rows.empty()) return "<p>No two implementations depart alike.</p>\n";
  return "<p class=\"note\">Alike: at the same clause, by the same deviation to 0.001 mm, or "
         "with the same record or alarm. Where all who answer agree against the reference, look at "
         "the reference first.</p>\n" +
         filter(site, "agreement-table", false) +
         table("agreement-table",
               "<th>They vote</th><th>Departure</th><th>Alike</th><th>With the reference</th><th>"
               "In another way</th><th class=\"number\">Cases</th><th>First of them</th>",
               rows, true);
}

}  // namespace

std::string vote_page(const SiteView& site) {
  if (site.gathered->voters.size() < 2) {
    return page(site, kPages[3],
                section("vote", "Vote", "<p>A vote needs two implementations or more.</p>\n"));
  }
  return page(site, kPages[3],
              section("vote", "Vote", ballots(site)) +
                  section("pairs", "Who agrees with whom", pairs(site)) +
                  section("against", "Agreed against the reference", agreements(site)));
}

}  // namespace gonogo::oracle::site
