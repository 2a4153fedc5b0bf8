// SPDX-License-Identifier: GPL-3.0-or-later
//
// A cycle that counts its steps otherwise than the reference: summed up in binary floating point,
// or one too many.
#include <fmt/format.h>

#include "fuzz/identify/variant.hpp"
#include "reference/dialect.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::identify {

namespace {

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
      const CodeWord* const role = block.role_of(word, *program.table);
      const bool is_withdrawal = role != nullptr && role->role == Role::size;
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
  const auto adjusted = [&](const TextBlock& block,
                            const TextWord& word) -> std::optional<std::string> {
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
  };
  return with_program(seen, edited(program, adjusted));
}

// The words by which cycles go on again and again.
std::set<std::string> steps_of_cycles(const Profile& profile) {
  std::set<std::string> steps;
  for (const Code& code : reference::find_dialect(profile.dialect)->descriptor->codes) {
    for (const auto& list : code.words) {
      for (const CodeWord& word : list) {
        if (word.role == Role::step) steps.emplace(word.address);
      }
    }
  }
  return steps;
}

}  // namespace

void add_step_variants(const Observation& departure, Variants& out) {
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
}

}  // namespace gonogo::identify
