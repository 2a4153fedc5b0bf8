// SPDX-License-Identifier: GPL-3.0-or-later
// Worked examples of the hole cycles and threads, by hand from the documentation, and what LinuxCNC
// 2.9 and NIST's interpreter, version 3, were measured to do instead.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <vector>

#include "harness.hpp"
#include "short_form.hpp"

namespace gonogo::expanders::testing {
namespace {

/// What a machine does otherwise: from record `from` on (1, 2, ...) to the end.
struct Departure {
  std::size_t from = 0;  // 0: nothing
  const char* records = "";
  const char* fault = "";  // where it is a defect, planted here
};
constexpr Departure kSame{};
constexpr std::size_t kLacks = 1'000;  // the machine lacks the code

// Records in their short form; M2 is left out.
struct Worked {
  const char* name;
  const char* program;  // '/' stands for the end of a line; M2 follows
  const char* records;
  Departure linuxcnc;
  Departure nist;
};

void PrintTo(const Worked& worked, std::ostream* out) {
  *out << worked.name;
}

constexpr const char* kAsLinuxcnc = R"({"readings":{"ngc.cycle.g91-r":"initial",
    "ngc.cycle.approach":"initial-level","ngc.cycle.initial-kept":"number",
    "ngc.cycle.alarm-at":"late","ngc.g73.end":"clear","ngc.tap.p":"last","ngc.g74.l":"barred",
    "ngc.g33.k":"free","ngc.g76.checks":"linuxcnc","ngc.g80-beside":"ignored"}})";
constexpr const char* kAsNist = R"({"readings":{"ngc.cycle.initial":"block",
    "ngc.cycle.feed":"free","ngc.cycle.alarm-at":"late","ngc.g83.retract":"clear",
    "ngc.g85.out":"clear","ngc.tap.p":"barred"}})";

