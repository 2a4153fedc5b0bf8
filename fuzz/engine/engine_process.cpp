// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/engine/engine_process.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

#include "fuzz/targets/decision_hooks.hpp"
#include "fuzz/targets/sign_counters.hpp"
#include "fuzz/targets/target.hpp"
#include "fuzz/tried_subject.hpp"

// libFuzzer's. Weak: a build without it has everything else.
extern "C" __attribute__((weak)) int LLVMFuzzerRunDriver(int* argc, char*** argv,
                                                         int (*run)(const std::uint8_t* data,
                                                                    std::size_t size));

namespace gonogo::fuzz {
namespace {

// How long a program of those that are learned from may take. The engine watches its own.
constexpr unsigned kLearningSeconds = 10;

// What is tried, and where it is reported. One a process.
class FuzzSession {
 public:
  FuzzSession(const FuzzOptions& options, SharedPage& page)
      : options_(options),
        page_(page),
        tried_(options.subject, options.programs.dialect,
               [&page](const generate::GeneratedProgram& program) {
                 page.note(program);
                 page.stage = FuzzStage::running;
                 ::alarm(kLearningSeconds);
               }),
        trial_([&options] { return make_subject_here(options.subject, options.stated); },
               options.trial) {
    ::alarm(0);
    page_.stage = FuzzStage::running;
  }

  generate::GeneratedProgram made(generate::Choices& choices) const {
    return tried_.generator().generate(choices, options_.programs.settings, nullptr);
  }

  void run(generate::Choices choices) {
    page_.count_program();
    generate::GeneratedProgram drawn = made(choices);
    options_.programs.put_in(drawn.profile);
    std::optional<generate::GeneratedProgram> program = tried_.fitted(std::move(drawn));
    if (!program) {
      ++page_.count.skipped;
      return;
    }
    options_.programs.put_in(program->profile);
    page_.note(*program);
    const SignCounters counters;
    take(trial_.run(*program), *program);
  }

 private:
  void take(const std::optional<oracle::Verdict>& verdict,
            const generate::GeneratedProgram& program) {
    if (!verdict) return;  // too long
    const oracle::Decision decided = oracle::decision(verdict->kind);
    if (verdict->kind == oracle::VerdictKind::skip) ++page_.count.skipped;
    if (decided == oracle::Decision::go || decided == oracle::Decision::no_go) {
      ++page_.count.judged;
      if (trial_.moved()) ++page_.count.moved;
    }
    if (!hunt::is_news(options_.programs, *verdict, program)) return;
    page_.stage = FuzzStage::departed;
    fail(verdict->message, program.text);
  }

  const FuzzOptions& options_;
  SharedPage& page_;
  TriedSubject tried_;
  hunt::Trial trial_;
};

// The engine calls functions without a context.
FuzzSession*& fuzz_session() {
  static FuzzSession* session = nullptr;
  return session;
}

// As fuzz/targets.bash has them for inputs that are decisions. The engine's time is for a run and
// its judge together.
std::vector<std::string> engine_words(const FuzzOptions& options) {
  constexpr std::int64_t kJudgeSeconds = 10;
  const std::int64_t run_seconds = options.trial.run_limit.count() / 1'000;
  std::vector<std::string> words = {"gonogo-fuzz",
                                    "-max_len=128",
                                    "-len_control=0",
                                    "-entropic=0",
                                    "-detect_leaks=0",
                                    fmt::format("-seed={}", options.programs.seed),
                                    fmt::format("-timeout={}", run_seconds + kJudgeSeconds),
                                    fmt::format("-exact_artifact_path={}", options.last_input)};
  if (options.most_programs != 0) words.push_back(fmt::format("-runs={}", options.most_programs));
  if (options.most_seconds != 0) {
    words.push_back(fmt::format("-max_total_time={}", options.most_seconds));
  }
  words.push_back(options.inputs);
  return words;
}

}  // namespace

void decide(generate::Choices& choices) {
  fuzz_session()->made(choices);
}

bool has_fuzz_engine() {
  return LLVMFuzzerRunDriver != nullptr;
}

void run_engine_here(const FuzzOptions& options, SharedPage& page) {
  std::vector<std::string> words = engine_words(options);
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  int argc = static_cast<int>(words.size());
  char** argv = pointers.data();
  try {
    fuzz_session() = new FuzzSession(options, page);
    LLVMFuzzerRunDriver(&argc, &argv, LLVMFuzzerTestOneInput);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    std::_Exit(EXIT_FAILURE);
  }
  std::_Exit(EXIT_SUCCESS);
}

}  // namespace gonogo::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  gonogo::fuzz::fuzz_session()->run(gonogo::fuzz::choices_of(data, size));
  return 0;
}
