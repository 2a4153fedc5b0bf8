// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/generate/cover/parameters.hpp"

#include <gtest/gtest.h>

namespace gonogo::cover {
namespace {

TEST(Parameters, HaveClassesWithNamesAndValues) {
  const Parameters parameters = parse_parameters("R: none zero=0 word=G1&X2\n");
  ASSERT_EQ(parameters.list.size(), 1U);
  EXPECT_EQ(parameters.list[0].classes[0].value, "none");
  EXPECT_EQ(parameters.list[0].classes[1].value, "0");
  EXPECT_EQ(parameters.list[0].classes[2].value, "G1 X2");
}

TEST(Parameters, AFaultNamesItsAlarms) {
  const Parameters parameters = parse_parameters("R: none !zero=0@value-sign+feed-missing\n");
  EXPECT_FALSE(parameters.list[0].classes[0].is_fault());
  EXPECT_EQ(parameters.list[0].classes[1].alarms,
            (std::vector<std::string>{"value-sign", "feed-missing"}));
}

TEST(Parameters, AFaultMayStandOnNoText) {
  const Parameters parameters = parse_parameters("R: none !a@value-sign !?b=0@value-sign\n");
  EXPECT_FALSE(parameters.list[0].classes[1].is_unsaid);
  EXPECT_TRUE(parameters.list[0].classes[2].is_unsaid);
  EXPECT_EQ(parameters.list[0].classes[2].name, "b");
  EXPECT_TRUE(parameters.list[0].classes[2].is_fault());
}

TEST(Parameters, ARuleNamesClassesOfParameters) {
  const Parameters parameters = parse_parameters("a: x y\n# a remark\nb: u v w\nno: a=y b=u,w\n");
  ASSERT_EQ(parameters.rules.size(), 1U);
  EXPECT_EQ(parameters.rules[0].members[0].classes, (std::vector<bool>{false, true}));
  EXPECT_EQ(parameters.rules[0].members[1].classes, (std::vector<bool>{true, false, true}));
}

TEST(Parameters, RefuseWhatIsNotThere) {
  EXPECT_THROW(parse_parameters("a: x\nno: b=x\n"), ModelError);
  EXPECT_THROW(parse_parameters("a: x\nno: a=y\n"), ModelError);
  EXPECT_THROW(parse_parameters("a x y\n"), ModelError);
  EXPECT_THROW(parse_parameters("a: x y@syntax\n"), ModelError);
  EXPECT_THROW(parse_parameters("a: x !y\n"), ModelError);
  EXPECT_THROW(parse_parameters("a: !x@syntax y\n"), ModelError);
}

}  // namespace
}  // namespace gonogo::cover
