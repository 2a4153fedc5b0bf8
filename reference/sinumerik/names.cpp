// SPDX-License-Identifier: GPL-3.0-or-later
//
// SIE-MOD-02: names that the gauge ignores, and names of the control that it does not read.
#include "reference/sinumerik/names.hpp"

#include <algorithm>
#include <string_view>

#include "reference/sinumerik/descriptor.hpp"

namespace gonogo::reference::sinumerik {
namespace {

// What a name that the table does not have stands for.
constexpr std::string_view kOtherAxis = "axis <n>";
constexpr std::string_view kOtherSpindle = "spindle <n>";
constexpr std::string_view kOtherAddress = "address <n>";
constexpr std::string_view kOwnName = "name <n>";

}  // namespace

const Code* find_name(Control control, const grammar::NamedWord& word) {
  const Descriptor& known = control == Control::sinumerik802s ? kDescriptor802s : kDescriptor840d;
  if (word.index) {
    if (word.name == "S" || word.name == "M" || word.name == "T") return known.find(kOtherSpindle);
    constexpr std::string_view kAxisLetters = "ABCUVWXYZ";
    const bool is_axis =
        word.name.size() == 1 && kAxisLetters.find(word.name[0]) != std::string_view::npos;
    return known.find(is_axis ? kOtherAxis : kOtherAddress);
  }
  if (const Code* const listed = known.find(word.name)) return listed;
  // Names beginning with LCYC and a number are the maker's, of its own cycles; of others the
  // machine decides.
  const std::string_view behind =
      std::string_view(word.name).substr(std::min<std::size_t>(4, word.name.size()));
  const bool is_own_cycle = word.name.starts_with("LCYC") && !behind.empty() &&
                            behind.find_first_not_of("0123456789") == std::string_view::npos;
  return is_own_cycle || word.name.size() == 1 ? nullptr : known.find(kOwnName);
}

std::string written_name(const grammar::NamedWord& word) {
  return word.index ? word.name + std::to_string(*word.index) : word.name;
}

}  // namespace gonogo::reference::sinumerik
