// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "publish/site/page.hpp"

namespace gonogo::oracle::site {
namespace {

std::string_view tone(const std::string& decision) {
  if (decision == "GO") return "go";
  return decision == "NO-GO" ? "no-go" : "undecided";
}

std::string number_cell(std::uint64_t count) {
  return "<td class=\"number\">" + (count == 0 ? "0" : grouped(count)) + "</td>";
}

std::string results_row(const SiteView& site, std::size_t i) {
  const Run& run = site.gathered->runs[i];
  std::string row = fmt::format(
      "<tr><th scope=\"row\">{}<span class=\"level\">corpus {}, gonogo {}</span></th>"
      "<td><span class=\"badge {}\">{}</span></td><td>{}</td><td class=\"number\">{}</td>",
      run_link(site, i), text(run.corpus), text(run.gonogo), tone(run.decision), text(run.decision),
      stacked_bar(run.counts), percent(run.counts[Outcome::go], run.counts.answered()));
  row += number_cell(run.counts.cases());
  for (std::size_t k = 0; k < kOutcomes; ++k) row += number_cell(run.counts.of[k]);
  return row + number_cell(run.reasons.size()) + "</tr>\n";
}

std::string results(const SiteView& site) {
  std::string head =
      "<th>Implementation</th><th>Run</th><th>Cases</th><th class=\"number\">GO of answered</th>"
      "<th class=\"number\">Cases</th>";
  for (std::size_t k = 0; k < kOutcomes; ++k) {
    head += fmt::format("<th class=\"number\">{}</th>", title(static_cast<Outcome>(k)));
  }
  head += "<th class=\"number\">Causes</th>";
  std::string rows;
  for (std::size_t i = 0; i < site.gathered->runs.size(); ++i) rows += results_row(site, i);
  return key_of_bars() + table("results-table", head, rows) +
         "<p class=\"note\">GO of a run with known departures is GO except for those. Causes: the "
         "reasons that its file of known failures gives. Answered: GO or departed; what was "
         "skipped or is undecided counts neither way.</p>\n";
}

std::string counts_hint(const Run& run, const CycleKey& cycle, const Counts& counts) {
  std::string hint = fmt::format("{}, {} of {}:", run.title(), cycle.cycle, cycle.dialect);
  for (std::size_t k = 0; k < kOutcomes; ++k) {
    if (counts.of[k] == 0) continue;
    hint += fmt::format(" {} {};", grouped(counts.of[k]), title(static_cast<Outcome>(k)));
  }
  return hint;
}

std::string matrix(const SiteView& site) {
  std::string rows;
  std::string dialect;
  for (const CycleKey& cycle : site.gathered->cycles()) {
    if (cycle.dialect != dialect) {
      dialect = cycle.dialect;
      rows +=
          fmt::format("<tr class=\"group\"><th colspan=\"{}\" scope=\"rowgroup\">{}</th></tr>\n",
                      site.gathered->runs.size() + 1, text(dialect));
    }
    rows += "<tr><th scope=\"row\" class=\"stay\">" + text(cycle.cycle) + "</th>";
    for (const Run& run : site.gathered->runs) {
      const Counts counts = run.of_cycle(cycle);
      rows += share_cell(counts[Outcome::go], counts.answered(), counts_hint(run, cycle, counts));
    }
    rows += "</tr>\n";
  }
  return "<p class=\"note\">GO of the cases that were answered; a dash: none was. The pointer on a "
         "cell tells the rest.</p>\n" +
         table("matrix-table", "<th class=\"stay\">Cycle</th>" + run_heads(site), rows, true);
}

}  // namespace

std::string overview_page(const SiteView& site) {
  return page(site, kPages[0],
              section("results", "Results", results(site)) +
                  section("cycles", "Implementations and cycles", matrix(site)));
}

}  // namespace gonogo::oracle::site
