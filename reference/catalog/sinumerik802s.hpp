// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the SINUMERIK 802S has beside the path commands: frames, LCYC82 and LCYC75.
#pragma once

#include <array>

#include "reference/catalog/clause.hpp"

namespace gonogo::reference::catalog::sinumerik {

inline constexpr std::string_view kFrames = "SINUMERIK 802S, programming: G158, G258, G259";
inline constexpr std::string_view kDrilling = "SINUMERIK 802S, cycles: LCYC82";
inline constexpr std::string_view kPockets = "SINUMERIK 802S, cycles: LCYC75";

using enum ClauseLevel;
inline constexpr auto kCycleClauses = std::to_array<Clause>({
    {"SIE-FRM-01", derived, kFrames,
     "G158 is a programmable translation; alone it clears translation and rotation. Whether one "
     "with values replaces both before it, replaces the translation alone, or is added to them is "
     "open: the maker's third example of LCYC75 comes back to its start only where it is added.",
     "reference/sinumerik/frame.cpp"},
    {"SIE-FRM-02", derived, kFrames,
     "G258 RPL= is a rotation, G259 RPL= one added to that in force, about the shifted zero; "
     "positive from the first axis of the plane toward the second.",
     "reference/sinumerik/frame.cpp"},
    {"SIE-FRM-03", derived, kFrames,
     "An '=' is due between RPL and its angle; the maker's own example writes RPL45 without it.",
     "reference/sinumerik/frame.cpp"},
    {"SIE-FRM-04", derived, kFrames,
     "Codes of frames stand alone and move nothing: an axis not named afterwards stays where the "
     "tool is. G158 and G258 replace translation and rotation. What a frame makes of a pole that "
     "was put before it, and what G53 leaves out of one, is open and not read.",
     "reference/sinumerik/frame.cpp"},
    {"SIE-FRM-06", derived, kFrames,
     "Whether an increment behind another translation goes its number alone, or that and what the "
     "translation has moved along its axis, is open.",
     "reference/sinumerik/polar.cpp"},
    {"SIE-LC82-01", derived, kDrilling,
     "LCYC82 drills where the tool stands: traverse to R103 + R102, feed to R104, dwell of R105 "
     "seconds, traverse to R101.",
     "reference/sinumerik/lcyc82.cpp"},
    {"SIE-LC82-02", derived, kDrilling, "R101 is not below R103, and R104 is below R103.",
     "reference/sinumerik/cycle.cpp"},
    {"SIE-LC82-03", derived, kDrilling,
     "A feed is in force. A cycle leaves the motion code and the plane as they were, and LCYC82 F, "
     "too.",
     "reference/sinumerik/lcyc82.cpp"},
    {"SIE-LC75-01", must, kPockets,
     "LCYC75 mills the pocket about R116, R117, R118 long and R119 wide with corners of R120, from "
     "the reference plane R103 to R104, by infeeds of at most R121.",
     "reference/sinumerik/lcyc75.cpp"},
    {"SIE-LC75-02", must, kPockets,
     "A width of twice the corner radius is a slot; a length of that as well is a circular pocket.",
     "reference/sinumerik/lcyc75.cpp"},
    {"SIE-LC75-03", must, kPockets, "It needs a tool in force and a spindle that turns.",
     "reference/sinumerik/lcyc75_rules.cpp"},
    {"SIE-LC75-04", must, kPockets,
     "Roughing: traverse to the centre at R101 and to R103 + R102; at every level feed R122 down "
     "at "
     "the centre and clear it at feed R123 as R126 says; back to R101 at the centre.",
     "reference/sinumerik/lcyc75.cpp"},
    {"SIE-LC75-05", must, kPockets,
     "Roughing ends at R104 + R125, and no infeed is deeper than R121.",
     "reference/sinumerik/lcyc75_levels.cpp"},
    {"SIE-LC75-06", derived, kPockets,
     "How the depth is divided is open: equal infeeds, or whole ones and a rest, from the "
     "reference "
     "plane or from the clearance above it.",
     "reference/sinumerik/lcyc75_levels.cpp"},
    {"SIE-LC75-07", must, kPockets,
     "Finishing takes the contour alone when R124 is above zero and R125 is zero: the floor is "
     "then "
     "not milled. Else it takes contour and floor; its last level is R104.",
     "reference/sinumerik/lcyc75.cpp"},
    {"SIE-LC75-08", derived, kPockets,
     "Roughing clears the rectangle inset by R124, finishing the programmed one; a tool larger "
     "than "
     "the corner leaves larger corners. The tool fits between the walls; equality passes.",
     "reference/sinumerik/lcyc75_rules.cpp"},
    {"SIE-LC75-09", derived, kPockets,
     "The parameters of LCYC75 have ranges. What R126=0 means, which the maker's second example "
     "has, and whether R124 has its limit in finishing, too, is open.",
     "reference/sinumerik/lcyc75_rules.cpp"},
    {"SIE-LC75-10", derived, kPockets,
     "R118 lies along the first axis of the plane, R119 along the second. Roughing clears what the "
     "tool can reach of the inset rectangle; finishing clears the strip up to the contour at every "
     "level, and the whole floor at R104.",
     "reference/sinumerik/lcyc75_path.cpp"},
    {"SIE-LC75-11", must, kPockets,
     "Finishing: only the last infeed is at the centre with R122; earlier ones may be fast and "
     "anywhere in the rough pocket.",
     "reference/sinumerik/lcyc75.cpp"},
    {"SIE-LC75-12", derived, kPockets,
     "The pass along the border of what the tool can reach goes round the centre clockwise (R126 = "
     "2) or counterclockwise (3); no other motion has a direction.",
     "reference/sinumerik/lcyc75_path.cpp"},
    {"SIE-LC75-13", derived, kPockets,
     "The approach to R101 is one traverse from any height; on the way down of finishing, between "
     "levels and at the end the tool travels freely and at any speed in what is cleared, never "
     "above R101, and it ends at the centre at R101.",
     "reference/sinumerik/lcyc75.cpp"},
    {"SIE-LC75-14", derived, kPockets,
     "Whether the feed in force behind LCYC75 is F of before or R123, mm/min or mm/rev, is open.",
     "reference/sinumerik/basic_motion.cpp"},
});

}  // namespace gonogo::reference::catalog::sinumerik
