// SPDX-License-Identifier: GPL-3.0-or-later
//
// The lines of results.jsonl: a header, a line a case sorted by id, a footer. A file without its
// footer is incomplete.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/tally.hpp"
#include "corpus/io/sha256.hpp"
#include "oracle/motion/tolerances.hpp"
#include "oracle/records/fresh_counts.hpp"
#include "oracle/records/subject_outcome.hpp"
#include "oracle/records/verdict.hpp"
#include "reference/profile.hpp"

namespace gonogo::oracle {

// What was run.
struct ResultsHeader {
  std::string version;         // of gonogo
  std::string commit;          // that it was built from; empty: unknown
  std::string program_sha256;  // of the program file; empty: unknown
  std::string corpus_version;
  std::string corpus_sha256;
  std::string subject_spec;
  SubjectInfo subject;
  std::string profile;  // JSON object of what the certifier set
  std::string machine;  // dialect of the certifier's profile; empty: there is none
  std::vector<reference::ProfileKey> machine_keys;  // that it sets, to the default or not
  std::vector<std::string> readings;                // "k=v" over the cases' profiles
  std::string tolerance;                            // empty: as declared
  std::string chord;                                // empty: none
  std::string feed_resolution;                      // empty: as declared
  std::string blend;           // mm; empty: corners of sampled positions are not cut
  std::string feed_tolerance;  // of feeds from sampled positions, percent; empty: not given
  bool show_ids = false;       // the subject is told the names of the cases
  bool strict = false;         // advices are NO-GO
  std::string sandbox;         // "bubblewrap", "none"; empty: the subject starts no process
  // By dialect: what the subject declares, but counts for less.
  std::vector<std::pair<std::string, Capped>> capped;
  std::vector<std::string> dialects;  // empty: all
  std::vector<std::string> only;      // globs over ids; empty: all
  std::vector<std::string> cases;     // empty: all
  std::vector<std::string> cycles;    // empty: all
  std::vector<std::string> clauses;   // empty: all
  std::string known_failures_sha256;  // of the file; empty: none
  std::string alarm_map_sha256;       // of the file; empty: none
  std::uint64_t seed = 0;             // of the order of the cases; 0: there is none
  std::string shard = "1/1";
  std::vector<std::string> argv;
};

// One judged case.
struct CaseResult {
  std::string id;
  std::string dialect;
  std::string cycle;
  std::vector<std::string> features;  // that it needs
  std::vector<std::string> clauses;
  Verdict verdict;
  std::string profile;             // JSON object
  std::string program;             // bytes; only when not GO, or when readings may make it so
  std::vector<std::string> trace;  // records as JSON; likewise
  std::string notes;               // what the subject noted and wrote to stderr; only when not GO
  std::int64_t microseconds = 0;
  int attempts = 1;
  bool expected_gap = false;             // the corpus expects that the gauge cannot say
  std::optional<OpenReadings> readings;  // of a GO that touched open readings
  std::string mapped;  // the entry of the alarm map that gave the alarm its class; empty: none
};

struct ResultsFooter {
  RunAnswer answer;
  std::size_t left_out = 0;  // contradict the certifier's profile
  // Entries of the subject's files that are no longer true.
  std::vector<std::string> stale;
  // Entries of the alarm map that no case met; nothing when cases were left out by choice. Stale
  // when the run is no shard.
  std::optional<std::vector<std::string>> unused_alarms;
  FreshCounts fresh;   // programs beside the cases
  std::string sha256;  // over the case lines without `us`, `attempts` and `notes`
};

std::string header_line(const ResultsHeader& header);
// The key `numeric` of a subject: what it says itself.
nlohmann::ordered_json numeric_json(const SubjectInfo& subject);

// The key `capped` of the header.
nlohmann::ordered_json capped_json(const std::vector<std::pair<std::string, Capped>>& capped);
std::string footer_line(const ResultsFooter& footer);
// The key `coordinates` of the footer.
nlohmann::ordered_json coordinates_json(const std::map<std::string, RoundingCensus>& coordinates);
// `with_timing`: with `us`, `attempts` and `notes`, which no two runs need have the same.
std::string case_line(const CaseResult& result, bool with_timing);

// A case line as written here without `us`, `attempts` and `notes`, as the hash of the footer takes
// it except for the line end.
std::string line_without_timing(std::string_view line);
// Takes a case line, as written here, into the hash of the footer.
void hash_case_line(std::string_view line, Sha256& hash);
// A case line of a run whose readings leave the case the verdict `kind`, for the `conflict` of the
// run. A pass keeps program and trace only where it may still come to another verdict, with other
// shards.
enum class PassEvidence { keep, drop };
std::string reconciled_line(const std::string& line, VerdictKind kind,
                            const std::optional<ReadingConflict>& conflict, PassEvidence evidence);
// The id that a case line begins with.
std::string id_of_line(std::string_view line);

}  // namespace gonogo::oracle
