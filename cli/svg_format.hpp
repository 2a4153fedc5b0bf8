// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/formats.hpp"

namespace gonogo::cli {

std::unique_ptr<RecordFormat> make_svg_format(const reference::Profile& profile,
                                              std::string_view program_name);

}  // namespace gonogo::cli
