// SPDX-License-Identifier: GPL-3.0-or-later
//
// While the subject's records are the reference's own, the judge only compares them, or even their
// lines. What it says must be what it says when every motion goes the whole way, to the last word:
// of right outcomes, of those of faulty expanders, and of those that are spoilt anywhere.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "oracle/motion/places.hpp"
#include "oracle/motion/plain_motion.hpp"
#include "oracle/records/trace_reader.hpp"
#include "reference/clause_literal.hpp"
#include "tests/oracle/judge/generated_outcomes.hpp"
#include "tests/trials.hpp"

namespace gonogo::oracle {
namespace {

using reference::kAllAxes;
using reference::Profile;
using reference::operator""_clause;

TEST(EqualSteps, SayWhatTheWholeWaySays) {
  std::size_t known = 0;
  std::size_t records = 0;
  each_trial(3'000, [&](Chance& chance) {
    generate::Choices& choices = chance.choices();
    const GeneratedOutcome of =
        generated_outcome(choices.pick(generate::generators()), {}, choices);
    const Profile& profile = of.program.profile;
    Tolerances tolerances = of.tolerances;
    tolerances.skip_equal = false;
    const std::string whole = text_of(judged(profile, of.program.text, of.outcome, tolerances));
    tolerances.skip_equal = true;
    std::string where = fmt::format("{}\n{}", reference::profile_json(profile), of.program.text);
    for (const Record& record : of.outcome.records) where += line_of(record) + "\n";
    ASSERT_EQ(text_of(judged(profile, of.program.text, of.outcome, tolerances)), whole) << where;
    ASSERT_EQ(text_of(judged_by_lines(profile, of.program.text, of.outcome, tolerances, known)),
              whole)
        << where;
    records += of.outcome.records.size();
  });
  EXPECT_GT(known * 10, records) << "hardly a record is equal: nothing was tried";
}

// A motion of few directions, lengths and centres, often too small to see.
Motion short_motion(const Position& from, Chance& chance) {
  constexpr auto kSteps =
      std::to_array<std::int64_t>({0, 0, 999, 1'000, 1'001, 1'000'000, -1'000'000});
  Record record;
  record.kind =
      chance.one_of(std::to_array({RecordKind::rapid, RecordKind::feed, RecordKind::arc}));
  record.block = 1 + chance.below(2);
  record.feed = Number(100 + static_cast<std::int64_t>(chance.below(2)));
  record.rot = chance.once_in(2) ? 1 : -1;
  record.axes = reference::kEveryAxis;
  record.to = from;
  for (const Axis axis : {Axis::x, Axis::y, Axis::c}) {
    if (!chance.once_in(3)) record.to[axis] += Number::millionths(chance.one_of(kSteps));
  }
  return motion_from(from, record, 0);
}

// One that is dropped is not visible, however far a subject's doubles are off.
TEST(PlainMotion, IsNotVisibleWhereItIsDropped) {
  constexpr long kTrials = 200'000;
  Tolerances tolerances;
  tolerances.binary64 = true;
  long dropped = 0;
  each_trial(kTrials, [&](Chance& chance) {
    Position from;
    const auto far =
        chance.one_of(std::to_array<std::int64_t>({0, 1'000, 100'000'000, 1'500'000'000}));
    from[Axis::x] = Number(far);
    const Motion motion = short_motion(from, chance);
    if (!stays_at(from, motion, tolerances)) return;
    ++dropped;
    PlainMotion plain;
    PlainMotion::Place start;
    ASSERT_TRUE(take_place(motion.from, start) && plain.take(motion.record, start));
    ASSERT_FALSE(plain.is_visible(tolerances)) << line_of(motion.record);
  });
  EXPECT_GT(dropped, trial_count(kTrials) / 100);
}

TEST(PlainMotion, IsVisibleWhereItIsLonger) {
  Record record;
  record.block = 1;
  record.axes = {Axis::z};
  record.to[Axis::z] = Number::millionths(1'001);
  PlainMotion plain;
  ASSERT_TRUE(plain.take(record, {}));
  EXPECT_TRUE(plain.is_visible(Tolerances()));
}

Record any_record(Chance& chance) {
  const auto any_number = [&] {
    const auto count = static_cast<std::int64_t>(chance.below(2'000'001)) - 1'000'000;
    return Number::millionths(count *
                              chance.one_of(std::to_array<std::int64_t>({1, 1000, 1'000'000})));
  };
  Record record;
  record.kind =
      chance.one_of(std::to_array({RecordKind::rapid, RecordKind::feed, RecordKind::arc}));
  record.block = 1 + chance.below(2'000);
  record.plane = chance.one_of(
      std::to_array({reference::Plane::g17, reference::Plane::g18, reference::Plane::g19}));
  record.rot = chance.one_of(std::to_array({-3, -1, 1, 20}));
  record.feed_mode = chance.one_of(
      std::to_array({reference::FeedMode::per_minute, reference::FeedMode::per_revolution}));
  record.feed = abs(any_number());
  record.centre = {any_number(), any_number()};
  const reference::PlaneAxes axes = axes_of(record.plane);
  record.axes = {axes.p, axes.q};  // which an arc has to name
  for (const Axis axis : kAllAxes) {
    if (chance.once_in(2)) record.axes.add(axis);
    if (record.axes.has(axis)) record.to[axis] = any_number();
  }
  if (chance.once_in(2)) record.clause = "NGC-G0-01"_clause;
  return record;
}

TEST(PlainLine, IsTheRecordThatIsWrittenSo) {
  each_trial(20'000, [](Chance& chance) {
    const Record record = any_record(chance);
    PlainMotion motion;
    ASSERT_TRUE(motion.take(record, {}));
    const std::string line = line_of(record);
    ASSERT_TRUE(is_line_of(motion, line)) << line;
  });
}

// Any byte is replaced, left out or put in: what still passes must be read as the same motion.
TEST(PlainLine, IsNothingThatIsReadAsAnotherRecord) {
  TraceReader reader;
  long passed = 0;
  each_trial(200'000, [&](Chance& chance) {
    const Record record = any_record(chance);
    PlainMotion motion;
    ASSERT_TRUE(motion.take(record, {}));
    std::string line = line_of(record);
    const std::size_t at = chance.below(line.size());
    const char byte = chance.one_of(std::string_view("0123456789.-\"{}[]:, xyzacfbkto+eE"));
    switch (chance.below(3)) {
      case 0:
        line[at] = byte;
        break;
      case 1:
        line.erase(at, 1);
        break;
      default:
        line.insert(at, 1, byte);
        break;
    }
    if (!is_line_of(motion, line)) return;
    ++passed;
    const TraceLine read = reader.read(line);
    const TraceFault* fault = std::get_if<TraceFault>(&read);
    ASSERT_TRUE(fault == nullptr) << line << ": " << fault->message;
    ASSERT_TRUE(motion.is(std::get<Record>(read))) << line;
  });
  EXPECT_GT(passed, 0);
}

}  // namespace
}  // namespace gonogo::oracle
