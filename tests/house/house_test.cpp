// SPDX-License-Identifier: GPL-3.0-or-later
//
// The invariants of ARCHITECTURE.md, read off the source files.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "reference/clause.hpp"
#include "reference/clause_literal.hpp"
#include "reference/reading.hpp"

namespace gonogo {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = GONOGO_SOURCE_DIR;

const std::vector<const char*> kProductFolders = {"grammar",   "reference", "oracle",  "subjects",
                                                  "corpus",    "campaign",  "capture", "publish",
                                                  "expanders", "fuzz",      "cli"};

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

// Source without comments; its string literals stay.
std::string without_comments(const std::string& text) {
  static const std::regex kComment(R"(//[^\n]*)");
  return std::regex_replace(text, kComment, "");
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

// The rooms in the order of ARCHITECTURE.md: each includes only those before it.
const std::vector<std::string> kRooms = {"grammar",
                                         "reference",
                                         "oracle/records",
                                         "oracle/region",
                                         "oracle/relation",
                                         "oracle/motion",
                                         "oracle/steps",
                                         "oracle/open",
                                         "oracle/judge",
                                         "oracle/differential",
                                         "subjects",
                                         "corpus/io",
                                         "capture",
                                         "campaign",
                                         "fuzz/program",
                                         "publish/report",
                                         "publish/manual",
                                         "publish/evidence",
                                         "publish/site",
                                         "fuzz/generate",
                                         "fuzz/relations",
                                         "fuzz/identify",
                                         "fuzz/hunt",
                                         "corpus/recipes",
                                         "expanders",
                                         "fuzz",
                                         "cli"};

// The room that a file stands in, its place in kRooms; none: what no target of the house has.
std::optional<std::size_t> room_of(const std::string& path) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < kRooms.size(); ++i) {
    if (!path.starts_with(kRooms[i] + "/")) continue;
    if (!found || kRooms[i].size() > kRooms[*found].size()) found = i;
  }
  return found;
}

TEST(House, RoomsIncludeOnlyWhatStandsBeforeThem) {
  static const std::regex kInclude(R"re(#include "([^"]+/[^"]+)")re");
  // Rooms that stand before another and are not for it.
  const std::map<std::string, std::regex> closed = {
      {"oracle/motion", std::regex("oracle/relation")},
      {"oracle/steps", std::regex("oracle/relation")},
      {"oracle/open", std::regex("oracle/relation")},
      {"oracle/judge", std::regex("oracle/relation")},
      {"oracle/differential", std::regex("oracle/relation")},
      {"oracle/region", std::regex("oracle/relation")},
      {"fuzz/program", std::regex("(oracle|subjects|corpus|capture|campaign|publish)/?.*")},
      {"fuzz/identify", std::regex("fuzz/relations")},
      {"fuzz/hunt", std::regex("fuzz/identify")},
      {"expanders", std::regex(".*")}};
  std::set<std::size_t> seen;
  for (const char* folder : kProductFolders) {
    for_each_source(folder, [&](const fs::path& path, const std::string& text) {
      const std::optional<std::size_t> room = room_of(path.string());
      ASSERT_TRUE(room) << path << " stands in no room";
      seen.insert(*room);
      const auto rule = closed.find(kRooms[*room]);
      for (std::sregex_iterator it(text.begin(), text.end(), kInclude), end; it != end; ++it) {
        const std::string header = (*it)[1];
        const std::optional<std::size_t> other = room_of(header);
        if (other == room) continue;
        if (!other) {  // the public header, or text that the build has written
          EXPECT_TRUE(header.starts_with("gonogo/") || header == "publish/example_texts.hpp" ||
                      header == "fuzz/program/dictionary_texts.hpp")
              << path << " includes " << header;
          continue;
        }
        EXPECT_LT(*other, *room) << path << " includes " << header;
        EXPECT_FALSE(rule != closed.end() && std::regex_match(kRooms[*other], rule->second))
            << path << " includes " << header;
      }
    });
  }
  EXPECT_EQ(seen.size(), kRooms.size());
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
  for (const char* folder : kProductFolders) {
    for_each_source(folder, [&](const fs::path& path, const std::string& text) {
      if (path.string().starts_with("oracle/relation/") || path.string().starts_with("cli/"))
        return;
      EXPECT_EQ(text.find("#include \"oracle/relation/"), std::string::npos) << path;
    });
  }
}

