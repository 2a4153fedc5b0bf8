// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace gonogo::oracle::report {

// The bytes as raw DEFLATE (RFC 1951) in base64, for a page that unpacks them itself: nothing of it
// can end a <script>.
std::string packed(std::string_view bytes);

}  // namespace gonogo::oracle::report