const Worked kHoles[] = {
    {"W01", "F100/G0 X1 Y2 Z3/G90 G98 G81 X4 Y5 Z1.5 R2.8",
     "R1,2,3 R4,5,3 R4,5,2.8 F4,5,1.5 R4,5,3", kSame, kSame},
    {"W02", "F100/G0 X1 Y2 Z3/G91 G98 G81 X4 Y5 Z-0.6 R1.8 L3",
     "R1,2,3 R1,2,4.8 R5,7,4.8 F5,7,4.2 R5,7,4.8 R9,12,4.8 F9,12,4.2 R9,12,4.8 R13,17,4.8 "
     "F13,17,4.2 R13,17,4.8",
     kSame, kSame},
    {"W03", "F100/G90 G98 G81 X4 Y5 Z1.5 R2.8", "R0,0,2.8 R4,5,2.8 F4,5,1.5 R4,5,2.8", kSame,
     kSame},
    {"W04", "F100/G91 G98 G81 X4 Y5 Z-0.6 R1.8 L3",
     "R0,0,1.8 R4,5,1.8 F4,5,1.2 R4,5,1.8 R8,10,1.8 F8,10,1.2 R8,10,1.8 R12,15,1.8 F12,15,1.2 "
     "R12,15,1.8",
     kSame, kSame},
    {"W05", "G90 G0 X0 Y0 Z0/G1 F10 X0 G4 P0.1/G81 X1 Y0 Z0 R1/X2/Y1 Z0.5/X1/G80/G0 X0/Z0",
     "D0.1 R0,0,1 R1,0,1 F1,0,0 R1,0,1 R2,0,1 F2,0,0 R2,0,1 R2,1,1 F2,1,0.5 R2,1,1 R1,1,1 "
     "F1,1,0.5 R1,1,1 R0,1,1 R0,1,0",
     kSame, kSame},
    {"W06", "G0 X0 Y0 Z0/F10/G91 G81 X1 Y0 Z-1 R1 L2/G90 G0 X0 Y1/Z0/G91 G81 X1 Y0 Z-0.5 R1 L2/G80",
     "R0,0,1 R1,0,1 F1,0,0 R1,0,1 R2,0,1 F2,0,0 R2,0,1 R0,1,1 R0,1,0 R0,1,1 R1,1,1 F1,1,0.5 "
     "R1,1,1 R2,1,1 F2,1,0.5 R2,1,1",
     kSame, kSame},
    {"W07",
     "G0 X0 Y0 Z0/F50/G91 G81 X1 Y0 Z-0.5 R1 L2/X0 Y1 R0 L2/X-1 Y0",
     "R0,0,1 R1,0,1 F1,0,0.5 R1,0,1 R2,0,1 F2,0,0.5 R2,0,1 R2,1,1 F2,1,0.5 R2,1,1 R2,2,1 "
     "F2,2,0.5 R2,2,1 R1,2,1 F1,2,0.5 R1,2,1",
     {9, "R2,1,0 F2,1,-0.5 R2,1,0 R2,2,0 F2,2,-0.5 R2,2,0 R1,2,0 F1,2,-0.5 R1,2,0"},
     kSame},
    {"W08", "G0 X1 Y2 Z3/G90 G98 G81 X4 Y5 Z-0.6 R1.8 F10",
     "R1,2,3 R4,5,3 R4,5,1.8 F4,5,-0.6 R4,5,3", kSame, kSame},
    {"W09",
     "F100/G0 Z10/G99 G81 X1 Z-1 R2/X2/G98 X3/X4",
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,2 R2,0,2 F2,0,-1 R2,0,2 R3,0,2 F3,0,-1 R3,0,10 R4,0,10 "
     "R4,0,2 F4,0,-1 R4,0,10",
     {9, "R3,0,10 R3,0,2 F3,0,-1 R3,0,10 R4,0,10 R4,0,2 F4,0,-1 R4,0,10"},
     {11, "R3,0,2 R4,0,2 F4,0,-1 R4,0,2"}},
    {"W10",
     "F100/G0 Z10/G99 G81 X1 Z-1 R2/G98 G82 X2 Z-1 R2 P1",
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,2 R2,0,2 F2,0,-1 D1 R2,0,10",
     {6, "R2,0,10 R2,0,2 F2,0,-1 D1 R2,0,10"},
     {9, "R2,0,2"}},
    {"W11", "F100/G0 Z10/G99 G81 X1 Z-1 R2/G80/G98 G81 X2 Z-1 R2",
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,2 R2,0,2 F2,0,-1 R2,0,2", kSame, kSame},
    {"W12",
     "F100/G0 Z10/G99 G81 X1 Z-1 R2/G4 P1/G98 X2",
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,2 D1 R2,0,2 F2,0,-1 R2,0,10",
     {7, "R2,0,10 R2,0,2 F2,0,-1 R2,0,10"},
     {9, "R2,0,2"}},
    {"W13",
     "F100/G0 Z10/G99 G81 X1 Z0 R4/X2 R8/X3 R1",
     "R0,0,10 R1,0,10 R1,0,4 F1,0,0 R1,0,4 R1,0,8 R2,0,8 F2,0,0 R2,0,8 R3,0,8 R3,0,1 F3,0,0 "
     "R3,0,1",
     {6, "R2,0,8 F2,0,0 R2,0,8 R3,0,8 R3,0,1 F3,0,0 R3,0,1"},
     kSame},
    {"W14",
     "F100/G0 Z5/G98 G81 X1 Z-1 R7/X2 R3",
     "R0,0,5 R0,0,7 R1,0,7 F1,0,-1 R1,0,7 R2,0,7 R2,0,3 F2,0,-1 R2,0,5",
     kSame,
     {9, "R2,0,7"}},
    {"W15",
     "F100/G0 Z10/G91 G99 G81 X1 Y0 Z-3 R-5/X1 Y0",
     "R0,0,10 R1,0,10 R1,0,5 F1,0,2 R1,0,5 R2,0,5 R2,0,0 F2,0,-3 R2,0,0",
     {7, "F2,0,2 R2,0,5"},
     kSame},
    {"W16", "F100/G0 Z10/G91 G98 G81 X1 Y0 Z-3 R-5/X1 Y0/X1 Y0 R-2",
     "R0,0,10 R1,0,10 R1,0,5 F1,0,2 R1,0,10 R2,0,10 R2,0,5 F2,0,2 R2,0,10 R3,0,10 R3,0,8 F3,0,5 "
     "R3,0,10",
     kSame, kSame},
    {"W17",
     "F100/G0 X1 Y2 Z10/G91 G81 X1 Z-1 R-2",
     "R1,2,10 R2,2,10 R2,2,8 F2,2,7 R2,2,8",
     kSame,
     {2, "R2,4,10 R2,4,8 F2,4,7 R2,4,8", "stale-step"}},
    {"W18", "F100/G0 Z10/G98 G81 X1 Y1 Z-3 R5 L3",
     "R0,0,10 R1,1,10 R1,1,5 F1,1,-3 R1,1,10 R1,1,5 F1,1,-3 R1,1,10 R1,1,5 F1,1,-3 R1,1,10", kSame,
     kSame},
    {"W19",
     "F100/G0 Z10/G98 G83 X1 Z-7 R2 Q3",
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,2 R1,0,-0.746 F1,0,-4 R1,0,2 R1,0,-3.746 F1,0,-7 "
     "R1,0,10",
     kSame,
     {5, "R1,0,10 R1,0,-0.746 F1,0,-4 R1,0,10 R1,0,-3.746 F1,0,-7 R1,0,10"}},
    {"W20", "F100/G98 G83 X1 Z-7 R2 Q2.5",
     "R0,0,2 R1,0,2 F1,0,-0.5 R1,0,2 R1,0,-0.246 F1,0,-3 R1,0,2 R1,0,-2.746 F1,0,-5.5 R1,0,2 "
     "R1,0,-5.246 F1,0,-7 R1,0,2",
     kSame, kSame},
    {"W21", "F100/G0 Z10/G98 G83 X1 Z-7 R2 Q20", "R0,0,10 R1,0,10 R1,0,2 F1,0,-7 R1,0,10", kSame,
     kSame},
    {"W22", "F100/G0 Z2/G99 G83 X1 Z0.625 R1 Q0.125",
     "R0,0,2 R1,0,2 R1,0,1 F1,0,0.875 R1,0,1 R1,0,1.129 F1,0,0.75 R1,0,1 R1,0,1.004 F1,0,0.625 "
     "R1,0,1",
     kSame, kSame},
    {"W23",
     "F100/G0 Z2/G99 G83 X1 Z0.7 R1 Q0.1",
     "R0,0,2 R1,0,2 R1,0,1 F1,0,0.9 R1,0,1 R1,0,1.154 F1,0,0.8 R1,0,1 R1,0,1.054 F1,0,0.7 R1,0,1",
     {12, "R1,0,0.954 F1,0,0.7 R1,0,1", "peck-binary-sum"},
     {12, "R1,0,0.954 F1,0,0.7 R1,0,1", "peck-binary-sum"}},
    // In millimetres: 0.25 inch is 6.35, 0.01 inch 0.254.
    {"W24",
     "G20 F10/G0 X1 Y1 Z1/G98 G83 X2 Z-0.5 R0.25 Q0.25",
     "R25.4,25.4,25.4 R50.8,25.4,25.4 R50.8,25.4,6.35 F50.8,25.4,0 R50.8,25.4,6.35 "
     "R50.8,25.4,0.254 F50.8,25.4,-6.35 R50.8,25.4,6.35 R50.8,25.4,-6.096 F50.8,25.4,-12.7 "
     "R50.8,25.4,25.4",
     kSame,
     {5,
      "R50.8,25.4,25.4 R50.8,25.4,0.254 F50.8,25.4,-6.35 R50.8,25.4,25.4 R50.8,25.4,-6.096 "
      "F50.8,25.4,-12.7 R50.8,25.4,25.4"}},
    {"W25", "F100/G0 Z10/G99 G83 X1 Z-1 R2 Q3/Q2 X2/X3",
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,2 R2,0,2 F2,0,0 R2,0,2 R2,0,0.254 F2,0,-1 R2,0,2 R3,0,2 "
     "F3,0,0 R3,0,2 R3,0,0.254 F3,0,-1 R3,0,2",
     kSame, kSame},
    {"W26",
     "F100/G0 Z5/G99 G73 X1 Z-4 R1 Q2.5 L2",
     "R0,0,5 R1,0,5 R1,0,1 F1,0,-1.5 R1,0,-1.246 F1,0,-4 R1,0,1 F1,0,-1.5 R1,0,-1.246 F1,0,-4 "
     "R1,0,1",
     kSame,
     {kLacks}},
    {"W27",
     "F100/G0 Z10/G98 G73 X1 Z-7 R2 Q3/X2",
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,-0.746 F1,0,-4 R1,0,-3.746 F1,0,-7 R1,0,2 R2,0,2 "
     "F2,0,-1 R2,0,-0.746 F2,0,-4 R2,0,-3.746 F2,0,-7 R2,0,2",
     {9, "R1,0,10 R2,0,10 R2,0,2 F2,0,-1 R2,0,-0.746 F2,0,-4 R2,0,-3.746 F2,0,-7 R2,0,10"},
     {kLacks}},
    {"W28", "F100/G0 Z10/G99 G82 X1 Z-1 R2 P0.5/X2/X3 P0",
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 D0.5 R1,0,2 R2,0,2 F2,0,-1 D0.5 R2,0,2 R3,0,2 F3,0,-1 R3,0,2",
     kSame, kSame},
    {"W29",
     "F100/G0 Z10/G98 G85 X1 Z-7 R2/X2",
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-7 F1,0,2 R1,0,10 R2,0,10 R2,0,2 F2,0,-7 F2,0,2 R2,0,10",
     kSame,
     {5, "F1,0,10 R2,0,10 R2,0,2 F2,0,-7 F2,0,10"}},
    {"W30", "F100/G0 Z10/G98 G89 X1 Z-7 R2 P1.5/P0.5 X3",
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-7 D1.5 F1,0,10 R3,0,10 R3,0,2 F3,0,-7 D0.5 F3,0,10", kSame,
     kSame},
    {"W31", "F100 S100 M3/G0 Z10/G98 G86 X1 Z-7 R2 P1.5/M4/X3",
     "M3 R0,0,10 R1,0,10 R1,0,2 F1,0,-7 D1.5 M5 R1,0,10 M3 M4 R3,0,10 R3,0,2 F3,0,-7 D1.5 M5 "
     "R3,0,10 M4",
     kSame, kSame},
    {"W32",
     "F100 S100 M3/G0 Z10/G98 G84 X1 Z-7 R2 P1.5",
     "M3 R0,0,10 R1,0,10 R1,0,2 F1,0,-7 M5 M4 D1.5 F1,0,10 M5 M3",
     kSame,
     {3, "alarm unused-word"}},
    {"W33",
     "F100 S100 M3/G0 Z10/G82 X1 Z-1 R2 P2/G84 X2 Z-1 R2",
     "M3 R0,0,10 R1,0,10 R1,0,2 F1,0,-1 D2 R1,0,2 R2,0,2 F2,0,-1 M5 M4 F2,0,2 M5 M3",
     {12, "D2 F2,0,2 M5 M3"},
     kSame},
    {"W34",
     "F100 S100 M4/G0 Z10/G99 G74 X1 Z-7 R2 P0.5 L2",
     "M4 R0,0,10 R1,0,10 R1,0,2 F1,0,-7 M5 M3 D0.5 F1,0,2 M5 M4 F1,0,-7 M5 M3 D0.5 F1,0,2 M5 M4",
     {3, "alarm unused-word"},
     {kLacks}},
    {"W35",
     "F100 S100 M3/G18/G0 Y10/G98 G84 X1 Z2 Y-3 R5",
     "M3 R0,10,0 R1,10,2 R1,5,2 F1,-3,2 M5 M4 F1,10,2 M5 M3",
     {5, "F-3,2,1 M5 M4 F10,2,1 M5 M3", "tap-axes-twice"},
     kSame},
    {"W36", "F100/G18/G0 Y10/G98 G81 X1 Z2 Y-3 R5/X2",
     "R0,10,0 R1,10,2 R1,5,2 F1,-3,2 R1,10,2 R2,10,2 R2,5,2 F2,-3,2 R2,10,2", kSame, kSame},
    {"W37", "F100/G19/G91 G0 X10/G99 G83 Y1 Z2 X-3 R-5 Q2 L2",
     "R10,0,0 R10,1,2 R5,1,2 F3,1,2 R5,1,2 R3.254,1,2 F2,1,2 R5,1,2 R5,2,4 F3,2,4 R5,2,4 "
     "R3.254,2,4 F2,2,4 R5,2,4",
     kSame, kSame},
    {"W38",
     "F100/G0 X10 Y20 Z10/G99 G81 X1 Z2 R5/G19 Y3 X1 R4",
     "R10,20,10 R1,20,10 R1,20,5 F1,20,2 R1,20,5 R4,20,5 R4,3,5 F1,3,5 R4,3,5",
     {6, "R4,3,5 F1,3,5 R4,3,5"},
     kSame},
    {"W39", "F100/G0 Z10/G98 G82 X1 Z-1 R2 G4 P1", "R0,0,10 D1 R1,0,10 R1,0,2 F1,0,-1 D1 R1,0,10",
     kSame, kSame},
    {"W40", "F100/G0 Z10/G81 X1 Z-1 R2/G1 X2/G81 X3 Z-1 R2",
     "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,2 F2,0,2 R3,0,2 F3,0,-1 R3,0,2", kSame, kSame},
};

// The roots and tangents are derived to the ninth decimal: sqrt(2)/2 = 0.707106781,
// sqrt(3)/2 = 0.866025404, sqrt(5) = 2.236067977, 1/sqrt(3) = 0.577350269, 44/sqrt(485) =
// 1.997937080.
#define GONOGO_DRIVE_LINE "G18 S100 M3/G0 X20 Z2/"
const Worked kThreads[] = {
    {"W41",
     GONOGO_DRIVE_LINE "G76 P2 Z-20 I-1 J0.5 K1.5",
     "M3 R20,0,2 R21,0,2 R18.5,0,2 T18.5,0,-20@2 R21,0,-20 R20.5,0,2 R18,0,2 T18,0,-20@2 "
     "R20.5,0,-20 R20,0,2 R17.5,0,2 T17.5,0,-20@2 R20,0,-20",
     kSame,
     {kLacks}},
    {"DiametersOfG7",
     "G7/G18 S100 M3/G0 X40 Z2/G76 P2 Z-20 I-2 J1 K3",
     "M3 R20,0,2 R21,0,2 R18.5,0,2 T18.5,0,-20@2 R21,0,-20 R20.5,0,2 R18,0,2 T18,0,-20@2 "
     "R20.5,0,-20 R20,0,2 R17.5,0,2 T17.5,0,-20@2 R20,0,-20",
     kSame,
     {kLacks}},
    {"W42",
     GONOGO_DRIVE_LINE "G76 P2 Z-20 I-1 J0.5 K1 R2 H1",
     "M3 R20,0,2 R20.5,0,2 R18.5,0,2 T18.5,0,-20@2 R20.5,0,-20 R20.292893219,0,2 "
     "R18.292893219,0,2 T18.292893219,0,-20@2 R20.292893219,0,-20 R20.133974596,0,2 "
     "R18.133974596,0,2 T18.133974596,0,-20@2 R20.133974596,0,-20 R20,0,2 R18,0,2 T18,0,-20@2 "
     "R20,0,-20 R20,0,2 R18,0,2 T18,0,-20@2 R20,0,-20",
     kSame,
     {kLacks}},
    {"W43",
     GONOGO_DRIVE_LINE "G76 P2 Z-20 I1 J0.5 K1 L3 E2",
     "M3 R20,0,2 R19.5,0,2 T20.5,0,2@2.236067977 T21.5,0,0@2 T21.5,0,-18@2 T20.5,0,-20@2 "
     "R19.5,0,-20 R20,0,2 T21,0,2@2.236067977 T22,0,0@2 T22,0,-18@2 T21,0,-20@2 R20,0,-20",
     kSame,
     {kLacks}},
    {"W44",
     GONOGO_DRIVE_LINE "G76 P2 Z-20 I-1 J0.5 K1 L2 E0.5",
     "M3 R20,0,2 R20.5,0,2 R18.5,0,2 T18.5,0,-19.5@2 T19.5,0,-20@4 R20.5,0,-20 R20,0,2 R18,0,2 "
     "T18,0,-19.5@2 T19,0,-20@4 R20,0,-20",
     kSame,
     {kLacks}},
    {"W45",
     GONOGO_DRIVE_LINE "G76 P2 Z-20 I-1 J0.5 K1.5 Q30",
     "M3 R20,0,2 R21,0,1.711324865 R18.5,0,1.711324865 T18.5,0,-19.422649731@2 "
     "R21,0,-19.422649731 R20.5,0,1.422649731 R18,0,1.422649731 T18,0,-19.711324865@2 "
     "R20.5,0,-19.711324865 R20,0,1.133974596 R17.5,0,1.133974596 T17.5,0,-20@2 R20,0,-20",
     kSame,
     {kLacks}},
    {"W46",
     "G18 S100 M3/G0 X20 Z-20/G76 P2 Z2 I-1 J0.5 K1 L3 E2 Q30",
     "M3 R20,0,-20 R20.5,0,-19.711324865 T19.5,0,-19.711324865@2.236067977 "
     "T18.5,0,-17.711324865@2 T18.5,0,-0.288675135@2 T19.5,0,1.711324865@2 R20.5,0,1.711324865 "
     "R20,0,-19.422649731 T19,0,-19.422649731@2.236067977 T18,0,-17.422649731@2 T18,0,0@2 "
     "T19,0,2@2 R20,0,2",
     kSame,
     {kLacks}},
    {"W47",
     "S100 M3/G0 X20 Z2/G91 G18 G76 P2 Z-20 I-1 J0.5 K1",
     "M3 R20,0,2 R20.5,0,2 R18.5,0,2 T18.5,0,-18@2 R20.5,0,-18 R20,0,2 R18,0,2 T18,0,-18@2 "
     "R20,0,-18",
     kSame,
     {kLacks}},
    {"W48", "S300 M3/G0 X3 Z4/G33 X6 Z0 K1.5", "M3 R3,0,4 T6,0,0@1.2", kSame, {kLacks}},
    {"W49",
     "S100 M3/G0 X20 Z2/G33 X21 Z-20 K2/Z-30 K1/Z-40",
     "M3 R20,0,2 T21,0,-20@1.99793708 T21,0,-30@1 alarm lead-missing",
     kSame,
     {kLacks}},
    {"W50",
     "S300 M3/G0 X3 Z4/G33.1 Z0 K1.5/G0 X5",
     "M3 R3,0,4 T3,0,0@1.5 M4 T3,0,4@1.5 M3 R5,0,4",
     kSame,
     {kLacks}},
};
#undef GONOGO_DRIVE_LINE

std::vector<std::string> split(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), {}};
}

