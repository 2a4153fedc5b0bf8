// SPDX-License-Identifier: GPL-3.0-or-later
//
// Under which assignments of open readings the reference says different things of a program.
#include "oracle/judge/different_assignments.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "oracle/judge/judge_session.hpp"

namespace gonogo::oracle {

using reference::Profile;
using reference::ReadingChoice;
using reference::ReadingKey;

namespace {

// A run of the reference to its end, for what it asks for.
template <typename Reference>
void run_through(Reference& reference) {
  try {
    std::size_t items = 0;
    std::uint64_t block = 0;
    while (const reference::Item* item = reference.next()) {
      const auto* record = std::get_if<Record>(item);
      if (record != nullptr && std::exchange(block, record->block) != record->block) items = 0;
      if (++items > kMostItems) break;
    }
  } catch (const exact::Undecided&) {
    // The judge comes to the same place and says so.
  }
}

}  // namespace

Profile with_readings(const Profile& profile, ReadingChoice choice) {
  Profile with = profile;
  with.readings = std::move(choice);
  return with;
}

bool add_different(const Profile& profile, const ProgramText& program, AssignmentSet set,
                   std::vector<AssignmentSet>& different) {
  std::size_t i = different.size();
  different.push_back(std::move(set));
  for (; i < different.size(); ++i) {
    if (different.size() > kMaximumAssignments) return false;
    AssignmentSet own = different[i];
    const AssignmentSet watched = own;
    const Profile assigned = with_readings(profile, own.taken());
    WatchedReference run(assigned, program, &watched, Forking::when_different);
    run_through(run);
    for (const auto& [key, value] : run.take_parted()) {
      different.push_back(own.with(key, value));
      own.leave_out(key, value);
    }
    different[i] = std::move(own);
  }
  return true;
}

std::vector<ReadingKey> touched_by(const Profile& profile, const ProgramText& program) {
  ProgramInput input(program);
  reference::Expander expander(profile, input.lines, reference::OpenPaths::judged);
  run_through(expander);
  return expander.readings().touched();
}

std::optional<std::vector<AssignmentSet>> different_assignments(const Profile& profile,
                                                                const ProgramText& program) {
  std::vector<AssignmentSet> different;
  if (!add_different(profile, program, AssignmentSet(profile), different)) return std::nullopt;
  return different;
}

Assignments assignments_of(const Profile& profile, const ProgramText& program) {
  Assignments result;
  const auto different = different_assignments(profile, program);
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

}  // namespace gonogo::oracle
