// SPDX-License-Identifier: GPL-3.0-or-later
//
// A trace with one thing wrong that is larger than the tolerance is never GO, however small the
// motions round it are. The programs have no open paths, so that what is right is one path.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "tests/oracle/judge/generated_outcomes.hpp"
#include "tests/trials.hpp"

namespace gonogo::oracle {
namespace {

using reference::kLinearAxes;

// Off by more than this, a place agrees with none that the reference may have dropped nearby.
constexpr int kTolerances = 4;

// Cycles whose path is open, and codes that name the position anew, in no record.
bool is_told_by_records(std::string program) {
  std::erase(program, ' ');
  return std::ranges::none_of(
      std::to_array<std::string_view>({"G11", "CYC75", "cyc75", "G50", "G92"}),
      [&](std::string_view word) { return program.find(word) != std::string_view::npos; });
}

// The motions of a trace, each from where the one before ends.
std::vector<Motion> motions_of(const GeneratedOutcome& of) {
  std::vector<Motion> motions;
  Position at = of.program.profile.initial.at;
  for (std::size_t i = 0; i < of.outcome.records.size(); ++i) {
    const Record& record = of.outcome.records[i];
    if (!is_motion(record.kind)) continue;
    motions.push_back(motion_from(at, record, i));
    at = motions.back().to();
  }
  return motions;
}

// Leads beside its end, on an axis along which it does not move. False where it moves on all.
bool lead_aside(const Motion& motion, const Number& by, Record& record) {
  for (const Axis axis : kLinearAxes) {
    const bool in_plane =
        motion.record.kind == RecordKind::arc && axis != reference::axes_of(motion.record.plane).d;
    if (in_plane || motion.record.kind == RecordKind::arc3 ||
        !agree(motion.from[axis], motion.to()[axis], 0)) {
      continue;
    }
    record.axes.add(axis);
    record.to[axis] = motion.to()[axis] + by;
    return true;
  }
  return false;
}

// Whether what comes up to the next motion that is seen may go on in the same way, and make up for
// this one.
bool goes_on(const std::vector<Motion>& motions, std::size_t i, const Number& tolerance) {
  const Record& record = motions[i].record;
  while (++i < motions.size()) {
    const Record& next = motions[i].record;
    if (next.kind == record.kind && next.block == record.block) return true;
    if (!agree(motions[i].from, motions[i].to(), tolerance)) return false;
  }
  return false;
}

enum class Wrong { aside, missing, sense };

// False where the motion cannot be put wrong so.
bool put_wrong(Wrong wrong, const std::vector<Motion>& motions, std::size_t i,
               const Number& tolerance, Outcome& outcome) {
  const Motion& motion = motions[i];
  Record& record = outcome.records[motion.number];
  const Number off = tolerance * kTolerances;
  // One too small to see may be part of the next.
  if (agree(motion.from, motion.to(), off)) return false;
  switch (wrong) {
    case Wrong::aside:
      return lead_aside(motion, off, record);
    case Wrong::missing:
      if (goes_on(motions, i, tolerance)) return false;
      outcome.records.erase(outcome.records.begin() + static_cast<std::ptrdiff_t>(motion.number));
      return true;
    case Wrong::sense:
      if (record.kind != RecordKind::arc) return false;
      record.rot = -record.rot;
      return true;
  }
  return false;
}

// One motion of each program is put wrong, where it can be. The same program with its right trace
// is the proof that nothing else is wrong.
void expect_no_go(Wrong wrong, std::string_view name, long usual) {
  generate::GeneratorSettings settings;
  settings.kinds = {.valid = 1, .near_invalid = 0, .boundary = 1, .raw = 0, .tiny = 4};
  long tried = 0;
  each_trial(usual, [&](Chance& chance) {
    generate::Choices& choices = chance.choices();
    GeneratedOutcome of = right_outcome(choices.pick(generate::generators()), settings, choices);
    if (!is_told_by_records(of.program.text)) return;
    // What is wrong may be the path of another alternative.
    of.program.profile.readings = of.program.profile.readings.shown();
    const std::vector<Motion> motions = motions_of(of);
    if (motions.size() < 2) return;  // without any motion an alarm may have come at load
    Outcome spoilt = of.outcome;
    if (!put_wrong(wrong, motions, chance.below(motions.size()), of.tolerances.tolerance, spoilt)) {
      return;
    }
    const auto passes = [&](const Outcome& outcome) {
      const VerdictKind kind =
          judged(of.program.profile, of.program.text, outcome, of.tolerances).verdict.kind;
      return kind != VerdictKind::skip && decision(kind) == Decision::go;
    };
    if (!passes(of.outcome)) return;
    ++tried;
    std::string trace;
    for (const Record& record : spoilt.records) trace += line_of(record) + "\n";
    ASSERT_FALSE(passes(spoilt)) << name << "\n"
                                 << reference::profile_json(of.program.profile) << "\n"
                                 << of.program.text << trace;
  });
  EXPECT_GT(tried * 20, trial_count(usual)) << "hardly anything was tried";
}

TEST(WrongMotion, ThatLeadsBesideItsEndIsNoGo) {
  expect_no_go(Wrong::aside, "aside", 3'000);
}

TEST(WrongMotion, ThatIsMissingIsNoGo) {
  expect_no_go(Wrong::missing, "missing", 3'000);
}

TEST(WrongMotion, ThatTurnsTheOtherWayIsNoGo) {
  expect_no_go(Wrong::sense, "sense", 3'000);
}

}  // namespace
}  // namespace gonogo::oracle
