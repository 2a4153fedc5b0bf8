// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/campaign_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "corpus/io/files.hpp"
#include "fuzz/hunt/finding_files.hpp"
#include "oracle/records/finding_text.hpp"
#include "oracle/records/output_file.hpp"
#include "publish/report/clauses.hpp"
#include "publish/report/escape.hpp"
#include "publish/report/figure.hpp"
#include "publish/report/page_parts.hpp"

namespace gonogo::hunt {
namespace {

namespace report = oracle::report;
using report::markup_text;
using report::section;
using report::table;

constexpr const char* kOwnStyle =
    "main > section { overflow-wrap: anywhere; }\n"
    "th { overflow-wrap: normal; }\n"
    ".totals { display: flex; flex-wrap: wrap; gap: 10px; margin: 0; }\n"
    ".totals div { border: 1px solid var(--line); border-radius: 8px; padding: 8px 14px; }\n"
    ".totals dt { color: var(--soft); font-size: .87rem; }\n"
    ".totals dd { margin: 0; font-size: 1.25rem; font-weight: 600; "
    "font-variant-numeric: tabular-nums; }\n"
    ".cause { font-size: 1.05rem; margin: 0 0 10px; }\n"
    ".figure { overflow-x: auto; border: 1px solid var(--line); border-radius: 8px; "
    "background: var(--gs-paper, #fff); margin-top: 12px; }\n"
    ".figure svg { display: block; max-width: 100%; height: auto; }\n"
    "details { margin-top: 10px; }\n"
    "td.dates { white-space: nowrap; }\n"
    "table[id^=symptoms-] td:first-child { min-width: 10em; overflow-wrap: break-word; }\n"
    "@media (max-width: 700px) { td.dates { white-space: normal; min-width: 7em; } "
    ".figure svg { max-width: none; } }\n"
    "#feature-table th + th, table[id^=symptoms-] th:nth-child(2) { text-align: right; }\n";

std::string heads(std::initializer_list<const char*> names) {
  std::string cells;
  for (const char* name : names) cells += fmt::format("<th scope=\"col\">{}</th>", name);
  return cells;
}

std::string total(const char* what, const std::string& value) {
  return fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", what, value);
}

std::string totals(const HuntSummary& summary) {
  const HuntCount& count = summary.count;
  std::string cells = total("programs", std::to_string(count.programs));
  if (summary.seconds > 0) {
    cells +=
        total("programs a second of a round, each shard",
              fmt::format("{:.0f}", static_cast<double>(summary.timed_programs) / summary.seconds));
  }
  cells += total("judged with motion", std::to_string(count.moved));
  cells += total("judged", std::to_string(count.judged));
  cells += total("not GO", std::to_string(count.no_go));
  cells += total("skipped", std::to_string(count.skipped));
  cells += total("undecided", std::to_string(count.gaps));
  cells += total("departures outside the domain", std::to_string(count.outside));
  cells += total("too long", std::to_string(count.too_long));
  cells += total("programs kept", std::to_string(summary.inputs));
  std::string text = "<dl class=\"totals\">\n" + cells + "</dl>\n";
  if (summary.begun && summary.ended) {
    text += fmt::format("<p class=\"note\">First round ended {}, last one {}.</p>\n",
                        date_text(*summary.begun), date_text(*summary.ended));
  }
  return text;
}

std::string features(const HuntSummary& summary) {
  std::string rows;
  for (const auto& [feature, count] : summary.features) {
    rows += fmt::format(
        "<tr><th scope=\"row\">{}</th><td class=\"number\">{}</td><td class=\"number\">{}</td>"
        "<td class=\"number\">{}</td></tr>\n",
        markup_text(feature), count.judged, count.no_go, count.skipped);
  }
  std::string text =
      table("feature-table", heads({"feature", "judged", "not GO", "skipped"}), rows);
  for (const std::string& left_out : summary.left_out) {
    text += fmt::format("<p class=\"note\">The subject skips programs with: {}.</p>\n",
                        markup_text(left_out));
  }
  return text;
}

std::string seen(std::size_t round,
                 const std::optional<std::chrono::system_clock::time_point>& at) {
  return fmt::format("round {}{}", round, at ? "<br>" + date_text(*at) : std::string());
}

std::string symptoms_table(const CampaignFinding& finding, std::size_t number) {
  std::string rows;
  for (const Symptom& symptom : finding.symptoms) {
    rows += fmt::format(
        "<tr><td>{}{}</td><td class=\"number\">{}</td><td class=\"dates\">{}</td>"
        "<td class=\"dates\">{}</td><td><a class=\"mono\" "
        "href=\"{}/verdict.txt\">{}</a></td></tr>\n",
        markup_text(symptom.signature.text()),
        symptom.stands ? "" : " <span class=\"badge go\">mended</span>", symptom.programs,
        seen(symptom.first, symptom.first_seen), seen(symptom.last, symptom.last_seen),
        markup_text(symptom.folder),
        markup_text(std::filesystem::path(symptom.folder).filename().string()));
  }
  return table(fmt::format("symptoms-{}", number),
               heads({"departure", "programs", "first seen", "last seen", "finding"}), rows);
}

// The sheet of the symptom; the clip of a pocket has a name of its own on a page of several.
std::string sheet_in(const std::filesystem::path& place, std::size_t number) {
  const std::filesystem::path file = place / "sheet.svg";
  if (!std::filesystem::exists(file)) return {};
  std::string svg = oracle::file_text(file.string());
  for (std::size_t at = 0; (at = svg.find(report::kPocketClip, at)) != std::string::npos;) {
    at += report::kPocketClip.size();
    svg.insert(at, fmt::format("-{}", number));
  }
  return "<div class=\"figure\">" + svg + "</div>\n";
}

std::string program_lines(const std::string& program) {
  std::string lines;
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < program.size();) {
    const std::size_t end = std::min(program.find('\n', begin), program.size());
    lines += fmt::format("<span class=\"line\" data-n=\"{}\">{}</span>", ++number,
                         markup_text(program.substr(begin, end - begin)));
    begin = end + 1;
  }
  return "<pre>" + lines + "</pre>\n";
}

// The program of the symptom, reduced, what was said of it, how to see it again, and the two paths.
std::string example(const PageFolder& folder, const Symptom& symptom, const std::string& dialect,
                    std::size_t number) {
  const std::filesystem::path place = std::filesystem::path(folder.path) / symptom.folder;
  try {
    const Reproducer reproducer = read_reproducer(place.string(), dialect);
    std::string text = program_lines(reproducer.program.text);
    if (!reproducer.before.empty()) {
      text += fmt::format("<p class=\"note\">after {} programs before it</p>\n",
                          reproducer.before.size());
    }
    const std::string machine =
        oracle::other_machine(reference::profile_json(reproducer.program.profile));
    if (!machine.empty()) {
      text += fmt::format("<p class=\"note\">machine: {}</p>\n", markup_text(machine));
    }
    text += fmt::format("<details><summary>What the judge says</summary>{}</details>\n",
                        program_lines(oracle::file_text((place / "verdict.txt").string())));
    if (reproducer.before.empty()) {
      text += fmt::format("<p class=\"note\">again: <code class=\"again\">{}</code></p>\n",
                          markup_text(folder.again(place.string())));
    }
    return text + sheet_in(place, number);
  } catch (const std::exception& error) {
    return fmt::format("<p class=\"note\">{}</p>\n", markup_text(error.what()));
  }
}

std::string finding_section(const PageFolder& folder, const HuntSummary& summary,
                            const CampaignFinding& finding, std::size_t number) {
  std::string text = fmt::format("<p class=\"cause\">{}</p>\n", markup_text(cause_text(finding)));
  text += symptoms_table(finding, number);
  const std::string& clause = finding.symptoms.front().signature.clause;
  if (const reference::Clause* known = report::find_clause(clause)) {
    text += fmt::format("<p class=\"note\">{}: {}</p>\n", markup_text(clause),
                        markup_text(known->text));
  }
  text += "<h3>The first symptom, reduced</h3>\n";
  text += example(folder, finding.symptoms.front(), summary.dialect, number);
  return section(fmt::format("finding-{}", number),
                 fmt::format("Finding {}: {}, {}{}", number, symptoms_text(finding),
                             markup_text(clauses_text(finding)),
                             finding.stands() ? "" : " <span class=\"badge go\">mended</span>"),
                 text);
}

}  // namespace

std::string campaign_page(const PageFolder& folder, const HuntSummary& summary) {
  const std::string title = markup_text(summary.subject + ", " + summary.dialect);
  std::string out = report::page_head("Hunt: " + title, kOwnStyle, nullptr);
  out += fmt::format(
      "<h1>Hunt: {}</h1>\n<p id=\"told\"><span class=\"badge {}\">{}</span> {}</p>\n"
      "</header>\n<main>\n",
      title, summary.standing() == 0 ? "go" : "no-go", findings_text(summary),
      rounds_text(summary));
  out += section("programs", "Programs", totals(summary));
  std::size_t number = 0;
  for (const CampaignFinding& finding : summary.findings) {
    out += finding_section(folder, summary, finding, ++number);
  }
  out += section("features", "By feature", features(summary));
  return out +
         "</main>\n<footer>Written by gonogo hunt when a round ended; nothing is loaded from "
         "elsewhere.</footer>\n</body>\n</html>\n";
}

void write_campaign_page(const PageFolder& folder, const HuntSummary& summary) {
  oracle::write_file(std::filesystem::path(folder.path) / "index.html",
                     campaign_page(folder, summary));
}

}  // namespace gonogo::hunt
