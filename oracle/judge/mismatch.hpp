// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the subject departs: what is said of the first motion, dwell or end that no hypothesis
// explains, and how far off it is.
#pragma once

#include "oracle/judge/alignment.hpp"
#include "oracle/region/constants.hpp"

namespace gonogo::oracle {

// The verdict on what was refuted, if it has one or nothing can be said of its path. Nothing: it is
// NO-GO, and `explain` says of which kind.
std::optional<Verdict> known_verdict(const Refutation& refutation, const Tolerances& tolerances);
// The verdict on a motion that departs from a curve. Looks ahead in the reference.
Verdict explain(const Refutation& refutation, ReferenceSteps& steps, const Tolerances& tolerances);

// J-CMP-12: for the motion that the subject has left unfinished. REQUIRES: a piece of it.
Verdict short_of(const Hypothesis& from, const Tolerances& tolerances);
// X, Y and Z, and the rotary axes that are not at zero.
std::string place_text(const Position& at);
// How far a motion is off: linear axes in mm, rotary ones in degrees, in the message.
void tell_distance(Verdict& verdict, const Number& distance, const Position& got,
                   const Position& want, const Number& tolerance);
// Adds to the message how far a rotary axis is off.
void tell_degrees(Verdict& verdict, Axis rotary, const Position& got, const Position& want);
// The trace ends, or alarms (`got`), where a step is due.
Verdict ends_early(const Hypothesis& from, const ReferenceStep& step, std::size_t records,
                   const std::string& got, const Tolerances& tolerances);

// In undue.cpp. A motion where none is due: before a renaming of the position; before a dwell, in
// an earlier block than an alarm, or behind the end; before an M function.
Verdict before_renaming(const Motion& motion, const ReferenceSteps::Step& step,
                        const Tolerances& tolerances);
Verdict motion_too_many(const Motion& motion, const ReferenceSteps::Step& step,
                        const Tolerances& tolerances);
Verdict motion_for_m_function(const DueMFunction& due, const Motion& motion,
                              const ReferenceSteps::Step& step, const Tolerances& tolerances);
Verdict m_function_for_dwell(const ReferenceStep& due, const Record& got, std::size_t number);

// R5. Whether the dwell is the one that is due; and what is said of one that is not.
bool is_dwell_due(const ReferenceStep& step, const Record& dwell, const Tolerances& tolerances);
Verdict wrong_dwell(const Record& dwell, std::size_t number, const Hypothesis& from,
                    ReferenceSteps& steps, const Tolerances& tolerances);

// How far a number of the subject's may be from what it computed.
Number rounding_of_number(const Number& number, const std::optional<Number>& resolution,
                          const Tolerances& tolerances);

// What is not judged, and why.
GapReason reason_of(const reference::NotCovered& outside);
Verdict not_covered_verdict(const reference::NotCovered& outside);

// J-ALM-03: makes the departure an advice where no text states its clause and the certifier is not
// strict; else leaves it. REQUIRES: it is the other answer to the clause's question. Nothing else
// is an advice.
Verdict advised(Verdict departure, const Tolerances& tolerances);
// R7: an arc with a centre that a control computes itself, off by no more than twice the
// tolerance, and its end where it should be.
std::optional<Verdict> coarse_centre_advice(const CurveAnswer& answer, const Motion& motion,
                                            const Motion& want, const Tolerances& tolerances);

}  // namespace gonogo::oracle
