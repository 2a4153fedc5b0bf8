// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a subject sent for a case, kept as capture:DIR reads it: DIR/<id>.jsonl, a record a line and
// an alarm last, and DIR/subject.json with what the subject says of itself.
#pragma once

#include <string>
#include <string_view>

#include "campaign/line_sorter.hpp"
#include "oracle/records/subject_outcome.hpp"

namespace gonogo::oracle {

// One run of one case. Until the run has ended well the file is <id>.jsonl.part.
class TraceFile {
 public:
  // Removes what an earlier run left of the case.
  TraceFile(const std::string& folder, std::string_view id);
  TraceFile(const TraceFile&) = delete;
  TraceFile& operator=(const TraceFile&) = delete;
  ~TraceFile();

  // Never throws: finish() reports a disk that is full.
  void record(const reference::Record& record);
  // Keeps the file when the run had an outcome, be it one that was cut short because nothing could
  // change the verdict any more; a crash, a timeout or a skip leaves none. Throws
  // ResultsUnwritable.
  void finish(const RunEnd& end);

 private:
  void put(const std::string& line);

  std::string path_;
  std::string part_;
  FileHandle file_;
  int error_ = 0;  // errno of the first write that failed
};

// Makes the folder and subject.json in it. Throws ResultsUnwritable.
void begin_traces(const std::string& folder, const SubjectInfo& subject);

}  // namespace gonogo::oracle
