// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/ngc/faults.hpp"

#include <array>

namespace gonogo::expanders::ngc {
namespace {

// In the order of Fault.
constexpr std::array<FaultDescription, kFaults> kDescriptions{{
    {"g18-sense-flipped", "G2 and G3 change places in G18", "NGC-ARC-01",
     "plane taken as (X, Z), seen from -Y"},
    {"g3-clockwise", "G3 turns clockwise", "NGC-ARC-01",
     "sense of the first code of the group for both"},
    {"radius-sign-ignored", "R < 0 gives the arc below 180 degrees", "NGC-ARC-04",
     "absolute value taken before the sign is read"},
    {"radius-centre-left", "with R the centre of G2 lies on the side of G3", "NGC-ARC-04",
     "sense left out of the formula of the centre"},
    {"short-radius-forgiven", "an R below half the chord gives half a turn", "NGC-ARC-04",
     "negative value under the root set to 0"},
    {"offsets-absolute", "I J K are absolute under G91.1", "NGC-DIS-01",
     "default of another maker"},
    {"absolute-centre-ignored", "G90.1 is accepted and I J K stay incremental", "NGC-DIS-01",
     "decimals of the code cut off before it is looked up"},
    {"g18-offsets-swapped", "in G18 I and K change places", "NGC-ARC-02",
     "offsets stored in the order of X, Z"},
    {"full-circle-dropped", "an arc that ends where it begins is no motion", "NGC-ARC-02",
     "angle from 0 to below 360 degrees"},
    {"end-point-unchecked", "every end is accepted", "NGC-ARC-03", "check forgotten"},
    {"end-point-equality-refused", "a difference of just the tolerance is refused", "NGC-ARC-03",
     ">= written for >"},
    {"inch-tolerance-millimetres", "the tolerance under G20 is that of G21", "NGC-ARC-03",
     "constant not converted"},
    {"end-onto-circle", "the end is moved onto the circle of the start", "NGC-ARC-03",
     "radius computed once for the whole arc"},
    {"helix-flat", "the third axis does not move in an arc", "NGC-ARC-05",
     "two-axis interpolation"},
    {"helix-z-in-g18", "in G18 the Y word moves Z", "NGC-ARC-05",
     "third axis of every plane taken as Z"},
    {"arc-rotary-dropped", "A and C do not move in an arc", "NGC-ARC-05",
     "interpolation of three axes"},
    {"turns-ignored", "P of an arc is ignored", "NGC-ARC-05", "word read by another code only"},
    {"turn-extra", "P gives a turn too many", "NGC-ARC-05",
     "P taken as the count of additional turns"},
    {"turns-unchecked", "P0 and P1.5 count as one turn", "NGC-ARC-05",
     "conversion to an integer instead of a check"},
    {"whole-limit-refused", "a number that is just the limit beside a whole one is refused",
     "NGC-COM-01", ">= written for >"},
    {"near-whole-cut", "a number just below a whole one counts as the one before", "NGC-COM-01",
     "cut off after the check, not rounded"},
    {"code-limit-unscaled", "a G code may be as far beside a whole one as an M function",
     "NGC-COM-01", "code not multiplied by ten for the check"},
    {"g91-ignored-after-g90", "G91 has no effect once there was a G90", "NGC-DIS-01",
     "mode latched by its first code"},
    {"inch-feed-unscaled", "F is not converted from inches", "NGC-UNI-01", "factor 25.4 missing"},
    {"inch-offsets-unscaled", "I J K are not converted from inches", "NGC-UNI-01",
     "conversion of axis words only"},
    {"inch-rotary-scaled", "A and C are converted from inches", "NGC-UNI-01",
     "one conversion for all axes"},
    {"rotary-feed-scaled", "degrees a minute are converted from inches", "NGC-UNI-01",
     "feed converted before the axes are known"},
    {"g80-keeps-motion", "after G80 the motion code stays in force", "NGC-MOD-01",
     "G80 ends canned cycles only"},
    {"motion-lost-after-dwell", "G4 ends the motion code in force", "NGC-MOD-01",
     "G4 stored in the motion group"},
    {"feed-after-motion", "F holds from the next block on", "NGC-MOD-01",
     "words taken in the order of the line"},
    {"plane-after-motion", "a plane code holds from the next block on", "NGC-MOD-01",
     "plane taken after the motion"},
    {"dwell-in-milliseconds", "P of G4 is taken as milliseconds", "NGC-G4-01",
     "unit of another maker's dwell"},
    {"block-delete-always", "lines with / are always left out", "NGC-COM-01",
     "switch not looked at"},
    {"capitals-only", "small letters are refused", "NGC-COM-01", "table of capitals only"},
    {"tape-mark-ignored", "the second % does not end the program", "NGC-COM-01",
     "tape marks skipped by the reader"},
    {"end-ignored", "blocks after M2 and M30 are run", "NGC-COM-01", "end taken as a stop"},
    {"alarm-next-block", "alarms name the block after", "NGC-COM-01",
     "alarm raised with the look-ahead block number"},
    {"cr-lf-counted-twice", "CR LF counts as two lines", "NGC-COM-01",
     "each of the two characters ends a line"},
    {"feed-survives-reset", "F of the program before is still in force", "NGC-COM-01",
     "reset clears the modal codes but not the feed"},
}};

}  // namespace

std::span<const FaultDescription> fault_descriptions() {
  return kDescriptions;
}

}  // namespace gonogo::expanders::ngc
