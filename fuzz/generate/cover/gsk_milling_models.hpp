// SPDX-License-Identifier: GPL-3.0-or-later
//
// Models of the GSK 988TA's milling cycles G110 to G117.
#pragma once

#include "fuzz/generate/cover/model.hpp"

namespace gonogo::cover {

Model gsk_g110_model();
Model gsk_g112_model();
Model gsk_g114_model();

}  // namespace gonogo::cover
