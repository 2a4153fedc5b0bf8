// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether what a vector expects can be at all: a path without gaps, arcs that are arcs, feeds above
// zero, source lines that are there, readings that exclude each other.
#pragma once

#include <string>
#include <vector>

#include "checker/corpus.hpp"

namespace gonogo::checker {

struct Coherence {
  std::vector<std::string> faults;     // sentences
  std::vector<std::string> undecided;  // what could not be decided, and why
  std::size_t enclosed_arcs = 0;       // their radii are equal within their enclosures
};

Coherence coherence_of(const Vector& vector);

}  // namespace gonogo::checker
