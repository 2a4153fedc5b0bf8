// SPDX-License-Identifier: GPL-3.0-or-later
//
// The invariants of ARCHITECTURE.md, read off the source files.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "reference/clause.hpp"

namespace gonogo {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = GONOGO_SOURCE_DIR;

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// Source without comments and string literals.
std::string code_of(const std::string& text) {
  static const std::regex kNoise(R"(//[^\n]*|/\*[^]*?\*/|"(\\.|[^"\\\n])*")");
  return std::regex_replace(text, kNoise, "");
}

std::size_t for_each_source(const std::string& folder,
                            const std::function<void(const fs::path&, const std::string&)>& visit) {
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
    const std::string ending = entry.path().extension().string();
    if (ending != ".cpp" && ending != ".hpp") continue;
    ++count;
    visit(fs::relative(entry.path(), kRoot), read(entry.path()));
  }
  return count;
}

std::set<std::string> house_folders_included(const std::string& text) {
  static const std::regex kInclude(
      R"re(#include "(grammar|reference|oracle|program|generate|relations|hunt|identify|fuzz|cli|expanders|checker)/)re");
  std::set<std::string> folders;
  for (std::sregex_iterator it(text.begin(), text.end(), kInclude), end; it != end; ++it) {
    folders.insert((*it)[1]);
  }
  return folders;
}

// The rooms in the order of ARCHITECTURE.md.
TEST(House, FoldersIncludeOnlyWhatStandsBeforeThem) {
  const std::vector<std::string> rooms = {"grammar", "reference", "oracle",
                                          "program", "generate",  "relations",
                                          "hunt",    "identify",  "fuzz"};
  std::map<std::string, std::set<std::string>> allowed = {{"expanders", {"expanders"}}};
  std::set<std::string> before;
  for (const std::string& room : rooms) {
    before.insert(room);
    allowed[room] = before;
  }
  // Those that need no other of their kind.
  allowed["identify"].erase("hunt");
  allowed["identify"].erase("relations");
  allowed["program"].erase("oracle");
  allowed["fuzz"].insert("expanders");  // what the soak run and the targets try
  for (const auto& [folder, may] : allowed) {
    const std::size_t files =
        for_each_source(folder, [&](const fs::path& path, const std::string& text) {
          for (const std::string& included : house_folders_included(text)) {
            EXPECT_TRUE(may.contains(included)) << path << " includes " << included;
          }
        });
    EXPECT_GT(files, 0U) << folder;
  }
}

TEST(House, RoomsOfTheOracleIncludeOnlyWhatStandsBeforeThem) {
  static const std::regex kInclude(R"re(#include "oracle/([a-z]+)/)re");
  const std::vector<std::string> rooms = {"region",       "records", "judge",    "subjects",
                                          "differential", "corpus",  "campaign", "capture",
                                          "report",       "manual",  "evidence", "site"};
  std::set<std::string> before;
  for (const std::string& room : rooms) {
    before.insert(room);
    const std::size_t files =
        for_each_source("oracle/" + room, [&](const fs::path& path, const std::string& text) {
          for (std::sregex_iterator it(text.begin(), text.end(), kInclude), end; it != end; ++it) {
            EXPECT_TRUE(before.contains((*it)[1])) << path << " includes " << (*it)[1];
          }
        });
    EXPECT_GT(files, 0U) << room;
  }
}

// docs/relation.md: written apart, else the definition has the holes of the judge.
TEST(House, TheDefinitionAndTheJudgeShareNothing) {
  static const std::regex kInclude(R"re(#include "oracle/([a-z]+)/)re");
  const std::size_t files =
      for_each_source("oracle/relation", [&](const fs::path& path, const std::string& text) {
        for (std::sregex_iterator it(text.begin(), text.end(), kInclude), end; it != end; ++it) {
          EXPECT_TRUE((*it)[1] == "relation" || (*it)[1] == "records")
              << path << " includes " << (*it)[1];
        }
      });
  EXPECT_GT(files, 0U);
}

// No campaign waits for it: only `gonogo judge --by-definition` and tests ask it.
TEST(House, OnlyTheProgramAsksTheDefinition) {
  for (const char* folder :
       {"oracle", "program", "generate", "relations", "hunt", "identify", "fuzz"}) {
    for_each_source(folder, [&](const fs::path& path, const std::string& text) {
      if (path.string().starts_with("oracle/relation/")) return;
      EXPECT_EQ(text.find("#include \"oracle/relation/"), std::string::npos) << path;
    });
  }
}

TEST(House, AFolderIsBuiltOfItsOwnFiles) {
  std::size_t lists = 0;
  for (const char* const folder : {"grammar", "reference", "oracle", "expanders", "program",
                                   "generate", "relations", "hunt", "identify", "fuzz", "cli"}) {
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
      if (entry.path().filename() != "CMakeLists.txt") continue;
      ++lists;
      static const std::regex kElsewhere(R"([\s(](\.\./)+\S+\.cpp)");
      const std::string text = read(entry.path());
      EXPECT_FALSE(std::regex_search(text, kElsewhere)) << entry.path();
    }
  }
  EXPECT_GT(lists, 15U);
}

TEST(House, GrammarAndReferenceHaveNoFloatingPoint) {
  static const std::regex kFloat(R"(\b(double|float)\b(?!\) = delete))");
  for (const char* folder : {"grammar", "reference"}) {
    for_each_source(folder, [&](const fs::path& path, const std::string& text) {
      std::smatch found;
      const std::string code = code_of(text);
      EXPECT_FALSE(std::regex_search(code, found, kFloat)) << path << ": " << found.str();
    });
  }
}

TEST(House, SpiritStaysInItsFolder) {
  for (const char* folder : {"grammar", "reference", "oracle", "expanders", "program", "generate",
                             "relations", "hunt", "identify", "fuzz", "cli"}) {
    for_each_source(folder, [&](const fs::path& path, const std::string& text) {
      if (path.string().starts_with("grammar/x3/")) return;
      EXPECT_EQ(text.find("boost/spirit"), std::string::npos) << path;
      if (path.string().starts_with("grammar/")) return;
      EXPECT_EQ(text.find("#include \"grammar/x3/"), std::string::npos) << path;
    });
  }
}

const std::vector<const char*> kProductFolders = {"grammar",  "reference", "oracle",    "expanders",
                                                  "program",  "generate",  "relations", "hunt",
                                                  "identify", "fuzz",      "cli"};

// The kernel over the exact number, the sets that clear a pocket, and the intervals before them.
TEST(House, CgalStandsInTheGeometryOfTheReferenceAndInTheRegionJudge) {
  std::size_t users = 0;
  for (const char* folder : kProductFolders) {
    for_each_source(folder, [&](const fs::path& path, const std::string& text) {
      if (text.find("#include <CGAL/") == std::string::npos) return;
      ++users;
      EXPECT_TRUE(path.parent_path() == "reference/geometry" ||
                  path == "oracle/region/circle_sets.cpp" || path == "oracle/region/interval.hpp")
          << path;
    });
  }
  EXPECT_GE(users, 3U);
}

// The kernel costs seconds a file: a header that brings it along is included in its own folder
// alone.
TEST(House, NoHeaderBringsTheKernelIntoAnotherRoom) {
  static const std::regex kInclude(R"re(#include "([^"]+\.hpp)")re");
  std::map<std::string, std::set<std::string>> includes;
  for (const char* folder : kProductFolders) {
    for_each_source(folder, [&](const fs::path& path, const std::string& text) {
      for (std::sregex_iterator it(text.begin(), text.end(), kInclude), end; it != end; ++it) {
        includes[path.string()].insert((*it)[1]);
      }
    });
  }
  std::vector<std::string> bringing = {"reference/geometry/kernel.hpp"};
  for (std::size_t i = 0; i < bringing.size(); ++i) {
    const std::string header = bringing[i];
    const fs::path room = fs::path(header).parent_path();
    for (const auto& [file, included] : includes) {
      if (!included.contains(header)) continue;
      EXPECT_TRUE(room == "reference/geometry" || fs::path(file).parent_path() == room)
          << file << " includes " << header;
      const bool known = std::find(bringing.begin(), bringing.end(), file) != bringing.end();
      if (file.ends_with(".hpp") && !known) bringing.push_back(file);
    }
  }
  EXPECT_GT(bringing.size(), 1U);
}

TEST(House, EveryClauseStandsInTheFileThatCarriesIt) {
  for (const reference::Clause& clause : reference::clauses()) {
    const std::string text = read(kRoot / clause.carrier);
    EXPECT_NE(text.find(clause.id), std::string::npos) << clause.id << " in " << clause.carrier;
  }
}

TEST(House, ClauseIdsAreUnique) {
  std::set<std::string_view> ids;
  for (const reference::Clause& clause : reference::clauses()) {
    EXPECT_TRUE(ids.insert(clause.id).second) << clause.id;
  }
}

// CONTRIBUTING.md: the files that G89 of rs274 is made of.
TEST(House, ACycleIsMadeOfTheFilesThatContributingNames) {
  static const std::regex kRow(R"(\n\| `([^`]+)` \|)");
  const std::string text = read(kRoot / "CONTRIBUTING.md");
  std::size_t files = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), kRow), end; it != end; ++it) {
    const std::string file = (*it)[1];
    ++files;
    ASSERT_TRUE(fs::is_regular_file(kRoot / file)) << file;
    const std::string content = read(kRoot / file);
    EXPECT_TRUE(content.find("G89") != std::string::npos ||
                content.find("g89") != std::string::npos)
        << file;
  }
  EXPECT_GT(files, 0U);
  EXPECT_LE(files, 15U);
}

