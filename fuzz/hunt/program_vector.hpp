// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "fuzz/generate/generator.hpp"
#include "corpus/io/corpus.hpp"

namespace gonogo::hunt {

// The program as a case without id, group, comment and provenance, of the cycle `cycle` ("hunt"):
// with the features that it needs, the clauses that it comes by (at least one), and what the
// reference expects under every combination of the readings that are open. May throw
// exact::Undecided.
oracle::Case vector_of(const generate::GeneratedProgram& program, std::string_view cycle);

}  // namespace gonogo::hunt
