// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/evidence/verify_traces.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <map>

#include "oracle/campaign/reading_tally.hpp"
#include "oracle/corpus/corpus.hpp"
#include "oracle/evidence/rejudge.hpp"
#include "oracle/evidence/text.hpp"
#include "oracle/records/trace_reader.hpp"
#include "oracle/report/case_paths.hpp"
#include "oracle/report/json_value.hpp"

namespace gonogo::oracle::evidence {
namespace {

namespace fs = std::filesystem;
using report::text_of;

// Lines that are held at a time; the corpus is read once for so many.
constexpr std::size_t kBatch = 50'000;

// Whether the verdict hangs on the trace alone: not on how the subject behaved, on two runs, or on
// all cases together.
bool hangs_on_trace(VerdictKind kind) {
  switch (kind) {
    case VerdictKind::skip:
    case VerdictKind::fail_declaration:
    case VerdictKind::state_leak:
    case VerdictKind::crash:
    case VerdictKind::timeout:
    case VerdictKind::out_of_memory:
    case VerdictKind::protocol:
    case VerdictKind::oracle_error:
      return false;
    default:
      return true;
  }
}

// As it was before the readings of the run were reconciled.
VerdictKind kind_of(const Json& line) {
  const auto readings = line.find("readings");
  const Json& source = readings == line.end() ? line : *readings;
  return verdict_kind(text_of(source, "verdict")).value_or(VerdictKind::oracle_error);
}

SessionVerdict judge_trace(const std::string& path, const reference::Profile& profile,
                           const std::string& program, const JudgeTerms& terms) {
  std::ifstream file(path, std::ios::binary);
  JudgeSession session(profile, program, terms);
  TraceReader reader;
  RunEnd end;
  std::size_t number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    TraceLine read = reader.read(line);
    if (auto* record = std::get_if<reference::Record>(&read)) {
      if (!session.record(*record)) break;
    } else if (auto* alarm = std::get_if<SubjectAlarm>(&read)) {
      end.kind = RunEnd::Kind::alarm;
      end.alarm = std::move(*alarm);
    } else {
      throw ResultsError(
          fmt::format("{}, line {}: {}", path, number, std::get<TraceFault>(read).message));
    }
  }
  return session.finish(end);
}

class Traces {
 public:
  Traces(std::string folder, const Json& header, const std::string& corpus)
      : folder_(std::move(folder)), terms_(run_terms(header)), corpus_(corpus) {
    // What stood before the programs of recorded output is not in the traces.
    recorded_ = text_of(header.value("subject", Json::object()), "spec").starts_with("capture:");
  }

  void take(const Json& line) {
    const VerdictKind kind = kind_of(line);
    const std::string id = text_of(line, "id");
    if (!hangs_on_trace(kind) || (recorded_ && decision(kind) != Decision::go)) return;
    if (!fs::exists(path_of(id))) {
      ++without_;
      return;
    }
    lines_.emplace(id, line);
    if (lines_.size() == kBatch) judge_lines();
  }

  void finish(Findings& findings) {
    judge_lines();
    findings.add_list(faults_, fmt::format("{} verdicts, {} GO among them, derived again from the "
                                           "traces: all the same.",
                                           grouped(judged_), grouped(go_)));
    if (without_ > 0) {
      findings.add(
          Check::Result::unchecked,
          fmt::format("{} verdicts hang on traces that are not there.", grouped(without_)));
    }
  }

 private:
  std::string path_of(const std::string& id) const {
    return (fs::path(folder_) / (id + ".jsonl")).string();
  }

  void judge_lines() {
    if (lines_.empty()) return;
    CaseReader cases(corpus_, Detail::to_run);
    while (std::optional<Case> test = cases.next()) {
      const auto line = lines_.find(test->id);
      if (line == lines_.end()) continue;
      const std::string fault = judge(line->second, *test);
      if (!fault.empty()) faults_.push_back(fmt::format("{}: {}", test->id, fault));
      lines_.erase(line);
    }
    for (const auto& [id, line] : lines_) {
      faults_.push_back(fmt::format("{}: the corpus has no such case.", id));
    }
    lines_.clear();
  }

  // In what the answer differs from the line, a sentence; empty: in nothing.
  std::string judge(const Json& line, const Case& test) {
    const auto profile = report::case_profile(test.dialect, line.value("profile", Json::object()));
    if (const auto* fault = std::get_if<std::string>(&profile)) {
      return fmt::format("its profile cannot be read: {}", *fault);
    }
    const auto& machine = std::get<reference::Profile>(profile);
    const JudgeTerms terms = make_terms(terms_.subject, machine, terms_.grants);
    const SessionVerdict now = judge_trace(path_of(test.id), machine, test.program, terms);
    ++judged_;
    if (decision(now.verdict.kind) == Decision::go) ++go_;
    return difference(line, now);
  }

  static std::string difference(const Json& line, const SessionVerdict& now) {
    const VerdictKind told = kind_of(line);
    const VerdictKind kind = now.verdict.kind;
    // What is known to fail is told with the reason in place of the verdict.
    const bool is_same = told == VerdictKind::xfail   ? decision(kind) == Decision::no_go
                         : told == VerdictKind::xpass ? decision(kind) == Decision::go
                                                      : told == kind;
    if (!is_same) {
      return fmt::format("the verdict was {}, but derived from the trace it is {}. {}", name(told),
                         name(kind), now.verdict.message);
    }
    if (decision(told) != Decision::go || told == VerdictKind::xfail) return {};
    const auto open = open_readings(now);
    const Json explaining = open ? Json(open->explaining) : Json::array();
    const Json readings = line.value("readings", Json::object());
    if (readings.value("explaining", Json::array()) == explaining) return {};
    return fmt::format("the readings that explain it were {}, but derived from the trace {}.",
                       report::dump(readings.value("explaining", Json::array())),
                       report::dump(explaining));
  }

  std::string folder_;
  RunTerms terms_;
  Corpus corpus_;
  bool recorded_ = false;
  std::map<std::string, Json> lines_;  // that are to be judged
  std::vector<std::string> faults_;
  std::size_t judged_ = 0;
  std::size_t go_ = 0;
  std::size_t without_ = 0;
};

}  // namespace

void check_traces(const std::string& results, const std::string& traces, const std::string& corpus,
                  Findings& findings) {
  ResultsReader reader(results);
  Traces judge(traces, reader.header(), corpus);
  for (Json line; reader.next(line);) judge.take(line);
  judge.finish(findings);
}

}  // namespace gonogo::oracle::evidence
