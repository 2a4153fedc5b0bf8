// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a subject runs and what it skips, learned from its own answers: real ones do a part of a
// dialect, and few say which. A hunt that knows it stays inside it.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "generate/generator.hpp"
#include "hunt/block_parts.hpp"
#include "oracle/subject.hpp"
#include "program/modes.hpp"

namespace gonogo::hunt {

// A program is made of parts: those of its blocks (hunt/block_parts.hpp) and settings of its
// machine that are not the default ("setting 3", hunt/profile_parts.hpp).
//
// (1) As long as the subject skips fewer than one program in twenty, programs stay as they are, but
//     for what is not declared.
// (2) A part goes out by a program that was skipped and had no other that was not known to run, or
//     where programs of known parts with it are skipped again and again.
// (3) What comes with other parts (rank_of_part) may stand until it was all that was not known to
//     run in a program that was skipped; what stands together in a block, until it was twice.
// (4) What is out is tried again now and then, and comes back where it runs. Where no word runs at
//     all it is begun anew.
class Repertoire {
 public:
  Repertoire(const oracle::SubjectInfo& info, std::string dialect);

  // The program without the parts that are out or not declared, and, once much was skipped, with
  // few that are untried. Blocks or words that have others are left out. Nothing: not enough is
  // left to be worth a run, or it still needs what is not declared.
  std::optional<generate::GeneratedProgram> fitted(const generate::GeneratedProgram& program) const;

  void ran(const generate::GeneratedProgram& program);
  void skipped(const generate::GeneratedProgram& program);
  // From now on nothing is tried: a program has what is known to run, and no more.
  void settle() { is_settled_ = true; }

  // What is out, for people: "codes G2 G3; words A B".
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
  void fit_settings(reference::Profile& profile, Trying& trying) const;
  // The text with the blocks and words left out that may not stand there.
  std::string fitted_text(const program::ProgramText& text, Trying& trying) const;
  std::string fitted_block(const program::TextBlock& block, const reference::Descriptor& table,
                           Trying& trying) const;

  oracle::SubjectInfo info_;
  std::string dialect_;
  std::map<std::string, Runs> in_;
  std::map<std::string, std::size_t> out_;  // how often each was the only one to blame
  // Codes and words of a block: how often it was skipped by itself.
  std::map<Parts, std::size_t> together_;
  bool skips_ = false;
  bool is_settled_ = false;
  std::size_t runs_ = 0;
  // Before much was skipped: the last programs, and whether each ran. What they are made of is
  // asked for only then.
  struct Tried {
    generate::GeneratedProgram program;
    bool ran;
  };
  std::deque<Tried> before_;
  std::size_t tried_ = 0;
  std::size_t skipped_before_ = 0;
};

}  // namespace gonogo::hunt
