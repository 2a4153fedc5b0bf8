// SPDX-License-Identifier: GPL-3.0-or-later
//
// Subjects as the command line names them, "<kind>:<rest>", and the files that belong to one: what
// it is known to fail, and what its alarms mean.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "campaign/known_failures.hpp"
#include "oracle/differential/subject.hpp"

namespace gonogo::cli {

// How to make the subject, again and again (one a job). Throws UsageError for what is no subject.
oracle::SubjectMaker subject_maker(const std::string& spec, const oracle::Limits& limits);
// Gives `first` to the worker that asks first, and then what `maker` makes: a subject that has
// described itself need not be started again to run its first case.
oracle::SubjectMaker beginning_with(std::unique_ptr<oracle::Subject> first,
                                    oracle::SubjectMaker maker);
// The dialects that the subject names in its description.
std::vector<std::string> declared_dialects(const oracle::SubjectMaker& maker);

// Both throw UsageError, with the file and what is wrong in it.
std::vector<oracle::KnownFailure> load_known_failures(const std::string& file);
std::vector<oracle::KnownCause> load_known_causes(const std::string& file);
// Null: no file is named.
std::shared_ptr<const oracle::AlarmMap> load_alarm_map(const std::string& file);

// The subject with its own alarms under the names of the gauge; null: they have these already.
std::unique_ptr<oracle::Subject> with_alarm_map(std::unique_ptr<oracle::Subject> subject,
                                                std::shared_ptr<const oracle::AlarmMap> alarms);

}  // namespace gonogo::cli
