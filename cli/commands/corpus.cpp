// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo corpus: what the corpus holds, and whether every case in it still says what the reference
// says.
#include <fmt/format.h>

#include <map>

#include "cli/commands.hpp"
#include "cli/corpus_folder.hpp"
#include "cli/exit_code.hpp"
#include "cli/output.hpp"
#include "oracle/corpus/corpus.hpp"
#include "oracle/corpus/recheck.hpp"

namespace gonogo::cli {
namespace {

int list(const std::string& folder) {
  const oracle::Corpus corpus(corpus_folder(folder));
  Output output;
  corpus.for_each([&](const oracle::Case& test) {
    output.text() += fmt::format("{}  {}\n", test.id, test.comment);
    output.flush_if_large();
    return true;
  });
  output.flush();
  return kGo;
}

int lint(const std::string& folder) {
  const oracle::Corpus corpus(corpus_folder(folder));
  Output output;
  std::size_t cases = 0;
  std::size_t wrong = 0;
  corpus.for_each([&](const oracle::Case& test) {
    ++cases;
    if (auto fault = oracle::recheck(test)) {
      ++wrong;
      output.text() += fmt::format("{}: {}\n", test.id, *fault);
    }
    return true;
  });
  output.text() +=
      fmt::format("{} cases, {} whose expectation the reference does not confirm\n", cases, wrong);
  output.flush();
  return wrong == 0 ? kGo : kNoGo;
}

int stats(const std::string& folder) {
  const oracle::Corpus corpus(corpus_folder(folder));
  struct Count {
    std::size_t cases = 0;
    std::size_t alarms = 0;
  };
  std::map<std::string, Count> by_cycle;
  corpus.for_each([&](const oracle::Case& test) {
    Count& count = by_cycle[test.dialect + " " + test.cycle];
    ++count.cases;
    for (const oracle::Expectation& expectation : test.expect) {
      if (!expectation.alarms.empty()) {
        ++count.alarms;
        break;
      }
    }
    return true;
  });
  Output output;
  output.text() = fmt::format("corpus {} sha256 {}\n", corpus.version(), corpus.sha256());
  for (const auto& [cycle, count] : by_cycle) {
    output.text() +=
        fmt::format("{:<24} {:>6} cases, {:>5} with an alarm\n", cycle, count.cases, count.alarms);
  }
  output.flush();
  return kGo;
}

}  // namespace

void add_corpus(Command& program) {
  auto folder = std::make_shared<std::string>();
  Command command = program.add_command("corpus", "List, check or count the corpus");
  command.require_command();
  struct Verb {
    const char* name;
    const char* text;
    int (*run)(const std::string&);
  };
  for (const Verb& verb : {Verb{"list", "the cases and what they are about", list},
                           Verb{"lint", "check every expectation against the reference", lint},
                           Verb{"stats", "version, hash and numbers of cases", stats}}) {
    Command sub = command.add_command(verb.name, verb.text);
    sub.option("--corpus", *folder, "folder of the corpus (the checked-in one)");
    sub.run([folder, verb] { return verb.run(*folder); });
  }
}

}  // namespace gonogo::cli