// What tools know of codes is in the tables of the dialects (reference/*/descriptor.hpp).
TEST(House, ToolsHaveNoCodesOfTheirOwn) {
  static const std::regex kCode(
      R"re("(G\d+(\.\d)?|M\d+|L?CYC(LE)?\d+|CIP|CT|TURN|RPL|CR|AR|AP|RP|R1\d\d)")re");
  static const std::regex kComment(R"(//[^\n]*)");
  // The names of planes in records, and what `expand --format ngc` writes; programs that are
  // written to ask every dialect for the same, of which the reference's tables must know nothing.
  const std::set<std::string> formats = {
      "oracle/records/plain_record.cpp", "oracle/records/record_json.cpp",
      "oracle/judge/plain_line.cpp", "cli/formats.cpp", "relations/operation_text.cpp"};
  std::size_t files = 0;
  for (const char* folder : {"program", "oracle", "hunt", "identify", "relations", "cli"}) {
    files += for_each_source(folder, [&](const fs::path& path, const std::string& text) {
      if (formats.contains(path.string())) return;
      const std::string code =
          std::regex_replace(std::regex_replace(text, kComment, ""), std::regex("\"_clause"), "");
      std::smatch found;
      EXPECT_FALSE(std::regex_search(code, found, kCode)) << path << ": " << found.str();
    });
  }
  EXPECT_GT(files, 300U);
}

