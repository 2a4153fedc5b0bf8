// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is known of a subject beforehand: the cases that it fails, and what its own alarm texts
// mean. Both belong to the subject and are TOML files of its own. An entry that is no longer true
// is itself a finding.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "oracle/campaign/results.hpp"

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
// or all keys of one failure in a [[failure]]. A KnownFailure is one glob of it.
struct KnownFailure {
  std::string cases;
  VerdictKind verdict = VerdictKind::fail_geometry;
  std::string deviation;
  std::string got;
  std::string reason;
};
std::variant<std::vector<KnownFailure>, FileFault> known_failures_from_toml(std::string_view text);

// Turns a failure that is known into `xfail`, and a pass that was to fail into `xpass`. Cases of
// the corpus are noted first.
class KnownFailures {
 public:
  explicit KnownFailures(std::vector<KnownFailure> entries)
      : entries_(std::move(entries)), has_case_(entries_.size(), false) {}
  // A case of the corpus, whether it is run or not.
  void note_case(const std::string& id);
  void apply(CaseResult& result) const;
  // Entries that are of no case of the corpus.
  std::vector<std::string> of_no_case() const;

 private:
  std::vector<KnownFailure> entries_;
  std::vector<bool> has_case_;
};

//   [alarms]
//   "PS0061" = "value-sign"
//   "Zero-radius arc*" = "arc-radius"    a glob over the subject's own text
// May be asked by several threads at once.
class AlarmMap {
 public:
  struct Entry {
    std::string native;
    std::string alarm_class;
  };
  explicit AlarmMap(std::vector<Entry> entries)
      : entries_(std::move(entries)),
        used_(std::make_unique<std::atomic<bool>[]>(entries_.size())) {}
  // The class of the first entry that matches.
  std::optional<std::string_view> class_of(const std::string& native) const;
  std::vector<std::string> unused() const;

 private:
  std::vector<Entry> entries_;
  std::unique_ptr<std::atomic<bool>[]> used_;
};
std::variant<std::vector<AlarmMap::Entry>, FileFault> alarm_map_from_toml(std::string_view text);

}  // namespace gonogo::oracle
