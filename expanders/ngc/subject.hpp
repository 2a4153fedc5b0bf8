// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "expanders/ngc/faults.hpp"
#include "gonogo/subject.h"

namespace gonogo::expanders::ngc {

/// The expander with one planted fault or Fault::kNone, behind the C interface.
const gonogo_subject_v1& subject(Fault fault);

/// How often runs of this process have met the fault.
FaultCount count(Fault fault);

}  // namespace gonogo::expanders::ngc
