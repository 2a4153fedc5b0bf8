// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/dialect.hpp"

#include <algorithm>
#include <array>

#include "reference/clause_literal.hpp"
#include "reference/gsk988ta/descriptor.hpp"
#include "reference/gsk988ta/interpreter.hpp"
#include "reference/hnc21t/descriptor.hpp"
#include "reference/hnc21t/interpreter.hpp"
#include "reference/rs274/descriptor.hpp"
#include "reference/rs274/interpreter.hpp"
#include "reference/sinumerik/descriptor.hpp"
#include "reference/sinumerik/interpreter.hpp"

namespace gonogo::reference {

namespace {

constexpr auto kOffsets =
    std::to_array<std::string_view>({"G54", "G55", "G56", "G57", "G58", "G59"});
constexpr auto kNgcOffsets = std::to_array<std::string_view>(
    {"G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"});
constexpr auto kNgcParameters =
    std::to_array<std::string_view>({"5181", "5182", "5183", "5184", "5186"});
constexpr auto kGskParameters = std::to_array<std::string_view>(
    {"3403.4", "3403.5", "3403.6", "3404.6", "3404.7", "3410", "5130", "5920", "5921"});
constexpr auto kSinumerikParameters =
    std::to_array<std::string_view>({"CIRCLE_ERROR_CONST", "CIRCLE_ERROR_FACTOR"});
constexpr auto kHncParameters = std::to_array<std::string_view>({"3410"});

// The clauses of the catalog from one to another; the 802S has the path commands of the 840D, and
// more.
consteval std::span<const Clause> clauses_from(ClauseId first, ClauseId last) {
  return std::span(catalog::kAll).subspan(first, last - first + 1U);
}
consteval std::span<const Clause> clauses_of(std::string_view maker) {
  std::size_t first = catalog::kAll.size();
  std::size_t last = 0;
  for (std::size_t i = 0; i < catalog::kAll.size(); ++i) {
    if (!catalog::kAll[i].id.starts_with(maker)) continue;
    first = std::min(first, i);
    last = i;
  }
  return clauses_from(static_cast<ClauseId>(first), static_cast<ClauseId>(last));
}
constexpr std::span<const Clause> kClauses802s = clauses_of("SIE-");
constexpr std::span<const Clause> kClauses840d = kClauses802s.first(
    catalog::sinumerik::kPathClauses.size() + catalog::silent::kSinumerikPath.size());

void keeps_defaults(Profile&) {}

void mills(Profile& profile) {
  profile.x_diameter = false;
  profile.initial.plane = Plane::g17;
  profile.initial.motion = kNoMotion;
}

void mills_finely(Profile& profile) {
  mills(profile);
  profile.dialect_resolution = Number::millionths(100);
}

}  // namespace

// NOLINTNEXTLINE(readability-function-size): a table.
std::span<const Dialect> dialects() {
  static const auto kDialects = std::to_array<Dialect>({
      {"gsk988ta", grammar::Dialect::gsk988ta, clauses_of("GSK-"), "GSK-COM-02"_clause,
       "GSK-COM-02"_clause, true, gsk988ta::make_interpreter, &gsk988ta::kDescriptor, kOffsets,
       kGskParameters, keeps_defaults,
       "M98, M99 (subprograms), M functions above 9999, a second program in the file, variables "
       "(#), expressions ([ ]), words behind a comma and control statements",
       "GSK-COM-14"_clause},
      {"hnc21t", grammar::Dialect::hnc21t, clauses_of("HNC-"), "HNC-COM-01"_clause,
       "HNC-COM-01"_clause, true, hnc21t::make_interpreter, &hnc21t::kDescriptor, kOffsets,
       kHncParameters, keeps_defaults,
       "M98, M99 (subprograms), M functions above 9999, a second program in the file, Y and V "
       "outside the cycles (programs "
       "for mills), RL= and RC=, variables (#), expressions ([ ]) and control statements",
       "HNC-COM-08"_clause},
      {"rs274", grammar::Dialect::rs274, clauses_of("NGC-"), "NGC-COM-01"_clause,
       "NGC-COM-01"_clause, false, rs274::make_interpreter, &rs274::kDescriptor, kNgcOffsets,
       kNgcParameters, mills_finely,
       "M100 to M199 (programs of the user), the axes B U V W, other spindles ($), other O words, "
       "most parameters of the machine"},
      {"sinumerik840d",
       grammar::Dialect::sinumerik,
       kClauses840d,
       "SIE-LEX-01"_clause,
       "SIE-LEX-02"_clause,
       false,
       sinumerik::make_interpreter_840d,
       &sinumerik::kDescriptor840d,
       {},
       kSinumerikParameters,
       mills,
       "subprograms (L, P, calls), the axes B E Q U V W, addresses with a number, names of own "
       "subprograms and variables, R[ ] and $ variables, "
       "exponents (EX), strings as values and control words (IF, GOTO, DEF, ...)"},
      {"sinumerik802s",
       grammar::Dialect::sinumerik,
       kClauses802s,
       "SIE-LEX-01"_clause,
       "SIE-LEX-02"_clause,
       false,
       sinumerik::make_interpreter_802s,
       &sinumerik::kDescriptor802s,
       {},
       kSinumerikParameters,
       mills,
       "subprograms (L, P, calls), M functions above 99, LCYC75 with an edge above D1 or behind a "
       "T that no M6 has followed though one has before, the axes B E Q U V W, addresses with a "
       "number, names of own subprograms and variables, "
       "R[ ] and $ variables, "
       "exponents (EX), strings as values and control words (IF, GOTO, DEF, ...)"},
  });
  return kDialects;
}

const Dialect* find_dialect(std::string_view name) {
  const auto all = dialects();
  const auto found = std::ranges::find(all, name, &Dialect::name);
  return found == all.end() ? nullptr : &*found;
}

std::string dialect_names() {
  std::string names;
  for (const Dialect& dialect : dialects()) {
    if (!names.empty()) names += ", ";
    names += dialect.name;
  }
  return names;
}

}  // namespace gonogo::reference
