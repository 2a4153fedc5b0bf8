// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes results.jsonl. Until all is there <path>.part is the journal: the header and the case
// lines as they come. Only an interrupted run that goes on reads it: everything is decided from the
// lines as they were added.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/line_sorter.hpp"
#include "campaign/results.hpp"
#include "campaign/results_lock.hpp"
#include "corpus/io/id_set.hpp"

namespace gonogo::oracle {

// The name of results in the folder of a report.
inline constexpr std::string_view kReportedResults = "results.jsonl";
// In the folder of a report: the programs that it has written.
inline constexpr std::string_view kListOfPrograms = "programs/.written";
// Removes what a report of earlier results has left in its folder, so that nothing of it stands
// beside others when a disk is full or the program is killed. Throws filesystem_error.
void remove_views(const std::filesystem::path& folder);

class ResultsWriter {
 public:
  enum class Start {
    anew,    // a journal that is there is overwritten
    resume,  // goes on from the journal, if there is one
  };

  // Throws ResultsUnwritable when the journal cannot be written; ResultsRefused when another run
  // writes there, when what stands there is no results, and when the journal is of another run: its
  // header may differ in argv and seed only.
  ResultsWriter(std::string path, const ResultsHeader& header, Start start = Start::anew);
  // With a header line that is there already.
  ResultsWriter(std::string path, std::string header, Start start = Start::anew);
  ResultsWriter(const ResultsWriter&) = delete;
  ResultsWriter& operator=(const ResultsWriter&) = delete;

  static std::string journal_of(const std::string& path) { return path + ".part"; }
  // Whether the journal held the case when the run began, and how many there were.
  bool has(std::string_view id) const { return resumed_.contains(id); }
  std::size_t resumed() const { return resumed_.size(); }

  // Both throw ResultsUnwritable; what came before is kept.
  void add(const CaseResult& result);
  void add_line(std::string_view line);
  // A fresh program. The journal has none: a run that goes on draws its own.
  void add_fresh(const CaseResult& result) { lines_.add(case_line(result, true)); }

  // What the cases come to so far, before the readings of the run are reconciled.
  struct Standing {
    std::map<std::string, std::size_t> judged;  // by dialect
    std::size_t no_go = 0;
    std::size_t known = 0;  // to fail
  };
  const Standing& standing() const { return standing_; }

  // What close() needs to know of the run besides its cases.
  struct Ending {
    std::size_t left_out = 0;
    std::vector<std::string> stale;  // except for alarms
    // All entries of the alarm map, when every case of the dialects was asked for.
    std::optional<std::vector<std::string>> alarms;
    // The other shards of a shard may have cases that meet what its own did not.
    bool is_shard = false;
    FreshCounts fresh;
    bool is_complete = true;  // else there are cases to come, and the file has no footer
  };
  // Sorts, reconciles the readings, fills in the footer and puts the file in place in one step; the
  // views of the results that it replaces are removed before.
  // `visit` sees each case line as it is written. Throws ResultsUnwritable, and std::runtime_error
  // when a case is there twice.
  using Visit = std::function<void(const std::string& line, VerdictKind kind)>;
  ResultsFooter close(const Ending& ending, const Visit& visit = nullptr);
  // Writes the sorted lines without a footer: an incomplete file.
  void close_without_footer();
  // The hash of the whole file that was put in place.
  const std::string& file_sha256() const { return file_sha256_; }

 private:
  class Sorted;
  void resume(const std::string& journal);
  void write(std::string_view line);
  void count(const std::string& dialect, VerdictKind kind);

  std::string path_;
  std::string header_;
  ResultsLock lock_;
  FileHandle journal_;
  LineSorter lines_;
  IdSet resumed_;
  Standing standing_;
  std::string file_sha256_;
};

}  // namespace gonogo::oracle
