// SPDX-License-Identifier: GPL-3.0-or-later
//
// A campaign: a subject against a corpus, to a complete result file whatever the subject does.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "oracle/campaign/known_failures.hpp"
#include "oracle/campaign/results.hpp"
#include "oracle/corpus/corpus.hpp"
#include "oracle/judge/judge_session.hpp"

namespace gonogo::oracle {

struct CampaignOptions {
  std::vector<std::string> dialects;  // empty: all
  std::vector<std::string> only;      // globs over ids; empty: all
  std::string case_id;                // one case
  std::vector<std::string> readings;  // "k=v" over the case's profile
  // A certifier's profile: what it sets holds for every case, and groups that contradict it are
  // left out.
  std::optional<reference::Profile> profile;
  std::optional<Number> tolerance;
  std::optional<Number> chord;
  int jobs = 1;
  unsigned shard = 1;
  unsigned shards = 1;
  bool fail_fast = false;
  Limits limits;
  std::vector<KnownFailure> known_failures;
  std::shared_ptr<const AlarmMap> alarm_map;  // null: the subject's classes are taken as they are

  // Every case of the dialects is asked for.
  bool is_whole() const {
    return only.empty() && case_id.empty() && shards == 1 && !profile && readings.empty() &&
           !fail_fast;
  }
};

struct CampaignSummary {
  ResultsFooter footer;
  std::size_t cases = 0;             // selected
  std::size_t left_out = 0;          // contradict the certifier's profile
  std::vector<CaseResult> failures;  // the first of them, for the terminal
  std::size_t no_go = 0;
  std::size_t unexpected_gaps = 0;
  std::size_t oracle_errors = 0;
  bool complete = true;
  bool judged_nothing = false;  // a dialect in which no case was judged
  // Known failures that are of no case in the corpus, and alarms of the map that a run over all
  // cases of the dialects never met.
  std::vector<std::string> stale;
  std::string reading_conflict;  // the readings that no single assignment explains

  // Exit code of a run, design section 6: 1, 3 or 0.
  int exit_code() const;
  // The same in words: GO, NO-GO or UNDECIDED.
  std::string_view decision() const;
};

using SubjectMaker = std::function<std::unique_ptr<Subject>()>;
// Called after each case, one at a time: done, all, NO-GO so far.
using Progress = std::function<void(std::size_t done, std::size_t all, std::size_t no_go)>;

// Takes each result, one at a time, in any order.
using ResultSink = std::function<void(const CaseResult&)>;

CampaignSummary run_campaign(const Corpus& corpus, const CampaignOptions& options,
                             const SubjectMaker& make_subject, const ResultSink& results,
                             const Progress& progress);

// Judges one case with a subject, with the repetitions that a verdict needs.
CaseResult judge_case(const Case& test, const CampaignOptions& options, Subject& subject,
                      SessionVerdict& session);

// Shard (from 1) of a case id: first 8 bytes of its SHA-256 modulo the number of shards, plus 1.
unsigned shard_of(std::string_view id, unsigned shards);

}  // namespace gonogo::oracle
