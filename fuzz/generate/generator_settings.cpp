// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/generate/generator_settings.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace gonogo::generate {
namespace {

// A setting that is a number, and where it stands.
struct NumberSetting {
  std::string_view name;
  std::uint32_t least;
  void (*set)(GeneratorSettings& settings, std::uint32_t value);
};

constexpr auto kNumbers = std::to_array<NumberSetting>({
    {"valid", 0, [](GeneratorSettings& all, std::uint32_t n) { all.kinds.valid = n; }},
    {"near-invalid", 0,
     [](GeneratorSettings& all, std::uint32_t n) { all.kinds.near_invalid = n; }},
    {"boundary", 0, [](GeneratorSettings& all, std::uint32_t n) { all.kinds.boundary = n; }},
    {"raw", 0, [](GeneratorSettings& all, std::uint32_t n) { all.kinds.raw = n; }},
    {"tiny", 0, [](GeneratorSettings& all, std::uint32_t n) { all.kinds.tiny = n; }},
    {"blocks", 1,
     [](GeneratorSettings& all, std::uint32_t n) { all.most_blocks = static_cast<int>(n); }},
    {"fault-one-in", 1, [](GeneratorSettings& all, std::uint32_t n) { all.fault_one_in = n; }},
    {"open-one-in", 1, [](GeneratorSettings& all, std::uint32_t n) { all.open_one_in = n; }},
    {"turns", 1, [](GeneratorSettings& all, std::uint32_t n) { all.turns = static_cast<int>(n); }},
    {"rings", 1, [](GeneratorSettings& all, std::uint32_t n) { all.rings = static_cast<int>(n); }},
    {"layers", 1,
     [](GeneratorSettings& all, std::uint32_t n) { all.layers = static_cast<int>(n); }},
    {"pecks", 1, [](GeneratorSettings& all, std::uint32_t n) { all.pecks = static_cast<int>(n); }},
    {"steps", 1, [](GeneratorSettings& all, std::uint32_t n) { all.steps = static_cast<int>(n); }},
    {"starts", 1,
     [](GeneratorSettings& all, std::uint32_t n) { all.starts = static_cast<int>(n); }},
});

struct SwitchSetting {
  std::string_view name;
  bool& (*of)(GeneratorSettings& settings);
};

constexpr auto kSwitches = std::to_array<SwitchSetting>({
    {"state", [](GeneratorSettings& all) -> bool& { return all.machine.state; }},
    {"readings", [](GeneratorSettings& all) -> bool& { return all.machine.readings; }},
    {"parameters", [](GeneratorSettings& all) -> bool& { return all.machine.parameters; }},
    {"offsets", [](GeneratorSettings& all) -> bool& { return all.machine.offsets; }},
    {"tools", [](GeneratorSettings& all) -> bool& { return all.machine.tools; }},
    {"pockets", [](GeneratorSettings& all) -> bool& { return all.pockets; }},
});

bool set(GeneratorSettings& settings, std::string_view key, std::string_view value) {
  const auto its_switch = std::ranges::find(kSwitches, key, &SwitchSetting::name);
  if (its_switch != kSwitches.end()) {
    its_switch->of(settings) = value == "on";
    return value == "on" || value == "off";
  }
  const auto number = std::ranges::find(kNumbers, key, &NumberSetting::name);
  std::uint32_t count = 0;
  const char* const end = value.data() + value.size();
  const auto [stop, error] = std::from_chars(value.data(), end, count);
  if (number == kNumbers.end() || error != std::errc{} || stop != end) return false;
  if (count < number->least || count > kMostOfASetting) return false;
  number->set(settings, count);
  return true;
}

}  // namespace

GeneratorSettings in_process_settings() {
  GeneratorSettings settings;
  settings.kinds = {.valid = 1, .near_invalid = 2, .boundary = 1, .raw = 0};
  settings.open_one_in = 8;
  return settings;
}

std::optional<GeneratorSettings> read_settings(std::string_view text, GeneratorSettings settings) {
  while (!text.empty()) {
    const std::string_view one = text.substr(0, text.find(','));
    text.remove_prefix(std::min(text.size(), one.size() + 1));
    const std::size_t equals = one.find('=');
    if (equals == std::string_view::npos) return std::nullopt;
    if (!set(settings, one.substr(0, equals), one.substr(equals + 1))) return std::nullopt;
  }
  const KindWeights& kinds = settings.kinds;
  if (kinds.valid + kinds.near_invalid + kinds.boundary + kinds.raw + kinds.tiny == 0)
    return std::nullopt;
  return settings;
}

}  // namespace gonogo::generate
