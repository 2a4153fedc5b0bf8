// SPDX-License-Identifier: GPL-3.0-or-later
//
// A shared library that is a subject.
#pragma once

#include <string>

#include "gonogo/subject.h"

namespace gonogo::oracle {

// Loads the library into this process and asks it for the C interface. Throws SubjectUnusable with
// what to do. A library stays loaded for the life of the process: its description and its threads
// may outlive every handle.
const gonogo_subject_v1& load_library(const std::string& path);

// The absolute path of a file that can be read. Throws SubjectUnusable with what to do.
std::string library_path(const std::string& path);

}  // namespace gonogo::oracle
