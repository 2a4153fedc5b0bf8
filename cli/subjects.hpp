// SPDX-License-Identifier: GPL-3.0-or-later
//
// Subjects as the command line names them: "<kind>:<rest>".
#pragma once

#include <string>
#include <vector>

#include "campaign/campaign.hpp"

namespace gonogo::cli {

// How to make the subject, again and again (one a job). Throws UsageError for what is no subject.
oracle::SubjectMaker subject_maker(const std::string& spec, const oracle::Limits& limits);
// The dialects that the subject names in its description.
std::vector<std::string> declared_dialects(const oracle::SubjectMaker& maker);

}  // namespace gonogo::cli
