// SPDX-License-Identifier: GPL-3.0-or-later
//
// The ranges of the words in blocks of G94, G110 and G111 (GSK-COM-06), at their ends: signed words
// +-999999.999 mm or +-99999.9999 inch in ISB, +-99999.9999 mm or +-9999.99999 inch in ISC;
// unsigned words from 0 to the same upper ends. An increment above 999999.999 is 1000000.
#include <gtest/gtest.h>

#include "expanding.hpp"

namespace gonogo::reference::testing {
namespace {

struct System {
  const char* name;
  Increment increment;
  Units units;
  std::string largest;    // the end of the range
  std::string one_below;  // one least increment less
  std::string one_above;
};

const System kSystems[] = {
    {"ISB mm", Increment::isb, Units::mm, "999999.999", "999999.998", "1000000"},
    {"ISB inch", Increment::isb, Units::inch, "99999.9999", "99999.9998", "100000"},
    {"ISC mm", Increment::isc, Units::mm, "99999.9999", "99999.9998", "100000"},
    {"ISC inch", Increment::isc, Units::inch, "9999.99999", "9999.99998", "10000"}};

Profile profile_of(const System& system) {
  Profile profile;
  profile.increment = system.increment;
  profile.units = system.units;
  return profile;
}

// Whether the program ends with a range alarm, and with no other.
bool out_of_range(const std::string& program, const System& system) {
  const std::string end = ending(program, profile_of(system), OpenPaths::judged);
  if (end.starts_with("end ")) return false;
  EXPECT_EQ(end, "alarm b1 value-out-of-range") << program << " in " << system.name;
  return true;
}

TEST(Range, SignedWordsOfG94) {
  for (const System& system : kSystems) {
    for (const char* address : {"X", "Z", "U", "W", "R"}) {
      for (const char* sign : {"", "-"}) {
        const std::string word = std::string("G94 F100 ") + address + sign;
        EXPECT_FALSE(out_of_range(word + system.one_below, system)) << word << system.name;
        EXPECT_FALSE(out_of_range(word + system.largest, system)) << word << system.name;
        EXPECT_TRUE(out_of_range(word + system.one_above, system)) << word << system.name;
      }
    }
  }
}

// A pocket of zero depth: it mills, and reaches the bottom for any R.
const std::string kPocketEntry = "G110 I16 L3 Q5 D4 F800 ";

TEST(Range, SignedWordsOfG110) {
  const std::pair<const char*, const char*> others[] = {
      {"X", "Z0 V0 "},       {"U", "Z0 V0 "},       {"Z", "X0 V0 "},    {"W", "X0 V0 "},
      {"Y", "X0 Z0 Q9000 "}, {"V", "X0 Z0 Q9000 "}, {"R", "X0 Z0 V0 "}, {"P", "X0 Z0 V0 "}};
  for (const System& system : kSystems) {
    for (const auto& [address, words] : others) {
      for (const char* sign : {"", "-"}) {
        std::string program = kPocketEntry;
        if (std::string(words).find('Q') != std::string::npos) program = "G110 I16 L3 D4 F800 ";
        program += std::string(words) + address + sign;
        EXPECT_FALSE(out_of_range(program + system.one_below, system)) << program << system.name;
        EXPECT_FALSE(out_of_range(program + system.largest, system)) << program << system.name;
        EXPECT_TRUE(out_of_range(program + system.one_above, system)) << program << system.name;
      }
    }
  }
}

TEST(Range, UnsignedWordsOfG110HaveTheSameUpperEnd) {
  // In a block that mills nothing: L against D and I against D are not asked for.
  const std::pair<char, const char*> words[] = {
      {'I', "L3 Q5 D4 "}, {'L', "I16 Q5 D4 "}, {'Q', "I16 L3 D4 "}, {'D', "I16 L3 Q5 "}};
  for (const System& system : kSystems) {
    for (const auto& [address, others] : words) {
      const std::string program = std::string("G110 ") + others + address;
      EXPECT_FALSE(out_of_range(program + system.one_below, system)) << program << system.name;
      EXPECT_FALSE(out_of_range(program + system.largest, system)) << program << system.name;
      EXPECT_TRUE(out_of_range(program + system.one_above, system)) << program << system.name;
    }
  }
}

TEST(Range, UnsignedWordsOfG110BeginAtZero) {
  for (const System& system : kSystems) {
    const std::string least = system.units == Units::mm ? "-0.001" : "-0.0001";
    for (const std::pair<char, const char*>& word :
         {std::pair{'I', "L3 Q5 D4 "}, {'L', "I16 Q5 D4 "}, {'Q', "I16 L3 D4 "}}) {
      const std::string program = std::string("G110 ") + word.second + word.first;
      EXPECT_FALSE(out_of_range(program + "0", system)) << program << system.name;
      EXPECT_TRUE(out_of_range(program + least, system)) << program << system.name;
    }
  }
}

TEST(Range, LargestUnsignedWordsMill) {
  for (const System& system : kSystems) {
    const std::string program = "G110 X0 Z0 V-1 F800 L3 Q" + system.largest + " I" +
                                system.largest + " D" + system.one_below;
    EXPECT_FALSE(out_of_range(program, system)) << system.name;
  }
}

TEST(Range, TheUnitsOfTheBlockCount) {
  const System& isb = kSystems[0];
  EXPECT_FALSE(out_of_range("G21 G94 F100 Z100000", isb));
  EXPECT_TRUE(out_of_range("G20 G94 F100 Z100000", isb));
}

TEST(Range, HoldsInRepeatedBlocksAndInEachBlockOfTheMode) {
  EXPECT_EQ(ending("G94 X0 Z-1 F100\nX1000000"), "alarm b2 value-out-of-range");
  EXPECT_EQ(ending("G110 I16 L3 Q5 D4 F800\n\nR1000000"), "alarm b3 value-out-of-range");
}

TEST(Range, EndsWithTheCycle) {
  EXPECT_EQ(ending("G94 X0 Z-1 F100\nG0 Z1000000"), "end x0 y0 z1000000 a0 c0");
  EXPECT_EQ(ending("G110 I16 L3 Q5 D4 F800\nG80 Z1000000"), "end x0 y0 z1000000 a0 c0");
}

TEST(Range, AWordThatG94DoesNotUseIsCheckedAndIgnored) {
  EXPECT_EQ(lines("G94 X-2 Z-1 F100 I5 Q5 P5"), lines("G94 X-2 Z-1 F100"));
  EXPECT_EQ(ending("G94 X-2 Z-1 F100 I1000000"), "alarm b1 value-out-of-range");
  EXPECT_EQ(ending("G94 X-2 Z-1 F100 Q-0.001"), "alarm b1 value-out-of-range");
}

}  // namespace
}  // namespace gonogo::reference::testing
