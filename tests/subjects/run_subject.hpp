// SPDX-License-Identifier: GPL-3.0-or-later
//
// What every test of a subject needs.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "subjects/make_subject.hpp"

namespace gonogo::oracle {

using Kind = RunEnd::Kind;

inline reference::Profile gsk_profile() {
  return std::get<reference::Profile>(reference::default_profile("gsk988ta"));
}

struct Ran {
  RunEnd end;
  std::vector<reference::Record> records;
};

// Runs `program`; stops after `most` records.
inline Ran run(Subject& subject, std::string_view program = "G0 X1\n", std::size_t most = 1000) {
  Ran ran;
  ran.end = subject.run("case.1", program, [&](const reference::Record& record) {
    ran.records.push_back(record);
    return ran.records.size() < most;
  });
  return ran;
}

// Limits that a busy machine does not reach.
inline Limits patient_limits() {
  Limits limits;
  limits.start = std::chrono::seconds(20);
  limits.run = std::chrono::seconds(20);
  return limits;
}

// For tests that wait for the limit of a run.
inline Limits run_limits(int milliseconds) {
  Limits limits = patient_limits();
  limits.run = std::chrono::milliseconds(milliseconds);
  return limits;
}

// The program fake_pipe as a subject that misbehaves in this way, and the end of its first run.
std::unique_ptr<Subject> fake_pipe(const std::string& mode,
                                   const Limits& limits = patient_limits());
RunEnd pipe_end(const std::string& mode);

std::size_t open_descriptors();
// Whether this process has children beside the keeper, running or not yet waited for.
bool has_children();
bool is_alive(int pid);

}  // namespace gonogo::oracle
