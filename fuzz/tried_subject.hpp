// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the soak run and the differential targets try.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "fuzz/generate/generator.hpp"
#include "fuzz/hunt/supported_features.hpp"
#include "subjects/make_subject.hpp"

namespace gonogo::fuzz {

// "NAME", "NAME+FAULT" or as on the command line: builtin:, lib:, pipe: and oneshot:. A library is
// loaded into this process, where its branches and crashes are the engine's to see. Throws
// oracle::SubjectUnusable with what to do.
std::unique_ptr<oracle::Subject> make_subject_here(const std::string& spec,
                                                   const oracle::StatedMachine& stated = {});

// A built-in expander, or somebody's subject in its place, which gets programs of what it declares
// and runs. What it runs is learned when it is made, from programs of fixed seeds: afterwards a
// program is the same, independent of what was tried before.
class TriedSubject {
 public:
  using BeforeRun = std::function<void(const generate::GeneratedProgram&)>;
  // `spec` as of make_subject_here(). `dialect`: empty for the first of a built-in expander, and
  // for the only one that the subject names. `before_run` gets each program that it learns from.
  TriedSubject(const std::string& spec, const std::string& dialect,
               const BeforeRun& before_run = nullptr);

  oracle::Subject& subject() const { return *subject_; }
  const generate::Generator& generator() const { return *generator_; }
  // What of the program the subject runs; nothing where too little of it is left.
  std::optional<generate::GeneratedProgram> fitted(generate::GeneratedProgram program) const;

 private:
  void learn(const BeforeRun& before_run);

  std::unique_ptr<oracle::Subject> subject_;
  const generate::Generator* generator_ = nullptr;
  std::optional<hunt::SupportedFeatures> supported_;  // nothing: of a built-in expander
};

}  // namespace gonogo::fuzz
