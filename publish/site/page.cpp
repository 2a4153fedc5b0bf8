// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/site/page.hpp"

#include <fmt/format.h>

#include "publish/report/escape.hpp"

namespace gonogo::oracle::site {
namespace {

std::string navigation(const PageName& here) {
  std::string links;
  for (const PageName& name : kPages) {
    links += fmt::format("<a href=\"{}\"{}>{}</a>\n", name.file,
                         name.file == here.file ? " aria-current=\"page\"" : "", name.title);
  }
  return "<nav class=\"pages\" aria-label=\"Pages of this site\">\n" + links + "</nav>\n";
}

std::string notes(const Gathered& gathered) {
  if (gathered.notes.empty()) return {};
  std::string items;
  for (const std::string& note : gathered.notes) items += "<li>" + text(note) + "</li>";
  return "<div class=\"banner undecided\" role=\"alert\"><strong>These results are not quite "
         "comparable.</strong><ul>" +
         items + "</ul></div>\n";
}

}  // namespace

std::string text(std::string_view untrusted) {
  return report::markup_text(untrusted);
}

std::string percent(std::uint64_t part, std::uint64_t of) {
  if (of == 0) return "-";
  if (part == of) return "100 %";
  const std::uint64_t tenths = part * 1000 / of;
  return fmt::format("{}.{} %", tenths / 10, tenths % 10);
}

std::string page(const SiteView& site, const PageName& name, const std::string& sections) {
  const std::string title = text(site.title);
  std::string out =
      report::page_head(fmt::format("{} - {}", name.title, title), "", &report::kSiteJs);
  out += fmt::format("<h1>{}</h1>\n{}</header>\n<main>\n", title, navigation(name));
  out += notes(*site.gathered);
  out += sections;
  out +=
      "</main>\n<footer>Written by gonogo site from results files alone; nothing is loaded from "
      "elsewhere.</footer>\n<script>";
  out += report::kSiteJs.text;
  return out + "</script>\n</body>\n</html>\n";
}

std::string run_link(const SiteView& site, std::size_t run) {
  const Run& one = site.gathered->runs[run];
  if (!site.reports) return text(one.title());
  return fmt::format("<a href=\"runs/{}/index.html\">{}</a>", one.stem, text(one.title()));
}

std::string run_heads(const SiteView& site) {
  std::string cells;
  for (std::size_t i = 0; i < site.gathered->runs.size(); ++i) {
    cells += "<th scope=\"col\" class=\"run\">" + run_link(site, i) + "</th>";
  }
  return cells;
}

std::string who(const SiteView& site, const std::vector<std::size_t>& runs) {
  std::string out;
  for (const std::size_t run : runs) {
    out += "<span class=\"who\">" + text(site.gathered->runs[run].title()) + "</span>";
  }
  return out;
}

std::string case_link(const SiteView& site, std::size_t run, const std::string& id) {
  if (!site.reports) return "<span class=\"mono\">" + text(id) + "</span>";
  return fmt::format("<a class=\"mono\" href=\"runs/{}/index.html#case={}\">{}</a>",
                     site.gathered->runs[run].stem, report::address_text(id), text(id));
}

std::string case_links(const SiteView& site, std::size_t run, const std::vector<std::string>& ids) {
  std::string out;
  for (const std::string& id : ids) {
    if (!out.empty()) out += ", ";
    out += case_link(site, run, id);
  }
  return out;
}

std::string share_cell(std::uint64_t part, std::uint64_t of, const std::string& hint) {
  if (of == 0) {
    return fmt::format("<td class=\"share none\" title=\"{}\">&ndash;</td>", text(hint));
  }
  const std::uint64_t width = part * 100 / of;
  return fmt::format(
      "<td class=\"share{}\" style=\"--part:{}%\" title=\"{}\">{}</td>", part == of ? " all" : "",
      width, text(hint),
      part == of ? grouped(part) : fmt::format("{} / {}", grouped(part), grouped(of)));
}

std::string stacked_bar(const Counts& counts) {
  const std::uint64_t all = counts.cases();
  if (all == 0) return "<div class=\"bar\"></div>";
  std::string parts;
  std::string words;
  for (std::size_t i = 0; i < kOutcomes; ++i) {
    const auto outcome = static_cast<Outcome>(i);
    const std::uint64_t cases = counts[outcome];
    if (cases == 0) continue;
    if (!words.empty()) words += ", ";
    words += fmt::format("{} {}", grouped(cases), title(outcome));
    // At least a sliver of each.
    const std::uint64_t hundredths = std::max<std::uint64_t>(cases * 10'000 / all, 40);
    parts += fmt::format("<i class=\"{}\" style=\"flex:{} 1 0\"></i>", key(outcome), hundredths);
  }
  return fmt::format("<div class=\"bar\" role=\"img\" aria-label=\"{0}\" title=\"{0}\">{1}</div>",
                     words, parts);
}

std::string key_of_bars() {
  std::string items;
  for (std::size_t i = 0; i < kOutcomes; ++i) {
    const auto outcome = static_cast<Outcome>(i);
    items += fmt::format("<li><i class=\"{}\"></i>{}</li>", key(outcome), title(outcome));
  }
  return "<ul class=\"key\">" + items + "</ul>\n";
}

std::string filter(const SiteView& site, std::string_view table_id, bool runs) {
  std::string choice;
  if (runs) {
    choice = "<label>Who has it <select><option value=\"\">anyone</option>";
    for (std::size_t i = 0; i < site.gathered->runs.size(); ++i) {
      choice +=
          fmt::format("<option value=\"{}\">{}</option>", i, text(site.gathered->runs[i].title()));
    }
    choice += "</select></label>";
  }
  return fmt::format(
      "<form class=\"filter\" id=\"filters\" data-of=\"{}\" role=\"search\" hidden><label "
      "class=\"grow\">Search <input type=\"search\" autocomplete=\"off\" spellcheck=\"false\">"
      "</label>{}<output id=\"count\" aria-live=\"polite\"></output></form>\n",
      table_id, choice);
}

}  // namespace gonogo::oracle::site
