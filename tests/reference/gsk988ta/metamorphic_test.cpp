// SPDX-License-Identifier: GPL-3.0-or-later
//
// What must not change, or change in a known way, when a program is written in another way. The
// records are compared exactly.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "expanding.hpp"
#include "metamorphic_layout.hpp"
#include "metamorphic_program.hpp"

namespace gonogo::reference::testing {
namespace {

// An item in the axes of the plane, with all that a change of writing may not touch.
struct Seen {
  int kind = 0;  // of the item
  RecordKind record = RecordKind::rapid;
  std::uint64_t block = 0;
  ClauseId clause = kNoClause;
  std::array<bool, 3> named = {};
  std::array<Number, 3> to = {};  // of named axes
  std::array<Number, 2> centre = {};
  int rot = 0;
  Number feed;
  FeedMode feed_mode = FeedMode::per_minute;
  Number seconds;
  std::array<Number, 3> level = {};  // I, L, D
  std::vector<AlarmClass> alarms;    // in the order of their classes

  friend bool operator==(const Seen&, const Seen&) = default;
};

struct Look {
  Plane plane;

  Seen operator()(const Record& record) const {
    Seen seen;
    seen.record = record.kind;
    seen.block = record.block;
    seen.clause = record.clause;
    const PlaneAxes axes = axes_of(plane);
    const std::array<Axis, 3> pqd = {axes.p, axes.q, axes.d};
    for (std::size_t i = 0; i < 3; ++i) {
      seen.named[i] = record.axes.has(pqd[i]);
      if (seen.named[i]) seen.to[i] = record.to[pqd[i]];
    }
    EXPECT_TRUE(record.kind != RecordKind::arc || record.plane == plane);
    seen.centre = record.centre;
    seen.rot = record.rot;
    seen.feed = record.feed;
    seen.feed_mode = record.feed_mode;
    seen.seconds = record.seconds;
    return seen;
  }
  Seen operator()(const PocketLevel& level) const {
    Seen seen;
    seen.block = level.block;
    seen.clause = level.clause;
    EXPECT_EQ(level.plane, plane);
    seen.centre = level.centre;
    seen.named[2] = true;
    seen.to[2] = level.depth;
    seen.rot = level.sense;
    seen.feed = level.feed;
    seen.feed_mode = level.feed_mode;
    seen.level = {level.pocket_radius, level.step, level.tool_radius};
    return seen;
  }
  Seen operator()(const AlarmReport& report) const {
    Seen seen;
    seen.block = report.block;
    for (const Alarm& alarm : report.alarms) seen.alarms.push_back(alarm.alarm);
    std::sort(seen.alarms.begin(), seen.alarms.end());
    return seen;
  }
  template <typename Other>
  Seen operator()(const Other&) const {
    ADD_FAILURE() << "no item of these programs";
    return {};
  }
};

using Trace = std::vector<Seen>;

Trace look(const std::string& program, const Profile& profile, Plane plane,
           OpenPaths open_paths = OpenPaths::shown) {
  Trace trace;
  for (const Item& item : expand(program, profile, open_paths)) {
    Seen seen = std::visit(Look{plane}, item);
    seen.kind = static_cast<int>(item.index());
    trace.push_back(std::move(seen));
  }
  return trace;
}

Trace look(const Model& model, const Writing& writing, OpenPaths open_paths = OpenPaths::shown) {
  return look(text(write(model, writing)), machine(model, writing), writing.plane, open_paths);
}

bool is_arc_or_level(const Seen& seen) {
  return seen.rot != 0;
}

Plane any_plane() {
  return static_cast<Plane>(*rc::gen::inRange(0, 3));
}
OpenPaths any_open_paths() {
  return *rc::gen::arbitrary<bool>() ? OpenPaths::judged : OpenPaths::shown;
}
Writing any_writing() {
  Writing writing;
  writing.plane = any_plane();
  writing.diameter = *rc::gen::arbitrary<bool>();
  return writing;
}

// The properties below say little where the programs say little.
TEST(Metamorphic, TheProgramsCutAndFewOfThemAlarm) {
  int alarms = 0;
  std::array<int, 7> steps = {};
  int arcs = 0;
  const rc::Gen<Model> any = models();
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const Model model = any(rc::Random(seed), 100).value();
    for (const Step& step : model.steps) ++steps[static_cast<std::size_t>(step.kind)];
    const Trace trace = look(model, {});
    if (!trace.back().alarms.empty()) ++alarms;
    arcs += static_cast<int>(std::count_if(trace.begin(), trace.end(), is_arc_or_level));
  }
  EXPECT_GT(alarms, 10);
  EXPECT_LT(alarms, 150);
  for (const int count : steps) EXPECT_GT(count, 50);
  EXPECT_GT(arcs, 1'000);
}

RC_GTEST_PROP(Metamorphic, ATranslatedProgramMovesByTheSameShift, ()) {
  const Model model = *models();
  const Point shift = {*rc::gen::inRange<std::int64_t>(-90'000, 90'000),
                       *rc::gen::inRange<std::int64_t>(-90'000, 90'000),
                       *rc::gen::inRange<std::int64_t>(-90'000, 90'000)};
  const Writing writing = any_writing();
  const OpenPaths open_paths = any_open_paths();
  Trace want = look(model, writing, open_paths);
  for (Seen& seen : want) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Number by = Number(shift[i]) / 1'000;
      if (seen.named[i]) seen.to[i] += by;
      if (i < 2 && is_arc_or_level(seen)) seen.centre[i] += by;
    }
  }
  RC_ASSERT(look(translated(model, shift), writing, open_paths) == want);
}

