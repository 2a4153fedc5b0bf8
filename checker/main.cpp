// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo-check: looks at corpora and results of gonogo again, and shares no code with it.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "checker/json.hpp"
#include "checker/vectors.hpp"
#include "checker/verdicts.hpp"

namespace {

constexpr int kWrongUse = 2;
constexpr int kIncomplete = 3;

constexpr const char* kUsage =
    "gonogo-check vectors CORPUS_DIR\n"
    "    the form of every vector, and whether what it expects can be at all\n"
    "gonogo-check verdicts RESULTS.jsonl --corpus DIR [--traces DIR]\n"
    "    every verdict, derived again from the vector and from what the subject sent\n"
    "Exit code: 0 all agree, 1 something differs, 2 wrong use, 3 incomplete or nothing derived.\n";

int wrong_use(const std::string& sentence) {
  std::fprintf(stderr, "gonogo-check: %s\n%s", sentence.c_str(), kUsage);
  return kWrongUse;
}

int run_verdicts(const std::vector<std::string>& words) {
  gonogo::checker::VerdictOptions options;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const bool is_option = words[i] == "--corpus" || words[i] == "--traces";
    if (is_option && i + 1 == words.size()) return wrong_use(words[i] + " needs a folder.");
    if (is_option) {
      (words[i] == "--corpus" ? options.corpus : options.traces) = words[i + 1];
      ++i;
    } else if (!options.results.empty() || words[i].starts_with("--")) {
      return wrong_use("\"" + words[i] + "\" is not understood.");
    } else {
      options.results = words[i];
    }
  }
  if (options.results.empty()) return wrong_use("Name a results file.");
  if (options.corpus.empty()) return wrong_use("Name the corpus of the run with --corpus DIR.");
  if (!options.traces.empty() && !std::filesystem::is_directory(options.traces)) {
    return wrong_use(options.traces + " is no folder of traces.");
  }
  return gonogo::checker::check_verdicts(options, stdout);
}

int check_vectors_of(const std::vector<std::string>& words) {
  if (words.size() != 2) return wrong_use("Name one corpus folder.");
  return gonogo::checker::check_vectors(words[1], stdout);
}

// What was found counts only where it was printed.
int told(int code) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  std::fprintf(stderr, "gonogo-check: standard output cannot be written.\n");
  return code == 1 ? 1 : kIncomplete;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.empty()) return wrong_use("Say what to check.");
  if (words[0] == "--help" || words[0] == "-h") {
    std::fputs(kUsage, stdout);
    return 0;
  }
  try {
    if (words[0] == "vectors") return told(check_vectors_of(words));
    if (words[0] == "verdicts") return told(run_verdicts(words));
  } catch (const gonogo::checker::Fault& fault) {
    std::fprintf(stderr, "gonogo-check: %s\n", fault.what());
    return kWrongUse;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gonogo-check: an error of this program: %s\n", error.what());
    return kWrongUse;
  }
  return wrong_use("\"" + words[0] + "\" is not understood.");
}
