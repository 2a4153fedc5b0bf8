// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "publish/evidence/verify.hpp"

namespace gonogo::cli {

// Runs the campaign of a certificate again, with the files and options that the certificate names,
// and compares. Throws UsageError when that cannot be done.
std::vector<oracle::evidence::Check> run_again(const std::string& certificate,
                                               const std::string& corpus,
                                               const std::string& subject);

}  // namespace gonogo::cli
