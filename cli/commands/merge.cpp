// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo merge: the results of the shards of a run put together.

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <optional>

#include "campaign/merge.hpp"
#include "campaign/results_reader.hpp"
#include "cli/commands.hpp"
#include "cli/named_files.hpp"
#include "cli/output.hpp"
#include "cli/program_file.hpp"
#include "cli/terminal.hpp"
#include "cli/verdict_text.hpp"

namespace gonogo::cli {
namespace {

namespace fs = std::filesystem;

// A file; a folder stands for results.jsonl in it.
std::string out_file(const std::string& out) {
  if (!fs::is_directory(out) && !out.ends_with('/')) return out;
  fs::create_directories(out);
  return (fs::path(out) / "results.jsonl").string();
}

void check_places(const oracle::MergeOptions& options) {
  // It is replaced at the end: no device, no pipe.
  if (fs::exists(options.out) && !fs::is_regular_file(options.out)) {
    throw UsageError(fmt::format("{} is no regular file. Name a file, or a folder.", options.out));
  }
  for (const std::string& path : options.results) {
    for (const std::string& own : {options.out, oracle::ResultsWriter::journal_of(options.out)}) {
      if (fs::exists(own) && fs::exists(path) && fs::equivalent(own, path)) {
        throw UsageError(fmt::format("{} is merged and cannot be written to as well.", path));
      }
    }
  }
}

int merge(oracle::MergeOptions options, const std::string& corpus) {
  for (std::string& path : options.results) path = results_in(path);
  options.out = out_file(options.out);
  options.argv = arguments();
  check_places(options);
  oracle::MergeOutcome outcome;
  std::optional<oracle::Corpus> of_run;
  try {
    if (const std::string folder = corpus_here(corpus); !folder.empty()) of_run.emplace(folder);
    options.corpus = of_run ? &*of_run : nullptr;
    outcome = oracle::merge_results(options);
  } catch (const oracle::MergeError& error) {
    throw UsageError(error.what());
  } catch (const oracle::ResultsError& error) {
    throw UsageError(error.what());
  } catch (const oracle::ResultsUnwritable& error) {
    throw OutputError(fmt::format("{}.", error.what()), false);
  }
  for (const std::string& note : outcome.notes) complain("gonogo: {}\n", note);
  if (!outcome.has_corpus) {
    complain(
        "gonogo: UNDECIDED: the corpus of the run is not here: whether the shards have all of its "
        "cases was not checked. --corpus names it.\n");
  }
  for (const std::string& shard : outcome.missing) complain("gonogo: {}.\n", shard);
  Output output;
  if (outcome.missing.empty()) {
    CampaignSummary summary;
    summary.footer = outcome.footer;
    output.text() = summary_text(summary, "merged", wants_colour(STDOUT_FILENO));
  }
  output.text() += outcome.written ? fmt::format("results: {}{}\n", options.out,
                                                 outcome.missing.empty() ? "" : " (incomplete)")
                                   : "Nothing is written; --partial writes what is there.\n";
  output.tell();
  const bool is_checked = outcome.missing.empty() && outcome.has_corpus;
  const int exit_code = outcome.footer.answer.exit_code;
  return is_checked || exit_code == kNoGo ? exit_code : kUndecided;
}

}  // namespace

void add_merge(Command& program) {
  auto options = std::make_shared<oracle::MergeOptions>();
  auto corpus = std::make_shared<std::string>();
  Command command = program.add_command("merge", "Put the results of the shards of a run together");
  command.arguments("results", options->results,
                    "results.jsonl of each shard, or the folders that they are in");
  command.needed("--out", options->out, "file, or folder for results.jsonl");
  command.flag("--partial", options->partial,
               "write what is there when shards are missing: an incomplete file");
  command.option("--corpus", *corpus, "folder of the corpus of the run (the checked-in one)");
  command.run([options, corpus] { return merge(*options, *corpus); });
}

}  // namespace gonogo::cli
