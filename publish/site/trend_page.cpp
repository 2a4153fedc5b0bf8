// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "publish/report/escape.hpp"
#include "publish/site/page.hpp"

namespace gonogo::oracle::site {
namespace {

constexpr double kWidth = 760;
constexpr double kHeight = 190;
constexpr double kLeft = 52;
constexpr double kRight = 60;
constexpr double kTop = 26;
constexpr double kBottom = 34;

double part_of(const Counts& counts) {
  return counts.answered() == 0
             ? 0
             : static_cast<double>(counts[Outcome::go]) / static_cast<double>(counts.answered());
}

// Down to the tenth below the least of them, at most nine tenths.
double floor_of(const std::vector<Run>& runs, const std::vector<std::size_t>& versions) {
  double least = 1;
  for (const std::size_t run : versions) least = std::min(least, part_of(runs[run].counts));
  return std::clamp(static_cast<int>(least * 10 - 0.001) / 10.0, 0.0, 0.9);
}

std::string chart(const std::vector<Run>& runs, const std::vector<std::size_t>& versions) {
  const double low = floor_of(runs, versions);
  const auto x = [&](std::size_t i) {
    const double step = (kWidth - kLeft - kRight) / static_cast<double>(versions.size() - 1);
    return kLeft + step * static_cast<double>(i);
  };
  const auto y = [&](double part) {
    return kTop + (kHeight - kTop - kBottom) * (1 - part) / (1 - low);
  };
  std::string out = fmt::format(
      "<div class=\"chart-box\"><svg class=\"chart\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "role=\"img\" aria-label=\"GO of "
      "the answered cases, version by version\">",
      kWidth, kHeight);
  for (const double part : {low, (1 + low) / 2, 1.0}) {
    out += fmt::format(
        "<line class=\"grid\" x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\"/><text x=\"{3}\" "
        "y=\"{4:.1f}\" text-anchor=\"end\">{5:.0f} %</text>",
        kLeft, kWidth - kRight, y(part), kLeft - 8, y(part) + 4, part * 100);
  }
  std::string line;
  std::string marks;
  for (std::size_t i = 0; i < versions.size(); ++i) {
    const Counts& counts = runs[versions[i]].counts;
    const double at = y(part_of(counts));
    line += fmt::format("{}{:.1f},{:.1f}", i == 0 ? "" : " ", x(i), at);
    marks += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4.5\"/>", x(i), at);
    // Words beside so many of them as have room, the last among them.
    if ((versions.size() - 1 - i) % (versions.size() / 9 + 1) != 0) continue;
    marks += fmt::format(
        "<text class=\"value\" x=\"{0:.1f}\" y=\"{2:.1f}\" text-anchor=\"middle\">{3}</text><text "
        "x=\"{0:.1f}\" y=\"{4}\" text-anchor=\"middle\">{5}</text>",
        x(i), at, at - 10, percent(counts[Outcome::go], counts.answered()), kHeight - 10,
        text(report::shortened(runs[versions[i]].version, 24)));
  }
  return out + "<polyline class=\"course\" points=\"" + line + "\"/>" + marks + "</svg></div>\n";
}

std::string change_cell(const SiteView& site, std::size_t run, const evidence::CountedIds& cases) {
  if (cases.count == 0) return "<td class=\"number\">0</td>";
  std::string more;
  if (cases.count > cases.first.size()) {
    more = fmt::format(" and {} more", grouped(cases.count - cases.first.size()));
  }
  return fmt::format(
      "<td><details><summary>{}</summary><div class=\"ids\">{}{}</div></details></td>",
      grouped(cases.count), case_links(site, run, cases.first), more);
}

std::string versions_table(const SiteView& site, const std::vector<std::size_t>& versions) {
  std::string rows;
  for (const std::size_t run : versions) {
    const Run& one = site.gathered->runs[run];
    rows += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td><td class=\"number\">{}</td>",
                        run_link(site, run), stacked_bar(one.counts),
                        percent(one.counts[Outcome::go], one.counts.answered()));
    const auto step = std::ranges::find(site.gathered->steps, run, &Step::after);
    if (step == site.gathered->steps.end()) {
      rows += "<td></td><td></td><td></td>";
    } else {
      rows += change_cell(site, run, step->lost) + change_cell(site, run, step->mended) +
              change_cell(site, run, step->moved);
    }
    rows += "</tr>\n";
  }
  return table(fmt::format("versions-{}", versions.front()),
               "<th>Version</th><th>Cases</th><th class=\"number\">GO of answered</th><th>Departs "
               "since the one before</th><th>Mended since</th><th>Departs in another way</th>",
               rows);
}

}  // namespace

std::string trend_page(const SiteView& site) {
  std::string sections;
  for (const std::vector<std::size_t>& versions : site.gathered->implementations()) {
    if (versions.size() < 2) continue;
    const std::vector<Run>& runs = site.gathered->runs;
    sections +=
        section(fmt::format("trend-{}", versions.front()), text(runs[versions.front()].name),
                key_of_bars() + chart(runs, versions) + versions_table(site, versions));
  }
  if (sections.empty()) {
    sections =
        section("trend", "Versions",
                "<p>No implementation has two versions here: give the results of several, as "
                "in gonogo site old new --out site.</p>\n");
  }
  return page(site, kPages[4], sections);
}

}  // namespace gonogo::oracle::site
