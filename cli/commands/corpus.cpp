// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo corpus: what a corpus holds, whether it keeps its promises, what differs between two, and
// a part of one as a corpus of its own.
#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <map>
#include <set>

#include "cli/commands.hpp"
#include "cli/corpus_folder.hpp"
#include "cli/exit_code.hpp"
#include "cli/output.hpp"
#include "cli/program_file.hpp"
#include "corpus/io/corpus_diff.hpp"
#include "corpus/io/folder_writer.hpp"
#include "corpus/io/lint.hpp"
#include "fuzz/generate/cover/cases.hpp"
#include "oracle/records/features.hpp"
#include "oracle/records/text.hpp"
#include "reference/dialect.hpp"
#include "reference/nearest_word.hpp"

namespace gonogo::cli {
namespace {

using cover::Making;
using oracle::Case;

std::string_view basis_name(const oracle::Expectation& expectation) {
  return expectation.basis ? reference::name(*expectation.basis) : "not said";
}

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
    if (!words.choice.takes(test)) return true;
    any = true;
    output.text() += fmt::format("{}  {}\n", test.id, oracle::visible(test.comment));
    output.flush_if_large();
    return true;
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

// The rows of each covering array that cases of a corpus come from, by what their ids begin with.
class Arrays {
 public:
  void take(const Case& test) {
    const std::optional<Making> making = cover::making_of(test);
    if (!making) return;
    Array& array = arrays_[making->stem()];
    if (array.rows.empty()) {
      array.making = *making;
      array.parameters = cover::parse_parameters(making->model->parameters);
    }
    array.rows.push_back(cover::row_of(array.parameters, test));
  }
  // Calls with what the ids begin with and the count of its tuples.
  template <typename Visit>
  void for_each(Visit visit) const {
    for (const auto& [stem, array] : arrays_) {
      visit(stem, cover::count_tuples(array.parameters, array.making.strength, array.rows));
    }
  }

 private:
  struct Array {
    Making making;
    cover::Parameters parameters;
    std::vector<cover::Row> rows;
  };
  std::map<std::string, Array> arrays_;
};

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
  Arrays arrays;
  corpus.for_each([&](const Case& test) {
    arrays.take(test);
    return true;
  });
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

// How often something occurs, by name.
using Count = std::map<std::string, std::size_t>;

class Stats {
 public:
  void take(const Case& test) {
    Cycle& cycle = cycles_[test.dialect + " " + test.cycle];
    ++cycle.cases;
    ++cases_;
    dialects_.insert(test.dialect);
    std::set<std::string> alarms;
    for (const oracle::Expectation& expectation : test.expect) {
      ++bases_[fmt::format("{}, {}", basis_name(expectation),
                           expectation.alarms.empty() ? "no alarm" : "alarm")];
      for (const auto& alarm : expectation.alarms) alarms.emplace(name(alarm.alarm));
      for (const auto& record : expectation.records) {
        if (record.clause != reference::kNoClause) {
          clauses_.emplace(reference::clause_name(record.clause));
        }
        if (record.kind == reference::RecordKind::arc) {
          ++planes_[fmt::format("G{}", reference::plane_code(record.plane))];
        }
      }
    }
    if (!alarms.empty()) ++cycle.alarms, ++alarming_;
    for (const std::string& alarm : alarms) ++alarms_[alarm];
    if (!test.tags_sign.empty()) ++signs_;
    listed_.insert(test.clauses.begin(), test.clauses.end());
    for (const reference::Reading& reading : reference::readings()) {
      const std::string_view value = test.profile.readings.get(reading.key);
      if (reading.belongs_to(test.dialect) && value != reading.fallback) {
        ++readings_[fmt::format("{}={}", reading.name, value)];
      }
    }
    arrays_.take(test);
  }

  std::size_t cases() const { return cases_; }

  void print(Output& output) const {
    std::string& text = output.text();
    text += fmt::format("{} cases, {} with an alarm ({:.1f} in a hundred), {} at a limit\n", cases_,
                        alarming_,
                        100.0 * static_cast<double>(alarming_) /
                            static_cast<double>(std::max<std::size_t>(cases_, 1)),
                        signs_);
    for (const auto& [name, cycle] : cycles_) {
      text +=
          fmt::format("{:<24} {:>6} cases, {:>5} with an alarm\n", name, cycle.cases, cycle.alarms);
    }
    text += fmt::format("clauses: {} of {} stand in groups, {} in records\n", listed_.size(),
                        count_clauses(), clauses_.size());
    print(text, "basis, expectations", bases_);
    print(text, "alarm, cases that may raise it", alarms_);
    print(text, "plane of arcs, records", planes_);
    print(text, "reading other than the default, cases", readings_);
    text += "covering arrays\n";
    arrays_.for_each([&](const std::string& stem, const cover::TupleCount& count) {
      text += fmt::format("  {:<28} {:>6} tuples, {:>6} covered, {:>5} excluded\n", stem,
                          count.allowed, count.covered, count.excluded);
    });
  }

 private:
  struct Cycle {
    std::size_t cases = 0;
    std::size_t alarms = 0;
  };

  // For the dialects that the cases have; a clause may belong to two of them.
  std::size_t count_clauses() const {
    std::set<std::string_view> ids;
    for (const std::string& dialect : dialects_) {
      for (const reference::Clause& clause : reference::find_dialect(dialect)->clauses) {
        ids.insert(clause.id);
      }
    }
    return ids.size();
  }

  static void print(std::string& text, const char* what, const Count& count) {
    text += fmt::format("{}\n", what);
    for (const auto& [name, times] : count) text += fmt::format("  {:<40} {:>6}\n", name, times);
  }

  std::map<std::string, Cycle> cycles_;
  std::size_t cases_ = 0, alarming_ = 0, signs_ = 0;
  Count bases_, alarms_, planes_, readings_;
  std::set<std::string> clauses_, listed_, dialects_;
  Arrays arrays_;
};

int stats(const CorpusWords& words) {
  check_choice(words.choice);
  const oracle::Corpus corpus(corpus_folder(words.folder));
  Stats stats;
  corpus.for_each([&](const Case& test) {
    if (words.choice.takes(test)) stats.take(test);
    return true;
  });
  if (stats.cases() == 0) fail_to_choose(corpus);
  Output output;
  output.text() =
      fmt::format("corpus {} sha256 {}\n", oracle::visible(corpus.version()), corpus.sha256());
  stats.print(output);
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
  diffs.argument("old", words->old_folder, "folder of the old corpus");
  diffs.argument("new", words->new_folder, "folder of the new corpus");
  diffs.run([words] { return diff(*words); });

  Command counts = command.add_command("stats", "how many cases, alarms, clauses, tuples");
  counts.option("--corpus", words->folder, whose);
  add_choice(counts, words->choice);
  counts.run([words] { return stats(*words); });

  Command copies = command.add_command("copy", "a part of the corpus as one of its own");
  copies.option("--corpus", words->folder, whose);
  copies.needed_option("--out", words->out, "new folder for the part");
  add_choice(copies, words->choice);
  copies.run([words] { return copy(*words); });

  add_corpus_making(command);
}

}  // namespace gonogo::cli
