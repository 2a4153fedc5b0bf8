// SPDX-License-Identifier: GPL-3.0-or-later
//
// libFuzzer on a subject, in a process of its own that holds engine, subject and judge. It ends
// with the first program that is a finding; the process may die of it, and the caller still learns
// which program it was.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "fuzz/hunt/hunt.hpp"
#include "subjects/make_subject.hpp"

namespace gonogo::fuzz {

struct FuzzOptions {
  std::string subject;         // as of make_subject_here()
  hunt::HuntOptions programs;  // their dialect, machine and settings, the seed, what is known
  hunt::TrialOptions trial;
  oracle::StatedMachine stated;
  std::uint64_t most_programs = 0;  // 0: no limit
  std::uint64_t most_seconds = 0;   // 0: no limit
  std::string inputs;               // folder of what showed something; it is read and added to
  std::string last_input;           // file for the engine's own form of what was found
  std::string log;                  // file for what engine and subject say
};

struct FuzzCount {
  std::uint64_t programs = 0;  // that the engine made
  std::uint64_t judged = 0;    // GO or NO-GO
  std::uint64_t moved = 0;     // of those judged, with a motion of the subject's
  std::uint64_t skipped = 0;   // by the subject, or for what it does not declare
  double first_after = 0;      // seconds to the first of them
  double seconds = 0;          // to the last one
};

struct FuzzEnd {
  enum class Kind : std::uint8_t {
    nothing,     // was found
    departed,    // `program` did
    broke_down,  // the process, in `program` if that is set
    too_much,    // of time or memory, in `program`
  };
  Kind kind = Kind::nothing;
  FuzzCount count;
  std::optional<generate::GeneratedProgram> program;
  std::string how;  // the process ended: a sentence
};

// Whether this program was linked with libFuzzer.
bool has_fuzz_engine();

// REQUIRES: has_fuzz_engine(), and no other thread runs. `progress` is called ten times a second.
// Throws oracle::SubjectUnusable where the subject cannot be loaded into such a process.
FuzzEnd run_fuzz_engine(const FuzzOptions& options,
                        const std::function<void(const FuzzCount&)>& progress);

}  // namespace gonogo::fuzz
