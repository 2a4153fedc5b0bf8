// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which features a subject supports, learned from its answers: most subjects support a part of a
// dialect, and few declare which. A hunt uses only what the subject supports.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "fuzz/generate/generator.hpp"
#include "fuzz/hunt/block_parts.hpp"
#include "fuzz/program/modes.hpp"
#include "oracle/records/subject_outcome.hpp"

namespace gonogo::hunt {

// A program is made of parts: those of its blocks (fuzz/hunt/block_parts.hpp) and settings of its
// machine that are not the default ("setting 3", fuzz/hunt/profile_parts.hpp).
//
// (1) While the subject skips fewer than one program in twenty, programs stay as they are, without
//     undeclared parts.
// (2) A part is removed when it was the only unknown part of a skipped program, or when programs of
//     otherwise known parts with it are skipped repeatedly.
// (3) A part that comes with others (rank_of_part) is removed only when it was all that was unknown
//     in a skipped program; a combination in a block, when it was so twice.
// (4) Removed parts are tried again now and then, and return where they run. Where no word runs at
//     all, learning starts again.
class SupportedFeatures {
 public:
  SupportedFeatures(const oracle::SubjectInfo& info, std::string dialect);

  // The program without removed or undeclared parts, and, once much was skipped, with few untried
  // ones. Blocks or words with other parts are omitted. Nothing: too little is left for a run, or
  // the program still needs undeclared parts.
  std::optional<generate::GeneratedProgram> fitted(const generate::GeneratedProgram& program) const;

  void ran(const generate::GeneratedProgram& program);
  void skipped(const generate::GeneratedProgram& program);
  // From now on programs have only parts that are known to run.
  void stop_trying() { has_stopped_trying_ = true; }

  // The removed parts as text: "codes G2 G3; words A B".
  std::string left_out() const;

 private:
  // How programs with a part that is known to run went.
  struct Runs {
    std::size_t ran = 0;
    std::size_t skipped = 0;
  };
  // What a program may have that is not known to run.
  struct Trying {
    Parts parts;
    std::size_t more = 0;  // how many others that are untried
  };
  // What the next program is for.
  enum class Turn { what_runs, untried, again, together };
  Turn turn() const;
  Trying next_try(const generate::GeneratedProgram& program) const;
  std::optional<std::string> least_blamed(const generate::GeneratedProgram& program) const;
  std::optional<generate::GeneratedProgram> together(
      const generate::GeneratedProgram& program) const;

  bool is_declared(const generate::GeneratedProgram& program) const;
  void start_again_where_nothing_runs();
  void note(const generate::GeneratedProgram& program, bool ran);
  void learn_ran(const generate::GeneratedProgram& program);
  void learn_skipped(const generate::GeneratedProgram& program);
  // For the first `blocks` blocks and for the machine.
  Parts parts_of(const generate::GeneratedProgram& program, std::size_t blocks) const;
  bool is_undeclared(const std::string& part) const;
  bool is_out(const std::string& part) const;
  bool is_like_what_is_out(const std::string& part) const;
  // Whether the part may stand in the program that is made now; one that is tried is noted in
  // `trying`.
  bool admits(const std::string& part, Trying& trying) const;
  // The block without the words that may not stand there; empty where it may not itself.
  std::string fitted_block(const program::TextBlock& block, const reference::Descriptor& table,
                           Trying& trying) const;

  oracle::SubjectInfo info_;
  std::string dialect_;
  std::map<std::string, Runs> in_;
  std::map<std::string, std::size_t> out_;  // how often each was the only cause
  // Codes and words of a block: how often it was skipped by itself.
  std::map<Parts, std::size_t> together_;
  bool skips_ = false;
  bool has_stopped_trying_ = false;
  std::size_t runs_ = 0;
  // Before much was skipped: the last programs, and whether each ran. Their parts are computed
  // only then.
  struct Tried {
    generate::GeneratedProgram program;
    bool ran;
  };
  std::deque<Tried> before_;
  std::size_t tried_ = 0;
  std::size_t skipped_before_ = 0;
};

}  // namespace gonogo::hunt
