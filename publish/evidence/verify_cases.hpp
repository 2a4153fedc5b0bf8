// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of verify that derives the verdict of every case: from its trace, else from what its
// line holds, without the subject.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "campaign/known_failures.hpp"
#include "corpus/io/corpus.hpp"
#include "publish/evidence/rejudge.hpp"
#include "publish/evidence/verify_parts.hpp"
#include "publish/evidence/verify_waivers.hpp"

namespace gonogo::oracle::evidence {

class VerdictsAgain {
 public:
  // `traces`: folder with `<id>.jsonl` of the cases; there may be none. `waivers`: the known
  // failures of the run. `alarms`: the entries of its alarm map. `is_own`: it was made by this
  // gonogo, whose messages are the same.
  VerdictsAgain(const Json& header, std::string traces, std::vector<KnownFailure> waivers,
                std::vector<AlarmMap::Entry> alarms = {}, bool is_own = true);
  // `test`: as the corpus and the header have it; null: there is no corpus here.
  void take(const Json& line, const Case* test);
  void tell(Findings& findings) const;

 private:
  // What was done with a verdict: the fault that was found, why it was not derived, else from what.
  struct Answer {
    std::string fault = {};
    std::string not_derived = {};
    std::string way = {};
  };
  Answer answer_of(const Json& line, const CaseRow& row, const Case* test);
  Answer of_skip(const Json& line, const CaseRow& row, const Case& test);
  Answer of_trace(const Json& line, const CaseRow& row, const Case& test,
                  const Wording& wording) const;
  std::string path_of(const std::string& id) const;

  bool is_format_2_;
  bool is_shard_;
  RunTolerances tolerances_;
  std::string traces_;
  Wording wording_;
  RunWaivers waivers_;
  AlarmMap alarms_;
  std::vector<std::string> faults_;
  std::map<std::string, std::size_t> derived_;      // by how
  std::map<std::string, std::size_t> not_derived_;  // by the reason
  // Dialect and profile -> a case that was skipped because the subject refused them, and a case
  // that was run under them.
  std::map<std::string, std::string> refused_;
  std::map<std::string, std::string> run_;
};

}  // namespace gonogo::oracle::evidence
