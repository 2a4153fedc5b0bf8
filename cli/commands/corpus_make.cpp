// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo corpus new, build, merge and publish: a corpus of one's own, from its first recipe to what
// is handed on.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "cli/program_file.hpp"
#include "corpus/io/corpus_diff.hpp"
#include "corpus/io/folder_writer.hpp"
#include "corpus/recipes/build.hpp"
#include "oracle/records/output_file.hpp"
#include "publish/evidence/certificate_files.hpp"
#include "reference/dialect.hpp"

namespace gonogo::cli {
namespace {

namespace fs = std::filesystem;
using oracle::Case;
using oracle::CorpusFolder;

struct MakeWords {
  std::string recipes, out, dialect, license, since, version;
  std::vector<std::string> corpora;
  bool review = false;
};

void say(const std::string& text) {
  Output output;
  output.text() = text;
  output.flush();
}

void write_new(const fs::path& file, const std::string& text) {
  if (fs::exists(file)) throw UsageError(fmt::format("{} is there already.", file.string()));
  fs::create_directories(file.parent_path());
  oracle::write_file(file, text);
}

// Recipes with one case, which builds as it stands.
int start(const MakeWords& words) {
  check_dialect_name(words.dialect);
  const reference::Dialect* const dialect = reference::find_dialect(words.dialect);
  const fs::path folder = words.out;
  write_new(folder / "corpus.toml",
            "# year.minor.patch: patch, expectations unchanged; minor, cases added; year, "
            "expectations changed.\n"
            "version = \"2026.1.0\"\n"
            "# Ids that left the corpus. An id is never used again.\n"
            "retired = []\n");
  write_new(
      folder / words.dialect / "mine.toml",
      fmt::format(
          "dialect = \"{}\"\n"
          "cycle = \"mine\"\n\n"
          "[[group]]\n"
          "gid = \"mine\"\n"
          "features = [\"basic\"]  # gonogo spec --features\n"
          "clauses = [\"{}\"]  # what the cases are there to test: gonogo spec --dialect {}\n\n"
          "[[group.case]]\n"
          "id = \"mine.basic.000001\"  # never changed, never used again\n"
          "comment = \"what the case is about\"\n"
          "program = '''\n"
          "G0 X10 Z5\n"
          "'''\n"
          "# The alarms that must come, class@line; without the key none may.\n"
          "# alarm = [\"missing-word@1\"]\n",
          words.dialect, dialect->clauses.front().id, words.dialect));
  say(fmt::format(
      "{0}/{1}/mine.toml has a first case.\nNext: gonogo corpus build {0} {0}-corpus --review\n",
      words.out, words.dialect));
  return kGo;
}

// What the reference says of each case, for whoever has to believe it.
void show_for_review(const std::string& folder, Output& output) {
  oracle::Corpus(folder).for_each([&](const Case& test) {
    output.text() += fmt::format("\n{}  {}\n{}\n", test.id, test.comment, test.program);
    for (const oracle::Expectation& expectation : test.expect) {
      output.text() += oracle::expectation_json(expectation) + "\n";
    }
    output.flush_if_large();
  });
}

int build(const MakeWords& words) {
  if (!fs::exists(fs::path(words.recipes) / "corpus.toml")) {
    throw UsageError(fmt::format(
        "{} has no corpus.toml: it is no folder of recipes. `gonogo corpus new` makes one.",
        words.recipes));
  }
  const recipes::BuiltCorpus built = recipes::build_corpus(words.recipes, words.out);
  Output output;
  output.text() =
      fmt::format("{} cases in {} files, version {}\n", built.cases, built.files, built.version);
  if (words.review) show_for_review(words.out, output);
  output.flush();
  return kGo;
}

CorpusFolder read_whole(const oracle::Corpus& corpus) {
  CorpusFolder whole{corpus.version(), corpus.retired(), {}};
  for (const std::string& file : corpus.files()) {
    whole.files[file] = oracle::read_vector_file(corpus.folder() + "/" + file);
  }
  return whole;
}

// The cases of all; a file that two have holds those of both. An id that two have, or that one has
// retired, is an error, which the reader of the whole reports.
int merge(const MakeWords& words) {
  if (words.corpora.size() < 2) throw UsageError("Name two corpora or more.");
  CorpusFolder all{words.version, {}, {}};
  for (const std::string& folder : words.corpora) {
    CorpusFolder one = read_whole(oracle::Corpus(folder));
    all.retired.insert(one.retired.begin(), one.retired.end());
    for (auto& [file, cases] : one.files) {
      std::vector<Case>& there = all.files[file];
      std::ranges::move(cases, std::back_inserter(there));
    }
  }
  oracle::write_corpus(words.out, all);
  std::size_t count = 0;
  oracle::Corpus(words.out).for_each([&](const Case&) { ++count; });
  say(fmt::format("{} cases of {} corpora in {}, version {}\n", count, words.corpora.size(),
                  words.out, words.version));
  return kGo;
}

void list_ids(std::string& text, const char* what, const std::vector<std::string>& ids) {
  if (ids.empty()) return;
  text += fmt::format("\n## {} ({})\n\n", what, ids.size());
  for (const std::string& id : ids) text += "- " + id + "\n";
}

std::string changes_text(const oracle::Corpus& before, const oracle::Corpus& now) {
  const oracle::CorpusDiff diff = oracle::diff(before, now);
  std::string text = fmt::format("# {} to {}\n", before.version(), now.version());
  if (diff.same()) text += "\nThe same cases.\n";
  list_ids(text, "Added", diff.added);
  list_ids(text, "Removed", diff.removed);
  list_ids(text, "Another program under the same id", diff.reused);
  list_ids(text, "Another expectation", diff.changed);
  return text;
}

// Writes what is handed on: vectors and manifest with the licence, what changed, and the sums of
// all.
int publish(const MakeWords& words) {
  const oracle::Corpus corpus(words.corpora.front());
  CorpusFolder whole = read_whole(corpus);
  whole.license = words.license;
  oracle::write_corpus(words.out, whole);
  std::vector<std::string> files = corpus.files();
  files.emplace_back("manifest.json");
  if (!words.since.empty()) {
    oracle::write_file(fs::path(words.out) / "CHANGES.md",
                       changes_text(oracle::Corpus(words.since), corpus));
    files.emplace_back("CHANGES.md");
  }
  std::string sums;
  for (const std::string& file : files) {
    sums += oracle::evidence::file_sha256(words.out + "/" + file) + "  " + file + "\n";
  }
  oracle::write_file(fs::path(words.out) / "SHA256SUMS", sums);
  say(fmt::format("{}: version {}, {}; {} files in SHA256SUMS\n", words.out, corpus.version(),
                  words.license, files.size()));
  return kGo;
}

}  // namespace

void add_corpus_making(Command& corpus) {
  auto words = std::make_shared<MakeWords>();
  Command news = corpus.add_command("new", "a folder of recipes with a first case");
  news.needed("recipes", words->out, "new folder");
  news.needed("--dialect", words->dialect, "dialect of the first case");
  news.run([words] { return start(*words); });

  Command builds = corpus.add_command("build", "the vectors of a corpus from its recipes");
  builds.needed("recipes", words->recipes, "folder of the recipes");
  builds.needed("out", words->out, "folder of the corpus");
  builds.flag("--review", words->review, "show what the reference says of each case");
  builds.run([words] { return build(*words); });

  Command merges = corpus.add_command("merge", "several corpora as one");
  merges.arguments("corpus", words->corpora, "folders of corpora");
  merges.needed("--out", words->out, "new folder");
  merges.needed("--version", words->version, "version of the whole: year.minor.patch");
  merges.run([words] { return merge(*words); });

  Command publishes =
      corpus.add_command("publish", "a corpus to hand on: licence, checksums, what changed");
  publishes.arguments("corpus", words->corpora, "folder of the corpus");
  publishes.needed("--out", words->out, "new folder");
  publishes.needed("--license", words->license, "an identifier of SPDX: CC0-1.0, CC-BY-4.0");
  publishes.option("--since", words->since, "folder of the version before, for CHANGES.md");
  publishes.run([words] { return publish(*words); });
}

}  // namespace gonogo::cli