TEST(House, AFolderIsBuiltOfItsOwnFiles) {
  std::size_t lists = 0;
  for (const char* const folder : kProductFolders) {
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
  for (const char* folder : kProductFolders) {
    for_each_source(folder, [&](const fs::path& path, const std::string& text) {
      if (path.string().starts_with("grammar/x3/")) return;
      EXPECT_EQ(text.find("boost/spirit"), std::string::npos) << path;
      if (path.string().starts_with("grammar/")) return;
      EXPECT_EQ(text.find("#include \"grammar/x3/"), std::string::npos) << path;
    });
  }
}

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

// The files that a table of CONTRIBUTING.md names have what it shows in them: one of `words`.
std::size_t files_named_in(const std::string& section, const std::vector<std::string>& words) {
  static const std::regex kRow(R"(\n\| `([^`]+)` \|)");
  std::string text = read(kRoot / "CONTRIBUTING.md");
  const std::size_t begin = text.find("\n## " + section + "\n");
  EXPECT_NE(begin, std::string::npos) << section;
  text = text.substr(begin, text.find("\n## ", begin + 1) - begin);
  std::size_t files = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), kRow), end; it != end; ++it, ++files) {
    const std::string file = (*it)[1];
    EXPECT_TRUE(fs::is_regular_file(kRoot / file)) << file;
    const std::string content = read(kRoot / file);
    EXPECT_TRUE(std::ranges::any_of(words, [&](const std::string& word) {
      return content.find(word) != std::string::npos;
    })) << file;
  }
  return files;
}

TEST(House, ACycleIsMadeOfTheFilesThatContributingNames) {
  const std::size_t files =
      files_named_in("A cycle, from the manual to the kill matrix", {"G89", "g89"});
  EXPECT_GT(files, 0U);
  EXPECT_LE(files, 15U);
}

TEST(House, AReadingIsMadeOfTheFilesThatContributingNames) {
  EXPECT_EQ(files_named_in("A reading", {"hnc.g75.end"}), 6U);
}

// A reading is named by its literal, which the compiler checks against the table.
TEST(House, NoReadingIsNamedByAPlainString) {
  static const std::regex kName(R"re("(gsk|hnc|ngc|sie)\.[a-z0-9.-]+(=[^"]*)?"(?!_))re");
  const auto names_one = [](const std::string& text) {
    return reference::find_reading(text.substr(1, text.find_first_of("=\"", 1) - 1)) != nullptr;
  };
  for (const char* folder :
       {"reference", "oracle", "subjects", "campaign", "publish", "fuzz", "cli"}) {
    for_each_source(folder, [&](const fs::path& path, const std::string& text) {
      if (path.string().starts_with("reference/catalog/")) return;
      const std::string code = without_comments(text);
      for (std::sregex_iterator it(code.begin(), code.end(), kName), end; it != end; ++it) {
        EXPECT_FALSE(names_one(it->str())) << path << ": " << it->str();
      }
    });
  }
}

// What tools know of codes is in the tables of the dialects (reference/*/descriptor.hpp).
TEST(House, ToolsHaveNoCodesOfTheirOwn) {
  static const std::regex kCode(
      R"re("(G\d+(\.\d)?|M\d+|L?CYC(LE)?\d+|CIP|CT|TURN|RPL|CR|AR|AP|RP|R1\d\d)")re");
  // The names of planes in records, and what `expand --format ngc` writes; programs that are
  // written to ask every dialect for the same, of which the reference's tables must know nothing.
  const std::set<std::string> formats = {
      "oracle/records/plain_record.cpp", "oracle/records/record_json.cpp",
      "oracle/motion/plain_line.cpp", "cli/formats.cpp", "fuzz/relations/operation_text.cpp"};
  std::size_t files = 0;
  for (const char* folder :
       {"oracle", "subjects", "corpus/io", "campaign", "capture", "publish", "fuzz/program",
        "fuzz/relations", "fuzz/hunt", "fuzz/identify", "cli"}) {
    files += for_each_source(folder, [&](const fs::path& path, const std::string& text) {
      if (formats.contains(path.string())) return;
      const std::string code =
          std::regex_replace(without_comments(text), std::regex("\"_clause"), "");
      std::smatch found;
      EXPECT_FALSE(std::regex_search(code, found, kCode)) << path << ": " << found.str();
    });
  }
  EXPECT_GT(files, 300U);
}

// Sentences are for people. What can be seen of it in the text: no search in a thing that is called
// a message, a reason or a sentence, nor its comparison with anything; no search for two words with
// a blank between them in any text; and a gap is made where its reason has to
// be given. What splits the sentences of results of format 1 decides nothing.
TEST(House, NoDecisionHangsOnTheWordingOfAMessage) {
  static const std::regex kSearch(
      R"re(\b(message|reason|sentence|why)\w*(\(\))?(\.|->)(r?find\w*|contains|starts_with|ends_with|compare)\()re"
      R"re(|\b(message|sentence)(\(\))?\s*[!=]=\s*)re");
  static const std::regex kSentence(
      R"re(\b(r?find|contains|starts_with|ends_with)\(\s*"[^"\\]*[A-Za-z]+ [a-z]{2})re");
  for (const char* folder : {"oracle", "subjects", "corpus", "campaign", "capture", "publish",
                             "fuzz", "cli", "tests/oracle/mutations"}) {
    for_each_source(folder, [&](const fs::path& path, const std::string& text) {
      std::smatch found;
      const std::string code = code_of(text);
      EXPECT_FALSE(std::regex_search(code, found, kSearch)) << path << ": " << found.str();
      const std::string with_texts = without_comments(text);
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
  for (const char* folder : kProductFolders) {
    EXPECT_TRUE(fs::is_directory(kRoot / folder)) << folder;
    EXPECT_TRUE(std::regex_search(sources, std::regex("[( ]" + std::string(folder) + "[\\s/]")))
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
