// SPDX-License-Identifier: GPL-3.0-or-later
//
// Subjects as they are connected: what limits them, how they are named, and who makes them.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/differential/subject.hpp"
#include "subjects/sandbox.hpp"

namespace gonogo::oracle {

// What the certifier says of the machine under the gauge. It holds whether the subject knows it or
// not.
struct StatedMachine {
  std::optional<reference::Profile> profile;
  std::vector<std::string> readings;  // "k=v"
  reference::Profile of(const std::string& dialect) const;
};

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
  // Bytes that are read after the sink has stopped: the run may end as a skip (J-RUN-05).
  std::size_t further_bytes = std::size_t{1} << 20;
  std::size_t memory_bytes = std::size_t{2} << 30;
  std::size_t processes = 512;  // at once, of the subject and all that it starts
  int restarts = 10;            // in a row
  // Names of variables that the subject gets besides those that every subject gets.
  std::vector<std::string> environment;
  Sandbox sandbox;
  bool show_ids = false;  // a subject behind a pipe gets the names of the cases
  CaptureOptions capture;
  StatedMachine stated;
};

// Thrown when a subject cannot be used at all: wrong use (exit 2), with what to do instead.
class SubjectUnusable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// How a subject is named on the command line: "<kind>:<rest>".
struct SubjectSpec {
  std::string kind;  // builtin, oneshot, pipe
  std::string rest;
};
std::optional<SubjectSpec> parse_subject_spec(std::string_view text);

std::unique_ptr<Subject> make_oneshot_subject(const std::string& command, const Limits& limits);
std::unique_ptr<Subject> make_pipe_subject(const std::string& command, const Limits& limits);

}  // namespace gonogo::oracle

struct gonogo_subject_v1;
namespace gonogo::oracle {
// A subject behind the C interface, in this process.
std::unique_ptr<Subject> make_interface_subject(const gonogo_subject_v1& subject,
                                                const StatedMachine& stated = {});
}  // namespace gonogo::oracle
