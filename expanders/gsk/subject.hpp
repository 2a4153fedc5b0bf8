// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "expanders/faults.hpp"
#include "gonogo/subject.h"

namespace gonogo::expanders::gsk {

/// The expander with one planted fault or none, behind the C interface.
const gonogo_subject_v1& subject(Fault fault);

}  // namespace gonogo::expanders::gsk
