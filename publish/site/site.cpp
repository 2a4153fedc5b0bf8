// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/site/site.hpp"

#include <unistd.h>

#include <filesystem>
#include <system_error>

#include "oracle/records/output_file.hpp"
#include "publish/report/html.hpp"
#include "publish/site/page.hpp"

namespace gonogo::oracle::site {
namespace {

namespace fs = std::filesystem;

// A folder within the site in which its files become whole, and which goes in any case.
class Staging {
 public:
  explicit Staging(const fs::path& site)
      : site_(site), path_(site / (".part-" + std::to_string(::getpid()))) {
    fs::create_directories(site_);
    fs::create_directory(path_);
  }
  ~Staging() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;

  const fs::path& path() const { return path_; }
  // All of its files, to their places. Folders that are in the way make it throw before any moves.
  void commit() const {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(path_)) {
      if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), path_));
    }
    for (const fs::path& file : files) {
      fs::create_directories((site_ / file).parent_path());
      if (fs::is_directory(site_ / file)) {
        throw std::system_error(std::make_error_code(std::errc::is_a_directory),
                                (site_ / file).string() + " cannot be written");
      }
    }
    for (const fs::path& file : files) fs::rename(path_ / file, site_ / file);
  }

 private:
  fs::path site_;
  fs::path path_;
};

// A page of somebody else's, as that of a report, is not written over.
void refuse_other_pages(const fs::path& out) {
  if (!fs::exists(out / "index.html") || fs::exists(out / "site.json")) return;
  throw SiteError(out.string() +
                  " has an index.html that is not of a site. Name another folder with --out.");
}

void write_reports(const std::vector<Run>& runs, const fs::path& folder) {
  for (const Run& run : runs) {
    const fs::path report = folder / "runs" / run.stem;
    fs::create_directories(report);
    if (const auto error = report::write_html_report(run.path, report.string())) {
      throw std::system_error(std::make_error_code(std::errc::io_error), *error);
    }
  }
}

}  // namespace

Gathered write_site(const SiteOptions& options) {
  refuse_other_pages(options.out);
  Gathered gathered = gather(options.sources, options.gather);
  const SiteView view{&gathered, options.title, options.reports};
  const Staging staging(options.out);
  constexpr std::string (*kWriters[])(const SiteView&) = {
      overview_page, clause_page, departures_page, vote_page, trend_page, speed_page};
  static_assert(std::size(kWriters) == kPages.size());
  for (std::size_t i = 0; i < kPages.size(); ++i) {
    write_file(staging.path() / kPages[i].file, kWriters[i](view));
  }
  write_file(staging.path() / "site.json", site_json(gathered, options.title));
  write_file(staging.path() / "summary.md", site_markdown(gathered, options.title));
  if (options.reports) write_reports(gathered.runs, staging.path());
  staging.commit();
  return gathered;
}

}  // namespace gonogo::oracle::site
