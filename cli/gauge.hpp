// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which gauge this is, for results and certificates.
#pragma once

#include <string>

namespace gonogo::cli {

// The commit of the checkout that it was built from; "unknown" where there was none.
std::string gauge_commit();
// SHA-256 of this program's own file; empty when it cannot be read.
std::string gauge_sha256();

}  // namespace gonogo::cli
