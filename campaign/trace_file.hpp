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

// One run of one case. Until it is kept the file is <id>.jsonl.part, of a further run of the case
// <id>.jsonl.2.part and so on.
class TraceFile {
 public:
  // Removes what an earlier campaign left of the case. `number`: of its runs, from 1.
  TraceFile(const std::string& folder, std::string_view id, int number = 1);
  TraceFile(const TraceFile&) = delete;
  TraceFile& operator=(const TraceFile&) = delete;
  ~TraceFile();

  // Never throws: finish() reports a disk that is full.
  void record(const reference::Record& record);
  // At the end of the run. Throws ResultsUnwritable.
  void finish(const RunEnd& end);
  // For the run that counts: keeps the file when the run had an outcome, also one that was cut
  // short because nothing could change the verdict any more; a crash, a timeout or a skip leaves
  // none. Throws ResultsUnwritable.
  void keep();

 private:
  void put(const std::string& line);

  std::string path_;
  std::string part_;
  FileHandle file_;
  int error_ = 0;  // errno of the first write that failed
  bool has_outcome_ = false;
};

// Makes the folder and subject.json in it. Throws ResultsUnwritable.
void begin_traces(const std::string& folder, const SubjectInfo& subject);

}  // namespace gonogo::oracle
