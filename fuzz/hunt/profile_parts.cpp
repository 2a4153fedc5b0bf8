// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/profile_parts.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

namespace gonogo::hunt {
namespace {

using reference::Profile;
using Take = void (*)(Profile& to, const Profile& from);

constexpr std::array<Take, 16> kParts = {{
    [](Profile& to, const Profile& from) { to.readings = from.readings; },
    [](Profile& to, const Profile& from) { to.offsets = from.offsets; },
    [](Profile& to, const Profile& from) { to.tools = from.tools; },
    [](Profile& to, const Profile& from) { to.parameters = from.parameters; },
    [](Profile& to, const Profile& from) { to.initial.at = from.initial.at; },
    [](Profile& to, const Profile& from) { to.initial.feed = from.initial.feed; },
    [](Profile& to, const Profile& from) { to.initial.plane = from.initial.plane; },
    [](Profile& to, const Profile& from) { to.initial.motion = from.initial.motion; },
    [](Profile& to, const Profile& from) { to.initial.spindle = from.initial.spindle; },
    [](Profile& to, const Profile& from) { to.units = from.units; },
    [](Profile& to, const Profile& from) { to.increment = from.increment; },
    [](Profile& to, const Profile& from) { to.given_resolution = from.given_resolution; },
    [](Profile& to, const Profile& from) { to.x_diameter = from.x_diameter; },
    [](Profile& to, const Profile& from) { to.reference_point = from.reference_point; },
    [](Profile& to, const Profile& from) { to.alarm_timing = from.alarm_timing; },
    [](Profile& to, const Profile& from) { to.block_skip = from.block_skip; },
}};

// Sets part i to that of another profile.
void take_part(Profile& to, const Profile& from, std::size_t part) {
  if (part < kParts.size()) {
    kParts[part](to, from);
  } else {
    const auto key = static_cast<reference::ReadingKey>(part - kParts.size());
    to.readings.set(key, from.readings.get(key));
  }
}

void choose_another_reading(program::Dice& dice, Profile& profile) {
  std::vector<const reference::Reading*> choices;
  for (const reference::Reading& reading : reference::readings()) {
    const bool has_choice = reading.alternatives.size() > 1;
    if (has_choice && reading.belongs_to(profile.dialect)) choices.push_back(&reading);
  }
  if (choices.empty()) return;
  const reference::Reading& reading = *dice.pick(choices);
  profile.readings.set(reading.key, dice.pick(reading.alternatives));
}

}  // namespace

void GivenMachine::put_in(Profile& machine) const {
  if (profile) machine = *profile;
  for (const auto& [key, value] : readings) machine.readings.set(key, value);
}

bool GivenMachine::is_in(const Reproducer& reproducer) const {
  const auto has = [&](const generate::GeneratedProgram& program) {
    Profile machine = program.profile;
    put_in(machine);
    return machine == program.profile;
  };
  return has(reproducer.program) && std::ranges::all_of(reproducer.before, has);
}

std::size_t profile_parts() {
  return kParts.size() + reference::readings().size();
}

std::vector<std::size_t> parts_set(const Profile& profile) {
  const Profile fallback = std::get<Profile>(reference::default_profile(profile.dialect));
  std::vector<std::size_t> parts;
  Profile other = profile;
  for (std::size_t part = 0; part < profile_parts(); ++part) {
    take_part(other, fallback, part);
    if (other == profile) continue;
    parts.push_back(part);
    take_part(other, profile, part);
  }
  return parts;
}

bool reset_part(Profile& profile, std::size_t part) {
  const Profile fallback = std::get<Profile>(reference::default_profile(profile.dialect));
  const Profile before = profile;
  take_part(profile, fallback, part);
  return !(profile == before);
}

std::vector<reference::Number*> numbers_of(Profile& profile) {
  std::vector<reference::Number*> numbers = {&profile.initial.feed};
  const auto add = [&](reference::Position& place) {
    for (reference::Number& number : place.at) numbers.push_back(&number);
  };
  add(profile.initial.at);
  add(profile.reference_point);
  for (auto& [code, offset] : profile.offsets) add(offset);
  for (auto& [number, tool] : profile.tools) {
    numbers.insert(numbers.end(), {&tool.radius, &tool.length});
  }
  return numbers;
}

bool drop_entry(Profile& profile, std::size_t i) {
  const auto drop = [&](auto& entries) {
    if (i >= entries.size()) {
      i -= entries.size();
      return false;
    }
    entries.erase(std::next(entries.begin(), static_cast<std::ptrdiff_t>(i)));
    return true;
  };
  return drop(profile.offsets) || drop(profile.tools) || drop(profile.parameters);
}

void mutate_profile(program::Dice& dice, Profile& profile, const Profile& other) {
  if (dice.one_in(2)) {
    choose_another_reading(dice, profile);
  } else {
    kParts[dice.below(kParts.size())](profile, other);
  }
}

}  // namespace gonogo::hunt
