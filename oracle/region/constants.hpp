// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every number that decides or bounds something in the judge and its regions: above each its unit,
// what it does, and the rules that it serves. docs/judging.md prints them; a test holds the two
// together, and sees that no other file of these folders has such a number of its own.
#pragma once

#include <cstddef>

namespace gonogo::oracle {

// What doubles may be off by: nearer to a limit than that a number decides nothing.

// mm, turns or radians | heights, radii and angles that are estimated; nearer to a limit it is
// undecided | R2, R8
inline constexpr double kEstimate = 1e-7;
// turns | the sweep of an arc, in a sum of them; within the sum of these it is undecided | R2, R8
inline constexpr double kLost = 1e-12;
// mm | a place of a region beside a border; pieces no longer are not halved | R8
inline constexpr double kBeside = 1e-9;
// mm | a place so near to a band may lie on its border; less than a place beside it | R8
inline constexpr double kUnsure = 1e-11;
// mm, or of a length | what is shorter is left to exact numbers, the band of such a line to the
// discs about its ends; the least progress | R2, R8, J-CYC-02
inline constexpr double kShort = 1e-6;
// mm | half the side of the windows in which exact sets decide | R8
inline constexpr double kWindow = 1e-5;
// - | nearly all of a length or a turn, for bounds and messages | R8
inline constexpr double kAlmost = 0.999;
// turns | tells whole turns apart; three of them a ring from a link, half of one a chord that turns
// back | R2, R8, J-PKT-06
inline constexpr double kQuarterTurn = 0.25;
// turns | a filter: ends that are seen farther apart than this, or so far from a whole turn, are no
// one place | R2
inline constexpr double kTenthOfTurn = 0.1;
// roundings | the same filter: the least distance of an end from the centre | R2
inline constexpr double kFarOff = 20;

// Bits behind the point of what stands for numbers that are no fractions.

// bits | of a double; two units in its last place are 2^-52 of the power of two above it | R3
inline constexpr int kUlpBits = 52;
// bits | of estimates | -
inline constexpr int kEstimateBits = 60;
// bits | beyond which a sign is not looked for | R2
inline constexpr int kSignBits = 100;
// bits | of rationals that stand for places of threads, helices and frames | R8
inline constexpr int kRationalBits = 80;
// bits | to which the sign of a sum of doubles is certain | -
inline constexpr int kSureBits = 48;
// bits | of rationals that stand for the points of a circle in space | R2
inline constexpr int kSpaceBits = 512;
// bits | of the middle of such a circle's part | R2
inline constexpr int kMiddleBits = 30;
// bits | of rationals that stand for places of a level and for its direction; the slack says so |
// R8
inline constexpr int kShortBits = 45;
// bits | of directions that bound exact sets | R8
inline constexpr int kHairBits = 40;
// bits | of directions of which any will do | R8
inline constexpr int kCoarseBits = 12;

// Multiples of the tolerance and of other lengths.

// eighths of a resolution | the tolerance of arcs that a control rounds: 3/sqrt(2) and a little |
// R2
inline constexpr int kRoundingEighths = 17;
// tolerances | places that far apart may be one: two of them, each off on two axes | R8, J-PKT-05
inline constexpr int kTwoPlaces = 3;
// tolerances | what is shorter shows no direction; a place that is new is so far from others | R2,
// J-CYC-02
inline constexpr int kNoDirection = 4;
// tolerances | nearer to the middle of a pocket, or shorter, nothing turns | J-PKT-06
inline constexpr int kBlur = 8;
// of the tool's radius | motions no longer, along the border of a pocket, are taken together, and
// no farther may the path lead back along it | J-PKT-06
inline constexpr int kSmallOfTool = 4;
// of a step | rings that are no farther apart are one | J-CYC-02
inline constexpr int kRingsOfStep = 100;
// of a tolerance | moves of a level that are less are rounding; an arc through the axes by less is
// flat | R8
inline constexpr int kRoundingOfTolerance = 1'000;
// millionths of a tolerance | sqrt(2), rounded up: how far a point off on two axes lies beyond a
// circle | R8
inline constexpr int kDiagonal = 1'414'220;
// of a coordinate or number | a text asks after a unit only where rounding is less | -
inline constexpr int kFewestParts = 100;
// degrees | between the points of a round motion among which its witness is looked for | J-CMP-12
inline constexpr int kWitnessDegrees = 45;

// Caps. Beyond those of R9 the answer is undecided, with `cap-...` for its reason.

// times | as many records as the reference without progress, as often one motion of a level, and
// its way | J-CYC-02, R8
inline constexpr std::size_t kMostTimes = 10;
// records | without progress on top of that | J-CYC-02
inline constexpr std::size_t kMostIdle = 1'000;
// records | of a pass of a thread, for the budget of records | J-CYC-02
inline constexpr std::size_t kRecordsOfPass = 4;
// places | of a step that are new | J-CYC-02
inline constexpr std::size_t kMostPlaces = 200'000;
// motions | of a level, an entry or a run-out | R9
inline constexpr std::size_t kMostMotions = 50'000;
// ways | under open readings that are followed at once, those that have departed not counted | R9
inline constexpr std::size_t kMaximumAssignments = 64;
// lengths | that a subject shows of an open length, in a program | J-READ-02
inline constexpr std::size_t kMostLengths = 16;
// records | that are kept for a way that forks later | -
inline constexpr std::size_t kMostParts = 4'096;
// records | judged again to name a reading | -
inline constexpr std::size_t kMostRecordsAgain = 4'000'000;
// records | what expanding a program again counts for in that | -
inline constexpr std::size_t kExpansion = 1'000;
// items | of a block or a program, which may have no end, that are looked at for readings and
// alarms | R9
inline constexpr std::size_t kMostItems = 10'000'000;
// items | of a program, which may have no end, that are looked at for readings to show | -
inline constexpr std::size_t kMostShown = 200'000;
// letters | of a word that cannot be read, back from the fault | R6
inline constexpr std::size_t kMostCuts = 32;
// hypotheses | ways to read a trace at once; motions among which one as small is looked for | R9
inline constexpr std::size_t kMostHypotheses = 128;
// motions | in a row that are too small to see | R9
inline constexpr std::size_t kMostSmall = 100'000;
// ways | along one curve at once | R9
inline constexpr std::size_t kMostWays = 64;
// places | where a helix may have begun | R9
inline constexpr std::size_t kMostStarts = 1'000;
// steps | ahead in which a text looks for what came too early | -
inline constexpr std::size_t kLookAhead = 200;
// parts | of an arc on which its clearance is looked for | R9
inline constexpr int kMostStretches = 20'000;
// bands | of a level that the tool clears | R9
inline constexpr std::size_t kMaximumBands = 400'000;
// pieces | of borders and ways, for each band or motion | R9
inline constexpr std::size_t kPiecesPerUnit = 400;
// pieces | on top of these | R9
inline constexpr std::size_t kPiecesOnTop = 100'000;
// spots | left to exact sets, corners of what they leave, steps towards a witness | R9
inline constexpr std::size_t kMostSpots = 400;
// tries | for a witness, and corners of a hole that are looked at | R9
inline constexpr std::size_t kMostTries = 24;
// shapes | in one exact decision | R9
inline constexpr std::size_t kMostShapes = 2'000;
// halvings | in a proof of the order of a level | R9
inline constexpr int kMostHalvings = 40;
// levels | that are kept with their verdicts | -
inline constexpr std::size_t kLevelsKept = 16;
// motions | of all levels that are kept; the last one is always kept | -
inline constexpr std::size_t kMostMotionsKept = 32'000;
// cells | of a grid along an axis | -
inline constexpr int kMostCells = 1'024;
// of the tolerance | parts into which a spiral's radius is cut, first and again | R8
inline constexpr double kSpiralCuts[] = {8, 128};
// times | as wide are the parts of a spiral that has too many | R8
inline constexpr double kWiderCut = 8;
// places | along an axis by which a floor is measured | J-PKT-10
inline constexpr int kPlacesAcross = 40;
// pieces | of a motion by which its way is measured | J-PKT-10
inline constexpr int kPiecesOfWay = 64;
// s | a sampled motion that lasts no longer may be all speeding up and slowing down | J-RUN-11
inline constexpr double kLongestRamp = 5;
// s | for which a machine may stand at the place of a dwell beyond what is due | J-RUN-11
inline constexpr double kLongestStand = 10;

}  // namespace gonogo::oracle
