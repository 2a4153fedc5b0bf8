// SPDX-License-Identifier: GPL-3.0-or-later
//
// G114 to G117, thread milling: external and internal, clockwise and counterclockwise.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>
#include <string_view>
#include <vector>

#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/gsk988ta/milling.hpp"
#include "reference/gsk988ta/thread_path.hpp"
#include "reference/predicate.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::reference::gsk988ta {
namespace {

Generator<Item> mill(MillingSite site, ThreadMilling thread, bool open, bool feeds_back) {
  if (!site.positioned.empty()) {
    const bool turns = site.positioned.has(Axis::c);
    co_yield site.rapid_to_centre(turns ? "GSK-G114-16"_clause : "GSK-G114-05"_clause,
                                  site.positioned);
  }
  co_yield site.rapid_depth("GSK-G114-05"_clause, site.r_plane);
  if (site.depth().sign() == 0) {
    // GSK-G110-17: no depth, no cut.
    co_yield site.rapid_depth("GSK-G110-17"_clause, site.initial_plane);
    co_return;
  }
  if (open) {
    co_yield thread;
  } else {
    Generator<Record> path = thread_passes(site, thread);
    while (const Record* record = path.next()) co_yield *record;
  }
  co_yield site.return_at(feeds_back, "GSK-G114-07"_clause);
}

constexpr std::array kThreadWords = {&ThreadWords::lead,         &ThreadWords::height,
                                     &ThreadWords::infeed,       &ThreadWords::tool,
                                     &ThreadWords::diameter,     &ThreadWords::run_out_length,
                                     &ThreadWords::run_out_angle};

bool is_external(int code) {
  return code == 114 || code == 115;
}

// GSK-G114-03, GSK-G114-15, GSK-G114-18
void check_tool(BlockContext& block, const ThreadWords& words) {
  if (words.height && words.tool &&
      decided("GSK-G114-03"_clause, "P - D", *words.height, *words.tool) > 0) {
    block.alarm(
        AlarmClass::depth_exceeds_tool, "GSK-G114-03"_clause, 'P',
        with_values("The thread's height of {} mm is larger than the tool's radius of {} mm.",
                    {*words.height, *words.tool}));
  }
  if (is_external(block.machine.milling.code) || !words.tool || !words.diameter) return;
  const int room = decided("GSK-G114-15"_clause, "E / 2 - D", *words.diameter / 2, *words.tool);
  if (room <= 0) {
    block.alarm(AlarmClass::tool_too_large, room < 0 ? "GSK-G114-15"_clause : "GSK-G114-18"_clause,
                'D',
                with_values("The tool's radius of {} mm is not smaller than the bore's of {} mm.",
                            {*words.tool, *words.diameter / 2}));
  }
}

// GSK-MOD-04: the words of the block, and under a reading those that the mode retains.
ThreadWords words_in_force(const BlockContext& block, const ThreadWords& given,
                           const ThreadWords& retained) {
  ThreadWords words = given;
  for (std::optional<Number> ThreadWords::*word : kThreadWords) {
    if (given.*word || !(retained.*word)) continue;
    if (block.readings.is("gsk.thread.modal=words"_reading)) words.*word = retained.*word;
  }
  return words;
}

ThreadWords words_of(const BlockWords& words) {
  return {words.length('I'),
          words.length('P'),
          words.length('Q'),
          words.length('D'),
          words.length('E'),
          words.length('J'),
          words.has('K') ? std::optional(words.written('K')) : std::nullopt};
}

void check_words(BlockContext& block, const ThreadWords& words) {
  const std::array<NeededWord, 4> needed = {{{'I', words.lead},
                                             {'P', words.height, "GSK-G114-17"_clause},
                                             {'D', words.tool},
                                             {'E', words.diameter, "GSK-G114-17"_clause}}};
  check_needed(block, needed, true, "GSK-G114-02"_clause, "GSK-G114-02"_clause);
  check_tool(block, words);
  // GSK-G114-12: the format of G116 and G117 prints R without brackets.
  if (!is_external(block.machine.milling.code) && !block.words.has('R') &&
      block.readings.is("gsk.thread.r=required"_reading)) {
    block.missing("GSK-G114-12"_clause, 'R');
  }
}

ThreadRunOut run_out_of(const BlockContext& block) {
  const ReadingsInUse& readings = block.readings;
  if (readings.is("gsk.thread.runout=radial"_reading)) return ThreadRunOut::radial;
  if (readings.is("gsk.thread.runout=tangent"_reading)) return ThreadRunOut::tangent;
  return readings.is("gsk.thread.runout=any"_reading) ? ThreadRunOut::open : ThreadRunOut::polar;
}

// GSK-G114-02, GSK-G114-11: J and K default to the parameters, and these to nothing.
void take_run_out(const Profile& profile, ThreadWords& words) {
  if (!words.run_out_length) words.run_out_length = profile.parameter("5921");
  if (!words.run_out_angle) words.run_out_angle = profile.parameter("5920");
}

// K is not needed for J = 0, which is no run-out.
bool lacks_angle(const ThreadWords& words) {
  return !words.run_out_angle && (!words.run_out_length || words.run_out_length->sign() != 0);
}

// What the machine does then only its parameters say: no alarm of it, and nothing is assumed.
bool lacks_parameter(BlockContext& block, const ThreadWords& words) {
  std::vector<std::string_view> what;
  std::vector<std::string_view> line;
  if (lacks_angle(words)) {
    what.emplace_back("5920 (for K, the angle of the run-out, degrees)");
    line.emplace_back(R"("5920" = "30")");
  }
  if (!words.run_out_length) {
    what.emplace_back("5921 (for J, the length of the run-out, mm)");
    line.emplace_back(R"("5921" = "2")");
  }
  if (line.empty()) return false;
  block.out.not_covered = lacking_in_profile(
      fmt::format("The machine's parameter {}", fmt::join(what, ", and its parameter ")),
      fmt::format("parameters = {{ {} }}", fmt::join(line, ", ")), block.places.behind(),
      block.line);
  return true;
}

ThreadMilling make_thread(BlockContext& block, const MillingSite& site, const ThreadWords& words) {
  const int code = block.machine.milling.code;
  ThreadMilling thread;
  thread.block = block.line;
  thread.clause = "GSK-G114-06"_clause;
  thread.plane = site.plane;
  thread.external = is_external(code);
  thread.sense = sense_of(code);  // GSK-G114-09
  thread.centre = site.plane_centre();
  thread.r_plane = site.r_plane;
  thread.bottom = site.bottom;
  thread.travel = site.travel;
  thread.initial_plane = site.initial_plane;
  thread.lead = *words.lead;
  thread.tool_radius = *words.tool;
  thread.height = *words.height;
  thread.start_radius =
      thread.external ? *words.diameter / 2 + *words.tool : *words.diameter / 2 - *words.tool;
  // GSK-G114-04; GSK-G114-12: Q = 0 counts as omitted.
  const Number infeed = words.infeed.value_or(0);
  thread.infeed = infeed.sign() > 0 ? min(infeed, thread.height) : thread.height;
  thread.runout_length = *words.run_out_length;
  thread.runout_angle = words.run_out_angle.value_or(0);
  thread.arc_path = !block.readings.is("gsk.thread.path=any"_reading);
  thread.runout = run_out_of(block);
  thread.feed = site.feed;  // GSK-G114-08: along the helix
  thread.feed_mode = site.feed_mode;
  return thread;
}

// A record counts the turns of a helix in 32 bits.
bool has_too_many_turns(BlockContext& block, const ThreadMilling& thread) {
  const Number turns = turns_of(thread);
  if (turns <= Number(std::int64_t{std::numeric_limits<std::int32_t>::max()})) return false;
  block.not_covered(
      block.machine.milling.code, 'I',
      fmt::format("A helix of {} turns is more than the gauge counts.", turns.ceil().text()));
  return true;
}

}  // namespace

