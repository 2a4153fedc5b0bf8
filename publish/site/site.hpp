// SPDX-License-Identifier: GPL-3.0-or-later
//
// One static site of many results: implementations and their versions side by side.
#pragma once

#include <string>
#include <vector>

#include "publish/site/gather.hpp"

namespace gonogo::oracle::site {

struct SiteOptions {
  std::vector<Source> sources;
  std::string out;  // folder; made when it is missing
  std::string title;
  bool reports = true;  // with the report of each run
  GatherOptions gather;
};

// Writes index.html and its pages, site.json, summary.md and runs/STEM/index.html; returns what
// they report. They are put in place only when all of them are whole: until then what lies there is
// untouched, and a page of another kind is never written over. The same results give the same
// bytes, in any order. Throws SiteError, ResultsError, std::system_error.
Gathered write_site(const SiteOptions& options);

// The data of the pages, as docs/formats.md says.
std::string site_json(const Gathered& gathered, const std::string& title);
// The tables of results, cycles, known causes and departures.
std::string site_markdown(const Gathered& gathered, const std::string& title);

}  // namespace gonogo::oracle::site
