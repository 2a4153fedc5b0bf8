// SPDX-License-Identifier: GPL-3.0-or-later
//
// The words by which a subject declares what it has.
#pragma once

#include <span>
#include <string_view>

namespace gonogo::oracle {

struct Feature {
  std::string_view dialect;  // "" for features of every subject
  std::string_view name;
  std::string_view text;
};

std::span<const Feature> feature_vocabulary();

}  // namespace gonogo::oracle
