// SPDX-License-Identifier: GPL-3.0-or-later
//
// Mistakes that need the reference's own motions: centres counted from the zero point, coordinates
// rounded, motions left out.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "fuzz/identify/variant.hpp"

namespace gonogo::identify {

namespace {

// A place to which polar words lead has no decimal; nobody sees a billionth of a millimetre.
Number writable(const Number& place) {
  return place.is_rational() ? place : half_up(place, 9);
}

std::optional<ChangedRun> absolute_centres(const Observation& seen) {
  const ProgramText program(seen.profile, seen.program);
  const auto paths = paths_of(seen, program.blocks.size());
  if (paths.empty()) return std::nullopt;
  const auto from_zero = [&](const TextBlock& block,
                             const TextWord& word) -> std::optional<std::string> {
    const std::string name = name_of(word);
    const std::size_t which = std::string_view("IJK").find(name);
    const auto written = exact_value_of(word);
    const bool is_centre = block.modes.is_of(Kind::arc) && name.size() == 1 && which <= 2 &&
                           !block.modes.absolute_centre;
    if (!is_centre || !written) return std::nullopt;
    const auto line = static_cast<std::size_t>(&block - program.blocks.data()) + 1;
    const Number start = writable(paths[line].start[reference::kLinearAxes[which]]);
    return with_value(word, *written - (block.modes.inch ? start * 5 / 127 : start));
  };
  return with_program(seen, edited(program, from_zero));
}

Number half_up_steps(const Number& steps) {
  return (steps + Number(1) / 2).floor();
}

Number half_to_even_steps(const Number& steps) {
  const Number near = half_up_steps(steps);
  const bool is_half = near - steps == Number(1) / 2;
  const bool is_odd = (near / 2).floor() * 2 != near;
  return is_half && is_odd ? near - 1 : near;
}

// Steps of a grid to a whole number of them.
struct Rounding {
  std::string_view name;
  Number (*whole)(const Number& steps);
};
constexpr std::array<Rounding, 7> kRoundings = {{
    {"half up", half_up_steps},
    {"half away from zero",
     [](const Number& n) { return n.sign() < 0 ? -half_up_steps(-n) : half_up_steps(n); }},
    {"half to even", half_to_even_steps},
    {"down", [](const Number& n) { return n.floor(); }},
    {"up", [](const Number& n) { return n.ceil(); }},
    {"toward zero", [](const Number& n) { return n.sign() < 0 ? n.ceil() : n.floor(); }},
    {"away from zero", [](const Number& n) { return n.sign() < 0 ? n.floor() : n.ceil(); }},
}};

bool round_all(KeptOutcome& model, const Number& grid, const Rounding& rounding) {
  bool changed = false;
  for (Record& record : model.records) {
    for (const Axis axis : reference::kLinearAxes) {
      const Number value = rounding.whole(record.to[axis] / grid) * grid;
      changed = changed || value != record.to[axis];
      record.to[axis] = value;
    }
    for (Number& centre : record.centre) centre = rounding.whole(centre / grid) * grid;
  }
  return changed;
}

void add_roundings(Variants& out) {
  for (const int places : {4, 3, 2, 1}) {
    Number grid = 1;
    for (int i = 0; i < places; ++i) grid = grid / 10;
    for (const Rounding& rounding : kRoundings) {
      add_model(
          fmt::format("coordinates are rounded {} to {} mm", rounding.name, grid.text()),
          [grid, &rounding](const Observation&, KeptOutcome& model) {
            return round_all(model, grid, rounding);
          },
          out);
    }
  }
}

// Leaves out the motion at this place of each block of the code that has several; negative places
// count from the last one.
bool leave_out(const Observation& seen, KeptOutcome& model, const Motions& motions, int place) {
  const ProgramText program(seen.profile, seen.program);
  std::vector<Record> kept;
  for (std::size_t begin = 0; begin < model.records.size();) {
    const std::uint64_t block = model.records[begin].block;
    std::size_t end = begin + 1;
    while (end < model.records.size() && model.records[end].block == block &&
           is_motion(model.records[end].kind) == is_motion(model.records[begin].kind)) {
      ++end;
    }
    const auto at = static_cast<std::ptrdiff_t>(place >= 0 ? begin : end) + place;
    const bool ours =
        is_of(program, block, motions) && is_motion(model.records[begin].kind) && end - begin > 1;
    for (std::size_t i = begin; i < end; ++i) {
      if (!ours || static_cast<std::ptrdiff_t>(i) != at) kept.push_back(model.records[i]);
    }
    begin = end;
  }
  const bool changed = kept.size() != model.records.size();
  model.records = std::move(kept);
  return changed;
}

// Leaves out the dwells of the codes.
bool go_without_dwells(const Observation& seen, KeptOutcome& model, const Motions& motions) {
  const ProgramText program(seen.profile, seen.program);
  return std::erase_if(model.records, [&](const Record& record) {
           return record.kind == RecordKind::dwell && is_of(program, record.block, motions);
         }) > 0;
}

// The program alarms in this line, and puts out nothing from it on.
void alarm_in(KeptOutcome& model, std::uint64_t line, const char* alarm_class) {
  std::erase_if(model.records, [&](const Record& record) { return record.block >= line; });
  model.end.kind = oracle::RunEnd::Kind::alarm;
  model.end.alarm.block = line;
  model.end.alarm.alarm_class = alarm_class;
}

// Everything from the first line with a small letter on is an alarm.
bool refuse_small_letters(const Observation& seen, KeptOutcome& model) {
  const ProgramText program(seen.profile, seen.program);
  for (std::size_t i = 0; i < program.blocks.size(); ++i) {
    const TextBlock& block = program.blocks[i];
    const bool small = std::ranges::any_of(block.words, [](const TextWord& word) {
      return !is_comment(word) &&
             std::ranges::any_of(word.text, [](char c) { return c >= 'a' && c <= 'z'; });
    });
    if (!small) continue;
    alarm_in(model, i + 1, "syntax");
    return true;
  }
  return false;
}

// The first block that runs a cycle and takes the word from a block before it; 0: there is none.
std::uint64_t first_without(const ProgramText& program, const std::string& address) {
  bool was_given = false;
  for (std::size_t i = 0; i < program.blocks.size(); ++i) {
    const TextBlock& block = program.blocks[i];
    if (!block.modes.in_cycle()) {
      was_given = was_given && block.modes.code() == nullptr;
      continue;
    }
    if (block.modes.code()->find(address) == nullptr) continue;
    const bool runs = std::ranges::any_of(block.words, [&](const TextWord& word) {
      const CodeWord* const role = block.modes.code()->find(name_of(word));
      return role != nullptr && (role->role == Role::place || role->role == Role::way);
    });
    if (block.find(address) != nullptr) {
      was_given = true;
    } else if (was_given && runs) {
      return i + 1;
    }
  }
  return 0;
}

// A word that a cycle retains is asked for again: the block that lacks it is an alarm.
bool ask_again(const Observation& seen, KeptOutcome& model, const std::string& address) {
  const ProgramText program(seen.profile, seen.program);
  const std::uint64_t line = first_without(program, address);
  const bool is_over =
      model.end.kind == oracle::RunEnd::Kind::alarm && model.end.alarm.block < line;
  if (line == 0 || is_over) return false;
  alarm_in(model, line, "missing-word");
  return true;
}

// Words that a cycle of the program takes.
std::set<std::string> words_of_cycles(const ProgramText& program) {
  std::set<std::string> addresses;
  for (const TextBlock& block : program.blocks) {
    if (!block.modes.in_cycle()) continue;
    for (const TextWord& word : block.words) {
      const std::string name = name_of(word);
      if (is_word(word) && block.modes.code()->find(name) != nullptr) addresses.insert(name);
    }
  }
  return addresses;
}

void add_asked_again(const Observation& departure, Variants& out) {
  if (departure.verdict.kind != oracle::VerdictKind::fail_alarm_spurious) return;
  const ProgramText program(departure.profile, departure.program);
  for (const std::string& address : words_of_cycles(program)) {
    add_model(
        fmt::format("{} has to stand in every block of a cycle", address),
        [=](const Observation& seen, KeptOutcome& model) {
          return ask_again(seen, model, address);
        },
        out);
  }
}

void add_left_out(const Motions& motions, Variants& out) {
  add_model(
      fmt::format("the dwells of {} are left out", names_of(motions)),
      [=](const Observation& seen, KeptOutcome& model) {
        return go_without_dwells(seen, model, motions);
      },
      out);
  for (const auto& [name, place] :
       {std::pair("first", 0), std::pair("last", -1), std::pair("last but one", -2)}) {
    add_model(
        fmt::format("the {} motion of {} is left out", name, names_of(motions)),
        [=](const Observation& seen, KeptOutcome& model) {
          return leave_out(seen, model, motions, place);
        },
        out);
  }
}

// An arc that ends where it begins is ignored.
bool drop_full_circles(const Observation& seen, KeptOutcome& model) {
  Position at = seen.profile.initial.at;
  std::vector<Record> kept;
  for (Record& record : model.records) {
    bool moves = record.kind != RecordKind::arc || record.rot > 1 || record.rot < -1;
    for (const Axis axis : reference::kAllAxes) {
      if (!record.axes.has(axis)) continue;
      moves = moves || record.to[axis] != at[axis];
      at[axis] = record.to[axis];
    }
    if (moves) kept.push_back(record);
  }
  const bool changed = kept.size() != model.records.size();
  model.records = std::move(kept);
  return changed;
}

}  // namespace

void add_model_variants(const Observation& departure, Variants& out) {
  out.push_back({"I J K are taken as absolute", absolute_centres});
  add_step_variants(departure, out);
  add_model("an arc that ends where it begins is no motion", drop_full_circles, out);
  add_model("small letters are refused", refuse_small_letters, out);
  add_asked_again(departure, out);
  add_roundings(out);
  for (const Motions& motions : motions_concerned(departure)) add_left_out(motions, out);
}

}  // namespace gonogo::identify
