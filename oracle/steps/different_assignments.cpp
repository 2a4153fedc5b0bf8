// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/steps/different_assignments.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <set>
#include <utility>

#include "oracle/region/constants.hpp"
#include "oracle/steps/watched_reference.hpp"

namespace gonogo::oracle {

using reference::Profile;
using reference::ReadingChoice;
using reference::ReadingKey;

namespace {

// A run of the reference to its end, or over so many items, for what it asks for: whether it ends
// in an alarm.
template <typename Reference>
bool ends_in_alarm(Reference& reference, std::size_t most) {
  try {
    std::size_t items = 0;
    std::uint64_t block = 0;
    while (const reference::Item* item = reference.next()) {
      if (std::holds_alternative<reference::AlarmReport>(*item)) return true;
      const auto* record = std::get_if<reference::Record>(item);
      if (record != nullptr && std::exchange(block, record->block) != record->block) items = 0;
      if (++items > kMostItems || --most == 0) break;
    }
  } catch (const exact::Undecided&) {
    // The judge comes to the same place and says so.
  }
  return false;
}

bool alarms(const Profile& profile, const ProgramText& program) {
  ProgramInput input(program);
  reference::Expander expander(profile, input.lines, reference::OpenPaths::judged);
  return ends_in_alarm(expander, kMostShown);
}

}  // namespace

Profile with_readings(const Profile& profile, ReadingChoice choice) {
  Profile with = profile;
  with.readings = std::move(choice);
  return with;
}

Profile with_reading(Profile profile, ReadingKey key, std::string_view value) {
  profile.readings.set(key, value);
  return profile;
}

bool add_different(const Profile& profile, const ProgramText& program, AssignmentSet set,
                   std::vector<AssignmentSet>& different, std::size_t most_items) {
  std::size_t i = different.size();
  different.push_back(std::move(set));
  for (; i < different.size(); ++i) {
    if (different.size() > kMaximumAssignments) return false;
    AssignmentSet own = different[i];
    const AssignmentSet watched = own;
    const Profile assigned = with_readings(profile, own.taken());
    WatchedReference run(assigned, program, &watched, Forking::when_different);
    ends_in_alarm(run, most_items);
    for (const auto& [key, value] : run.take_parted()) {
      different.push_back(own.with(key, value));
      own.leave_out(key, value);
    }
    different[i] = std::move(own);
  }
  return true;
}

std::vector<ReadingKey> open_lengths(const AssignmentSet& set,
                                     const reference::ReadingsInUse& asked) {
  std::vector<ReadingKey> keys;
  for (const ReadingKey key : set.openable()) {
    if (!reference::reading(key).is_length || !asked.touched(key)) continue;
    if (!set.values(key).empty() && std::ranges::count(set.settled(), key) == 0) {
      keys.push_back(key);
    }
  }
  return keys;
}

std::vector<ReadingKey> touched_by(const Profile& profile, const ProgramText& program,
                                   std::size_t most_items) {
  ProgramInput input(program);
  reference::Expander expander(profile, input.lines, reference::OpenPaths::judged);
  ends_in_alarm(expander, most_items);
  return expander.readings().touched();
}

bool asks_open(const AssignmentSet& set, const reference::ReadingsInUse& asked) {
  return std::ranges::any_of(set.openable(), [&](ReadingKey key) {
    return asked.touched(key) && !set.values(key).empty();
  });
}

bool has_other_outcomes(const Profile& profile, const ProgramText& program,
                        const reference::ReadingsInUse& asked) {
  const AssignmentSet all(profile);
  if (!asks_open(all, asked)) return false;
  if (!open_lengths(all, asked).empty()) return true;
  const auto different = different_assignments(profile, program);
  return !different || different->size() > 1;
}

std::optional<std::vector<AssignmentSet>> different_assignments(const Profile& profile,
                                                                const ProgramText& program,
                                                                std::size_t most_items) {
  std::vector<AssignmentSet> different;
  if (!add_different(profile, program, AssignmentSet(profile), different, most_items)) {
    return std::nullopt;
  }
  return different;
}

Assignments assignments_of(const Profile& profile, const ProgramText& program,
                           std::size_t most_items) {
  Assignments result;
  const auto different = different_assignments(profile, program, most_items);
  result.too_many = !different;
  if (result.too_many) {
    result.choices.push_back(profile.readings);
    return result;
  }
  std::set<ReadingKey> open;
  for (const AssignmentSet& set : *different) {
    std::ranges::move(set.choices(), std::back_inserter(result.choices));
    std::ranges::copy(set.settled(), std::inserter(open, open.end()));
  }
  result.open.assign(open.begin(), open.end());
  return result;
}

Profile profile_to_show(const Profile& profile, const ProgramText& program) {
  if (!AssignmentSet(profile).leaves_open() || !alarms(profile, program)) return profile;
  const auto different = different_assignments(profile, program);
  if (!different) return profile;
  for (const AssignmentSet& set : *different) {
    Profile assigned = with_readings(profile, set.taken());
    if (!alarms(assigned, program)) return assigned;
  }
  return profile;
}

}  // namespace gonogo::oracle
