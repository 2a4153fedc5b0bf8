// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "publish/evidence/case_row.hpp"
#include "publish/report/summary.hpp"

namespace gonogo::oracle::evidence {

// What a run came to, once all of its lines are read.
struct RunState {
  std::string decision;    // GO, NO-GO, UNDECIDED; INCOMPLETE without a footer
  std::string head;        // of what, in a line
  std::string unfinished;  // what the run lacks, a sentence; or empty
  // Entries of the subject's files that are no longer true: each makes the run NO-GO.
  std::vector<std::string> stale;
  std::string subject;  // its name and version
  Json summary;         // of report::Summary
  Json footer;          // null: none
};

RunState run_state(const report::Summary& summary, const Json& header, const Json* footer);

// "An entry of the subject's files is stale: known failure ngc.a: no case has this id"
std::string stale_sentence(const std::string& entry);

// The subject, with what the certifier granted and with the part of the corpus: "acme 3.2
// (tolerance 1000 mm, shard 1/300)".
std::string run_title(const Json& header);

}  // namespace gonogo::oracle::evidence
