// SPDX-License-Identifier: GPL-3.0-or-later
#include "worked_holes.hpp"

#include <array>

namespace gonogo::reference::testing::ngc {
namespace {

constexpr auto kWorked = std::to_array<WorkedHoles>({
    {"W01", "G81, G98: the page's first example",
     "F100\nG0 X1 Y2 Z3\nG90 G98 G81 X4 Y5 Z1.5 R2.8\nM2", "R1,2,3 R4,5,3 R4,5,2.8 F4,5,1.5 R4,5,3",
     kSame, kSame},
    {"W02", "G91, R above the start, L3", "F100\nG0 X1 Y2 Z3\nG91 G98 G81 X4 Y5 Z-0.6 R1.8 L3\nM2",
     "R1,2,3 R1,2,4.8 R5,7,4.8 F5,7,4.2 R5,7,4.8 R9,12,4.8 F9,12,4.2 R9,12,4.8 R13,17,4.8"
     " F13,17,4.2 R13,17,4.8",
     kSame, kSame},
    {"W03", "start below R", "F100\nG90 G98 G81 X4 Y5 Z1.5 R2.8\nM2",
     "R0,0,2.8 R4,5,2.8 F4,5,1.5 R4,5,2.8", kSame, kSame},
    {"W04", "G91 from the origin, L3", "F100\nG91 G98 G81 X4 Y5 Z-0.6 R1.8 L3\nM2",
     "R0,0,1.8 R4,5,1.8 F4,5,1.2 R4,5,1.8 R8,10,1.8 F8,10,1.2 R8,10,1.8 R12,15,1.8 F12,15,1.2"
     " R12,15,1.8",
     kSame, kSame},
    {"W05", "the page's G80 example: sticky Z and R, a later Z, G80",
     "G90 G0 X0 Y0 Z0\nG1 F10 X0 G4 P0.1\nG81 X1 Y0 Z0 R1\nX2\nY1 Z0.5\nX1\nG80\nG0 X0\nZ0\nM2",
     "D0.1 R0,0,1 R1,0,1 F1,0,0 R1,0,1 R2,0,1 F2,0,0 R2,0,1 R2,1,1 F2,1,0.5 R2,1,1 R1,1,1"
     " F1,1,0.5 R1,1,1 R0,1,1 R0,1,0",
     kSame, kSame},
    {"W06", "the page's eight holes, shortened to L2",
     "G0 X0 Y0 Z0\nF10\nG91 G81 X1 Y0 Z-1 R1 L2\nG90 G0 X0 Y1\nZ0\nG91 G81 X1 Y0 Z-0.5 R1 "
     "L2\nG80\nM2",
     "R0,0,1 R1,0,1 F1,0,0 R1,0,1 R2,0,1 F2,0,0 R2,0,1 R0,1,1 R0,1,0 R0,1,1 R1,1,1 F1,1,0.5"
     " R1,1,1 R2,1,1 F2,1,0.5 R2,1,1",
     kSame, kSame},
    {"W07", "the page's square of holes, shortened: G91 and R0 in the second block",
     "G0 X0 Y0 Z0\nF50\nG91 G81 X1 Y0 Z-0.5 R1 L2\nX0 Y1 R0 L2\nX-1 Y0\nM2",
     "R0,0,1 R1,0,1 F1,0,0.5 R1,0,1 R2,0,1 F2,0,0.5 R2,0,1 R2,1,1 F2,1,0.5 R2,1,1 R2,2,1"
     " F2,2,0.5 R2,2,1 R1,2,1 F1,2,0.5 R1,2,1",
     "R0,0,1 R1,0,1 F1,0,0.5 R1,0,1 R2,0,1 F2,0,0.5 R2,0,1 R2,1,1 R2,1,0 F2,1,-0.5 R2,1,0"
     " R2,2,0 F2,2,-0.5 R2,2,0 R1,2,0 F1,2,-0.5 R1,2,0",
     kSame},
    {"W08", "G98 with F in the cycle's block", "G0 X1 Y2 Z3\nG90 G98 G81 X4 Y5 Z-0.6 R1.8 F10\nM2",
     "R1,2,3 R4,5,3 R4,5,1.8 F4,5,-0.6 R4,5,3", kSame, kSame},
    {"W09", "G99 then G98 in one series", "F100\nG0 Z10\nG99 G81 X1 Z-1 R2\nX2\nG98 X3\nX4\nM2",
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,2 R2,0,2 F2,0,-1 R2,0,2 R3,0,2 F3,0,-1 R3,0,10"
     " R4,0,10 R4,0,2 F4,0,-1 R4,0,10",
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,2 R2,0,2 F2,0,-1 R2,0,2 R3,0,10 R3,0,2 F3,0,-1"
     " R3,0,10 R4,0,10 R4,0,2 F4,0,-1 R4,0,10",
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,2 R2,0,2 F2,0,-1 R2,0,2 R3,0,2 F3,0,-1 R3,0,2 R4,0,2"
     " F4,0,-1 R4,0,2"},
    {"W10", "a series over two cycles", "F100\nG0 Z10\nG99 G81 X1 Z-1 R2\nG98 G82 X2 Z-1 R2 P1\nM2",
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,2 R2,0,2 F2,0,-1 D1 R2,0,10",
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,2 R2,0,10 R2,0,2 F2,0,-1 D1 R2,0,10",
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,2 R2,0,2 F2,0,-1 D1 R2,0,2"},
    {"W11", "G80 ends the series", "F100\nG0 Z10\nG99 G81 X1 Z-1 R2\nG80\nG98 G81 X2 Z-1 R2\nM2",
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,2 R2,0,2 F2,0,-1 R2,0,2", kSame, kSame},
    {"W12", "M5 and G4 do not end it", "F100\nG0 Z10\nG99 G81 X1 Z-1 R2\nG4 P1\nG98 X2\nM2",
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,2 D1 R2,0,2 F2,0,-1 R2,0,10",
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,2 D1 R2,0,10 R2,0,2 F2,0,-1 R2,0,10",
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,2 D1 R2,0,2 F2,0,-1 R2,0,2"},
    {"W13", "R raised within a G99 series", "F100\nG0 Z10\nG99 G81 X1 Z0 R4\nX2 R8\nX3 R1\nM2",
     "R0,0,10 R1,0,10 R1,0,4 F1,0,0 R1,0,4 R1,0,8 R2,0,8 F2,0,0 R2,0,8 R3,0,8 R3,0,1 F3,0,0"
     " R3,0,1",
     "R0,0,10 R1,0,10 R1,0,4 F1,0,0 R1,0,4 R2,0,8 F2,0,0 R2,0,8 R3,0,8 R3,0,1 F3,0,0 R3,0,1",
     kSame},
    {"W14", "G98, R above the initial level, then below it",
     "F100\nG0 Z5\nG98 G81 X1 Z-1 R7\nX2 R3\nM2",
     "R0,0,5 R0,0,7 R1,0,7 F1,0,-1 R1,0,7 R2,0,7 R2,0,3 F2,0,-1 R2,0,5", kSame,
     "R0,0,5 R0,0,7 R1,0,7 F1,0,-1 R1,0,7 R2,0,7 R2,0,3 F2,0,-1 R2,0,7"},
    {"W15", "G91 G99: the sticky R counts from the tool",
     "F100\nG0 Z10\nG91 G99 G81 X1 Y0 Z-3 R-5\nX1 Y0\nM2",
     "R0,0,10 R1,0,10 R1,0,5 F1,0,2 R1,0,5 R2,0,5 R2,0,0 F2,0,-3 R2,0,0",
     "R0,0,10 R1,0,10 R1,0,5 F1,0,2 R1,0,5 R2,0,5 F2,0,2 R2,0,5", kSame},
    {"W16", "G91 G98: as before with the initial level",
     "F100\nG0 Z10\nG91 G98 G81 X1 Y0 Z-3 R-5\nX1 Y0\nX1 Y0 R-2\nM2",
     "R0,0,10 R1,0,10 R1,0,5 F1,0,2 R1,0,10 R2,0,10 R2,0,5 F2,0,2 R2,0,10 R3,0,10 R3,0,8 F3,0,5"
     " R3,0,10",
     kSame, kSame},
    {"W17", "G91, one plane word left out", "F100\nG0 X1 Y2 Z10\nG91 G81 X1 Z-1 R-2\nM2",
     "R1,2,10 R2,2,10 R2,2,8 F2,2,7 R2,2,8", kSame, kOther},
    {"W18", "G90 L3 G98: thrice in one place", "F100\nG0 Z10\nG98 G81 X1 Y1 Z-3 R5 L3\nM2",
     "R0,0,10 R1,1,10 R1,1,5 F1,1,-3 R1,1,10 R1,1,5 F1,1,-3 R1,1,10 R1,1,5 F1,1,-3 R1,1,10", kSame,
     kSame},
    {"W19", "G83, three pecks without remainder, G98", "F100\nG0 Z10\nG98 G83 X1 Z-7 R2 Q3\nM2",
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,2 R1,0,-0.746 F1,0,-4 R1,0,2 R1,0,-3.746 F1,0,-7"
     " R1,0,10",
     kSame,
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,10 R1,0,-0.746 F1,0,-4 R1,0,10 R1,0,-3.746 F1,0,-7"
     " R1,0,10"},
    {"W20", "G83 with a remainder, start below R", "F100\nG98 G83 X1 Z-7 R2 Q2.5\nM2",
     "R0,0,2 R1,0,2 F1,0,-0.5 R1,0,2 R1,0,-0.246 F1,0,-3 R1,0,2 R1,0,-2.746 F1,0,-5.5 R1,0,2"
     " R1,0,-5.246 F1,0,-7 R1,0,2",
     kSame, kSame},
    {"W21", "G83, Q above the depth", "F100\nG0 Z10\nG98 G83 X1 Z-7 R2 Q20\nM2",
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-7 R1,0,10", kSame, kSame},
    {"W22", "G83, Q below the clearance", "F100\nG0 Z2\nG99 G83 X1 Z0.625 R1 Q0.125\nM2",
     "R0,0,2 R1,0,2 R1,0,1 F1,0,0.875 R1,0,1 R1,0,1.129 F1,0,0.75 R1,0,1 R1,0,1.004 F1,0,0.625"
     " R1,0,1",
     kSame, kSame},
    {"W23", "G83, Q a tenth: exact arithmetic", "F100\nG0 Z2\nG99 G83 X1 Z0.7 R1 Q0.1\nM2",
     "R0,0,2 R1,0,2 R1,0,1 F1,0,0.9 R1,0,1 R1,0,1.154 F1,0,0.8 R1,0,1 R1,0,1.054 F1,0,0.7"
     " R1,0,1",
     kOther, kOther},
    {"W24", "G83 in inches (lengths of the records here in inches)",
     "G20 F10\nG0 X1 Y1 Z1\nG98 G83 X2 Z-0.5 R0.25 Q0.25\nM2",
     "R25.4,25.4,25.4 R50.8,25.4,25.4 R50.8,25.4,6.35 F50.8,25.4,0 R50.8,25.4,6.35"
     " R50.8,25.4,0.254 F50.8,25.4,-6.35 R50.8,25.4,6.35 R50.8,25.4,-6.096 F50.8,25.4,-12.7"
     " R50.8,25.4,25.4",
     kSame,
     "R25.4,25.4,25.4 R50.8,25.4,25.4 R50.8,25.4,6.35 F50.8,25.4,0 R50.8,25.4,25.4"
     " R50.8,25.4,0.254 F50.8,25.4,-6.35 R50.8,25.4,25.4 R50.8,25.4,-6.096 F50.8,25.4,-12.7"
     " R50.8,25.4,25.4"},
    {"W25", "Q changed and sticky", "F100\nG0 Z10\nG99 G83 X1 Z-1 R2 Q3\nQ2 X2\nX3\nM2",
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,2 R2,0,2 F2,0,0 R2,0,2 R2,0,0.254 F2,0,-1 R2,0,2"
     " R3,0,2 F3,0,0 R3,0,2 R3,0,0.254 F3,0,-1 R3,0,2",
     kSame, kSame},
    {"W26", "G73, G99, L2", "F100\nG0 Z5\nG99 G73 X1 Z-4 R1 Q2.5 L2\nM2",
     "R0,0,5 R1,0,5 R1,0,1 F1,0,-1.5 R1,0,-1.246 F1,0,-4 R1,0,1 F1,0,-1.5 R1,0,-1.246 F1,0,-4"
     " R1,0,1",
     kSame, kOther},
    {"W27", "G73 under G98: ends on R as the page says",
     "F100\nG0 Z10\nG98 G73 X1 Z-7 R2 Q3\nX2\nM2",
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,-0.746 F1,0,-4 R1,0,-3.746 F1,0,-7 R1,0,2 R2,0,2"
     " F2,0,-1 R2,0,-0.746 F2,0,-4 R2,0,-3.746 F2,0,-7 R2,0,2",
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,-0.746 F1,0,-4 R1,0,-3.746 F1,0,-7 R1,0,10 R2,0,10"
     " R2,0,2 F2,0,-1 R2,0,-0.746 F2,0,-4 R2,0,-3.746 F2,0,-7 R2,0,10",
     kOther},
    {"W28", "G82, P sticky, P0", "F100\nG0 Z10\nG99 G82 X1 Z-1 R2 P0.5\nX2\nX3 P0\nM2",
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 D0.5 R1,0,2 R2,0,2 F2,0,-1 D0.5 R2,0,2 R3,0,2 F3,0,-1"
     " R3,0,2",
     kSame, kSame},
    {"W29", "G85 under G98: feed to R, traverse on", "F100\nG0 Z10\nG98 G85 X1 Z-7 R2\nX2\nM2",
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-7 F1,0,2 R1,0,10 R2,0,10 R2,0,2 F2,0,-7 F2,0,2 R2,0,10", kSame,
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-7 F1,0,10 R2,0,10 R2,0,2 F2,0,-7 F2,0,10"},
    {"W30", "G89 under G98: feed out to the clear level",
     "F100\nG0 Z10\nG98 G89 X1 Z-7 R2 P1.5\nP0.5 X3\nM2",
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-7 D1.5 F1,0,10 R3,0,10 R3,0,2 F3,0,-7 D0.5 F3,0,10", kSame,
     kSame},
    {"W31", "G86, both senses", "F100 S100 M3\nG0 Z10\nG98 G86 X1 Z-7 R2 P1.5\nM4\nX3\nM2",
     "M3 R0,0,10 R1,0,10 R1,0,2 F1,0,-7 D1.5 M5 R1,0,10 M3 M4 R3,0,10 R3,0,2 F3,0,-7 D1.5 M5"
     " R3,0,10 M4",
     kSame, kSame},
    {"W32", "G84 with P", "F100 S100 M3\nG0 Z10\nG98 G84 X1 Z-7 R2 P1.5\nM2",
     "M3 R0,0,10 R1,0,10 R1,0,2 F1,0,-7 M5 M4 D1.5 F1,0,10 M5 M3", kSame,
     "M3 R0,0,10 !b3:unused-word"},
    {"W33", "G84 after G82: no P, no dwell",
     "F100 S100 M3\nG0 Z10\nG82 X1 Z-1 R2 P2\nG84 X2 Z-1 R2\nM2",
     "M3 R0,0,10 R1,0,10 R1,0,2 F1,0,-1 D2 R1,0,2 R2,0,2 F2,0,-1 M5 M4 F2,0,2 M5 M3",
     "M3 R0,0,10 R1,0,10 R1,0,2 F1,0,-1 D2 R1,0,2 R2,0,2 F2,0,-1 M5 M4 D2 F2,0,2 M5 M3", kSame},
    {"W34", "G74 with L2, as the page lists it",
     "F100 S100 M4\nG0 Z10\nG99 G74 X1 Z-7 R2 P0.5 L2\nM2",
     "M4 R0,0,10 R1,0,10 R1,0,2 F1,0,-7 M5 M3 D0.5 F1,0,2 M5 M4 F1,0,-7 M5 M3 D0.5 F1,0,2 M5 M4",
     "M4 R0,0,10 !b3:unused-word", kOther},
    {"W35", "G84 in G18", "F100 S100 M3\nG18\nG0 Y10\nG98 G84 X1 Z2 Y-3 R5\nM2",
     "M3 R0,10,0 R1,10,2 R1,5,2 F1,-3,2 M5 M4 F1,10,2 M5 M3", kOther, kSame},
    {"W36", "G81 in G18", "F100\nG18\nG0 Y10\nG98 G81 X1 Z2 Y-3 R5\nX2\nM2",
     "R0,10,0 R1,10,2 R1,5,2 F1,-3,2 R1,10,2 R2,10,2 R2,5,2 F2,-3,2 R2,10,2", kSame, kSame},
    {"W37", "G83 in G19, G91, L2", "F100\nG19\nG91 G0 X10\nG99 G83 Y1 Z2 X-3 R-5 Q2 L2\nM2",
     "R10,0,0 R10,1,2 R5,1,2 F3,1,2 R5,1,2 R3.254,1,2 F2,1,2 R5,1,2 R5,2,4 F3,2,4 R5,2,4"
     " R3.254,2,4 F2,2,4 R5,2,4",
     kSame, kSame},
    {"W38", "plane changed in a series", "F100\nG0 X10 Y20 Z10\nG99 G81 X1 Z2 R5\nG19 Y3 X1 R4\nM2",
     "R10,20,10 R1,20,10 R1,20,5 F1,20,2 R1,20,5 R4,20,5 R4,3,5 F1,3,5 R4,3,5",
     "R10,20,10 R1,20,10 R1,20,5 F1,20,2 R1,20,5 R4,3,5 F1,3,5 R4,3,5", kSame},
    {"W39", "G4 in the cycle's block: P serves both", "F100\nG0 Z10\nG98 G82 X1 Z-1 R2 G4 P1\nM2",
     "R0,0,10 D1 R1,0,10 R1,0,2 F1,0,-1 D1 R1,0,10", kSame, kSame},
    {"W40", "G1 cancels; the next cycle needs all its words",
     "F100\nG0 Z10\nG81 X1 Z-1 R2\nG1 X2\nG81 X3 Z-1 R2\nM2",
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,2 F2,0,2 R3,0,2 F3,0,-1 R3,0,2", kSame, kSame},
});

}  // namespace

std::span<const WorkedHoles> worked_holes() {
  return kWorked;
}

}  // namespace gonogo::reference::testing::ngc
