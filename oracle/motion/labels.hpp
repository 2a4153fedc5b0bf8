// SPDX-License-Identifier: GPL-3.0-or-later
//
// R3. The numbers of a record beside its places: feed, lead, start angle, dwell. The functions
// throw exact::Undecided where the width of an enclosure decides.
#pragma once

#include <optional>

#include "oracle/motion/motion.hpp"
#include "oracle/motion/tolerances.hpp"

namespace gonogo::oracle {

// Whether a number of the subject's is the exact one, or as far off as rounding makes it.
// `resolution`: what is declared of such numbers.
bool stands_for(const Number& got, const Number& exact, const std::optional<Number>& resolution,
                const Tolerances& tolerances);

// Compares two cutting motions.
bool feeds_agree(const Record& want, const Record& got, const Tolerances& tolerances);
bool feeds_agree(const Number& want, reference::FeedMode mode, const Record& got,
                 const Tolerances& tolerances);
// Compares two threads; angles a whole turn apart are the same.
bool leads_agree(const Record& want, const Record& got, const Tolerances& tolerances);
bool start_angles_agree(const Record& want, const Record& got, const Tolerances& tolerances);
// Compares two dwells.
bool times_agree(const Record& want, const Record& got, const Tolerances& tolerances);
// R3: whether a dwell of no time, which is no event, stands for the dwell when that is rounded.
bool may_be_no_dwell(const Record& dwell, const Tolerances& tolerances);

}  // namespace gonogo::oracle
