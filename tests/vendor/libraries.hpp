// SPDX-License-Identifier: GPL-3.0-or-later
//
// The libraries that the tests load, and their subjects.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "subjects/library_subject.hpp"

namespace gonogo::oracle {

using Kind = RunEnd::Kind;

inline std::string library(const std::string& variant) {
  return GONOGO_LIBRARIES + variant + ".so";
}

inline reference::Profile profile_of(const std::string& dialect) {
  return std::get<reference::Profile>(reference::default_profile(dialect));
}

// Limits that a busy machine does not reach.
inline Limits patient_limits() {
  Limits limits;
  limits.start = std::chrono::seconds(30);
  limits.run = std::chrono::seconds(30);
  return limits;
}

inline std::unique_ptr<Subject> subject_of(const std::string& variant,
                                           const Limits& limits = patient_limits(),
                                           const std::string& dialect = "gsk988ta") {
  auto subject = make_library_subject(library(variant), limits, GONOGO_PROGRAM);
  subject->configure(profile_of(dialect));
  return subject;
}

struct Ran {
  RunEnd end;
  std::vector<reference::Record> records;
};

inline Ran run(Subject& subject, std::string_view program, std::size_t most = 1'000'000) {
  Ran ran;
  ran.end = subject.run("case.1", program, [&](const reference::Record& record) {
    ran.records.push_back(record);
    return ran.records.size() < most;
  });
  return ran;
}

}  // namespace gonogo::oracle
