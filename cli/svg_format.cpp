// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/svg_format.hpp"

#include "oracle/report/sheet.hpp"

namespace gonogo::cli {
