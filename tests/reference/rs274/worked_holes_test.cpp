// SPDX-License-Identifier: GPL-3.0-or-later
#include "worked_holes.hpp"

#include <gtest/gtest.h>

#include "ngc_trace.hpp"

namespace gonogo::reference::testing::ngc {
namespace {

std::string_view known(std::string_view of_machine, const WorkedHoles& worked) {
  return of_machine == kSame ? worked.want : of_machine;
}

TEST(NgcWorkedHoles, AreAsTheDocumentsSay) {
  EXPECT_EQ(worked_holes().size(), 40U);
  for (const WorkedHoles& worked : worked_holes()) {
    EXPECT_EQ(trace(worked.program), worked.want) << worked.name << ": " << worked.title;
  }
}

TEST(NgcWorkedHoles, AreAsLinuxcncHasThemUnderItsReadings) {
  int measured = 0;
  for (const WorkedHoles& worked : worked_holes()) {
    if (worked.linuxcnc == kOther) continue;
    ++measured;
    EXPECT_EQ(trace(worked.program, column_linuxcnc()), known(worked.linuxcnc, worked))
        << worked.name << ": " << worked.title;
  }
  EXPECT_EQ(measured, 38);
}

TEST(NgcWorkedHoles, AreAsTheInterpreterOfNistHasThemUnderItsReadings) {
  int measured = 0;
  for (const WorkedHoles& worked : worked_holes()) {
    if (worked.nist == kOther) continue;
    ++measured;
    EXPECT_EQ(trace(worked.program, column_nist()), known(worked.nist, worked))
        << worked.name << ": " << worked.title;
  }
  EXPECT_EQ(measured, 35);
}

}  // namespace
}  // namespace gonogo::reference::testing::ngc
