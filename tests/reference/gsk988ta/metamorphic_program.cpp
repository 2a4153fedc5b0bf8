// SPDX-License-Identifier: GPL-3.0-or-later
#include "metamorphic_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ostream>

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

void straight(Step& step, const Point& at) {
  Point end = any_point();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    step.named[axis] = !seldom(3);
    if (!step.named[axis]) end[axis] = at[axis];
  }
  step.ends = {end};
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
  step.ends = {{at[0] + step.offset[0] + p + beside, at[1] + step.offset[1] + q,
                step.named[2] ? between(-50'000, 50'000) : at[2]}};
}

void radius_arc(Step& step, const Point& at) {
  const std::int64_t dp = between(-20'000, 20'000);
  const std::int64_t dq = between(-20'000, 20'000);
  step.named[2] = seldom(3);
  step.ends = {{at[0] + dp, at[1] + dq, step.named[2] ? between(-50'000, 50'000) : at[2]}};
  // Above half the chord; seldom too small.
  const std::int64_t least = (std::abs(dp) + std::abs(dq)) / (seldom(10) ? 4 : 1);
  step.r = (least + between(1, 5'000)) * any_sense();
}

void taper(Step& step) {
  step.named[2] = false;
  for (std::int64_t count = between(1, 3); count > 0; --count) step.ends.push_back(any_point());
  step.r = seldom(3) ? 0 : between(-5'000, 5'000);
}

void pocket(Step& step, const Point& at) {
  step.tool = between(500, 5'000);
  const std::int64_t room = seldom(10) ? 0 : between(1, 12'000);
  step.pocket_radius = step.tool + room;
  step.step = std::min(2 * step.tool - (seldom(10) ? 0 : 1), room / 8 + between(1, 4'000));
  const std::int64_t direction = any_sense();
  step.r = seldom(3) ? 0 : direction * between(0, 5'000);
  if (seldom(15)) step.r = -step.r;
  std::int64_t deepest = 0;
  for (std::int64_t count = between(1, 2); count > 0; --count) {
    Point place = any_point();
    const std::int64_t depth = seldom(8) ? 0 : between(1, 20'000);
    deepest = std::max(deepest, depth);
    place[2] = at[2] + step.r + direction * depth;
    step.ends.push_back(place);
  }
  step.infeed = deepest / 4 + between(1, 5'000);
  step.clearance = between(-6'000, 6'000);
}

Step any_step(const Point& at) {
  Step step;
  step.kind = static_cast<StepKind>(between(0, static_cast<int>(StepKind::dwell)));
  step.per_revolution = seldom(4);
  step.feed = between(1, 900'000);
  step.sense = any_sense();
  switch (step.kind) {
    case StepKind::rapid:
    case StepKind::feed:
      straight(step, at);
      break;
    case StepKind::centre_arc:
      centre_arc(step, at);
      break;
    case StepKind::radius_arc:
      radius_arc(step, at);
      break;
    case StepKind::taper:
      taper(step);
      break;
    case StepKind::pocket:
      pocket(step, at);
      break;
    case StepKind::dwell:
      break;
  }
  return step;
}

// Where the machine stands after a step.
Point after(const Step& step, const Point& at) {
  if (step.kind == StepKind::taper || step.kind == StepKind::dwell) return at;
  if (step.kind == StepKind::pocket) return {step.ends.back()[0], step.ends.back()[1], at[2]};
  return step.ends.back();
}

template <typename Move>
Model moved(Model model, Move move) {
  move(model.start);
  for (Step& step : model.steps) {
    for (Point& end : step.ends) move(end);
  }
  return model;
}

// Writes steps as blocks of words; keeps where the machine stands.
class Writer {
 public:
  Writer(const Model& model, const Writing& writing)
      : writing_(writing), axes_(axes_of(writing.plane)), at_(model.start) {
    block({{'G', fmt::format("{}", plane_code(writing.plane))},
           {'G', writing.lengths == Lengths::inch ? "20" : "21"}});
    for (const Step& step : model.steps) put(step);
  }
  std::vector<Words> take() { return std::move(blocks_); }

 private:
  void block(Words words) { blocks_.push_back(std::move(words)); }

  std::string number(std::int64_t count) const {
    const bool converted = writing_.lengths == Lengths::inch_in_mm;
    const std::int64_t value = std::abs(converted ? count * 254 : count);
    const std::int64_t one = converted ? 10'000 : 1'000;
    return fmt::format("{}{}.{:0{}}", count < 0 ? "-" : "", value / one, value % one,
                       converted ? 4 : 3);
  }

  Axis axis(std::size_t place) const {
    return place == 0 ? axes_.p : place == 1 ? axes_.q : axes_.d;
  }

  // The word of an axis; an increment counts from `from`.
  Word word(std::size_t place, std::int64_t to, std::int64_t from) const {
    std::int64_t value = writing_.incremental ? to - from : to;
    if (axis(place) == Axis::x && writing_.diameter) value *= 2;
    return {(writing_.incremental ? "UVW" : "XYZ")[index(axis(place))], number(value)};
  }

  Words end_words(const Step& step, const Point& end) const {
    Words words;
    for (std::size_t place = 0; place < 3; ++place) {
      if (step.named[place]) words.push_back(word(place, end[place], at_[place]));
    }
    return words;
  }

  void put(const Step& step) {
    static constexpr const char* kCodes[] = {"0", "1", "", "", "94", "", "4"};
    std::string code = kCodes[static_cast<std::size_t>(step.kind)];
    if (step.kind == StepKind::dwell) {
      block({{'G', code}, {'P', fmt::format("{}", step.feed)}});
      return;
    }
    const bool is_pocket = step.kind == StepKind::pocket;
    if (is_pocket) code = step.sense < 0 ? "110" : "111";
    if (code.empty()) code = step.sense < 0 ? "2" : "3";
    Words head = {{'G', code}, {'G', step.per_revolution ? "99" : "98"}, {'F', number(step.feed)}};
    if (is_pocket) {
      head.push_back({'I', number(step.pocket_radius)});
      head.push_back({'L', number(step.step)});
      head.push_back({'Q', number(step.infeed)});
      head.push_back({'D', number(step.tool)});
    }
    const std::int64_t initial_plane = at_[2];
    for (const Point& end : step.ends) {
      put_end(step, end, initial_plane, std::move(head));
      head.clear();
    }
    if (is_pocket) block({{'G', "80"}});
    at_[2] = is_pocket ? initial_plane : at_[2];
  }

  void put_end(const Step& step, const Point& end, std::int64_t initial_plane, Words words) {
    Words last = end_words(step, end);
    if (step.kind == StepKind::pocket) {
      last.back() = word(2, end[2], initial_plane + step.r);  // from the R plane
      last.push_back({'P', number(step.clearance)});
    }
    words.insert(words.end(), last.begin(), last.end());
    if (step.kind == StepKind::centre_arc) {
      words.push_back({"IJK"[index(axes_.p)], number(step.offset[0])});
      words.push_back({"IJK"[index(axes_.q)], number(step.offset[1])});
    } else if (step.kind != StepKind::rapid && step.kind != StepKind::feed) {
      words.push_back({'R', number(step.r)});
    }
    block(std::move(words));
    at_ = after(step, at_);
    if (step.kind == StepKind::pocket) at_ = {end[0], end[1], initial_plane};
  }

  Writing writing_;
  PlaneAxes axes_;
  Point at_;
  std::vector<Words> blocks_;
};

}  // namespace

rc::Gen<Model> models() {
  return rc::gen::exec([] {
    Model model;
    model.start = any_point();
    Point at = model.start;
    for (std::int64_t count = between(1, 8); count > 0; --count) {
      model.steps.push_back(any_step(at));
      at = after(model.steps.back(), at);
    }
    return model;
  });
}

Model translated(Model model, const Point& shift) {
  return moved(std::move(model), [&](Point& point) {
    for (std::size_t axis = 0; axis < 3; ++axis) point[axis] += shift[axis];
  });
}

Model mirrored_in_q(Model model) {
  for (Step& step : model.steps) {
    step.sense = -step.sense;
    step.offset[1] = -step.offset[1];
  }
  return moved(std::move(model), [](Point& point) { point[1] = -point[1]; });
}

Model mirrored_in_d(Model model) {
  for (Step& step : model.steps) {
    if (step.kind == StepKind::pocket) step.r = -step.r;
  }
  return moved(std::move(model), [](Point& point) { point[2] = -point[2]; });
}

std::vector<Words> write(const Model& model, const Writing& writing) {
  return Writer(model, writing).take();
}

Profile machine(const Model& model, const Writing& writing) {
  Profile profile;
  profile.x_diameter = writing.diameter;
  const Number one = Number(writing.lengths == Lengths::mm ? 1'000 : 25'400) / 1'000'000;
  const PlaneAxes axes = axes_of(writing.plane);
  profile.initial.at[axes.p] = Number(model.start[0]) * one;
  profile.initial.at[axes.q] = Number(model.start[1]) * one;
  profile.initial.at[axes.d] = Number(model.start[2]) * one;
  return profile;
}

std::string text(const std::vector<Words>& blocks) {
  std::string program;
  for (const Words& words : blocks) {
    for (const Word& word : words) {
      if (&word != &words.front()) program += ' ';
      program += word.address + word.number;
    }
    program += '\n';
  }
  return program;
}

void operator<<(std::ostream& out, const Model& model) {
  out << fmt::format("from ({}, {}, {}) thousandths along p, q, d:\n", model.start[0],
                     model.start[1], model.start[2])
      << text(write(model, {}));
}

}  // namespace gonogo::reference::testing
