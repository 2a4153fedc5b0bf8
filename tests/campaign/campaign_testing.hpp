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

namespace gonogo::oracle {

class Scratch {
 public:
  Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch();
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void write(const std::string& name, const std::string& text) const;
  std::string read(const std::string& name) const;

 private:
  std::filesystem::path folder_;
};

// `cases` moves along X in files of ten, as a corpus below scratch.path("corpus").
void write_corpus(const Scratch& scratch, int cases);

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

// A result of its own, for tests of the files.
CaseResult passed(std::string id);
std::string results_of(const Scratch& scratch, const std::string& name,
                       const CampaignOptions& options, const SubjectMaker& maker);

}  // namespace gonogo::oracle
