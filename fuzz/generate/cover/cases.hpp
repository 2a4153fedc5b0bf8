// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vectors from models: the rows of a covering array as cases with what the reference says of them,
// held against what the model says.
#pragma once

#include <optional>
#include <set>

#include "fuzz/generate/cover/model.hpp"
#include "fuzz/generate/cover/tuple_count.hpp"
#include "corpus/io/corpus.hpp"

namespace gonogo::cover {

// For the corpora that the models give as they are now.
inline constexpr const char* kModelsVersion = "2026.1.0";

// What determines the cases of a model, and stands in their ids.
struct Making {
  const Model* model = nullptr;
  Strength strength;
  std::uint64_t seed = 1;
  std::size_t signs = 0;           // triples at the reference's predicates, at most (boundary.hpp)
  std::set<std::string> left_out;  // ids of cases that are not to be made

  // "gsk.g94.v1-t3f2-s1", what its ids begin with.
  std::string stem() const;
  std::string provenance() const;
};

struct CoverCases {
  std::vector<oracle::Case> cases;
  TupleCount count;       // of the classes that the tags of the cases name
  std::size_t signs = 0;  // how many of the cases stand at a predicate; they come last
  // Cases left out, where model and reference disagree: an id, a sentence, and the program.
  std::vector<std::string> disagreements;
};

// Ids count the rows of the whole array. A row that the others make superfluous is left out
// (minimise.hpp).
CoverCases cover_cases(const Making& making);

// A case, and what of its program may be varied.
struct DrawnCase {
  oracle::Case test;
  std::size_t test_line = 0;
  int decimals = 3;
};

// The case of one row, without its id; nothing, and a sentence in `why`, where the reference does
// not say what the model says: no alarm of a valid row, and of one with a fault those alarms in the
// block under test.
std::optional<DrawnCase> case_of(const Making& making, const Parameters& parameters, const Row& row,
                                 std::string& why);

// "STEM.0123abcd": a group for each profile and list of features, which alone its name depends on.
std::string group_name(const std::string& stem, const oracle::Case& test);

// The profile's expectation, or that of each choice of the readings that it leaves open and that
// change what comes of the program.
std::vector<oracle::Expectation> expectations_of(const reference::Profile& profile,
                                                 std::string_view program);

// "GSK-G94-01..03 GSK-COM-01" -> each of them.
std::vector<std::string> clause_list(std::string_view text);
// What the id of a case says of its making; nothing where it is not of a covering array, or of
// another version of its model.
std::optional<Making> making_of(const oracle::Case& test);
// The row that the tags of a case name.
Row row_of(const Parameters& parameters, const oracle::Case& test);
// Rows counted from the tags of cases; those that are not of covering arrays are omitted.
TupleCount count_cases(const Parameters& parameters, Strength strength,
                       const std::vector<oracle::Case>& cases);

}  // namespace gonogo::cover
