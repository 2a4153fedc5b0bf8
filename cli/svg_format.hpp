// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/formats.hpp"

namespace gonogo::cli {

// `named_block`: the line whose cycle has its points and planes named; 0: the first cycle.
std::unique_ptr<RecordFormat> make_svg_format(const reference::Profile& profile,
                                              std::string_view program_name,
                                              std::uint64_t named_block);

}  // namespace gonogo::cli
