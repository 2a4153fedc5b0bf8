// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "campaign/campaign.hpp"

namespace gonogo::cli {

// Gives `first` to the worker that asks first, and then what `maker` makes: a subject that has
// described itself need not be started again to run its first case.
oracle::SubjectMaker beginning_with(std::unique_ptr<oracle::Subject> first,
                                    oracle::SubjectMaker maker);

}  // namespace gonogo::cli
