// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a subject says of itself, and how a run of it ended.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "reference/outcome.hpp"
#include "reference/profile.hpp"

namespace gonogo::oracle {

using reference::Number;

// What a subject says of itself in the reply to `start`.
struct SubjectInfo {
  std::string name;
  std::string version;
  // Dialect -> features declared in it; an empty set declares everything in it. When nothing was
  // said of dialects at all, `everything` is set.
  std::map<std::string, std::set<std::string>> dialects;
  bool everything = false;
  bool recorded = false;  // captured output: what is not there was not asked of the machine
  std::set<std::string> features;         // "blocks", "m", "bytes"
  std::string numeric_kind = "exact";     // fixed, binary64, exact
  bool says_numeric = false;              // whether it said so itself
  std::optional<Number> resolution;       // mm
  std::optional<Number> feed_resolution;  // mm/min or mm/rev
  std::optional<Number> chord;            // mm
  std::set<std::string> readings;         // those that it takes by name; "*": all of them
  int max_in_flight = 1;
  bool greeted = true;  // it has said who it is; a command for one program need not

  bool declares(std::string_view dialect, std::string_view feature) const;
  bool knows(const reference::Reading& reading) const;
};

// The alarm as the subject reported it.
struct SubjectAlarm {
  std::string native;
  // Empty when only native was given; up to three between blanks, where its text stands for
  // several.
  std::string alarm_class;
  std::uint64_t block = 0;  // 0: not given
  reference::WordName word;
  bool before_program = false;  // of captured output: in a line of its header
};

class SampledOutcome;

// How a run of one program ended, apart from the records.
struct RunEnd {
  enum class Kind {
    ok,       // expanded
    alarm,    // `alarm` says which
    skip,     // a feature that the subject does not have
    refused,  // configure: ok false
    error,    // the subject said that it failed
    stopped,  // the sink asked for it
    crash,    // a signal, an unexpected exit, a closed pipe
    timeout,
    out_of_memory,
    protocol,  // not the protocol: bad JSON, wrong seq, unknown record, bare number, ...
  };
  Kind kind = Kind::ok;
  SubjectAlarm alarm;
  std::string feature;  // skip
  std::string message;  // what happened, a sentence
  // What the subject noted of the run, and wrote to stderr meanwhile (cut, U+FFFD for bad bytes).
  std::string notes;
  std::int64_t microseconds = 0;
  bool given_up = false;  // nothing was run: the subject had failed too often in a row
  // Positions sampled from a machine in place of records, which have a judge of their own.
  std::shared_ptr<const SampledOutcome> sampled = nullptr;

  static RunEnd of(Kind kind, std::string message) {
    RunEnd end;
    end.kind = kind;
    end.message = std::move(message);
    return end;
  }
};

// Takes the records of a run as they come. Returning false stops the run.
using RecordSink = std::function<bool(const reference::Record&)>;

}  // namespace gonogo::oracle
