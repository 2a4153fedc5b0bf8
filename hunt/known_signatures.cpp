// SPDX-License-Identifier: GPL-3.0-or-later
#include "hunt/known_signatures.hpp"

#include <algorithm>

namespace gonogo::hunt {

std::set<Signature> known_signatures(const std::vector<oracle::KnownFailure>& entries,
                                     const oracle::Corpus& corpus, const std::string& dialect,
                                     Trial& trial) {
  std::set<Signature> signatures;
  oracle::CaseReader reader(corpus, oracle::Detail::to_run);
  while (const auto test = reader.next()) {
    if (test->dialect != dialect) continue;
    const auto entry = std::ranges::find_if(entries, [&](const oracle::KnownFailure& known) {
      return !known.flaky && known.covers(test->id);
    });
    if (entry == entries.end()) continue;
    const generate::GeneratedProgram program{test->profile, test->program};
    const std::optional<oracle::Verdict> verdict = trial.run(program);
    if (verdict && entry->is(*verdict)) signatures.insert(signature_of(*verdict, program));
  }
  return signatures;
}

}  // namespace gonogo::hunt
