// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rules of docs/domain.md are those that oracle/differential/domain.cpp carries and its test holds.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

namespace gonogo {
namespace {

std::set<std::string> rules_in(const std::string& file) {
  static const std::regex kRule(R"(D-DOM-[0-9]{2})");
  std::ifstream in(std::string(GONOGO_SOURCE_DIR "/") + file, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(in), {});
  std::set<std::string> rules;
  for (std::sregex_iterator it(text.begin(), text.end(), kRule), end; it != end; ++it) {
    rules.insert(it->str());
  }
  return rules;
}

TEST(DomainRules, AreWrittenCarriedAndHeld) {
  const std::set<std::string> written = rules_in("docs/domain.md");
  EXPECT_GT(written.size(), 5U);
  std::set<std::string> carried = rules_in("oracle/differential/domain.cpp");
  carried.merge(rules_in("oracle/differential/domain.hpp"));
  EXPECT_EQ(carried, written);
  EXPECT_EQ(rules_in("tests/oracle/differential/domain_test.cpp"), written);
}

}  // namespace
}  // namespace gonogo
