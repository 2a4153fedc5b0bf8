// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo signs: which signs of the comparisons that clauses turn on the corpus has, and which a
// hunt comes to: clause by sign by dialect.
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/named_files.hpp"
#include "cli/output.hpp"
#include "cli/program_file.hpp"
#include "cli/subjects.hpp"
#include "fuzz/generate/generator.hpp"
#include "fuzz/hunt/sign_coverage.hpp"
#include "reference/dialect.hpp"

namespace gonogo::cli {
namespace {

struct SignsWords {
  std::string corpus;
  std::string dialect;  // empty: all
  std::string format = "text";
  bool missing = false;
  long programs = 2'000;  // of the hunt
  long seed = 1;
};

std::string line_of(const hunt::SignRow& row, bool is_markdown) {
  if (is_markdown) {
    return fmt::format("| {} | `{}` | `{}` | `{}` |\n", row.clause, row.what, hunt::met(row.corpus),
                       hunt::met(row.hunt));
  }
  return fmt::format("  {:<12} {:<28} corpus {}   hunt {}\n", row.clause, row.what,
                     hunt::met(row.corpus), hunt::met(row.hunt));
}

bool is_complete(const hunt::Signs& signs) {
  return signs[0] != 0 && signs[1] != 0 && signs[2] != 0;
}

void append_dialect(std::string& out, const SignsWords& words, std::string_view dialect,
                    const std::vector<hunt::SignRow>& rows) {
  const bool is_markdown = words.format == "markdown";
  const hunt::SignSummary summary = summary_of(rows);
  out += is_markdown ? fmt::format("\n{}: ", dialect) : fmt::format("{}: ", dialect);
  out += fmt::format(
      "{} comparisons, {} signs; the corpus has {}, a hunt of {} programs {}, either {}\n",
      summary.comparisons, summary.comparisons * 3, summary.corpus, words.programs, summary.hunt,
      summary.either);
  std::string lines;
  for (const hunt::SignRow& row : rows) {
    if (words.missing && is_complete(row.corpus) && is_complete(row.hunt)) continue;
    lines += line_of(row, is_markdown);
  }
  if (is_markdown && !lines.empty())
    out += "\n| clause | sign of | corpus | hunt |\n|---|---|---|---|\n";
  out += lines;
}

int signs(const SignsWords& words) {
  if (!words.dialect.empty()) check_dialect_name(words.dialect);
  const oracle::Corpus corpus(corpus_folder(words.corpus));
  Output output;
  for (const reference::Dialect& dialect : reference::dialects()) {
    if (!words.dialect.empty() && words.dialect != dialect.name) continue;
    const std::string name(dialect.name);
    const generate::Generator& generator = generate::generator_of(name);
    const oracle::SubjectMaker subject =
        subject_maker(fmt::format("builtin:{}", generator.expander), {});
    append_dialect(
        output.text(), words, name,
        hunt::sign_rows(hunt::signs_of_corpus(corpus, name),
                        hunt::signs_of_hunt(subject, name, static_cast<std::uint64_t>(words.seed),
                                            static_cast<std::size_t>(words.programs))));
    output.flush();
  }
  return kGo;
}

}  // namespace

void add_signs(Command& program) {
  auto words = std::make_shared<SignsWords>();
  Command command = program.add_command(
      "signs", "Tell which signs of what clauses turn on the corpus and a hunt meet");
  command.option("--corpus", words->corpus, "folder of the corpus (the checked-in one)");
  command.option("--dialect", words->dialect, "only this one");
  command.flag("--missing", words->missing, "only comparisons of which a sign is not met");
  command.number("--programs", words->programs, 0, 100'000'000, "of the hunt (2000)");
  command.number("--seed", words->seed, 0, 2'000'000'000, "of the hunt (1)");
  command.choice("--format", words->format, {"text", "markdown"}, "text or markdown (text)");
  command.run([words] { return signs(*words); });
}

}  // namespace gonogo::cli
