// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/sample_reader.hpp"

#include <gtest/gtest.h>

#include "tests/capture/sampling.hpp"

namespace gonogo::oracle {
namespace {

// What is said of a file that cannot be read; empty where it can.
std::string fault_of(std::string_view text) {
  const TemporaryFile file(text);
  try {
    SampleReader reader(file.path());
    Sample sample;
    while (reader.next(sample)) {
    }
  } catch (const SampleFault& fault) {
    return std::string(fault.what()).substr(file.path().size());
  }
  return {};
}

TEST(SampleReader, NumbersAreExactDecimals) {
  const TemporaryFile file("time,x,z\n0.004,0.1000000000000000000001,-12.5\n");
  SampleReader reader(file.path());
  Sample sample;
  ASSERT_TRUE(reader.next(sample));
  EXPECT_EQ(sample.time, *Number::parse("0.004"));
  EXPECT_EQ(sample.at[reference::Axis::x], *Number::parse("0.1000000000000000000001"));
  EXPECT_EQ(sample.at[reference::Axis::z], *Number::parse("-12.5"));
  EXPECT_FALSE(reader.next(sample));
  EXPECT_EQ(reader.time_decimals(), 3);
}

TEST(SampleReader, TakesCarriageReturnsBlanksAByteOrderMarkAndCapitals) {
  EXPECT_EQ(fault_of("\xEF\xBB\xBFTime, X , Z\r\n0, 1,2\r\n\r\n0.1,1,2\r\n"), "");
}

TEST(SampleReader, AFaultSaysLineColumnAndWhat) {
  EXPECT_EQ(fault_of("t,x\n0,1\n0.1,1e3\n"), ", line 3, column 2: \"1e3\" is no decimal number.");
  EXPECT_EQ(fault_of("t,x,u\n"),
            ", line 1, column 3: \"u\" names no column. Write t or time, x, y, z, a, c, f, block "
            "or line, motion, alarm, or say with --columns what it is.");
}

TEST(SampleReader, RefusesWhatIsNoSample) {
  for (const std::string_view text :
       {"", "x,z\n0,1\n", "t\n0\n", "t,x,x\n", "t,x\n0\n", "t,x\n0,1,2\n", "t,x\n0,nan\n",
        "t,x\n0,1/3\n", "t,x\n0,0x1p3\n", "t,x\n0,1..2\n", "t,x\n0,\n", "t,x\n0,1\n0,2\n",
        "t,x\n1,1\n0.5,2\n", "t,x,line\n0,1,a\n", "t,x\nalarm\n", "t,x\nalarm,syntax,2\n0,1\n"}) {
    EXPECT_NE(fault_of(text), "") << text;
  }
}

TEST(SampleReader, AnAlarmIsAClassOrTheMachinesOwnName) {
  const TemporaryFile file("t,x\n0,1\nalarm,PS0061,3\n");
  SampleReader reader(file.path());
  Sample sample;
  while (reader.next(sample)) {
  }
  ASSERT_TRUE(reader.alarm());
  EXPECT_EQ(reader.alarm()->native, "PS0061");
  EXPECT_EQ(reader.alarm()->alarm_class, "");
  EXPECT_EQ(reader.alarm()->block, 3U);
}

}  // namespace
}  // namespace gonogo::oracle
