// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo site: one static site of many results.
#include <fmt/format.h>

#include <filesystem>

#include "campaign/results_reader.hpp"
#include "cli/commands.hpp"
#include "cli/named_files.hpp"
#include "cli/output.hpp"
#include "cli/program_file.hpp"
#include "publish/site/site.hpp"

namespace gonogo::cli {
namespace {

namespace fs = std::filesystem;
using oracle::site::Source;

struct SiteWords {
  std::vector<std::string> results;
  bool without_reports = false;
  oracle::site::SiteOptions options;
};

// A path, or NAME=PATH, or NAME@VERSION=PATH; what exists as a path is taken as one.
Source source_of(const std::string& word) {
  Source source;
  const std::size_t equals = word.find('=');
  if (fs::exists(word) || equals == std::string::npos) {
    source.path = results_in(word);
    return source;
  }
  const std::string name = word.substr(0, equals);
  const std::size_t at = name.find('@');
  source.name = name.substr(0, at);
  if (at != std::string::npos) source.version = name.substr(at + 1);
  source.path = results_in(word.substr(equals + 1));
  const bool empty = source.name.empty() || (at != std::string::npos && source.version.empty());
  if (empty) {
    throw UsageError(fmt::format(
        "\"{}\" names no implementation. Write NAME=RESULTS or NAME@VERSION=RESULTS.", word));
  }
  return source;
}

void refuse_named_twice(const std::vector<Source>& sources) {
  for (std::size_t i = 0; i < sources.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const bool both = fs::exists(sources[i].path) && fs::exists(sources[k].path);
      if (!both || !fs::equivalent(sources[i].path, sources[k].path)) continue;
      throw UsageError(
          fmt::format("{} is named twice. Name each results file once.", sources[i].path));
    }
  }
}

int site(const SiteWords& words) {
  oracle::site::SiteOptions options = words.options;
  for (const std::string& word : words.results) options.sources.push_back(source_of(word));
  refuse_named_twice(options.sources);
  options.reports = !words.without_reports;
  oracle::site::Gathered gathered;
  try {
    gathered = oracle::site::write_site(options);
  } catch (const oracle::site::SiteError& error) {
    throw UsageError(error.what());
  } catch (const oracle::ResultsError& error) {
    throw UsageError(error.what());
  }
  for (const std::string& note : gathered.notes) complain("gonogo: {}\n", note);
  Output output;
  output.text() = fmt::format("{}/index.html\n", options.out);
  output.flush();
  return kGo;
}

}  // namespace

void add_site(Command& program) {
  auto words = std::make_shared<SiteWords>();
  oracle::site::SiteOptions& options = words->options;
  options.title = "Implementations under the gauge";
  Command command = program.add_command(
      "site", "Write one static site of many results: implementations and versions side by side");
  command.arguments(
      "results", words->results,
      "results.jsonl of each run, or its folder; NAME=RESULTS or NAME@VERSION=RESULTS "
      "gives it another name");
  command.needed("--out", options.out, "folder for the site");
  command.option("--title", options.title,
                 "heading of its pages (Implementations under the gauge)");
  command.flag("--without-reports", words->without_reports,
               "leave out the report of each run, to which cases are linked");
  command.flag("--partial", options.gather.partial,
               "take results without a footer: incomplete runs");
  command.flag("--mixed-corpus", options.gather.mixed_corpus,
               "take results of several corpora: cases of the same id are compared");
  command.run([words] { return site(*words); });
}

}  // namespace gonogo::cli
