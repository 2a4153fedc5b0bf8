// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is said of a results file, and counted of its verdicts.
#pragma once

#include <cstddef>
#include <cstdio>
#include <map>
#include <string>

#include "checker/derive.hpp"
#include "checker/verdicts.hpp"

namespace gonogo::checker {

class VerdictReport {
 public:
  // `options` must outlive it.
  VerdictReport(const VerdictOptions& options, std::FILE* out) : options_(options), out_(out) {}

  // What does not hold of the results file, or of the corpus.
  void file_fault(const std::string& sentence);
  void corpus_fault(const std::string& sentence);
  // What nobody can tell by the file.
  void open(const std::string& sentence) const { say("open", options_.results, sentence); }
  void differs(const std::string& id, const std::string& sentence);
  // A verdict that was derived again; not of Kind::undecided.
  void agrees(Derived::Kind kind) { ++derived_[kind]; }
  // A verdict that is not decided here, and why.
  void leave_out(const std::string& reason) { ++left_out_[reason]; }
  // The same, so that the run is not proven (J-RUN-13).
  void unproven(const std::string& reason) {
    leave_out(reason);
    note_unproven();
  }
  void note_unproven() { is_unproven_ = true; }

  // Prints the counts; returns the exit code.
  int summary(std::size_t cases, bool is_incomplete) const;

 private:
  void say(const char* what, const std::string& where, const std::string& sentence) const;
  std::size_t derived(Derived::Kind kind) const;

  const VerdictOptions& options_;
  std::FILE* out_;
  std::map<Derived::Kind, std::size_t> derived_;
  std::map<std::string, std::size_t> left_out_;
  std::size_t differing_ = 0;
  std::size_t file_faults_ = 0;
  bool is_unproven_ = false;
};

}  // namespace gonogo::checker
