// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is known of a subject in advance: the cases that it fails, and the meaning of its alarm
// texts. Both are TOML files that belong to the subject. An entry that is no longer true is itself
// a finding.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "campaign/results.hpp"
#include "oracle/records/subject_outcome.hpp"

namespace gonogo::oracle {

// Why a file cannot be used: a sentence with the place.
struct FileFault {
  std::string message;
};

//   [[cause]]
//   reason = "chords above 2 R are taken for half circles"
//   program = "G2 X30 R5 F100"      optional, for the reader: the smallest program that shows it
//   [[cause.failure]]
//   cases = ["ngc.arc-r.00004[5-7]", "ngc.arc-r.000051"]   globs over case ids, or one
//   verdict = "fail.geometry"
//   deviation = "1/1000"            optional: exactly this, as results.jsonl has it
//   got = '{"k":"dwell","s":"-1"}'  optional, likewise
//   flaky = "1 of 5"                optional: it fails now and then, in no more runs than that
// or all keys of one failure in a [[failure]].
struct Flaky {
  int failures = 1;  // at most, fewer than runs
  int runs = 2;
};
inline constexpr int kMostRunsOfAFlakyCase = 100;

struct KnownCause {
  struct Failure {
    VerdictKind verdict = VerdictKind::fail_geometry;
    std::string deviation;
    std::string got;
    std::optional<Flaky> flaky;
    std::vector<std::string> cases;  // globs
  };
  std::string reason;
  std::string program;
  std::vector<Failure> failures;
};
std::variant<std::vector<KnownCause>, FileFault> known_causes_from_toml(std::string_view text);
// The inverse, except for comments and the order of keys.
std::string known_causes_text(const std::vector<KnownCause>& causes);

// One glob of a failure. A glob of wildcards alone is refused, and one that covers more than
// kMostCasesOfAGlob cases is a finding: nobody has looked at what it hides.
inline constexpr std::size_t kMostCasesOfAGlob = 20;
struct KnownFailure {
  std::string cases;
  VerdictKind verdict = VerdictKind::fail_geometry;
  std::string deviation;
  std::string got;
  std::string reason;
  std::optional<Flaky> flaky;

  bool covers(const std::string& id) const;
  // Whether the verdict is the one that is known.
  bool is(const Verdict& verdict) const;
  // Makes the known verdict an xfail, which says why it is known and how the case departs.
  void make_known(Verdict& verdict) const;
  // The message of a case that passes though it is known to fail.
  std::string pass_message() const;
  // Behind the message of a case of which so many runs failed, more than a flaky entry allows.
  // REQUIRES: it is flaky.
  std::string beyond_flaky(int runs_that_failed) const;
};
// "1 of 4 runs failed so"
std::string failed_runs(int failures, const Flaky& flaky);
std::vector<KnownFailure> entries_of(const std::vector<KnownCause>& causes);
std::variant<std::vector<KnownFailure>, FileFault> known_failures_from_toml(std::string_view text);

// Turns a failure that is known into `xfail`, and a pass that was to fail into `xpass`. Cases of
// the corpus are noted first.
class KnownFailures {
 public:
  explicit KnownFailures(std::vector<KnownFailure> entries)
      : entries_(std::move(entries)), cases_(entries_.size(), 0) {}
  // A case of the corpus, whether it is run or not.
  void note_case(const std::string& id);
  // May be called by several threads at once, also while cases are noted.
  void apply(CaseResult& result) const;
  // Whether a pass of the case contradicts an entry: one that is not flaky covers it.
  bool must_fail(const std::string& id) const;
  // The flaky entry for such a failure of the case; null: there is none.
  const KnownFailure* flaky_entry(const std::string& id, const Verdict& verdict) const;
  // Entries that are of no case of the corpus, or of too many, as sentences.
  std::vector<std::string> stale() const;

 private:
  std::vector<KnownFailure> entries_;
  std::vector<std::size_t> cases_;  // that each entry covers
};

//   [alarms]
//   "PS0061" = "value-sign"
//   "Zero-radius arc*" = "arc-radius"    a glob over the subject's own text
//   "Bad value" = ["value-sign", "value-out-of-range"]
class AlarmMap {
 public:
  struct Entry {
    std::string native;
    std::string alarm_class;  // several between blanks
  };
  explicit AlarmMap(std::vector<Entry> entries) : entries_(std::move(entries)) {}
  // The first entry that matches; null: none does.
  const Entry* entry_for(const std::string& native) const;
  // Gives an alarm the class of the first entry that matches. That entry; null: there is none, or
  // the run ends in no alarm.
  const Entry* name_class(RunEnd& end) const;
  // The left sides of all entries.
  std::vector<std::string> natives() const;

 private:
  std::vector<Entry> entries_;
};
// What a footer says of an entry that no case met.
std::string stale_alarm(const std::string& native);
std::variant<std::vector<AlarmMap::Entry>, FileFault> alarm_map_from_toml(std::string_view text);

}  // namespace gonogo::oracle
