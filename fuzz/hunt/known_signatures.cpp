// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/known_signatures.hpp"

#include <algorithm>

namespace gonogo::hunt {

std::set<Signature> known_signatures(const std::vector<oracle::KnownFailure>& entries,
                                     const oracle::Corpus& corpus, const std::string& dialect,
                                     Trial& trial) {
  std::set<Signature> signatures;
  oracle::CaseReader reader(corpus, oracle::Detail::to_run, {dialect});
  while (const auto test = reader.next()) {
    const auto is_of_it = [&](const oracle::KnownFailure& entry) {
      return !entry.flaky && entry.covers(test->id);
    };
    if (std::ranges::none_of(entries, is_of_it)) continue;
    const generate::GeneratedProgram program{test->profile, test->program};
    const std::optional<oracle::Verdict> verdict = trial.run(program);
    const bool is_known =
        verdict && std::ranges::any_of(entries, [&](const oracle::KnownFailure& entry) {
          return is_of_it(entry) && entry.is(*verdict);
        });
    if (is_known) signatures.insert(signature_of(*verdict, program));
  }
  return signatures;
}

}  // namespace gonogo::hunt
