// SPDX-License-Identifier: GPL-3.0-or-later
//
// A subject: the implementation under the gauge, whichever way it is connected.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/subjects/sandbox.hpp"
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
  std::set<std::string> readings;         // those that it may be told by name; "*": all of them
  int max_in_flight = 1;
  bool greeted = true;  // it has said who it is; a command for one program need not

  bool declares(std::string_view dialect, std::string_view feature) const;
  bool knows(const reference::Reading& reading) const;
};

// What the certifier says of the machine under the gauge. It holds whether the subject is told or
// not.
struct StatedMachine {
  std::optional<reference::Profile> profile;
  std::vector<std::string> readings;  // "k=v"
  reference::Profile of(const std::string& dialect) const;
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

// What a certifier says of output that was captured on a machine.
struct CaptureOptions {
  std::string manifest;                  // of the export; empty: the one beside the files, if any
  std::optional<Number> feed_tolerance;  // part of the feed, for feeds from samples; 0.05
  std::optional<Number> fastest;         // mm/min: the most of traverses and threads; 60,000
  std::optional<Number> blend;           // mm: by how much corners may be cut; 0
  std::string columns;                   // which column of samples is what (sample_columns.hpp)
};

// Limits of a subject (docs/protocol.md).
struct Limits {
  std::chrono::milliseconds start{10'000};
  std::chrono::milliseconds run{2'000};
  std::size_t line_bytes = std::size_t{64} << 20;
  std::size_t memory_bytes = std::size_t{2} << 30;
  int restarts = 10;  // in a row
  // Names of variables that the subject is given besides those that every one is.
  std::vector<std::string> environment;
  Sandbox sandbox;
  bool show_ids = false;  // a subject behind a pipe is told the names of the cases
  CaptureOptions capture;
  StatedMachine stated;
};

// Thrown when a subject cannot be used at all: wrong use (exit 2), with what to do instead.
class SubjectUnusable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Subject {
 public:
  virtual ~Subject() = default;
  virtual const SubjectInfo& info() const = 0;
  // Before the first run, and whenever the profile changes. A refusal is told by the runs.
  virtual void configure(const reference::Profile& profile) = 0;
  // What will be run next under this configuration, in order: the next run first. A hint for a
  // subject that takes programs ahead; `id` and `program` are copied.
  virtual void announce(std::string_view id, std::string_view program) {
    static_cast<void>(id);
    static_cast<void>(program);
  }
  // Runs one program. Never throws for what the subject does.
  virtual RunEnd run(std::string_view id, std::string_view program, const RecordSink& sink) = 0;
  // Makes the next run start in a fresh process (or handle).
  virtual void renew() = 0;
  // Behind the last run: ends what stands behind the subject. How it broke down in that; nothing:
  // it did not, or nothing stands there.
  virtual std::optional<RunEnd> finish() { return std::nullopt; }
  // Another time limit for the next runs.
  virtual void set_run_limit(std::chrono::milliseconds limit) { static_cast<void>(limit); }
  // Whether a run in a fresh process can differ from one in a used one.
  virtual bool keeps_state() const { return true; }
};

// How a subject is named on the command line: "<kind>:<rest>".
struct SubjectSpec {
  std::string kind;  // builtin, oneshot, pipe
  std::string rest;
};
std::optional<SubjectSpec> parse_subject_spec(std::string_view text);

// Makes subjects of one kind; the program registers those that it links.
using SubjectFactory =
    std::function<std::unique_ptr<Subject>(const std::string& rest, const Limits& limits)>;

std::unique_ptr<Subject> make_oneshot_subject(const std::string& command, const Limits& limits);
std::unique_ptr<Subject> make_pipe_subject(const std::string& command, const Limits& limits);

}  // namespace gonogo::oracle

struct gonogo_subject_v1;
namespace gonogo::oracle {
// A subject behind the C interface, in this process.
std::unique_ptr<Subject> make_interface_subject(const gonogo_subject_v1& subject,
                                                const StatedMachine& stated = {});
}  // namespace gonogo::oracle
