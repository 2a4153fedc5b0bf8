// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/identify/variant.hpp"

#include <fmt/format.h>

namespace gonogo::identify {

std::vector<Motions> motions_concerned(const Observation& departure) {
  const ProgramText program(departure.profile, departure.program);
  const std::size_t line = departure.verdict.block;
  if (line == 0 || line > program.blocks.size()) return {};
  const std::string& motion = program.blocks[line - 1].motion;
  if (motion.empty()) return {};
  static const std::vector<Motions> kKin = {
      {"G2", "G3"},
      {"G110", "G111"},
      {"G112", "G113"},
      {"G114", "G115", "G116", "G117"},
      {"G110", "G111", "G112", "G113", "G114", "G115", "G116", "G117"}};
  std::vector<Motions> concerned = {{motion}};
  for (const Motions& kin : kKin) {
    const bool of_gsk = kin.contains("G2") || departure.profile.dialect == "gsk988ta";
    if (of_gsk && kin.contains(motion)) concerned.push_back(kin);
  }
  return concerned;
}

std::string names_of(const Motions& motions) {
  return fmt::format("{}", fmt::join(motions, " "));
}

bool is_of(const ProgramText& program, std::uint64_t line, const Motions& motions) {
  return line > 0 && line <= program.blocks.size() &&
         motions.contains(program.blocks[line - 1].motion);
}

}  // namespace gonogo::identify