void expect_records(const Worked& worked, const Departure& departure, const char* profile) {
  if (departure.from == kLacks) return;
  std::string program = worked.program;
  std::replace(program.begin(), program.end(), '/', '\n');
  std::vector<std::string> want = split(worked.records);
  if (departure.from != 0) {
    want.resize(departure.from - 1);
    for (const std::string& record : split(departure.records)) want.push_back(record);
  }
  EXPECT_EQ(short_form(run_ngc(program + "\nM2\n", profile, departure.fault)), want);
}

class NgcWorked : public ::testing::TestWithParam<Worked> {};

TEST_P(NgcWorked, AsDocumented) {
  expect_records(GetParam(), kSame, "{}");
}

TEST_P(NgcWorked, AsLinuxcnc) {
  expect_records(GetParam(), GetParam().linuxcnc, kAsLinuxcnc);
}

TEST_P(NgcWorked, AsNist) {
  expect_records(GetParam(), GetParam().nist, kAsNist);
}

constexpr auto kName = [](const ::testing::TestParamInfo<Worked>& worked) {
  return std::string(worked.param.name);
};
INSTANTIATE_TEST_SUITE_P(Holes, NgcWorked, ::testing::ValuesIn(kHoles), kName);
INSTANTIATE_TEST_SUITE_P(Threads, NgcWorked, ::testing::ValuesIn(kThreads), kName);

// Depths 0.7, 1.4 and 2.1; a binary sum of 0.7 falls short of 2.1.
TEST(NgcWorkedReadings, SumsOfLinuxcncInThreads) {
  const std::string program = "G18 M3\nG0 X20 Z2\nG76 P2 Z-20 I-0.5 J0.7 K2.1\n";
  const auto cuts = [&](const char* fault) {
    std::size_t count = 0;
    for (const std::string& record : run_ngc(program, "{}", fault).records) {
      if (record.starts_with("thread")) ++count;
    }
    return count;
  };
  EXPECT_EQ(cuts(""), 3u);
  EXPECT_EQ(cuts("g76-binary-sum"), 4u);  // the full depth twice
}

}  // namespace
}  // namespace gonogo::expanders::testing
