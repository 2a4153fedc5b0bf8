// SPDX-License-Identifier: GPL-3.0-or-later
//
// X=AC(10) and X=IC(10): read as the other of the two, as the mode in force says, or where a word
// has neither.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "fuzz/identify/variant.hpp"
#include "grammar/byte_set.hpp"

namespace gonogo::identify {
namespace {

// X=AC(10) read as X=10, as the mode in force says; or as the other of the two. No addresses: in
// every word.
void add_brackets(const std::set<std::string>& addresses, Variants& out) {
  const std::string of = addresses.empty() ? "" : fmt::format(" of {}", fmt::join(addresses, " "));
  for (const std::string_view name : {"AC", "IC"}) {
    for (const std::string_view instead : {"", "AC", "IC"}) {
      if (name == instead) continue;
      add_edit(
          instead.empty() ? fmt::format("{}{} is ignored", name, of)
                          : fmt::format("{}{} does what {} does", name, of, instead),
          [=](const TextBlock&, const TextWord& word) -> std::optional<std::string> {
            std::string text = word.text;
            std::ranges::transform(text, text.begin(), grammar::capital_of);
            const std::size_t at = text.find(fmt::format("{}(", name));
            const bool is_meant = addresses.empty() || addresses.contains(name_of(word));
            if (!is_meant || at == std::string::npos) return std::nullopt;
            return text.replace(at, name.size(), instead);
          },
          out);
    }
  }
}

// X10 read as X=AC(10) or X=IC(10) while the mode in force says otherwise.
void add_read_as(const std::set<std::string>& addresses, const Descriptor& table, Variants& out) {
  for (const auto mode : {Setting::absolute, Setting::incremental}) {
    const bool is_incremental = mode == Setting::incremental;
    for (const std::string_view name : {"AC", "IC"}) {
      add_edit(
          fmt::format("{} is taken as {} under {}", fmt::join(addresses, " "), name,
                      table.find(mode)->name),
          [=](const TextBlock& block, const TextWord& word) -> std::optional<std::string> {
            const std::string own = name_of(word);
            const bool is_meant =
                addresses.contains(own) && word.text.find('(') == std::string::npos;
            if (!is_meant || block.modes.incremental != is_incremental) return std::nullopt;
            const bool has_sign = word.text.size() > own.size() && word.text[own.size()] == '=';
            return fmt::format("{}={}({})", own, name,
                               word.text.substr(own.size() + (has_sign ? 1 : 0)));
          },
          out);
    }
  }
}

}  // namespace

void add_bracket_variants(const Observation& departure, Variants& out) {
  if (!departure.profile.dialect.starts_with("sinumerik")) return;
  const Descriptor& table = *ProgramText(departure.profile, departure.program).table;
  add_brackets({}, out);
  for (const std::set<std::string>& kin : kin_addresses(table)) {
    if (kin.empty()) continue;
    add_brackets(kin, out);
    add_read_as(kin, table, out);
  }
}

}  // namespace gonogo::identify
