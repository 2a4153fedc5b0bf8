// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "oracle/judge/judge_session.hpp"
#include "oracle/relation/definition.hpp"

namespace gonogo::relation {

// A trace in memory.
struct Trace {
  std::vector<reference::Record> records;
  oracle::RunEnd end;
  Outcome outcome() const {
    return {records, end.kind == oracle::RunEnd::Kind::alarm ? &end.alarm : nullptr};
  }
};
// Reads JSON lines; an alarm record closes them.
Trace trace_of(std::string_view lines);
std::string text_of(const Trace& trace);

// The judge's tolerances as those of the definition.
Tolerances tolerances_of(const oracle::Tolerances& tolerances, const reference::Profile& profile);

// What the subject declares and the certifier grants.
struct Declared {
  std::string_view dialect = "rs274";
  std::string reading = {};  // "k=v"
  bool open = false;         // the other readings are as a run leaves them, else as `expand` shows
  std::string tool = {};     // radius of tool 1, mm
  bool blocks = true;
  bool m = true;
  bool exact = false;
  bool strict = false;
  std::string resolution = {};
  std::string feed_resolution = {};
  std::string chord = {};
  bool at_load = false;        // alarm_timing = program
  std::string tolerance = {};  // granted, mm
};
// "GO", "NO-GO", "undecided" or "advice".
inline std::string_view word(oracle::VerdictKind kind) {
  switch (decision(kind)) {
    case oracle::Decision::go:
      return "GO";
    case oracle::Decision::no_go:
      return "NO-GO";
    case oracle::Decision::undecided:
      return "undecided";
    default:
      return "advice";
  }
}

Answer decide(std::string_view program, std::string_view trace, const Declared& declared = {});
// The judge's verdict of the same.
oracle::Verdict judge(std::string_view program, std::string_view trace, const Declared& declared);

}  // namespace gonogo::relation
