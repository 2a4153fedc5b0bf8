// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/manual/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "publish/manual/page_parts.hpp"
#include "reference/editions.hpp"
#include "reference/power_on.hpp"

namespace gonogo::oracle::manual {
namespace {

using reference::Clause;

// A section of the manual with what stands in it.
struct Section {
  std::string_view source;
  std::vector<const Clause*> clauses;
  std::string_view page;  // the dialect on whose page its drawings stand
  std::vector<const Example*> examples;
  std::vector<const ReadingExample*> readings;
  std::vector<const AlarmExample*> alarms;
};

std::vector<Section> sections_of(const reference::Dialect& dialect) {
  std::vector<Section> sections;
  for (const Clause& clause : dialect.clauses) {
    auto section = std::ranges::find(sections, clause.source, &Section::source);
    if (section == sections.end()) {
      sections.push_back({clause.source, {}, dialect.name, {}, {}, {}});
      section = std::prev(sections.end());
    }
    section->clauses.push_back(&clause);
  }
  return sections;
}

Section& section_of_clause(std::vector<Section>& sections, std::string_view id) {
  for (Section& section : sections) {
    const bool has = std::ranges::any_of(section.clauses,
                                         [id](const Clause* clause) { return clause->id == id; });
    if (has) return section;
  }
  throw std::logic_error(fmt::format("an example names the unknown clause {}", id));
}

const reference::Reading& reading_of(const ReadingExample& example) {
  const reference::Reading* reading = reference::find_reading(example.name);
  if (reading == nullptr) throw std::logic_error("an example of an unknown reading");
  return *reading;
}

void place(std::vector<Section>& sections, const Examples& examples) {
  for (const Example& example : examples.examples) {
    const auto section = std::ranges::find(sections, example.section, &Section::source);
    if (section == sections.end()) {
      throw std::logic_error(fmt::format("an example of the unknown section {}", example.section));
    }
    section->page = examples.dialect;
    section->examples.push_back(&example);
  }
  for (const ReadingExample& example : examples.readings) {
    section_of_clause(sections, reference::clause_name(reading_of(example).clause))
        .readings.push_back(&example);
  }
  for (const AlarmExample& example : examples.alarms) {
    section_of_clause(sections, example.clause).alarms.push_back(&example);
  }
}

void append_head(PageDraft& page, const std::vector<Section>& sections) {
  page.text += fmt::format(
      "# Dialect {0}\n\n"
      "Written by `gonogo spec --dialect {0} --format markdown --out docs/dialects`; a test "
      "compares this page with what the program says, so change the catalog, not the page.\n\n"
      "**Texts**: {2}.\n\n"
      "**At power-on**: {3}.\n\n"
      "**Clauses** are what the manual says, one thing each: `must` stands in the text, `derived` "
      "follows from it, `open` is left open by it and decided here. The **basis** is what a "
      "departure departs from: `text`, the section above the table; `derived`, with its "
      "derivation; `silent`, no text but our judgement, from which a departure is an advice and no "
      "NO-GO. **Readings** are the choices that remain where a manual is open or contradicts "
      "itself: choose one with `--reading name=value` or in the profile, or say `any`. "
      "**Drawings** are made by the program from the example above them: the numbers in a drawing "
      "are those of the table below it; it begins where the first positioning ends. Where two "
      "readings part, the broad blue path is the first and the fine red path the other; where only "
      "one of the two is seen, they differ.{1} **Try it** opens the program in the playground, "
      "which `playground/build` makes.\n\n",
      page.dialect,
      page.lathe ? " X is a diameter in a program and a radius in drawings and motions." : "",
      reference::editions_of(page.dialect), reference::power_on_text(page.dialect));
  for (std::size_t i = 0; i < sections.size(); ++i) {
    page.text += fmt::format("- [{}](#section-{})\n", sections[i].source, i + 1);
  }
  page.text += "- [Codes and words](#codes)\n- [Not covered, ignored](#outside)\n\n";
}

void append_section(PageDraft& page, const Section& section, std::size_t number) {
  page.text += fmt::format("<a id=\"section-{}\"></a>\n## {}\n\n", number, section.source);
  append_clauses(page, section.clauses);
  if (section.page != page.dialect) {
    page.text +=
        fmt::format("Drawings, readings and alarms are those of [{0}]({0}.md#section-{1}).\n\n",
                    section.page, number);
    return;
  }
  for (const Example* example : section.examples) append_example(page, *example);
  if (!section.readings.empty()) page.text += "### Readings\n\n";
  for (const ReadingExample* example : section.readings) {
    append_reading(page, reading_of(*example), *example);
  }
  append_alarms(page, section.alarms);
}

}  // namespace

std::vector<PageFile> page_of(const reference::Dialect& dialect) {
  const std::vector<Examples> files = examples_of(dialect.name);
  std::vector<Section> sections = sections_of(dialect);
  for (const Examples& examples : files) place(sections, examples);
  PageDraft page{dialect.name, dialect.lathe, {}, {}};
  append_head(page, sections);
  for (std::size_t i = 0; i < sections.size(); ++i) append_section(page, sections[i], i + 1);
  append_codes(page, dialect);
  append_outside(page, dialect);
  std::vector<PageFile> all = {{fmt::format("{}.md", dialect.name), std::move(page.text)}};
  for (PageFile& drawing : page.drawings) all.push_back(std::move(drawing));
  return all;
}

}  // namespace gonogo::oracle::manual