RC_GTEST_PROP(Metamorphic, APlaneOnlyNamesTheAxes, ()) {
  const Model model = *models();
  const OpenPaths open_paths = any_open_paths();
  const bool incremental = *rc::gen::arbitrary<bool>();
  const Trace want = look(model, {Plane::g18, true, incremental, Lengths::mm}, open_paths);
  RC_ASSERT(look(model, {Plane::g17, true, incremental, Lengths::mm}, open_paths) == want);
  RC_ASSERT(look(model, {Plane::g19, true, incremental, Lengths::mm}, open_paths) == want);
}

RC_GTEST_PROP(Metamorphic, ADiameterIsTwiceTheRadius, ()) {
  const Model model = *models();
  const Plane plane = any_plane();
  const bool incremental = *rc::gen::arbitrary<bool>();
  RC_ASSERT(look(model, {plane, true, incremental, Lengths::mm}) ==
            look(model, {plane, false, incremental, Lengths::mm}));
}

RC_GTEST_PROP(Metamorphic, AnInchIs254TenthsOfAMillimetre, ()) {
  const Model model = *models();
  Writing writing = any_writing();
  writing.incremental = *rc::gen::arbitrary<bool>();
  const OpenPaths open_paths = any_open_paths();
  writing.lengths = Lengths::inch;
  const Trace inch = look(model, writing, open_paths);
  writing.lengths = Lengths::inch_in_mm;
  RC_ASSERT(look(model, writing, open_paths) == inch);
}

RC_GTEST_PROP(Metamorphic, IncrementsLeadWhereAbsoluteWordsLead, ()) {
  const Model model = *models();
  Writing writing = any_writing();
  const OpenPaths open_paths = any_open_paths();
  const Trace absolute = look(model, writing, open_paths);
  writing.incremental = true;
  RC_ASSERT(look(model, writing, open_paths) == absolute);
}

RC_GTEST_PROP(Metamorphic, TheOtherSenseIsTheMirrorImageInQ, ()) {
  const Model model = *models();
  const Writing writing = any_writing();
  const OpenPaths open_paths = any_open_paths();
  Trace want = look(model, writing, open_paths);
  for (Seen& seen : want) {
    seen.to[1] = -seen.to[1];
    seen.centre[1] = -seen.centre[1];
    seen.rot = -seen.rot;
  }
  RC_ASSERT(look(mirrored_in_q(model), writing, open_paths) == want);
}

