// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs to begin with, some for each dialect; none alarms.
'use strict';

const kExamples = {
  gsk988ta: [
    { name: 'G94: a face, a shoulder and two tapers', program: 'G00 X130 Z5 M3 S500;\nG94 X0 Z0 F200;\nX120 Z-110 F300;\nG00 X120 Z0;\nG94 X108 Z-30 R-10;\nX60 R-50;\nM30;\n' },
    { name: 'G92: two passes of a thread', program: 'G00 X36 Z5 M3 S300\nG92 X29.2 Z-40 F2\nX28.6\nG00 X100 Z50\nM30\n' },
    { name: 'G110: a pocket in two layers', program: 'G17 G00 X30 Y14 Z9\nG110 X20 Y10 W-4 R-3 I10 L4 Q2 P0.5 D3 F200\n' },
  ],
  hnc21t: [
    { name: 'G82: a thread with a run-out', program: 'G00 X35 Z5\nG82 X29 Z-40 R-4 E2 F1.5\nX28 Z-40\nM30\n' },
    { name: 'G74: a hole in three pecks', program: 'G00 X10 Z5\nG74 Z-17 R3 Q8 F50\nM30\n' },
  ],
  rs274: [
    { name: 'G83 and G73: holes in pecks', program: 'G0 X0 Z6 F100\nG98 G83 X10 Z-7 R2 Q3\nG73 X30 Z-7 R2 Q3\nM2\n' },
    { name: 'G76: a thread in several passes', program: 'G18 S100 M3\nG0 X20 Z2\nG76 P2 Z-20 I-1 J1 K2.5 R1.5 H1 Q29.5 L2 E3\nM2\n' },
  ],
  sinumerik840d: [
    { name: 'A helix of two whole turns and a half', program: 'S500 M3\nG0 X20 Y0 Z0\nG3 X-20 Y0 Z-15 I-20 J0 TURN=2 F200\nG0 Z5\nM30\n' },
    { name: 'A hexagon\'s corners about a pole', program: 'S500 M3\nG111 X30 Y20\nG0 AP=0 RP=15\nG1 AP=60 F200\nAP=IC(60)\nAP=180\nG3 AP=300 RP=15\nM30\n' },
  ],
  sinumerik802s: [
    { name: 'LCYC75: a pocket in two levels', program: 'G0 X8 Y5 Z14 S400 M3 T1 D1\nR101=10 R102=2 R103=0 R104=-8 R116=0 R117=0\nR118=50 R119=36 R120=8 R121=4 R122=100 R123=300\nR124=0 R125=0 R126=2 R127=1\nLCYC75\nM30\n', profile: 'tools = {"1" = {radius = "5"}}' },
    { name: 'LCYC82: two holes with a dwell', program: 'S400 M3\nR101=10 R102=2 R103=0 R104=-12 R105=0.5\nG0 X15 Y10 Z20 F100\nLCYC82\nG0 X40\nLCYC82\nM30\n' },
  ],
};