void latch_g114(BlockContext& block) {
  const ThreadWords given = words_of(block.words);
  ThreadWords& retained = block.machine.milling.thread;
  for (std::optional<Number> ThreadWords::*word : kThreadWords) {
    if (given.*word) retained.*word = given.*word;
  }
}

void run_g114(BlockContext& block) {
  const ThreadWords retained = block.machine.milling.thread;
  latch_g114(block);
  if (!names_site(block)) {
    position_only(block);  // GSK-G110-14
    return;
  }
  ThreadWords words = words_in_force(block, words_of(block.words), retained);
  check_words(block, words);
  const bool from_initial = block.readings.is("gsk.thread.v-from=initial"_reading);
  const MillingSite site =
      place_site(block, block.words.length('R').value_or(0), from_initial);  // GSK-G114-01
  if (block.readings.is("gsk.thread.direction=alarm"_reading)) {
    check_direction(block, site, "GSK-G114-12"_clause);
  }
  check_depth(block, site);
  if (!block.out.alarms.empty()) return;

  name_planes(block, site);
  Position& position = block.machine.position;
  position = site.centre;
  ThreadMilling thread;
  bool open = false;
  if (site.depth().sign() != 0) {
    take_run_out(block.profile, words);
    if (lacks_parameter(block, words)) return;
    thread = make_thread(block, site, words);
    if (has_too_many_turns(block, thread)) return;
    // GSK-G114-06, GSK-G114-11: the path is open unless readings name all of it; its steps are not
    // (GSK-G114-14, GSK-CYC-01).
    open = block.open_paths == OpenPaths::judged &&
           (!thread.arc_path ||
            (thread.runout == ThreadRunOut::open && thread.runout_length.sign() != 0));
    const std::array<Number, 2> end = end_of_passes(thread);
    position[site.axes.p] = end[0];
    position[site.axes.q] = end[1];
  }
  position[site.axes.d] = site.initial_plane;
  // GSK-G114-07: asked where the planes are not one.
  const bool feeds_back = site.depth().sign() != 0 && site.r_plane != site.initial_plane &&
                          block.readings.is("gsk.thread.return=feed"_reading);
  block.out.cycle = mill(site, std::move(thread), open, feeds_back);
}

}  // namespace gonogo::reference::gsk988ta
