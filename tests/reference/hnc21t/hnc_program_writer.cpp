// SPDX-License-Identifier: GPL-3.0-or-later
//
// One program as text, in any of its writings.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ostream>
#include <stdexcept>

#include "hnc_program.hpp"

namespace gonogo::reference::testing::hnc {
namespace {

// HNC-MOD-01: what is modal within a command, of the words that the programs hold.
std::string_view retained_addresses(int code) {
  switch (code) {
    case 32:
      return "FJ";
    case 74:
      return "RQF";
    case 75:
      return "RQIPF";
    case 80:
      return "IF";
    case 81:
      return "KF";
    case 82:
      return "IRECPFJQ";
    default:
      return "";
  }
}

class Writer {
 public:
  Writer(const Program& program, const Writing& writing)
      : program_(program), writing_(writing), stand_(stand_at_start(program)) {
    Words head = {{'G', writing.lengths == Lengths::inch ? "20" : "21"}};
    if (writing.by_code) head.push_back({'G', writing.diameter ? "36" : "37"});
    if (writing.ends == Ends::g91) head.push_back({'G', "91"});
    if (writing.names_g54 || program.reads("hnc.offset.initial", "none")) {
      head.push_back({'G', "54"});
    }
    lines_.push_back(std::move(head));
    for (const Block& block : program.blocks) put(block);
  }
  std::vector<Words> take() { return std::move(lines_); }

 private:
  std::string number(std::int64_t count, bool is_length) const {
    const bool converted = is_length && writing_.lengths == Lengths::inch_in_mm;
    const std::int64_t value = std::abs(converted ? count * 254 : count);
    const std::int64_t one = converted ? 10'000 : 1'000;
    return fmt::format("{}{}.{:0{}}", count < 0 ? "-" : "", value / one, value % one,
                       converted ? 4 : 3);
  }

  // Readings that let a word of X count as a diameter.
  bool is_doubled(int code, char address) const {
    if (!writing_.diameter) return false;
    if (code == 82) return address == 'E' && program_.reads("hnc.g82.e-scale", "diameter");
    if (code != 75 || !program_.reads("hnc.g75.depth-scale", "diameter")) return false;
    return address == 'R' || address == 'Q';
  }

  Word word(int code, const Given& given) const {
    if (given.address == 'J' && writing_.j_as_f) {
      const std::int64_t value = given.count * 254;
      return {'F', fmt::format("{}.{:04}", value / 10'000, value % 10'000)};
    }
    const std::int64_t count = is_doubled(code, given.address) ? 2 * given.count : given.count;
    if (given.measure == Measure::number && count % 1'000 == 0) {
      return {given.address, fmt::format("{}", count / 1'000)};
    }
    const bool is_length = given.measure == Measure::lead ? program_.reads("hnc.lead.unit", "units")
                                                          : given.measure != Measure::number;
    return {given.address, number(count, is_length)};
  }

  Word axis_word(const Block& block, std::size_t axis) const {
    const bool by_letter =
        writing_.ends == Ends::letters || (writing_.ends == Ends::mixed && axis == 1);
    // The words of G92 are absolute under G91.
    const bool from_here = by_letter || (writing_.ends == Ends::g91 && block.code != 92);
    std::int64_t value = block.end[axis];
    if (from_here) value -= stand_.work()[axis];
    if (axis == 0 && writing_.diameter) value *= 2;
    return {(by_letter ? "UW" : "XZ")[axis], number(value, true)};
  }

  void put(const Block& block) {
    const bool entry = is_motion(block.code) && block.code != code_;
    if (entry) retained_.clear();
    const bool repeats = !entry && block.code >= 32 && is_motion(block.code);
    const bool spelled_out = repeats && writing_.repeats != Repeats::as_given;
    if (spelled_out && writing_.repeats == Repeats::entered_anew) lines_.push_back({{'G', "0"}});
    for (const Given& given : block.words) latch(block.code, given);
    Words words;
    if (!is_motion(block.code) || entry || block.code_stands || spelled_out) {
      words.push_back({'G', fmt::format("{}", block.code)});
    }
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (block.named[axis]) words.push_back(axis_word(block, axis));
    }
    for (const Given& given : block.words) words.push_back(word(block.code, given));
    if (spelled_out) add_retained(block, words);
    lines_.push_back(std::move(words));
    if (is_motion(block.code)) code_ = block.code;
    stand_ = after(program_, block, stand_);
  }

  void latch(int code, const Given& given) {
    if (retained_addresses(code).find(given.address) == std::string_view::npos) return;
    const bool threads = code == 82 || code == 32;
    std::erase_if(retained_, [&](const Given& old) {
      // HNC-G82-08: of F and J a later one replaces the other.
      if (threads && given.address == 'F' && old.address == 'J') return true;
      if (threads && given.address == 'J' && old.address == 'F') return true;
      return old.address == given.address;
    });
    retained_.push_back(given);
  }

  void add_retained(const Block& block, Words& words) const {
    for (const Given& given : retained_) {
      // HNC-G75-05: the number of steps needs its width.
      const bool is_count = block.code == 75 && given.measure == Measure::number;
      if (is_count && !block.named[1]) continue;
      const bool stands =
          std::any_of(block.words.begin(), block.words.end(),
                      [&](const Given& one) { return one.address == given.address; });
      if (!stands) words.push_back(word(block.code, given));
    }
  }

  const Program& program_;
  Writing writing_;
  Stand stand_;
  int code_ = 0;
  std::vector<Given> retained_;
  std::vector<Words> lines_;
};

}  // namespace

std::vector<Words> write(const Program& program, const Writing& writing) {
  return Writer(program, writing).take();
}

Profile machine(const Program& program, const Writing& writing) {
  Profile profile = std::get<Profile>(default_profile("hnc21t"));
  // Where G36 or G37 is written, it is the other one that holds at power-on.
  profile.x_diameter = writing.diameter != writing.by_code;
  const Number one = Number(writing.lengths == Lengths::mm ? 1'000 : 25'400) / 1'000'000;
  const auto set = [&](Position& position, const Place& place) {
    position[Axis::x] = Number(place[0]) * one;
    position[Axis::z] = Number(place[1]) * one;
  };
  set(profile.initial.at, program.start);
  for (std::size_t i = 0; i < program.offsets.size(); ++i) {
    set(profile.offsets[fmt::format("G{}", 54 + i)], program.offsets[i]);
  }
  for (const auto& [name, value] : program.readings) {
    if (auto error = set_reading(profile, name, value)) throw std::invalid_argument(error->message);
  }
  return profile;
}

void operator<<(std::ostream& out, const Program& program) {
  out << profile_json(machine(program, {})) << '\n' << text(write(program, {}));
}

}  // namespace gonogo::reference::testing::hnc
