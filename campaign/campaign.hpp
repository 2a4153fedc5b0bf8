// SPDX-License-Identifier: GPL-3.0-or-later
//
// A campaign: a subject against a corpus, into a results file that no subject can keep incomplete.
// The cases stream from the corpus to the workers and from them to the results; none is kept.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "campaign/known_failures.hpp"
#include "campaign/results.hpp"
#include "corpus/io/corpus.hpp"
#include "oracle/motion/tolerances.hpp"
#include "subjects/make_subject.hpp"

namespace gonogo::oracle {

struct CampaignOptions {
  std::vector<std::string> dialects;  // empty: all
  std::vector<std::string> only;      // globs over ids; empty: all
  std::vector<std::string> cases;     // ids; empty: all
  std::vector<std::string> cycles;    // empty: all
  std::vector<std::string> clauses;   // cases that are there to test one of them; empty: all
  std::vector<std::string> readings;  // "k=v" over the case's profile
  // A certifier's profile: what it sets holds for every case, and groups that contradict it are
  // left out.
  std::optional<reference::Profile> profile;
  std::vector<reference::ProfileKey> profile_keys;  // those that it sets, to the default or not
  Grants grants;
  int jobs = 1;
  unsigned shard = 1;
  unsigned shards = 1;
  std::uint64_t seed = 0;  // of the order in which cases run; 0: that of the corpus
  bool fail_fast = false;
  Limits limits;
  std::vector<KnownFailure> known_failures;
  std::shared_ptr<const AlarmMap> alarm_map;  // null: the subject's classes are taken as they are
  std::size_t expected = 0;  // what count_cases() says, for the progress; 0: not counted
  std::string traces;        // folder for what the subject sends for each case; empty: none
  // Cases of a resumed run that have results already; null: none.
  std::function<bool(std::string_view id)> is_done;

  // Whether no case is left out by choice, except by sharding. A profile, and readings that the
  // subject follows, leave out nothing that it could run.
  bool is_whole() const { return !is_part() && !fail_fast; }
  // Only some cases of the dialects were asked for.
  bool is_part() const {
    return !only.empty() || !cases.empty() || !cycles.empty() || !clauses.empty();
  }
};

// What a campaign has besides its case lines.
struct CampaignEnd {
  std::size_t cases = 0;     // selected, those that were done before among them
  std::size_t left_out = 0;  // contradict the certifier's profile
  bool complete = true;      // not stopped at the first NO-GO
  // Known failures that belong to no case in the corpus, or to more cases than one of them may.
  std::vector<std::string> stale;
};

using SubjectMaker = std::function<std::unique_ptr<Subject>()>;
// Called after each case, one at a time: done, all (options.expected, or estimated until the corpus
// has been read), NO-GO so far.
using Progress = std::function<void(std::size_t done, std::size_t all, std::size_t no_go)>;

// Takes each result, one at a time, in any order, before the readings of the run are reconciled.
using ResultSink = std::function<void(const CaseResult&)>;

// How many cases a campaign will take from the corpus. Throws CorpusError.
std::size_t count_cases(const Corpus& corpus, const CampaignOptions& options);
// The first case that the campaign would judge and whose expectation is not what the reference
// says, with what differs: a fault of the corpus, not of a subject. Nothing: there is none.
std::optional<std::string> first_wrong_vector(const Corpus& corpus, const CampaignOptions& options);

// Throws what the corpus, the subject's making and the sink throw.
CampaignEnd run_campaign(const Corpus& corpus, const CampaignOptions& options,
                         const SubjectMaker& make_subject, const ResultSink& results,
                         const Progress& progress);

}  // namespace gonogo::oracle
