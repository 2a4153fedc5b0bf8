// SPDX-License-Identifier: GPL-3.0-or-later
//
// The way to a reference point: by the point of the words or not, in the axes of the words or in
// all. A word that says "stand still" takes an axis along without a point to go by.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "fuzz/identify/variant.hpp"

namespace gonogo::identify {
namespace {

// The place along an axis and the way along it, in dialects that have both.
struct AxisWords {
  Axis axis;
  std::string_view place;
  std::string_view way;
};
constexpr std::array<AxisWords, 5> kAxisWords = {{{Axis::x, "X", "U"},
                                                  {Axis::y, "Y", "V"},
                                                  {Axis::z, "Z", "W"},
                                                  {Axis::a, "A", ""},
                                                  {Axis::c, "C", "H"}}};

bool is_named(const TextBlock& block, const AxisWords& words) {
  return block.find(words.place) != nullptr || block.find(words.way) != nullptr;
}

// What names the axis and does not move it: a way of nothing, or the place where it is.
std::string still_word(const TextBlock& block, const AxisWords& words, const Position& at) {
  if (block.modes.own->find(words.way) != nullptr) return fmt::format("{}0", words.way);
  if (block.modes.incremental) return fmt::format("{}0", words.place);
  Number place = at[words.axis];
  if (block.modes.inch && is_linear(words.axis)) place = place * 5 / 127;
  if (words.axis == Axis::x && !block.modes.x_radius) place = place * 2;
  return fmt::format("{}{}", words.place, place.text());
}

// The blocks that one of the codes takes to a reference point, with what is written for a word of
// an axis that they name, and for one that they do not.
class HomeWays {
 public:
  HomeWays(const Observation& seen, const Motions& codes)
      : program_(seen.profile, seen.program),
        paths_(paths_of(seen, program_.blocks.size())),
        codes_(codes) {}

  bool are_known() const { return !paths_.empty(); }
  // The axes of the words go straight to the reference point.
  std::optional<std::string> without_point() const {
    return edited(program_, [&](const TextBlock& block, const TextWord& word) {
      std::optional<std::string> text;
      for (const AxisWords& words : kAxisWords) {
        const bool is_its = name_of(word) == words.place || name_of(word) == words.way;
        if (is_its && is_meant(block)) text = still_word(block, words, start_of(block));
      }
      return text;
    });
  }
  // The other axes go there, too.
  std::optional<std::string> with_all_axes() const {
    return edited_in_order(program_, [&](const TextBlock& block) {
      std::string more;
      for (const AxisWords& words : kAxisWords) {
        const bool is_wanted = is_meant(block) && block.modes.own->find(words.place) != nullptr &&
                               !is_named(block, words);
        if (is_wanted) more += " " + still_word(block, words, start_of(block));
      }
      return more;
    });
  }
  // A block without such words goes nowhere.
  std::optional<std::string> with_words_alone() const {
    return without_words(program_, [&](const TextBlock& block, const TextWord& word) {
      const bool goes = std::ranges::any_of(
          kAxisWords, [&](const AxisWords& words) { return is_named(block, words); });
      return !goes && is_meant(block) && codes_.contains(block.code_of(word));
    });
  }

 private:
  bool is_meant(const TextBlock& block) const { return codes_.contains(block.modes.code_name()); }
  const Position& start_of(const TextBlock& block) const {
    return paths_[static_cast<std::size_t>(&block - program_.blocks.data()) + 1].start;
  }

  ProgramText program_;
  std::vector<BlockPath> paths_;
  const Motions& codes_;
};

using HomeChange = std::optional<std::string> (HomeWays::*)() const;

void add_home_way(std::string name, const Motions& codes, HomeChange change, Variants& out) {
  out.push_back({std::move(name), [codes, change](const Observation& seen) {
                   const HomeWays ways(seen, codes);
                   return with_program(seen, ways.are_known() ? (ways.*change)() : std::nullopt);
                 }});
}

}  // namespace

void add_reference_point_variants(const Observation& departure, Variants& out) {
  const ProgramText program(departure.profile, departure.program);
  Motions all;
  Motions present;
  for (const Code& code : program.table->codes) {
    if (code.kind != Kind::reference_point || code.find("X") == nullptr) continue;
    all.emplace(code.name);
    const bool stands = std::ranges::any_of(
        program.blocks, [&](const TextBlock& block) { return block.has_code(code.name); });
    if (stands) present.emplace(code.name);
  }
  if (present.empty()) return;
  std::vector<Motions> sets;
  for (const std::string& code : present) sets.push_back({code});
  if (all.size() > 1) sets.push_back(all);
  for (const Motions& codes : sets) {
    const std::string names = names_of(codes);
    add_home_way(names + " leaves out the point of its words", codes, &HomeWays::without_point,
                 out);
    add_home_way(names + " takes all axes to the reference point", codes, &HomeWays::with_all_axes,
                 out);
    add_home_way(names + " without a word of an axis moves none", codes,
                 &HomeWays::with_words_alone, out);
  }
}

}  // namespace gonogo::identify
