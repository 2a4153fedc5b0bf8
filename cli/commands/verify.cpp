// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo verify: whether a certificate holds.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "cli/commands.hpp"
#include "cli/gauge.hpp"
#include "cli/named_files.hpp"
#include "cli/output.hpp"
#include "cli/program_file.hpp"
#include "cli/run_again.hpp"
#include "cli/version.hpp"
#include "publish/evidence/statement.hpp"
#include "publish/evidence/verify.hpp"

namespace gonogo::cli {
namespace {

namespace fs = std::filesystem;
using oracle::evidence::Check;

struct VerifyOptions {
  std::string folder;
  std::string corpus;
  std::string subject;
};

// In the order of Check::Result.
constexpr std::array<std::string_view, 4> kResults = {"holds", "FAILS", "not checked", "not shown"};

int verify(const VerifyOptions& options) {
  if (!fs::exists(fs::path(options.folder) / oracle::evidence::kSums)) {
    throw UsageError(fmt::format("{} is no certificate: it has no {}.", options.folder,
                                 oracle::evidence::kSums));
  }
  const std::string corpus = corpus_here(options.corpus);
  std::vector<Check> checks =
      oracle::evidence::verify_certificate(options.folder, corpus, kVersion, gauge_commit());
  auto any = [&](Check::Result result) {
    return std::ranges::find(checks, result, &Check::result) != checks.end();
  };
  if (!options.subject.empty() && !any(Check::Result::fails)) {
    if (corpus.empty()) throw UsageError("To run the subject again a corpus is needed: --corpus.");
    std::vector<Check> again = run_again(options.folder, corpus, options.subject);
    const bool is_same = std::ranges::none_of(
        again, [](const Check& check) { return check.result == Check::Result::fails; });
    // What only the subject can show, it has shown.
    if (is_same) std::erase_if(checks, [](const Check& check) { return check.shown_by_subject; });
    checks.insert(checks.end(), again.begin(), again.end());
  }
  Output output;
  for (const Check& check : checks) {
    output.text() += fmt::format("{:<12} {}\n", kResults[static_cast<std::size_t>(check.result)],
                                 check.sentence);
  }
  const int exit_code = any(Check::Result::fails)       ? kNoGo
                        : any(Check::Result::unchecked) ? kUndecided
                                                        : kGo;
  constexpr const char* kAnswers[] = {"verified", "NOT VERIFIED", "",
                                      "could not be checked in full"};
  output.text() += fmt::format("{}: {}\n", options.folder, kAnswers[exit_code]);
  output.tell();
  return exit_code;
}

}  // namespace

void add_verify(Command& program) {
  auto options = std::make_shared<VerifyOptions>();
  Command command = program.add_command("verify", "Check a certificate");
  command.needed("folder", options->folder, "folder of the certificate");
  command.option("--corpus", options->corpus, "folder of the corpus (the checked-in one)");
  command.option("--subject", options->subject,
                 "run the campaign again with this subject and compare");
  command.run([options] { return verify(*options); });
}

}  // namespace gonogo::cli
