// SPDX-License-Identifier: GPL-3.0-or-later
//
// The table of readings and how a run of the reference asks it.
#include "reference/reading.hpp"
#include "reference/reading_literal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "reference/dialect.hpp"

namespace gonogo::reference {
namespace {

TEST(Reading, TheTableIsInTheOrderOfItsKeys) {
  ASSERT_EQ(readings().size(), kReadings);
  for (std::size_t i = 0; i < kReadings; ++i) {
    EXPECT_EQ(index(readings()[i].key), i) << readings()[i].name;
  }
}

TEST(Reading, EachHasANameOfItsOwnAndIsFoundByIt) {
  std::set<std::string_view> names;
  for (const Reading& entry : readings()) {
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
    EXPECT_EQ(find_reading(entry.name), &entry);
    EXPECT_EQ(&reading(entry.key), &entry);
  }
  EXPECT_EQ(find_reading("gsk.pocket"), nullptr);
  EXPECT_EQ(find_reading(""), nullptr);
}

TEST(Reading, EachIsAChoiceBetweenTwoAtLeast) {
  for (const Reading& entry : readings()) {
    const std::set<std::string_view> different(entry.alternatives.begin(),
                                               entry.alternatives.end());
    EXPECT_EQ(different.size(), entry.alternatives.size()) << entry.name;
    EXPECT_FALSE(different.contains("any")) << entry.name;
    // What a property judges may leave one given path beside "any"; a length is any number.
    EXPECT_GE(different.size(), entry.is_length || entry.by_properties ? 1U : 2U) << entry.name;
  }
}

// S and M3 of SINUMERIK say that a spindle need not turn. All documents of rs274 say the same of
// these, not what interpreters do.
TEST(Reading, EachIsOpenByDefaultButWhereATextDecides) {
  std::set<std::string_view> decided;
  for (const Reading& entry : readings()) {
    EXPECT_TRUE(admits(entry, entry.fallback)) << entry.name;
    EXPECT_TRUE(!entry.by_properties || entry.fallback == "any") << entry.name;
    if (entry.fallback != "any") decided.insert(entry.name);
  }
  EXPECT_EQ(decided, (std::set<std::string_view>{
                         "ngc.cycle.approach", "ngc.cycle.g91-r", "ngc.cycle.sticky",
                         "ngc.feed-units", "ngc.g76.checks", "ngc.g83.return", "ngc.peck.dwell",
                         "ngc.program-end", "ngc.unused-words", "sie.spindle"}));
}

TEST(Reading, EachNamesItsDialectItsClauseAndItsChoice) {
  for (const Reading& entry : readings()) {
    const Dialect* dialect = find_dialect(entry.dialect);
    ASSERT_NE(dialect, nullptr) << entry.name;
    // gsk.pocket.end of gsk988ta cites a clause GSK-..., ngc.arc-tolerance of rs274 one NGC-...
    const std::string_view maker = entry.dialect == "rs274" ? "ngc"
                                   : entry.dialect.starts_with("sinumerik")
                                       ? "sie"
                                       : entry.dialect.substr(0, 3);
    EXPECT_EQ(entry.name.substr(0, entry.name.find('.')), maker) << entry.name;
    EXPECT_EQ(clause(entry.clause).id.substr(0, 4), dialect->clauses.front().id.substr(0, 4))
        << entry.name;
    EXPECT_FALSE(entry.text.empty()) << entry.name;
    EXPECT_TRUE(entry.also.empty() || find_dialect(entry.also) != nullptr) << entry.name;
  }
}

TEST(Reading, TheReadingsOfThe840DAreThoseOfThe802SToo) {
  const Reading& correct = reading("sie.arc.correct"_key);
  EXPECT_TRUE(correct.belongs_to("sinumerik840d"));
  EXPECT_TRUE(correct.belongs_to("sinumerik802s"));
  EXPECT_FALSE(correct.belongs_to("rs274"));
  EXPECT_FALSE(correct.belongs_to(""));
}

TEST(Reading, AnAlternativeIsWrittenAsItStands) {
  const Reading& end = reading("gsk.pocket.end"_key);
  EXPECT_TRUE(admits(end, "initial"));
  EXPECT_TRUE(admits(end, "r-plane"));
  EXPECT_TRUE(admits(end, "any"));
  for (std::string_view value : {"", "Initial", "initial ", "r_plane", "0"}) {
    EXPECT_FALSE(admits(end, value)) << value;
  }
}

TEST(Reading, ALengthIsAnyExactNumberFromZero) {
  const Reading& clearance = reading("gsk.pocket.p-omitted"_key);
  for (std::string_view value : {"0", "0.5", "1", "1/3", "any"}) {
    EXPECT_TRUE(admits(clearance, value));
  }
  for (std::string_view value : {"-0.001", "", "one", "1 mm"}) {
    EXPECT_FALSE(admits(clearance, value)) << value;
  }
}

TEST(Reading, ANewChoiceIsTheDefaults) {
  const ReadingChoice choice;
  for (const Reading& entry : readings()) {
    EXPECT_TRUE(choice.is(entry.key, entry.fallback)) << entry.name;
  }
}

TEST(Reading, AnAlternativeThatIsChosenIsTheOnlyOneThatHolds) {
  for (const Reading& entry : readings()) {
    if (entry.is_length) continue;
    const auto count = static_cast<std::uint8_t>(entry.alternatives.size());
    for (std::uint8_t chosen = 1; chosen <= count; ++chosen) {
      ReadingChoice choice;
      choice.set(entry.key, entry.alternatives[chosen - 1U]);
      const ReadingsInUse in_use(choice);
      EXPECT_FALSE(in_use.is({entry.key, 0})) << entry.name;  // "any"
      for (std::uint8_t other = 1; other <= count; ++other) {
        EXPECT_EQ(in_use.is({entry.key, other}), other == chosen) << entry.name << " " << +chosen;
      }
    }
  }
}

TEST(Reading, AnyShowsTheFirstAlternative) {
  ReadingChoice choice;
  choice.set("gsk.pocket.end=any"_reading);
  const ReadingsInUse in_use(choice);
  EXPECT_TRUE(in_use.is("gsk.pocket.end=initial"_reading));
  EXPECT_FALSE(in_use.is("gsk.pocket.end=r-plane"_reading));
  EXPECT_FALSE(in_use.is("gsk.pocket.end=any"_reading));
}

TEST(Reading, AnyThatPropertiesJudgeStaysOpen) {
  ReadingChoice choice;
  choice.set("gsk.pocket.path=any"_reading);
  const ReadingsInUse in_use(choice);
  EXPECT_TRUE(in_use.is("gsk.pocket.path=any"_reading));
  EXPECT_FALSE(in_use.is("gsk.pocket.path=semicircles"_reading));
}

TEST(Reading, ALengthIsItsNumber) {
  ReadingChoice choice;
  choice.set("gsk.pocket.p-omitted"_key, "0.25");
  EXPECT_EQ(ReadingsInUse(choice).length("gsk.pocket.p-omitted"_key), exact::Number(1) / 4);
}

TEST(Reading, OneThatIsAskedIsTouched) {
  const ReadingChoice choice;
  const ReadingsInUse in_use(choice);
  EXPECT_TRUE(in_use.touched().empty());
  in_use.is("gsk.x-depth=radius"_reading);
  in_use.length("gsk.pocket.p-omitted"_key);
  EXPECT_TRUE(in_use.touched("gsk.x-depth"_key));
  EXPECT_FALSE(in_use.touched("gsk.pocket.end"_key));
  const std::vector<ReadingKey> touched = {"gsk.pocket.p-omitted"_key, "gsk.x-depth"_key};
  EXPECT_EQ(in_use.touched(), touched);
}

}  // namespace
}  // namespace gonogo::reference
