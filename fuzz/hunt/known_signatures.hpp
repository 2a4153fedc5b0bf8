// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a subject is known to fail of a corpus, as a hunt would find it.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "fuzz/hunt/signature.hpp"
#include "fuzz/hunt/trial.hpp"
#include "corpus/io/corpus.hpp"

namespace gonogo::hunt {

// Runs the corpus's cases of the dialect that entries cover; the signatures of those that fail as
// one of them says. A flaky entry hides nothing: a hunt could not distinguish it from a failure that is
// always there. Throws oracle::CorpusError, oracle::SubjectUnusable.
std::set<Signature> known_signatures(const std::vector<oracle::KnownFailure>& entries,
                                     const oracle::Corpus& corpus, const std::string& dialect,
                                     Trial& trial);

}  // namespace gonogo::hunt
