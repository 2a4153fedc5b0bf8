// SPDX-License-Identifier: GPL-3.0-or-later
#include "subjects/reply_pace.hpp"

#include <gtest/gtest.h>

namespace gonogo::oracle {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;

TEST(ReplyPace, NothingGathersBeforeThePaceIsKnown) {
  EXPECT_EQ(ReplyPace().wait(64), microseconds(0));
}

TEST(ReplyPace, RepliesGatherForAQuarterOfWhatIsOpen) {
  ReplyPace pace;
  pace.note(4, 64, microseconds(80));
  EXPECT_EQ(pace.wait(40), microseconds(200));
}

TEST(ReplyPace, NoLongerThanAMillisecond) {
  ReplyPace pace;
  pace.note(1, 64, microseconds(200));
  EXPECT_EQ(pace.wait(64), milliseconds(1));
}

TEST(ReplyPace, SlowRepliesAreTakenAsTheyCome) {
  ReplyPace pace;
  pace.note(1, 64, milliseconds(5));
  EXPECT_EQ(pace.wait(64), microseconds(0));
}

TEST(ReplyPace, ASubjectWithLittleToDoIsNotKeptWaiting) {
  ReplyPace pace;
  pace.note(4, 64, microseconds(80));
  EXPECT_EQ(pace.wait(7), microseconds(0));
}

// The time in which it had nothing to do is not its pace.
TEST(ReplyPace, WhoAnswersAllIsLookedAtSooner) {
  ReplyPace pace;
  pace.note(10, 64, microseconds(200));
  pace.note(64, 64, milliseconds(6));
  EXPECT_EQ(pace.wait(64), microseconds(160));
  pace.note(0, 64, milliseconds(6));
  EXPECT_EQ(pace.wait(64), microseconds(160));
}

}  // namespace
}  // namespace gonogo::oracle
