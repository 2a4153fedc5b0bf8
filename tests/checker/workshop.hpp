// SPDX-License-Identifier: GPL-3.0-or-later
//
// A corpus of three vectors, a results file and traces, made by hand in a folder of their own; a
// test breaks one thing and looks what the checker says.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace gonogo::checker {

inline const std::string kLineCase = "tiny.line.000001";
inline const std::string kArcCase = "tiny.arc.000001";
inline const std::string kAlarmCase = "tiny.alarm.000001";

struct Said {
  int exit_code = 0;
  std::string text;
};

class Workshop {
 public:
  Workshop();
  ~Workshop();
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  // In the file of the vectors; the text must be there, once.
  void change_vectors(const std::string& from, const std::string& to);
  // In the lines of the cases, after which the hash is made again.
  void change_lines(const std::string& from, const std::string& to);
  // In the text of the whole results file, as it lies there in the end.
  void change_results(const std::string& from, const std::string& to);
  void drop_line(const std::string& id);
  void set_trace(const std::string& id, const std::string& records) { traces_[id] = records; }
  void drop_trace(const std::string& id) { traces_.erase(id); }
  void change_trace(const std::string& id, const std::string& from, const std::string& to);
  // The trace of the line departs.
  void depart() { change_trace(kLineCase, R"("to":{"y":"2"},"f")", R"("to":{"y":"3"},"f")"); }
  // A verdict that stands in the line with the records of its trace.
  void set_verdict(const std::string& id, const std::string& verdict);

  Said check_vectors();
  Said check_verdicts();

 private:
  std::string results_text();
  void write();

  std::filesystem::path folder_;
  std::string manifest_;
  std::string vectors_;
  std::string header_;
  std::map<std::string, std::string> lines_;  // by id
  std::map<std::string, std::string> verdicts_;
  std::map<std::string, std::string> traces_;
  std::vector<std::pair<std::string, std::string>> results_changes_;
};

// That it says the sentence of the results.
void expect_said(Workshop& shop, int exit_code, const std::string& sentence);

}  // namespace gonogo::checker
