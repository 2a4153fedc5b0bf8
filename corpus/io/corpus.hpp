// SPDX-License-Identifier: GPL-3.0-or-later
//
// Conformance vectors: files by dialect and cycle, read one file at a time.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "corpus/io/id_spans.hpp"
#include "reference/outcome.hpp"
#include "reference/profile.hpp"

namespace gonogo::oracle {

// One admissible class of an expected alarm.
struct ExpectedAlarm {
  reference::AlarmClass alarm = reference::AlarmClass::syntax;
  std::uint64_t block = 0;
  reference::WordName word;
  friend bool operator==(const ExpectedAlarm&, const ExpectedAlarm&) = default;
};

// Records of a shown path that the manual leaves open: the path is one of those that meet the
// conditions.
struct OpenPart {
  std::size_t from = 0;  // its first record, from 0
  std::size_t to = 0;    // behind its last
  reference::ClauseId clause = reference::kNoClause;
  std::string path;        // "pocket-level", "helical-pocket", "thread", "pocket"
  std::string conditions;  // what the words give, an object of JSON; docs/formats.md
};

// What is expected when the named readings have the named values (none: under the profile alone).
struct Expectation {
  std::vector<std::pair<std::string, std::string>> when;  // reading -> value
  std::vector<reference::Record> records;                 // the shown path; `end` last, or none
  std::vector<OpenPart> open;                             // in the order of their records
  std::vector<ExpectedAlarm> alarms;                      // any of them; empty: no alarm
  // As the reference says it: what else those may be called. In a file they are among `alarms`.
  std::vector<ExpectedAlarm> other_classes;
  // What it stands on: of an alarm as the judge takes it (J-ALM-01), else the weakest of what its
  // records and the blocks that run on stand on. Nothing: the file does not say.
  std::optional<reference::Basis> basis;
  bool not_covered = false;
  // Readings that are open give the program other outcomes, too, which this one does not state.
  bool has_others = false;
};

struct Case {
  std::string id;       // "gsk.g94.000001"; immutable, never used again
  std::string comment;  // what it is about
  std::string program;  // bytes
  std::vector<Expectation> expect;
  std::vector<std::string> tags_tway;
  std::vector<std::string> tags_sign;
  std::string provenance;
  // From its file and group.
  std::string dialect;
  std::string cycle;
  std::string group;
  std::vector<std::string> features;
  std::vector<std::string> clauses;
  reference::Profile profile;
};

// Whether an alarm is expected of it, under some values of the readings at least.
bool expects_alarm(const Case& test);

// The version of a corpus that is never released.
inline constexpr std::string_view kUnreleased = "0000.0.0";

// A corpus that cannot be read: file, place and what is wrong, a sentence.
class CorpusError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A folder of vector files (<folder>/vectors/DIALECT/*.json), in the order of their names.
class Corpus {
 public:
  // Lists the files and reads the manifest; throws CorpusError.
  explicit Corpus(std::string folder);
  const std::string& folder() const { return folder_; }
  const std::string& version() const { return version_; }
  // SHA-256 over the names and bytes of all vector files, hex.
  const std::string& sha256() const { return sha256_; }
  // Every case, sorted by id within a file, one file in memory at a time. Throws CorpusError, also
  // for an id that stands in two files or is retired.
  void for_each(const std::function<void(const Case&)>& visit) const;
  const std::vector<std::string>& files() const { return files_; }
  // The size of each file, in the same order.
  const std::vector<std::uint64_t>& file_bytes() const { return file_bytes_; }
  // Ids that were used once and never are again.
  const std::set<std::string>& retired() const { return retired_; }

 private:
  std::string folder_;
  std::string version_;
  std::string sha256_;
  std::vector<std::string> files_;
  std::vector<std::uint64_t> file_bytes_;
  std::set<std::string> retired_;
};

// How much of a case is read: a run of it needs of its expectations only whether they are covered.
enum class Detail { whole, to_run };

// Gives the cases of a corpus out one after the other, one file in memory at a time.
class CaseReader {
 public:
  // The corpus must outlive the reader. `dialects`: only the cases of these, none for all; a file
  // in the folder of another one is not opened. `seed`: files, in each its groups, in each its
  // cases come in an order of that seed; 0: in that of their names and ids.
  explicit CaseReader(const Corpus& corpus, Detail detail = Detail::whole,
                      std::vector<std::string> dialects = {}, std::uint64_t seed = 0);
  CaseReader(const CaseReader&) = delete;
  CaseReader& operator=(const CaseReader&) = delete;
  // Nothing after the last. Throws CorpusError, also for an id that stands in two of the files or
  // is retired, and for a file that is not of the dialect of its folder.
  std::optional<Case> next();
  // How much of these files has been given out, from 0 to 1.
  double part() const;

 private:
  std::string path(std::size_t file) const;
  bool is_wanted(const std::string& dialect) const;
  void read_file();
  void shuffle();
  void refuse_again(const std::string& id) const;

  const Corpus& corpus_;
  Detail detail_;
  std::vector<std::string> dialects_;
  std::uint64_t seed_;
  std::vector<std::size_t> order_;  // of the files that are read
  std::uint64_t bytes_ = 0;         // of all files
  std::uint64_t bytes_before_ = 0;  // of the files before the present one
  std::uint64_t present_bytes_ = 0;
  std::size_t files_read_ = 0;
  std::vector<Case> cases_;  // of the present file
  std::size_t next_ = 0;     // of them
  IdSpans ids_;
};

// One vector file.
std::vector<Case> read_vector_file(const std::string& path, Detail detail = Detail::whole);
// Writes cases of one dialect and cycle as a vector file, canonical: same cases, same bytes.
std::string vector_file_text(std::string_view corpus_version, const std::vector<Case>& cases);

// One expectation as in a vector file; equal texts are equal expectations.
std::string expectation_json(const Expectation& expectation);

// Where a program has more outcomes under open readings, a case states one, and that there are
// others.
inline constexpr std::size_t kMostStated = 8;

// What the reference says of a case's program under its profile: fills `expect`.
Expectation expectation_of(const reference::Profile& profile, std::string_view program);

}  // namespace gonogo::oracle
