// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the documents of LinuxCNC say of threads; the interpreter of NIST has none.
#pragma once

#include <array>

#include "reference/catalog/clause.hpp"

namespace gonogo::reference::catalog::rs274 {

inline constexpr std::string_view kSynchronous =
    "LinuxCNC 2.9, G codes: G33 and G33.1, motion in step with the spindle";
inline constexpr std::string_view kThreading = "LinuxCNC 2.9, G codes: G76, threading cycle";

inline constexpr auto kThreadClauses = std::to_array<Clause>({
    {"NGC-G33-01", must, kSynchronous,
     "G33 is a straight motion to the point, K along it for each turn of the spindle. One axis "
     "word at least is needed.",
     "reference/rs274/synchronous.cpp"},
    {"NGC-G33-02", must, kSynchronous,
     "K is needed in every block, also in one that repeats the motion.",
     "reference/rs274/synchronous.cpp"},
    {"NGC-G33-03", must, kSynchronous, "F in its block is an alarm; no feed needs to be in force.",
     "reference/rs274/synchronous.cpp"},
    {"NGC-G33-04", must, kSynchronous, "The spindle has to turn.",
     "reference/rs274/synchronous.cpp"},
    {"NGC-G33-05", open, kSynchronous, "K is above zero.", "reference/rs274/synchronous.cpp"},
    {"NGC-G33-06", derived, kSynchronous,
     "G33 is modal, of the group of motions: it ends a series of cycles. K is its only word that "
     "not all motions have; with a rotary axis the gauge does not read it.",
     "reference/rs274/synchronous.cpp"},
    {"NGC-G331-01", must, kSynchronous,
     "G33.1 goes in step with the spindle to the point, which then turns the other way, and back; "
     "then it turns as before. Its words are those of G33.",
     "reference/rs274/g33_1.cpp"},
    {"NGC-G331-02", derived, kSynchronous,
     "Each reversal is passed on as the M function of the sense that begins.",
     "reference/rs274/g33_1.cpp"},
    {"NGC-G331-03", derived, kSynchronous,
     "I, the speed on the way back as a multiple, changes no path.", "reference/rs274/g33_1.cpp"},
    {"NGC-G76-01", must, kThreading, "G76 needs P, the lead, I, J, K and Z, in every block.",
     "reference/rs274/thread_words.cpp"},
    {"NGC-G76-02", must, kThreading,
     "It runs in G18 alone; X, Y and rotary axes are no words of it.",
     "reference/rs274/thread_words.cpp"},
    {"NGC-G76-03", must, kThreading,
     "P and J are above zero, K is above J, I is not zero, R not below 1, H a whole number not "
     "below zero, L 0 to 3, E not below zero, and with a taper not above half of the length.",
     "reference/rs274/thread_words.cpp"},
    {"NGC-G76-04", must, kThreading, "The spindle has to turn.",
     "reference/rs274/thread_words.cpp"},
    {"NGC-G76-05", must, kThreading,
     "Pass n cuts J times the R-th root of n deep, counted from the peak, while that is less than "
     "K; then come 1 + H passes at K. The gauge reads an R that is a fraction of whole numbers up "
     "to 10000, and follows up to 10000 passes.",
     "reference/rs274/thread_passes.hpp"},
    {"NGC-G76-06", must, kThreading,
     "A pass is cut at I and its depth beside the drive line, inside where I is above zero, with "
     "the lead P along Z.",
     "reference/rs274/thread_passes.hpp"},
    {"NGC-G76-07", derived, kThreading,
     "A pass begins and ends as far from its cut as I and K together: with a part of the depth "
     "beyond the drive line by what is left of it.",
     "reference/rs274/thread_passes.hpp"},
    {"NGC-G76-08", open, kThreading,
     "With Q a pass begins later by its depth times tan Q, and ends earlier by what is left of the "
     "depth times tan Q: the full pass ends at Z.",
     "reference/rs274/thread_passes.hpp"},
    {"NGC-G76-09", must, kThreading,
     "A pass begins with a traverse beside its start and another one in to the cut; with a taper "
     "at the start (L 1 or 3, E) in by I, and along the taper to the cut.",
     "reference/rs274/thread_passes.cpp"},
    {"NGC-G76-10", must, kThreading,
     "The cut ends at the end of the pass; with a taper at the end (L 2 or 3, E) that leads from E "
     "before it out by K.",
     "reference/rs274/thread_passes.cpp"},
    {"NGC-G76-11", must, kThreading, "Along a taper Z goes P for each turn of the spindle.",
     "reference/rs274/thread_passes.cpp"},
    {"NGC-G76-12", must, kThreading,
     "After a pass a traverse along X out of the thread; after the last one to the drive line at "
     "Z.",
     "reference/rs274/thread_passes.cpp"},
    {"NGC-G76-13", derived, kThreading,
     "No feed is needed. A block that repeats G76 needs the same words.",
     "reference/rs274/g76.cpp"},
    {"NGC-G76-14", derived, kThreading,
     "Under G20 lengths are inches; R, H and L are numbers, Q is degrees.",
     "reference/rs274/g76.cpp"},
});

}  // namespace gonogo::reference::catalog::rs274
