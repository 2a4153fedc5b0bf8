// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "publish/site/page.hpp"

namespace gonogo::oracle::site {
namespace {

std::string milliseconds(std::uint64_t microseconds) {
  return fmt::format("{}.{:03} ms", grouped(microseconds / 1000), microseconds % 1000);
}

std::string rates(const SiteView& site) {
  std::string rows;
  for (std::size_t i = 0; i < site.gathered->runs.size(); ++i) {
    const Speed& speed = site.gathered->runs[i].speed;
    if (speed.cases() == 0) {
      rows += "<tr><th scope=\"row\">" + run_link(site, i) +
              "</th><td colspan=\"5\">no times in the results</td></tr>\n";
      continue;
    }
    rows += fmt::format(
        "<tr><th scope=\"row\">{}</th><td class=\"number\">{}</td><td class=\"number\">{}</td><td "
        "class=\"number\">{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td></tr>\n",
        run_link(site, i), grouped(speed.cases()), milliseconds(speed.microseconds()),
        grouped(static_cast<std::uint64_t>(speed.rate())), milliseconds(speed.below(50)),
        milliseconds(speed.below(99)));
  }
  return "<p class=\"note\">As the runs were timed, subject and judge together, a case after "
         "another: with several jobs a run took less. Times of different machines are not "
         "comparable.</p>\n" +
         table("speed-table",
               "<th>Implementation</th><th class=\"number\">Cases</th><th class=\"number\">Run time"
               "</th><th class=\"number\">Cases a second</th><th class=\"number\">Half are below"
               "</th><th class=\"number\">99 % are below</th>",
               rows);
}

std::string slowest(const SiteView& site) {
  std::string rows;
  for (std::size_t i = 0; i < site.gathered->runs.size(); ++i) {
    for (const Speed::Slow& slow : site.gathered->runs[i].speed.slowest()) {
      rows += fmt::format("<tr><td>{}</td><td>{}</td><td class=\"number\">{}</td></tr>\n",
                          run_link(site, i), case_link(site, i, slow.id),
                          milliseconds(slow.microseconds));
    }
  }
  return table("slowest-table",
               "<th>Implementation</th><th>Case</th><th class=\"number\">Run time</th>", rows,
               true);
}

}  // namespace

std::string speed_page(const SiteView& site) {
  return page(site, kPages[5],
              section("speed", "Speed", rates(site)) +
                  section("slowest", "The slowest cases of each", slowest(site)));
}

}  // namespace gonogo::oracle::site