// Sentences are for people. What can be seen of it in the text: no search in a thing that is called
// a message, a reason or a sentence, nor its comparison with anything; no search for two words with
// a blank between them, whatever they are looked for in; and a gap is made where its reason has to
// be given. What splits the sentences of results of format 1 decides nothing.
TEST(House, NoDecisionHangsOnTheWordingOfAMessage) {
  static const std::regex kSearch(
      R"re(\b(message|reason|sentence|why)\w*(\(\))?(\.|->)(r?find\w*|contains|starts_with|ends_with|compare)\()re"
      R"re(|\b(message|sentence)(\(\))?\s*[!=]=\s*)re");
  static const std::regex kSentence(
      R"re(\b(r?find|contains|starts_with|ends_with)\(\s*"[^"\\]*[A-Za-z]+ [a-z]{2})re");
  static const std::regex kComment(R"(//[^\n]*)");
  for (const char* folder : {"oracle", "program", "generate", "relations", "hunt", "identify",
                             "fuzz", "cli", "tests/oracle/mutations"}) {
    for_each_source(folder, [&](const fs::path& path, const std::string& text) {
      std::smatch found;
      const std::string code = code_of(text);
      EXPECT_FALSE(std::regex_search(code, found, kSearch)) << path << ": " << found.str();
      const std::string with_texts = std::regex_replace(text, kComment, "");
      EXPECT_FALSE(std::regex_search(with_texts, found, kSentence)) << path << ": " << found.str();
      // The definition has an answer of its own, which names its reason beside it.
      const bool is_definition = path.string().starts_with("oracle/relation/");
      if (path == "oracle/records/verdict.cpp" || is_definition) return;
      EXPECT_EQ(code.find("kind = VerdictKind::oracle_gap"), std::string::npos) << path;
      EXPECT_EQ(code.find("kind = oracle::VerdictKind::oracle_gap"), std::string::npos) << path;
    });
  }
}

// `./gonogo` builds again when a source is newer: of every folder that the program is linked from.
TEST(House, TheDoorLooksAtEveryFolderOfTheProgram) {
  const std::string door = read(kRoot / "gonogo");
  const std::size_t begin = door.find("sources=(");
  ASSERT_NE(begin, std::string::npos);
  const std::string sources = door.substr(begin, door.find(')', begin) - begin);
  for (const char* folder : {"grammar", "reference", "oracle", "expanders", "program", "generate",
                             "relations", "hunt", "identify", "cli"}) {
    EXPECT_TRUE(fs::is_directory(kRoot / folder)) << folder;
    EXPECT_TRUE(std::regex_search(sources, std::regex("[( ]" + std::string(folder) + "\\s")))
        << folder;
  }
}

// fuzz/seed-programs names programs by their content; other inputs so named are an engine's, put
// here by accident.
TEST(House, SeedsThatAreNoProgramsHaveNames) {
  static const std::regex kContentName("[0-9a-f]{40}");
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(kRoot / "fuzz" / "seeds")) {
    if (!entry.is_regular_file()) continue;
    ++count;
    const std::string target = entry.path().parent_path().filename().string();
    if (target.starts_with("fuzz_text_")) continue;
    EXPECT_FALSE(std::regex_match(entry.path().filename().string(), kContentName))
        << entry.path() << " was written by an engine";
  }
  EXPECT_GT(count, 100U);
}

}  // namespace
}  // namespace gonogo
