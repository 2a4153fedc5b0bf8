// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the pages of a site are made of. They are whole without their script; every text that comes
// from results goes through text().
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "publish/site/gather.hpp"
#include "publish/report/page_parts.hpp"

namespace gonogo::oracle::site {

struct SiteView {
  const Gathered* gathered = nullptr;
  std::string title;
  bool reports = true;  // the reports of the runs stand in runs/STEM
};

// A page of the site: its file, and what stands in the navigation.
struct PageName {
  std::string_view file;
  std::string_view title;
};
inline constexpr std::array<PageName, 6> kPages = {{{"index.html", "Overview"},
                                                    {"clauses.html", "Clauses"},
                                                    {"departures.html", "Departures"},
                                                    {"vote.html", "Vote"},
                                                    {"trend.html", "Versions"},
                                                    {"speed.html", "Speed"}}};

// For HTML text and attributes.
std::string text(std::string_view untrusted);
// "87.4 %", downward: 100 % is all of them.
std::string percent(std::uint64_t part, std::uint64_t of);

// The whole file around the sections of its <main>.
std::string page(const SiteView& site, const PageName& name, const std::string& sections);
using report::section;
using report::table;
// The head cell of each run, a link to its report.
std::string run_heads(const SiteView& site);
std::string run_link(const SiteView& site, std::size_t run);
// Names of runs, each in a box.
std::string who(const SiteView& site, const std::vector<std::size_t>& runs);
// A case in the report of a run.
std::string case_link(const SiteView& site, std::size_t run, const std::string& id);
std::string case_links(const SiteView& site, std::size_t run, const std::vector<std::string>& ids);
// The cell of how many of `of` are GO.
std::string share_cell(std::uint64_t part, std::uint64_t of, const std::string& hint);
std::string stacked_bar(const Counts& counts);
std::string key_of_bars();
// A search over the rows of a table; `runs`: by run as well.
std::string filter(const SiteView& site, std::string_view table_id, bool runs);

std::string overview_page(const SiteView& site);
std::string clause_page(const SiteView& site);
std::string departures_page(const SiteView& site);
std::string vote_page(const SiteView& site);
std::string trend_page(const SiteView& site);
std::string speed_page(const SiteView& site);

}  // namespace gonogo::oracle::site
