// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/registry.hpp"

#include <array>

#include "expanders/gsk/faults.hpp"
#include "expanders/gsk/subject.hpp"

namespace gonogo::expanders {

std::span<const std::string_view> names() {
  static constexpr std::array<std::string_view, 1> kNames = {"gsk"};
  return kNames;
}

const gonogo_subject_v1* find(std::string_view name, std::string_view fault) {
  if (name != "gsk") return nullptr;
  if (fault.empty()) return &gsk::subject(gsk::Fault::kNone);
  const std::span<const FaultDescription> known = gsk::fault_descriptions();
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (known[i].name == fault) return &gsk::subject(gsk::fault_at(i));
  }
  return nullptr;
}

std::span<const FaultDescription> faults(std::string_view name) {
  if (name == "gsk") return gsk::fault_descriptions();
  return {};
}

}  // namespace gonogo::expanders
