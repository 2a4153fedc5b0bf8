// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the judge and the definition say of many traces.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "deciding.hpp"

namespace gonogo::relation {

// A program and the tolerances with which a trace of it is judged.
struct Task {
  std::string_view id;
  std::string_view program;
  const reference::Profile& profile;
  const oracle::Tolerances& tolerances;
};

class Comparison {
 public:
  // `change` names what was done to the trace.
  void compare(const Task& task, std::string_view change,
               std::span<const reference::Record> records, const oracle::RunEnd& end);
  void print() const;
  long differences() const;
  long traces() const { return traces_; }

 private:
  void print_difference(const Task& task, std::string_view kind, const Answer& answer,
                        const oracle::Verdict& verdict, const Trace& trace) const;

  long traces_ = 0;
  long narrower_ = 0;  // the judge, about the limit
  long wider_ = 0;
  long of_numbers_ = 0;
  std::map<std::string, long> undecided_;
  std::map<std::string, long> said_;
  std::map<std::string, long> differences_;
};

// A subject that declares lines or M functions, or neither.
oracle::Tolerances tolerances_for(const reference::Profile& profile, bool blocks, bool m);

}  // namespace gonogo::relation
