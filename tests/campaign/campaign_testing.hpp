// SPDX-License-Identifier: GPL-3.0-or-later
//
// A small corpus in a folder of its own, and a subject that answers from the reference.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "campaign/results_writer.hpp"
#include "tests/has.hpp"

namespace gonogo::oracle {

class Scratch {
 public:
  // With a corpus of `cases` moves along X, in files of ten, below path("corpus"); 0: without.
  explicit Scratch(int cases = 0);
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch();
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void write(const std::string& name, const std::string& text) const;
  std::string read(const std::string& name) const;

 private:
  std::filesystem::path folder_;
};

// What a run of the fake subject does instead of answering well; nothing: it answers well.
struct FakeSubject {
  int window = 1;
  // Called before each run with the id and how many runs this process has done.
  std::function<std::optional<RunEnd>(std::string_view id, int runs)> act;
  RunEnd::Kind end = RunEnd::Kind::ok;  // behind the records of the reference
  std::int64_t microseconds = 0;        // of such a run
  // What becomes of a record of the reference; nothing: it is sent as it is.
  std::function<void(std::string_view id, reference::Record&)> alter;
  bool breaks_at_end = false;  // behind the last run
  // What it says of itself; nothing: of everything, with source lines.
  std::optional<SubjectInfo> info;
};
SubjectMaker fake_maker(FakeSubject fake);
FakeSubject acting(decltype(FakeSubject::act) act);

RunEnd ended(RunEnd::Kind kind);

// A result of its own, for tests of the files.
CaseResult passed(std::string id);

// For tests of the answer of a run.
CaseFacts facts(std::string id, VerdictKind verdict, std::string dialect = "gsk988ta");
RunAnswer answer(const std::vector<CaseFacts>& cases, const std::vector<std::string>& stale = {});

CampaignOptions options_of(int jobs);
// Runs the corpus of the folder and writes the results there; returns their footer.
std::string results_of(const Scratch& scratch, const FakeSubject& fake,
                       const CampaignOptions& options = options_of(1),
                       const std::string& name = "r");

}  // namespace gonogo::oracle
