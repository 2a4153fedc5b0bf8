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
    EXPECT_EQ(trace(worked.program, column("linuxcnc")), known(worked.linuxcnc, worked))
        << worked.name << ": " << worked.title;
  }
  EXPECT_EQ(measured, 38);
}

TEST(NgcWorkedHoles, AreAsTheInterpreterOfNistHasThemUnderItsReadings) {
  int measured = 0;
  for (const WorkedHoles& worked : worked_holes()) {
    if (worked.nist == kOther) continue;
    ++measured;
    EXPECT_EQ(trace(worked.program, column("nist")), known(worked.nist, worked))
        << worked.name << ": " << worked.title;
  }
  EXPECT_EQ(measured, 35);
}

// Read in their sources, and derived by hand.
TEST(NgcWorkedHoles, AreAsOtherMachinesHaveThemUnderTheirReadings) {
  const std::string_view pecks = "G98 F100\nG0 Z10\nG83 X1 Z-7 R2 Q3\nM2";
  EXPECT_EQ(trace(pecks, column("grblhal")),
            "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 D0.25 R1,0,10 F1,0,-4 D0.25 R1,0,10 F1,0,-7 D0.25 "
            "R1,0,10");
  EXPECT_EQ(trace(pecks, column("freecad")),
            "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,2 R1,0,-0.85 F1,0,-4 R1,0,2 R1,0,-3.85 F1,0,-7 "
            "R1,0,10");
  EXPECT_EQ(trace("G98 F100\nG0 Z10\nG73 X1 Z-1 R2 Q2\nM2", column("freecad")),
            "R0,0,10 R1,0,10 R1,0,2 F1,0,0 R1,0,0.1 F1,0,-1 R1,0,2 R1,0,10");
  EXPECT_EQ(trace("F100\nG0 Z10\nG98 G85 X1 Z-7 R2\nM2", column("camotics")),
            "R0,0,10 R1,0,10 R1,0,2 F1,0,-7 F1,0,10");
  EXPECT_EQ(trace("F100\nG0 Z5\nG91 G99 G81 X1 Z-2 R3 L2\nM2", column("camotics")),
            "R0,0,5 R1,0,5 R1,0,3 F1,0,1 R1,0,3 R2,0,3 F2,0,1 R2,0,3");
  EXPECT_EQ(trace("F100\nG0 Z5\nG98 G81 X1 Z-1 R7\nX2 R3\nM2", column("grblhal")),
            "R0,0,5 R0,0,7 R1,0,7 F1,0,-1 R1,0,7 R2,0,7 R2,0,3 F2,0,-1 R2,0,7");
}

// By hand: a traverse to the place, one to R where the tool is not there, the feed to the bottom,
// and the traverse to R (G99 is the default).
TEST(NgcWorkedHoles, OfMistakesThatControlsMake) {
  Profile elsewhere = ngc();
  elsewhere.initial.at[Axis::x] = 3;
  EXPECT_EQ(trace("F9\nG99 G81 X1 Z-1 R0\nM2", elsewhere), "R1,0,0 F1,0,-1 R1,0,0");
  EXPECT_EQ(trace("F9\nG0 Z5\nG99 G81 X1 Z2 R2\nM2"), "R0,0,5 R1,0,5 R1,0,2");
  EXPECT_EQ(trace("F9\nG99 G0 Z5\nG81 X1 Z-1 R2\nM2"), "R0,0,5 R1,0,5 R1,0,2 F1,0,-1 R1,0,2");
  EXPECT_EQ(trace("G0 Z5\nG99 G81 X1 Z-1 R0 F9\nG1 X2\nM2"),
            "R0,0,5 R1,0,5 R1,0,0 F1,0,-1 R1,0,0 F2,0,0");
  // Pecks to -k 0.005; back in to -k 0.005 + 0.254, which is above R: the rapid goes up.
  EXPECT_EQ(trace("F9\nG83 X1 Z-0.02 R0 Q0.005\nM2"),
            "R1,0,0 F1,0,-0.005 R1,0,0 R1,0,0.249 F1,0,-0.01 R1,0,0 R1,0,0.244 F1,0,-0.015 R1,0,0 "
            "R1,0,0.239 F1,0,-0.02 R1,0,0");
}

}  // namespace
}  // namespace gonogo::reference::testing::ngc
