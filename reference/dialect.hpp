// SPDX-License-Identifier: GPL-3.0-or-later
//
// The dialects that the gauge reads: one table, from which everything else looks them up.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "grammar/ast.hpp"
#include "reference/clause.hpp"
#include "reference/descriptor.hpp"
#include "reference/expander.hpp"

namespace gonogo::reference {

struct Dialect {
  std::string_view name;  // "gsk988ta"
  grammar::Dialect grammar;
  std::span<const Clause> clauses;
  ClauseId syntax_clause;           // of a block that cannot be read
  ClauseId disputed_syntax_clause;  // of one that another reader of the text might read
  bool lathe;                       // drawings show X upwards over Z
  // `profile` and `readings` must outlive the interpreter.
  std::unique_ptr<BlockInterpreter> (*make_interpreter)(const Profile& profile,
                                                        const ReadingsInUse& readings,
                                                        OpenPaths open_paths);
  const Descriptor* descriptor;                  // its codes and words
  std::span<const std::string_view> offsets;     // names of work offsets that a profile may give
  std::span<const std::string_view> parameters;  // and of machine parameters
  void (*power_on)(Profile& profile);            // sets what is not Profile's own default
  std::string_view outside_constructs;           // for people: what else is not covered
  // The clause of a block that would be read in capitals; no text asks for that.
  ClauseId lower_case_clause = kNoClause;
};

std::span<const Dialect> dialects();
// Null: there is no such dialect.
const Dialect* find_dialect(std::string_view name);
// "gsk988ta, hnc21t"
std::string dialect_names();

}  // namespace gonogo::reference
