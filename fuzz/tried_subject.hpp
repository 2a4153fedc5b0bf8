// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the soak run and the differential targets try.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "generate/generator.hpp"
#include "hunt/repertoire.hpp"
#include "oracle/subject.hpp"

namespace gonogo::fuzz {

// A built-in expander, or somebody's subject in its place, which gets programs of what it declares
// and runs. What it runs is learned when it is made, from programs of fixed seeds: afterwards a
// program is the same whatever was tried before.
class TriedSubject {
 public:
  // "NAME", "NAME+FAULT" or as on the command line: builtin:, lib:, pipe: and oneshot:. A library
  // is loaded into this process, where its branches and crashes are the engine's to see. `dialect`:
  // empty for the first of a built-in expander, and for the only one that the subject names. Throws
  // oracle::SubjectUnusable with what to do.
  TriedSubject(const std::string& spec, const std::string& dialect);

  oracle::Subject& subject() const { return *subject_; }
  const generate::Generator& generator() const { return *generator_; }
  // What of the program the subject runs; nothing where too little of it is left.
  std::optional<generate::GeneratedProgram> fitted(generate::GeneratedProgram program) const;

 private:
  void learn();

  std::unique_ptr<oracle::Subject> subject_;
  const generate::Generator* generator_ = nullptr;
  std::optional<hunt::Repertoire> repertoire_;  // nothing: of a built-in expander
};

}  // namespace gonogo::fuzz
