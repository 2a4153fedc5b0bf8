// SPDX-License-Identifier: GPL-3.0-or-later
//
// Models of steps one after the other, where they do not stand with the cycles of their dialect.
#pragma once

#include "fuzz/generate/cover/model.hpp"

namespace gonogo::cover {

Model hnc_sequence_model();
Model sinumerik840d_sequence_model();

}  // namespace gonogo::cover
