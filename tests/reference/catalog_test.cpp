// SPDX-License-Identifier: GPL-3.0-or-later
//
// The clause catalog against the source: each clause is carried, and no other is spoken of.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "reference/clause_literal.hpp"
#include "reference/dialect.hpp"

namespace gonogo::reference {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = GONOGO_SOURCE_DIR;

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// All ids of the form GSK-G94-02 that a file speaks of, in code or comments.
std::set<std::string> ids_in(const std::string& text) {
  static const std::regex kId(R"(\b[A-Z]{3}-[A-Z]+[0-9]*-[0-9]{2}\b)");
  std::set<std::string> ids;
  for (std::sregex_iterator it(text.begin(), text.end(), kId), end; it != end; ++it) {
    ids.insert(it->str());
  }
  return ids;
}

std::set<std::string> catalog_ids() {
  std::set<std::string> ids;
  for (const Clause& clause : clauses()) ids.emplace(clause.id);
  return ids;
}

TEST(Catalog, EveryClauseStandsInTheFileThatItNames) {
  for (const Clause& clause : clauses()) {
    ASSERT_TRUE(fs::is_regular_file(kRoot / clause.carrier)) << clause.id << " " << clause.carrier;
    EXPECT_TRUE(ids_in(read(kRoot / clause.carrier)).contains(std::string(clause.id)))
        << clause.id << " in " << clause.carrier;
  }
}

TEST(Catalog, EveryClauseThatTheReferenceNamesStandsInIt) {
  const std::set<std::string> known = catalog_ids();
  std::size_t named = 0;
  for (const auto& entry : fs::recursive_directory_iterator(kRoot / "reference")) {
    const fs::path& path = entry.path();
    if (path.extension() != ".cpp" && path.extension() != ".hpp") continue;
    for (const std::string& id : ids_in(read(path))) {
      ++named;
      EXPECT_TRUE(known.contains(id)) << id << " in " << fs::relative(path, kRoot);
    }
  }
  EXPECT_GE(named, known.size());
}

TEST(Catalog, NoIdStandsTwice) {
  EXPECT_EQ(catalog_ids().size(), clauses().size());
}

TEST(Catalog, EveryIdHasTheFormOfOne) {
  for (const Clause& clause : clauses()) {
    const std::set<std::string> only = {std::string(clause.id)};
    EXPECT_EQ(ids_in(std::string(clause.id)), only);
  }
}

TEST(Catalog, EveryClauseSaysSomethingAndWhereItStands) {
  for (const Clause& clause : clauses()) {
    EXPECT_FALSE(clause.source.empty()) << clause.id;
    EXPECT_FALSE(clause.text.empty()) << clause.id;
    EXPECT_TRUE(clause.text.ends_with('.')) << clause.id;
  }
}

// J-ALM-01.
TEST(Catalog, EveryDerivedClauseSaysFromWhat) {
  for (const Clause& clause : clauses()) {
    EXPECT_EQ(clause.basis() == Basis::derived, !clause.derivation.empty()) << clause.id;
    EXPECT_TRUE(clause.derivation.empty() || clause.derivation.ends_with('.')) << clause.id;
  }
}

TEST(Catalog, AClauseThatNoTextStatesSaysSo) {
  std::size_t silent = 0;
  for (const Clause& clause : clauses()) {
    if (clause.basis() != Basis::silent) continue;
    ++silent;
    EXPECT_EQ(clause.level, ClauseLevel::open) << clause.id;
    EXPECT_NE(clause.text.find("No text says"), std::string_view::npos) << clause.id;
    EXPECT_TRUE(clause.text.ends_with("our judgement.") ||
                clause.text.find("our judgement (") != std::string_view::npos)
        << clause.id;
  }
  EXPECT_GE(silent, 30U);
}

// R7: what the other answer to an unstated rule is stands in the catalog, by the names of
// alarms.
TEST(Catalog, OnlyASilentClauseHasAnotherAnswer) {
  for (const Clause& clause : clauses()) {
    for (const std::string_view names : {clause.refusals, clause.other_names}) {
      if (names.empty()) continue;
      EXPECT_EQ(clause.basis(), Basis::silent) << clause.id;
      std::istringstream words{std::string(names)};
      for (std::string word; words >> word;) {
        EXPECT_TRUE(alarm_class(word).has_value()) << clause.id << " " << word;
        EXPECT_TRUE(has_name(names, word)) << clause.id << " " << word;
      }
    }
  }
}

TEST(Catalog, SaysWhatTheOtherAnswerIs) {
  EXPECT_EQ(other_answer(clause("SIE-G1-04"_clause)), "the alarm spindle-stopped.");
  EXPECT_EQ(other_answer(clause("GSK-COM-10"_clause)),
            "the alarm unused-word or conflicting-words.");
  EXPECT_EQ(other_answer(clause("SIE-G1-02"_clause)), "");
  EXPECT_FALSE(has_name("unused-word conflicting-words", "word"));
}

// One note of the manual has one level, wherever it is printed.
TEST(Catalog, OneNoteHasOneLevel) {
  EXPECT_EQ(clause("GSK-G110-04"_clause).level, clause("GSK-G112-10"_clause).level);
  EXPECT_EQ(clause("SIE-G1-02"_clause).level, ClauseLevel::must);
  EXPECT_EQ(clause("GSK-G114-15"_clause).level, ClauseLevel::derived);
}

TEST(Catalog, TheBasesHaveTheirNames) {
  for (const Basis one : {Basis::text, Basis::derived, Basis::silent}) {
    EXPECT_EQ(basis(name(one)), one);
  }
  EXPECT_EQ(basis("must"), std::nullopt);
}

TEST(Catalog, AClauseIsFoundByItsPlace) {
  constexpr ClauseId kId = "GSK-G94-02"_clause;
  EXPECT_EQ(clause(kId).id, "GSK-G94-02");
  EXPECT_EQ(clause_name(kId), "GSK-G94-02");
  EXPECT_EQ(clause_name(kNoClause), "");
}

TEST(Catalog, TheLevelsHaveTheirNames) {
  EXPECT_EQ(name(ClauseLevel::must), "must");
  EXPECT_EQ(name(ClauseLevel::derived), "derived");
  EXPECT_EQ(name(ClauseLevel::open), "open");
}

// A sample of each level, from the text: the cycle's path is said, the one direction of R and depth
// follows from a note, the way home after the last layer is left open.
TEST(Catalog, ALevelSaysHowFirmlyAClauseStands) {
  EXPECT_EQ(clause("GSK-G94-03"_clause).level, ClauseLevel::must);
  EXPECT_EQ(clause("GSK-G110-04"_clause).level, ClauseLevel::derived);
  EXPECT_EQ(clause("GSK-G110-13"_clause).level, ClauseLevel::open);
}

std::set<std::string> codes_beside_the_readable(const Dialect& dialect) {
  std::set<std::string> names;
  for (const OutsideCode& code : outside_codes(*dialect.descriptor)) {
    EXPECT_TRUE(names.insert(code.code).second) << code.code;
    EXPECT_FALSE(code.title.empty()) << code.code;
  }
  for (const std::string& code : codes_without_effect(*dialect.descriptor)) {
    EXPECT_TRUE(names.insert(code).second) << code;
  }
  return names;
}

TEST(Catalog, ACodeIsEitherOutsideOrWithoutEffect) {
  for (const Dialect& dialect : dialects()) codes_beside_the_readable(dialect);
  const auto gsk = codes_beside_the_readable(*find_dialect("gsk988ta"));
  EXPECT_TRUE(gsk.contains("G71") && gsk.contains("G83") && gsk.contains("G40"));
  const auto hnc = codes_beside_the_readable(*find_dialect("hnc21t"));
  EXPECT_TRUE(hnc.contains("G71") && hnc.contains("G76") && hnc.contains("G97"));
}

TEST(Catalog, AnotherDialectIsNotFound) {
  EXPECT_EQ(find_dialect("fanuc"), nullptr);
}

// Two dialects of a maker may share clauses.
TEST(Catalog, TheClausesOfADialectBeginWithOneMaker) {
  std::set<std::string_view> all;
  for (const Dialect& dialect : dialects()) {
    const std::string_view maker = dialect.clauses.front().id.substr(0, 4);
    for (const Clause& clause : dialect.clauses) {
      EXPECT_TRUE(clause.id.starts_with(maker)) << clause.id;
      all.insert(clause.id);
    }
    EXPECT_TRUE(clause_name(dialect.syntax_clause).starts_with(maker));
  }
  EXPECT_EQ(all.size(), clauses().size());
}

}  // namespace
}  // namespace gonogo::reference
