// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo corpus: what a corpus holds, whether it keeps its promises, what differs between two, and
// a part of one as a corpus of its own.
#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <map>

#include "cli/commands.hpp"
#include "cli/corpus_stats.hpp"
#include "cli/named_files.hpp"
#include "cli/output.hpp"
#include "cli/program_file.hpp"
#include "corpus/io/corpus_diff.hpp"
#include "corpus/io/folder_writer.hpp"
#include "corpus/io/lint.hpp"
#include "oracle/records/features.hpp"
#include "oracle/records/text.hpp"
#include "reference/nearest_word.hpp"

namespace gonogo::cli {
namespace {

using oracle::Case;

// Which cases are meant; empty lists choose all.
struct Choice {
  std::vector<std::string> only;  // globs over ids
  std::vector<std::string> dialects;
  std::vector<std::string> features;
  std::vector<std::string> bases;  // one of the expectations stands on it

  bool takes(const Case& test) const {
    const bool named = std::ranges::any_of(only, [&](const std::string& glob) {
      return ::fnmatch(glob.c_str(), test.id.c_str(), 0) == 0;
    });
    const bool spoken = std::ranges::find(dialects, test.dialect) != dialects.end();
    const bool needed = std::ranges::any_of(features, [&](const std::string& feature) {
      return std::ranges::find(test.features, feature) != test.features.end();
    });
    const bool based = std::ranges::any_of(test.expect, [&](const auto& expectation) {
      return std::ranges::find(bases, basis_name(expectation)) != bases.end();
    });
    return (only.empty() || named) && (dialects.empty() || spoken) &&
           (features.empty() || needed) && (bases.empty() || based);
  }
};

struct CorpusWords {
  std::string folder;
  Choice choice;
  std::string out;
  std::string old_folder, new_folder;
  bool part = false;
};

[[noreturn]] void fail_to_choose(const oracle::Corpus& corpus) {
  throw UsageError(
      fmt::format("No case of the corpus {} is meant. Widen --only, --dialect, "
                  "--feature or --basis.",
                  corpus.folder()));
}

// A word that names nothing chooses no case, and somebody mistyped it.
void check_choice(const Choice& choice) {
  for (const std::string& name : choice.dialects) check_dialect_name(name);
  std::vector<std::string> features;
  for (const oracle::Feature& one : oracle::feature_vocabulary()) features.emplace_back(one.name);
  for (const std::string& name : choice.features) {
    if (std::ranges::find(features, name) != features.end()) continue;
    throw UsageError(fmt::format("There is no feature {}. {}`gonogo spec --features` names them.",
                                 name,
                                 reference::did_you_mean(reference::nearest_word(name, features))));
  }
  for (const std::string& name : choice.bases) {
    if (reference::basis(name)) continue;
    throw UsageError(
        fmt::format("There is no basis {}. A basis is text, derived or silent.", name));
  }
}

int list(const CorpusWords& words) {
  check_choice(words.choice);
  const oracle::Corpus corpus(corpus_folder(words.folder));
  Output output;
  bool any = false;
  corpus.for_each([&](const Case& test) {
    if (!words.choice.takes(test)) return;
    any = true;
    output.text() += fmt::format("{}  {}\n", test.id, oracle::visible(test.comment));
    output.flush_if_large();
  });
  if (!any) fail_to_choose(corpus);
  output.tell();
  return kGo;
}

// The cycles of the cases that are meant, for those who run each by itself.
int cycles(const CorpusWords& words) {
  check_choice(words.choice);
  const oracle::Corpus corpus(corpus_folder(words.folder));
  std::map<std::pair<std::string, std::string>, std::size_t> cycles;
  // A basis is one of the expectations, which a run does not read.
  oracle::CaseReader reader(
      corpus, words.choice.bases.empty() ? oracle::Detail::to_run : oracle::Detail::whole);
  while (const std::optional<Case> test = reader.next()) {
    if (words.choice.takes(*test)) ++cycles[{test->dialect, test->cycle}];
  }
  if (cycles.empty()) fail_to_choose(corpus);
  Output output;
  for (const auto& [cycle, cases] : cycles) {
    output.text() += fmt::format("{} {} {}\n", cycle.first, cycle.second, cases);
  }
  output.tell();
  return kGo;
}

int lint(const CorpusWords& words) {
  const oracle::Corpus corpus(corpus_folder(words.folder));
  Output output;
  std::size_t findings = 0;
  const auto say = [&](const std::string& sentence) {
    ++findings;
    output.text() += sentence + "\n";
    output.flush_if_large();
  };
  const std::size_t cases = oracle::lint(corpus, {words.part}, say);
  CoveringArrays arrays;
  corpus.for_each([&](const Case& test) { arrays.take(test); });
  arrays.for_each([&](const std::string& stem, const cover::TupleCount& count) {
    for (const std::string& row : count.invalid) {
      say(fmt::format("{}: {} has classes that do not go together.", stem, row));
    }
  });
  output.text() += fmt::format("{} cases, {} findings\n", cases, findings);
  output.tell();
  return findings == 0 ? kGo : kNoGo;
}

void show(Output& output, const char* what, const std::vector<std::string>& ids) {
  if (ids.empty()) return;
  output.text() += fmt::format("{}: {}\n", what, ids.size());
  for (const std::string& id : ids) output.text() += "  " + id + "\n";
}

int diff(const CorpusWords& words) {
  const oracle::Corpus before(corpus_folder(words.old_folder));
  const oracle::Corpus now(corpus_folder(words.new_folder));
  const oracle::CorpusDiff diff = oracle::diff(before, now);
  Output output;
  output.text() = fmt::format("{} -> {}\n", before.version(), now.version());
  show(output, "added", diff.added);
  show(output, "removed", diff.removed);
  show(output, "removed, but not retired", diff.not_retired);
  show(output, "another program under the same id", diff.reused);
  show(output, "changed expectation", diff.changed);
  show(output, "of them, another end", diff.changed_ends);
  if (diff.same()) output.text() += "the same cases\n";
  output.tell();
  return diff.same() ? kGo : kNoGo;
}

int stats(const CorpusWords& words) {
  check_choice(words.choice);
  const oracle::Corpus corpus(corpus_folder(words.folder));
  CorpusStats stats;
  corpus.for_each([&](const Case& test) {
    if (words.choice.takes(test)) stats.take(test);
  });
  if (stats.cases() == 0) fail_to_choose(corpus);
  Output output;
  output.text() =
      fmt::format("corpus {} sha256 {}\n", oracle::visible(corpus.version()), corpus.sha256());
  output.text() += stats.text();
  output.tell();
  return kGo;
}

int copy(const CorpusWords& words) {
  check_choice(words.choice);
  const oracle::Corpus corpus(corpus_folder(words.folder));
  oracle::CorpusFolder part{corpus.version(), corpus.retired(), {}};
  std::size_t cases = 0;
  for (const std::string& file : corpus.files()) {
    for (Case& test : oracle::read_vector_file(corpus.folder() + "/" + file)) {
      if (!words.choice.takes(test)) continue;
      ++cases;
      part.files[file].push_back(std::move(test));
    }
  }
  if (cases == 0) fail_to_choose(corpus);
  oracle::write_corpus(words.out, part);
  Output output;
  output.text() = fmt::format("{} cases in {}\n", cases, words.out);
  output.tell();
  return kGo;
}

void add_choice(Command& command, Choice& choice) {
  command.repeated_option("--only", choice.only, "cases by a glob over ids: gsk.g94.*");
  command.repeated_option("--dialect", choice.dialects, "cases of this dialect");
  command.repeated_option("--feature", choice.features, "cases that need this feature");
  command.repeated_option("--basis", choice.bases,
                          "cases with an expectation on this basis: text, derived or silent");
}

}  // namespace

void add_corpus(Command& program) {
  auto words = std::make_shared<CorpusWords>();
  const char* whose = "folder of the corpus (the checked-in one)";
  Command command =
      program.add_command("corpus", "Make, list, check, count, compare, copy or publish a corpus");
  command.require_command();

  Command lists = command.add_command("list", "the cases and what they are about");
  lists.option("--corpus", words->folder, whose);
  add_choice(lists, words->choice);
  lists.run([words] { return list(*words); });

  Command each =
      command.add_command("cycles", "dialect, cycle and number of cases, a line a cycle");
  each.option("--corpus", words->folder, whose);
  add_choice(each, words->choice);
  each.run([words] { return cycles(*words); });

  Command lints =
      command.add_command("lint", "check what a corpus promises, case by case and whole");
  lints.option("--corpus", words->folder, whose);
  lints.flag("--part", words->part, "a part of a corpus, which need not hit every clause");
  lints.run([words] { return lint(*words); });

  Command diffs = command.add_command("diff", "what was added, removed or changed between two");
  diffs.needed("old", words->old_folder, "folder of the old corpus");
  diffs.needed("new", words->new_folder, "folder of the new corpus");
  diffs.run([words] { return diff(*words); });

  Command counts = command.add_command("stats", "how many cases, alarms, clauses, tuples");
  counts.option("--corpus", words->folder, whose);
  add_choice(counts, words->choice);
  counts.run([words] { return stats(*words); });

  Command copies = command.add_command("copy", "a part of the corpus as one of its own");
  copies.option("--corpus", words->folder, whose);
  copies.needed("--out", words->out, "new folder for the part");
  add_choice(copies, words->choice);
  copies.run([words] { return copy(*words); });

  add_corpus_making(command);
}

}  // namespace gonogo::cli
