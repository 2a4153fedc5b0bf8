// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs that the reference does not refuse: the generator writes them, a block that a rule
// refuses is left out, and what is left is looked at once more as a whole.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "fuzz/generate/generator.hpp"

namespace gonogo::generate {

struct ValidOptions {
  // For the programs; kinds near_invalid and raw are not asked for.
  GeneratorSettings settings;
  std::optional<reference::Profile> profile;  // the machine of every program; nothing: any
  // Words of `gonogo spec --features`, the only ones that a program may need; empty: all.
  std::set<std::string> features;
};

struct ValidCount {
  std::size_t programs = 0;
  std::size_t blocks = 0;    // that the generator wrote
  std::size_t left_out = 0;  // of them, since a rule refused them or their feature is not declared
  std::size_t thrown_out =
      0;  // programs that were refused all the same, or are left without a block
  // The blocks that a rule refused, by the clause and the class of the alarm.
  std::map<std::string, std::size_t> refused_by;
};

class ValidPrograms {
 public:
  // `generator` must outlive this.
  ValidPrograms(const Generator& generator, ValidOptions options);

  // The program of a seed: under every combination of its open readings the reference expands it to
  // its end. Nothing: it was thrown out. Equal seeds give equal programs.
  std::optional<GeneratedProgram> of_seed(std::uint64_t seed);
  const ValidCount& count() const { return count_; }

 private:
  void leave_out_features(GeneratedProgram& program);
  bool has_features(const GeneratedProgram& program) const;
  bool leave_out_refused(GeneratedProgram& program);

  const Generator& generator_;
  ValidOptions options_;
  ValidCount count_;
};

// Where the reference first refuses the program under any combination of its open readings.
struct Refusal {
  std::uint64_t block = 0;  // 1-based line; 0: of no block, as where something is undecided
  std::string why;          // "GSK-G94-09 value-range"
};
// Nothing: it expands to its end under each of them. Programs of more items than the second number
// are refused, too.
std::optional<Refusal> refusal_of(const GeneratedProgram& program, std::size_t most_items);

}  // namespace gonogo::generate
