// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs at random.
#include "metamorphic_program.hpp"

#include <algorithm>
#include <cstdlib>

namespace gonogo::reference::testing {
namespace {

std::int64_t between(std::int64_t low, std::int64_t high) {
  return *rc::gen::inRange(low, high + 1);
}
// True once in `often` times.
bool seldom(int often) {
  return between(1, often) == 1;
}
int any_sense() {
  return seldom(2) ? 1 : -1;
}
Point any_point() {
  return {between(-50'000, 50'000), between(-50'000, 50'000), between(-50'000, 50'000)};
}

void straight(Step& step, const Stand& stand) {
  step.end = any_point();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    step.named[axis] = (stand.astray && axis < 2) || !seldom(3);
    if (!step.named[axis]) step.end[axis] = stand.at[axis];
  }
}

// About a centre by quarter turns, so that the end lies on the circle; sometimes a little beside
// it.
void centre_arc(Step& step, const Point& at) {
  step.offset = {between(1, 20'000) * any_sense(), between(-20'000, 20'000)};
  std::int64_t p = -step.offset[0];
  std::int64_t q = -step.offset[1];
  for (std::int64_t turns = between(1, 4); turns > 0; --turns) {
    const std::int64_t old_p = p;
    p = step.sense * -q;
    q = step.sense * old_p;
  }
  const std::int64_t beside = seldom(5) ? between(0, 12) : 0;
  step.named[2] = seldom(3);
  step.end = {at[0] + step.offset[0] + p + beside, at[1] + step.offset[1] + q,
              step.named[2] ? between(-50'000, 50'000) : at[2]};
}

void radius_arc(Step& step, const Point& at) {
  const std::int64_t dp = between(-20'000, 20'000);
  const std::int64_t dq = between(-20'000, 20'000);
  step.named[2] = seldom(3);
  step.end = {at[0] + dp, at[1] + dq, step.named[2] ? between(-50'000, 50'000) : at[2]};
  // Above half the chord; seldom too small.
  const std::int64_t least = (std::abs(dp) + std::abs(dq)) / (seldom(15) ? 4 : 1);
  step.r = (least + between(1, 5'000)) * any_sense();
}

// A repeat may change some of the words, or none.
CycleBlock cut_block(int code, bool first) {
  CycleBlock block;
  block.code = code;
  block.code_stands = !first && seldom(5);
  block.end = any_point();
  block.named = {!seldom(first ? 6 : 2), !seldom(first ? 6 : 2), seldom(80)};
  const std::int64_t most = seldom(4) ? 60'000 : 5'000;
  if (seldom(3)) block.r = seldom(3) ? 0 : between(-most, most);
  if (code == 92 && seldom(4)) block.words.push_back({seldom(2) ? 'J' : 'K', 0});
  if (!first && seldom(4)) block.words.push_back({'F', between(1, 900'000)});
  if (!first && seldom(6)) block.dwell = between(1, 5'000);
  return block;
}

// The code differs from the one in force, so that nothing is retained from before: a retained
// increment would be taken from where the tool stands now (GSK-MOD-07), a retained absolute word
// not.
void cut(Step& step, int motion) {
  static constexpr std::array<int, 3> kCodes = {90, 92, 94};
  auto choice = static_cast<std::size_t>(between(0, 2));
  if (kCodes[choice] == motion) choice = (choice + 1) % 3;
  for (std::int64_t count = between(1, 3); count > 0; --count) {
    step.blocks.push_back(cut_block(kCodes[choice], step.blocks.empty()));
  }
}

// Where one block mills: R and the depth lead the same way, but seldom.
CycleBlock site(const Stand& stand, int direction, std::int64_t depth) {
  CycleBlock block;
  block.end = any_point();
  if (!seldom(3)) block.r = direction * between(0, 5'000);
  if (seldom(25) && block.r) block.r = -*block.r;
  block.end[2] = stand.at[2] + block.r.value_or(0) + direction * depth;
  if (seldom(12)) block.named[static_cast<std::size_t>(between(0, 2))] = false;
  if (seldom(6)) block.dwell = between(1, 5'000);
  return block;
}

// In the mode: the other code of the pair, or the code once more, or no code.
int next_code(const Step& step, CycleBlock& block, int code) {
  block.code_stands = seldom(5);
  if (step.blocks.empty()) return code;
  const int last = step.blocks.back().code;
  return seldom(4) ? last ^ 1 : last;
}

void pocket(Step& step, const Stand& stand) {
  const std::int64_t tool = between(500, 5'000);
  const std::int64_t room = seldom(20) ? 0 : between(1, 12'000);
  const int direction = any_sense();
  const int code = seldom(2) ? 110 : 111;
  for (std::int64_t count = between(1, 3); count > 0; --count) {
    CycleBlock block = site(stand, direction, seldom(8) ? 0 : between(1, 20'000));
    block.code = next_code(step, block, code);
    const bool first = step.blocks.empty();
    if (first || seldom(4)) block.words.push_back({'I', tool + room});
    if (first || seldom(4)) {
      const std::int64_t step_over = room / 8 + between(1, 4'000);
      block.words.push_back({'L', std::min(2 * tool - (seldom(20) ? 0 : 1), step_over)});
    }
    if (first || seldom(4)) block.words.push_back({'Q', between(5'000, 20'000)});
    if (first || seldom(4)) block.words.push_back({'D', tool});
    if (!seldom(3)) block.words.push_back({'P', between(-6'000, 6'000)});
    if (first && seldom(20)) block.words.erase(block.words.begin());
    step.blocks.push_back(block);
  }
}

void helix(Step& step, const Stand& stand) {
  const std::int64_t tool = between(500, 5'000);
  const std::int64_t room = seldom(20) ? 0 : between(1, 12'000);
  const int direction = any_sense();
  const int code = seldom(2) ? 112 : 113;
  for (std::int64_t count = between(1, 3); count > 0; --count) {
    CycleBlock block = site(stand, direction, seldom(8) ? 0 : between(1, 20'000));
    block.code = next_code(step, block, code);
    const bool first = step.blocks.empty();
    if (first || seldom(4)) block.words.push_back({'I', tool + room});
    if (first || seldom(4)) block.words.push_back({'D', tool});
    if (!seldom(3)) block.words.push_back({'L', 1'000 * between(seldom(30) ? 0 : 1, 30), false});
    if (first && seldom(20)) block.words.erase(block.words.begin());
    step.blocks.push_back(block);
  }
}

// Half of them end at a multiple of 30 degrees, where sine and cosine are exact.
CycleBlock thread_block(const Stand& stand, bool internal, std::vector<Given> words) {
  std::int64_t depth = between(1, 20'000);
  std::int64_t lead = depth / 10 + between(1, 2 * depth);
  if (seldom(2)) {
    const std::int64_t twelfth = between(1, 500);
    lead = 12 * twelfth;
    depth = twelfth * between(1, 40);
  }
  if (seldom(12)) depth = 0;
  const std::int64_t tool = between(500, 5'000);
  const std::int64_t height = seldom(30) ? tool + 1 : between(1, tool);
  const std::int64_t bore = internal ? 2 * tool + (seldom(30) ? 0 : between(1, 40'000)) : 0;
  words.push_back({'I', lead});
  words.push_back({'P', height});
  words.push_back({'D', tool});
  words.push_back({'E', internal ? bore : between(1, 40'000)});
  if (seldom(40)) words.pop_back();
  if (!seldom(3)) words.push_back({'Q', seldom(5) ? 0 : height / 4 + between(1, height)});
  CycleBlock block = site(stand, any_sense(), depth);
  block.words = std::move(words);
  return block;
}

// The run-out: longer and shorter than the thread is high, none, or that of the parameters.
std::vector<Given> run_out_words() {
  std::vector<Given> words;
  if (!seldom(4)) words.push_back({'J', seldom(5) ? 0 : between(1, 6'000)});
  if (seldom(4)) return words;
  const std::int64_t angle = seldom(2) ? 30'000 * between(0, 12) : between(0, 360'000);
  words.push_back({'K', seldom(60) ? 360'001 : angle, false});
  return words;
}

void thread(Step& step, const Stand& stand) {
  const int first_code = static_cast<int>(between(114, 117));
  for (std::int64_t count = between(1, 3); count > 0; --count) {
    const int code =
        step.blocks.empty() || seldom(3) ? first_code : static_cast<int>(between(114, 117));
    CycleBlock block = thread_block(stand, code >= 116, run_out_words());
    block.code = code;
    block.code_stands = seldom(5);
    step.blocks.push_back(block);
  }
}

// From where a thread has left the tool an arc can meet no end point that is a count.
StepKind any_kind(const Stand& stand) {
  const auto kind = static_cast<StepKind>(between(0, static_cast<int>(kStepKinds) - 1));
  return stand.astray && kind == StepKind::centre_arc ? StepKind::increment : kind;
}

Step any_step(const Stand& stand, int motion) {
  Step step;
  step.kind = any_kind(stand);
  step.per_revolution = seldom(4);
  if (step.kind == StepKind::dwell || !seldom(12)) step.feed = between(1, 900'000);
  step.sense = any_sense();
  step.closes = seldom(2);
  switch (step.kind) {
    case StepKind::rapid:
    case StepKind::feed:
      straight(step, stand);
      break;
    case StepKind::increment:
      step.end = any_point();
      for (bool& named : step.named) named = !seldom(3);
      break;
    case StepKind::centre_arc:
      centre_arc(step, stand.at);
      break;
    case StepKind::radius_arc:
      radius_arc(step, stand.at);
      break;
    case StepKind::cut:
      cut(step, motion);
      break;
    case StepKind::pocket:
      pocket(step, stand);
      break;
    case StepKind::helix:
      helix(step, stand);
      break;
    case StepKind::thread:
      thread(step, stand);
      break;
    case StepKind::dwell:
      break;
  }
  return step;
}

// The code of group 01 in force after a step, where it matters to the next one.
int motion_after(const Step& step, int motion) {
  if (step.kind == StepKind::cut) return step.blocks.front().code;
  if (step.kind == StepKind::dwell) return motion;
  return is_milling(step.kind) && !step.closes ? motion : 0;
}

template <typename Move>
Model moved(Model model, Move move) {
  move(model.start);
  for (Step& step : model.steps) {
    if (step.kind != StepKind::increment) move(step.end);
    for (CycleBlock& block : step.blocks) move(block.end);
  }
  return model;
}

// -1 where a mirror turns the sign of R of a block.
void turn_r(CycleBlock& block, bool turns) {
  if (turns && block.r) block.r = -*block.r;
}

}  // namespace

Stand after(const CycleBlock& block, StepKind kind, Stand stand) {
  const bool mills = block.named == std::array<bool, 3>{true, true, true};
  if (!is_milling(kind) || !mills) return stand;
  const bool cuts = block.end[2] != stand.at[2] + block.r.value_or(0);
  return {{block.end[0], block.end[1], stand.at[2]}, kind == StepKind::thread && cuts};
}

Stand after(const Step& step, Stand stand) {
  for (const CycleBlock& block : step.blocks) stand = after(block, step.kind, stand);
  if (!step.blocks.empty() || step.kind == StepKind::dwell) return stand;
  if (step.kind != StepKind::increment) return {step.end, false};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (step.named[axis]) stand.at[axis] += step.end[axis];
  }
  return stand;
}

rc::Gen<Model> models() {
  // At the full size in each case: a range of size 0 is its lower end.
  return rc::gen::resize(rc::kNominalSize, rc::gen::exec([] {
                           Model model;
                           model.start = any_point();
                           Stand stand{model.start, false};
                           int motion = 0;
                           for (std::int64_t count = between(1, 8); count > 0; --count) {
                             model.steps.push_back(any_step(stand, motion));
                             stand = after(model.steps.back(), stand);
                             motion = motion_after(model.steps.back(), motion);
                           }
                           return model;
                         }));
}

Model translated(Model model, const Point& shift) {
  return moved(std::move(model), [&](Point& point) {
    for (std::size_t axis = 0; axis < 3; ++axis) point[axis] += shift[axis];
  });
}

// G90 and G92 have their taper along q.
Model mirrored_in_q(Model model) {
  for (Step& step : model.steps) {
    step.sense = -step.sense;
    step.offset[1] = -step.offset[1];
    if (step.kind == StepKind::increment) step.end[1] = -step.end[1];
    for (CycleBlock& block : step.blocks) {
      turn_r(block, block.code == 90 || block.code == 92);
      if (is_milling(step.kind)) block.code ^= 1;
    }
  }
  return moved(std::move(model), [](Point& point) { point[1] = -point[1]; });
}

// R leads along d to the R plane.
Model mirrored_in_d(Model model) {
  for (Step& step : model.steps) {
    if (step.kind == StepKind::increment) step.end[2] = -step.end[2];
    for (CycleBlock& block : step.blocks) turn_r(block, is_milling(step.kind));
  }
  return moved(std::move(model), [](Point& point) { point[2] = -point[2]; });
}

}  // namespace gonogo::reference::testing
