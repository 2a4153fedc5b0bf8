// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether a planted fault was reached and triggered, apart from the method that is measured: the
// same expander without the fault runs the programs that reach it, until two answers differ.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "fuzz/hunt/trial.hpp"

namespace gonogo::hunt {

// How far the programs so far have got with one fault.
struct Witness {
  // How often the line of the fault ran in this process; null: not known, so that every program
  // counts as one that reaches it.
  std::function<std::uint64_t()> reached_count;
  bool is_reached = false;    // the line of the fault ran
  bool is_triggered = false;  // an answer differs from that of the expander without the fault
  double seconds = 0;         // of processor time, that the witness itself took
};

// Makes the subjects of `make`, each run of which the witness records. `control` makes the
// expander without the fault.
SubjectMaker witnessed(SubjectMaker make, SubjectMaker control, std::shared_ptr<Witness> witness);

// Seconds of processor time of this process: others may use the machine meanwhile.
double processor_seconds();

}  // namespace gonogo::hunt