RC_GTEST_PROP(Metamorphic, APocketUpwardsIsTheMirrorImageInD, ()) {
  const Model model = *models();
  const Writing writing = any_writing();
  const OpenPaths open_paths = any_open_paths();
  Trace want = look(model, writing, open_paths);
  for (Seen& seen : want) seen.to[2] = -seen.to[2];
  RC_ASSERT(look(mirrored_in_d(model), writing, open_paths) == want);
}

std::uint32_t any_seed() {
  return *rc::gen::arbitrary<std::uint32_t>();
}

RC_GTEST_PROP(Metamorphic, BlanksBetweenAndInWordsMeanNothing, ()) {
  const Model model = *models();
  Layout layout(any_seed());
  std::string program;
  for (const Words& words : write(model, {})) program += layout.spaced(words) + "\n";
  RC_ASSERT(look(program, machine(model, {}), Plane::g18) == look(model, {}));
}

RC_GTEST_PROP(Metamorphic, WordsWithoutBlanksMeanTheSame, ()) {
  const Model model = *models();
  std::string program = text(write(model, {}));
  std::erase(program, ' ');
  RC_ASSERT(look(program, machine(model, {}), Plane::g18) == look(model, {}));
}

RC_GTEST_PROP(Metamorphic, BlockNumbersAndCommentsMeanNothing, ()) {
  const Model model = *models();
  Layout layout(any_seed());
  std::string program;
  for (const Words& words : write(model, {})) program += layout.commented(words) + "\n";
  RC_ASSERT(look(program, machine(model, {}), Plane::g18) == look(model, {}));
}

RC_GTEST_PROP(Metamorphic, TheOrderOfWordsMeansNothing, ()) {
  const Model model = *models();
  Layout layout(any_seed());
  std::vector<Words> blocks = write(model, {});
  for (Words& words : blocks) layout.shuffle(words);
  RC_ASSERT(look(text(blocks), machine(model, {}), Plane::g18) == look(model, {}));
}

RC_GTEST_PROP(Metamorphic, LeadingAndTrailingZerosMeanNothing, ()) {
  const Model model = *models();
  Layout layout(any_seed());
  std::vector<Words> blocks = write(model, {});
  for (Words& words : blocks) {
    for (Word& word : words) {
      const std::size_t first = word.number.starts_with('-') ? 1 : 0;
      word.number.insert(first, layout.below(4), '0');
      if (word.number.find('.') != std::string::npos) word.number.append(layout.below(20), '0');
    }
  }
  RC_ASSERT(look(text(blocks), machine(model, {}), Plane::g18) == look(model, {}));
}

RC_GTEST_PROP(Metamorphic, IdleLinesOnlyMoveTheBlockNumbers, ()) {
  const Model model = *models();
  Layout layout(any_seed());
  std::string program;
  std::vector<std::uint64_t> line_of_block = {0};
  std::uint64_t line = 0;
  for (const Words& words : write(model, {})) {
    for (std::size_t count = layout.below(4); count > 0; --count, ++line) {
      program += layout.idle() + layout.line_end();
    }
    line_of_block.push_back(++line);
    std::string block = text({words});
    block.pop_back();
    program += block + layout.line_end();
  }
  Trace want = look(model, {});
  for (Seen& seen : want) seen.block = line_of_block.at(seen.block);
  RC_ASSERT(look(program, machine(model, {}), Plane::g18) == want);
}

RC_GTEST_PROP(Metamorphic, EveryLineEndMeansTheSame, ()) {
  const Model model = *models();
  const std::string program = text(write(model, {}));
  const Trace want = look(model, {});
  for (const char* line_end : {"\r", "\r\n"}) {
    std::string other;
    for (const char byte : program) other += byte == '\n' ? line_end : std::string(1, byte);
    RC_ASSERT(look(other, machine(model, {}), Plane::g18) == want);
  }
}

}  // namespace
}  // namespace gonogo::reference::testing
