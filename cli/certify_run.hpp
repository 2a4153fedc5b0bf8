// SPDX-License-Identifier: GPL-3.0-or-later
//
// `gonogo certify` of one subject, from its first start to report and certificate.
#pragma once

#include <string>

#include "cli/certify_options.hpp"

namespace gonogo::cli {

// Its exit code. `report` is the folder that gets the results. Throws UsageError, OutputError.
int certify_one(CertifyOptions options, const std::string& subject, const std::string& report);

}  // namespace gonogo::cli
