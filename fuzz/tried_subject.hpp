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

// A built-in expander, or somebody's subject in its place, which gets what it declares alone.
// Nothing is learned from its answers: a program is the same whatever ran before.
class TriedSubject {
 public:
  // "NAME", "NAME+FAULT" or as on the command line: builtin:, lib:, pipe: and oneshot:. A library
  // is loaded into this process, where its branches and crashes are the engine's to see. `dialect`:
  // empty for the first of a built-in expander, and for the only one that the subject names. Throws
  // oracle::SubjectUnusable with what to do.
  TriedSubject(const std::string& spec, const std::string& dialect);

  oracle::Subject& subject() const { return *subject_; }
  const generate::Generator& generator() const { return *generator_; }
  // What of the program the subject declares; nothing where too little of it is left.
  std::optional<generate::GeneratedProgram> within_declared(
      const generate::GeneratedProgram& program) const;

 private:
  std::unique_ptr<oracle::Subject> subject_;
  const generate::Generator* generator_ = nullptr;
  std::optional<hunt::Repertoire> declared_;  // nothing: everything
};

}  // namespace gonogo::fuzz
