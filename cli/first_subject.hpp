// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "oracle/campaign/campaign.hpp"

namespace gonogo::cli {

// Gives `first` out once, to whichever worker asks first, and then what `maker` makes: a subject
// that has said who it is need not be started again to run its first case.
oracle::SubjectMaker beginning_with(std::unique_ptr<oracle::Subject> first,
                                    oracle::SubjectMaker maker);

}  // namespace gonogo::cli
