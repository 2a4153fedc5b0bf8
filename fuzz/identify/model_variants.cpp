// SPDX-License-Identifier: GPL-3.0-or-later
//
// Mistakes that need the reference's own motions: centres counted from the zero point, sums in
// binary floating point, coordinates rounded, motions left out.
#include <fmt/format.h>

#include <algorithm>

#include "fuzz/identify/variant.hpp"
#include "reference/dialect.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::identify {

using reference::Axis;
using reference::Number;
using reference::Position;
using reference::RecordKind;

namespace {

// A place to which polar words lead has no decimal; nobody sees a billionth of a millimetre.
Number writable(const Number& place) {
  return place.is_rational() ? place : half_up(place, 9);
}

std::optional<ChangedRun> absolute_centres(const Observation& seen) {
  const ProgramText program(seen.profile, seen.program);
  const auto paths = paths_of(seen, program.blocks.size());
  if (paths.empty()) return std::nullopt;
  auto text = edited(
      program, [&](const TextBlock& block, const TextWord& word) -> std::optional<std::string> {
        const std::string name = name_of(word);
        const std::size_t which = std::string_view("IJK").find(name);
        const auto written = exact_value_of(word);
        const bool is_centre = block.modes.is_of(reference::Kind::arc) && name.size() == 1 &&
                               which <= 2 && !block.modes.absolute_centre;
        if (!is_centre || !written) return std::nullopt;
        const auto line = static_cast<std::size_t>(&block - program.blocks.data()) + 1;
        const Number start = writable(paths[line].start[reference::kLinearAxes[which]]);
        return with_value(word, *written - (block.modes.inch ? start * 5 / 127 : start));
      });
  if (!text) return std::nullopt;
  return ChangedRun{std::move(*text), seen.profile, seen.outcome, std::nullopt};
}

// How a loop goes down: by `first`, then by `step` again and again.
struct Steps {
  Number first;
  Number step;
};

// How many steps a loop makes until it has gone `depth`.
using StepCount = std::int64_t (*)(const Steps& steps, const Number& depth);

constexpr std::int64_t kMostSteps = 1'000'000;

// Until a sum reaches the depth. A model of a subject: the one place where floating point is meant.
template <typename Float>
std::int64_t summed_steps(const Steps& steps, const Number& depth) {
  const auto as_float = [](const Number& number) {
    return static_cast<Float>(std::stod(number.decimal_text(12)));
  };
  const Float step = as_float(steps.step);
  const Float end = as_float(depth);
  Float sum = 0;
  std::int64_t count = 0;
  while (sum < end && count < kMostSteps) {
    sum += count == 0 ? as_float(steps.first) : step;
    ++count;
  }
  return count;
}

std::int64_t whole_quotient_and_one(const Steps& steps, const Number& depth) {
  return ((depth - steps.first) / steps.step).floor().to_int64().value_or(0) + 2;
}

std::int64_t exact_count(const Steps& steps, const Number& depth) {
  const Number after_first = (depth - steps.first) / steps.step;
  return after_first.sign() <= 0 ? 1 : after_first.ceil().to_int64().value_or(0) + 1;
}

Number in_mm(const TextBlock& block, const Number& written) {
  return block.modes.inch ? written * 127 / 5 : written;
}

// The withdrawal of HNC's pecks in force in a line: the last R up to it.
Number withdrawal_at(const ProgramText& program, std::size_t line) {
  Number withdrawal;
  for (std::size_t i = 0; i < line; ++i) {
    const TextBlock& block = program.blocks[i];
    for (const TextWord& word : block.words) {
      const reference::CodeWord* const role = block.role_of(word, *program.table);
      const bool is_withdrawal = role != nullptr && role->role == reference::Role::size;
      const auto written = is_withdrawal ? exact_value_of(word) : std::nullopt;
      if (written) withdrawal = in_mm(block, *written);
    }
  }
  return withdrawal;
}

// Under hnc.peck.from = withdrawn a peck after the first goes on from where it was withdrawn to.
Steps steps_of(const Observation& seen, const ProgramText& program, std::size_t line,
               const Number& infeed) {
  const bool net = seen.profile.dialect == "hnc21t" &&
                   seen.profile.readings.is("hnc.peck.from=withdrawn"_reading);
  return {infeed, net ? infeed - withdrawal_at(program, line) : infeed};
}

// From where the first cut along one axis begins to the farthest point along it.
std::optional<Number> depth_of(const BlockPath& path) {
  Position at = path.start;
  std::optional<Axis> axis;
  Number from;
  Number depth;
  for (const Record& record : path.records) {
    for (const Axis candidate : reference::kLinearAxes) {
      if (!record.axes.has(candidate)) continue;
      const bool moves = record.to[candidate] != at[candidate];
      if (!axis && moves && record.kind == RecordKind::feed) {
        axis = candidate;
        from = at[candidate];
      }
      at[candidate] = record.to[candidate];
    }
    if (axis) depth = max(depth, abs(at[*axis] - from));
  }
  return axis ? std::optional(depth) : std::nullopt;
}

// A step word a little smaller, where the loop makes a step more than the exact count, or larger,
// where it makes one less: by too little to see otherwise.
std::optional<ChangedRun> counted(const Observation& seen, const std::string& address,
                                  StepCount count) {
  const ProgramText program(seen.profile, seen.program);
  const auto paths = paths_of(seen, program.blocks.size());
  if (paths.empty()) return std::nullopt;
  auto text = edited(
      program, [&](const TextBlock& block, const TextWord& word) -> std::optional<std::string> {
        const auto written = name_of(word) == address ? exact_value_of(word) : std::nullopt;
        if (!written || written->sign() <= 0) return std::nullopt;
        const auto line = static_cast<std::size_t>(&block - program.blocks.data()) + 1;
        const auto depth = depth_of(paths[line]);
        if (!depth) return std::nullopt;
        const Steps steps = steps_of(seen, program, line, in_mm(block, *written));
        if (depth->sign() == 0 || steps.step.sign() <= 0) return std::nullopt;
        const std::int64_t exact = exact_count(steps, *depth);
        const std::int64_t loop = count(steps, *depth);
        if (exact == loop) return std::nullopt;
        const Number slightly = Number(1) / 1'000'000'000;
        return with_value(word, *written * (loop > exact ? 1 - slightly : 1 + slightly));
      });
  if (!text) return std::nullopt;
  return ChangedRun{std::move(*text), seen.profile, seen.outcome, std::nullopt};
}

enum class Rounding {
  half_up,
  half_away_from_zero,
  half_to_even,
  down,
  up,
  toward_zero,
  away_from_zero
};

Number to_even(const Number& steps) {
  const Number near = (steps + Number(1) / 2).floor();
  const bool is_half = near - steps == Number(1) / 2;
  const bool is_odd = (near / 2).floor() * 2 != near;
  return is_half && is_odd ? near - 1 : near;
}

Number rounded(const Number& value, const Number& grid, Rounding rounding) {
  const Number steps = value / grid;
  const Number half = Number(1) / 2;
  switch (rounding) {
    case Rounding::half_up:
      return (steps + half).floor() * grid;
    case Rounding::half_away_from_zero:
      return (steps.sign() < 0 ? (steps - half).ceil() : (steps + half).floor()) * grid;
    case Rounding::half_to_even:
      return to_even(steps) * grid;
    case Rounding::down:
      return steps.floor() * grid;
    case Rounding::up:
      return steps.ceil() * grid;
    case Rounding::toward_zero:
      return (steps.sign() < 0 ? steps.ceil() : steps.floor()) * grid;
    case Rounding::away_from_zero:
      return (steps.sign() < 0 ? steps.floor() : steps.ceil()) * grid;
  }
  return value;
}

bool round_all(KeptOutcome& model, const Number& grid, Rounding rounding) {
  bool changed = false;
  for (Record& record : model.records) {
    for (const Axis axis : reference::kLinearAxes) {
      const Number value = rounded(record.to[axis], grid, rounding);
      changed = changed || value != record.to[axis];
      record.to[axis] = value;
    }
    for (Number& centre : record.centre) centre = rounded(centre, grid, rounding);
  }
  return changed;
}

void add_roundings(Variants& out) {
  for (const int places : {4, 3, 2, 1}) {
    Number grid = 1;
    for (int i = 0; i < places; ++i) grid = grid / 10;
    for (const auto& [name, rounding] :
         {std::pair("half up", Rounding::half_up),
          std::pair("half away from zero", Rounding::half_away_from_zero),
          std::pair("half to even", Rounding::half_to_even), std::pair("down", Rounding::down),
          std::pair("up", Rounding::up), std::pair("toward zero", Rounding::toward_zero),
          std::pair("away from zero", Rounding::away_from_zero)}) {
      add_model(
          fmt::format("coordinates are rounded {} to {} mm", name, grid.text()),
          [=](const Observation&, KeptOutcome& model) { return round_all(model, grid, rounding); },
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
    std::erase_if(model.records, [&](const Record& record) { return record.block >= i + 1; });
    model.end.kind = oracle::RunEnd::Kind::alarm;
    model.end.alarm.block = i + 1;
    model.end.alarm.alarm_class = "syntax";
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
      const reference::CodeWord* const role = block.modes.code()->find(name_of(word));
      return role != nullptr &&
             (role->role == reference::Role::place || role->role == reference::Role::way);
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
  std::erase_if(model.records, [&](const Record& record) { return record.block >= line; });
  model.end.kind = oracle::RunEnd::Kind::alarm;
  model.end.alarm.block = line;
  model.end.alarm.alarm_class = "missing-word";
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

namespace {

// The words by which cycles go on again and again.
std::set<std::string> steps_of_cycles(const Profile& profile) {
  std::set<std::string> steps;
  for (const reference::Code& code : reference::find_dialect(profile.dialect)->descriptor->codes) {
    for (const auto& list : code.words) {
      for (const reference::CodeWord& word : list) {
        if (word.role == reference::Role::step) steps.emplace(word.address);
      }
    }
  }
  return steps;
}

}  // namespace

void add_model_variants(const Observation& departure, Variants& out) {
  out.push_back({"I J K are taken as absolute", absolute_centres});
  for (const std::string& address : steps_of_cycles(departure.profile)) {
    for (const auto& [how, count] :
         {std::pair<const char*, StepCount>{"is summed up in binary32", summed_steps<float>},
          {"is summed up in binary64", summed_steps<double>},
          {"makes a step more where it divides the depth", whole_quotient_and_one}}) {
      out.push_back({fmt::format("{} {}", address, how), [address, count](const Observation& seen) {
                       return counted(seen, address, count);
                     }});
    }
  }
  add_model("an arc that ends where it begins is no motion", drop_full_circles, out);
  add_model("small letters are refused", refuse_small_letters, out);
  add_asked_again(departure, out);
  add_roundings(out);
  for (const Motions& motions : motions_concerned(departure)) add_left_out(motions, out);
}

}  // namespace gonogo::identify
