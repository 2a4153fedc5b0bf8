// SPDX-License-Identifier: GPL-3.0-or-later
//
// A library as a subject: it runs in a process of its own, `gonogo host LIBRARY`, so that a
// crash, a hang, its memory and its exit() are the library's alone.
#pragma once

#include "subjects/make_subject.hpp"

namespace gonogo::oracle {

// Loads the library in a process and lets it describe itself. `program` is the gonogo program.
// Throws SubjectUnusable with what to do.
void check_library(const std::string& path, const Limits& limits, const std::string& program);

std::unique_ptr<Subject> make_library_subject(const std::string& path, const Limits& limits,
                                              const std::string& program);

}  // namespace gonogo::oracle
