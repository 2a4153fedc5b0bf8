// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs at random.
#include "sie_program.hpp"

#include <algorithm>
#include <cstdlib>
#include <ostream>

namespace gonogo::reference::testing::sie {
namespace {

using Pair = std::array<std::int64_t, 2>;

bool seldom(int often) {
  return any_between(1, often) == 1;
}
std::int64_t any_sign(std::int64_t value) {
  return seldom(2) ? -value : value;
}
Vector any_place() {
  return {any_between(-50'000, 50'000), any_between(-50'000, 50'000), any_between(-50'000, 50'000)};
}

// Writes the steps of one program.
class Maker {
 public:
  Program make(bool two_way) {
    two_way_ = two_way;
    program_.start = at_ = any_place();
    if (!two_way) add_readings();
    for (std::int64_t count = any_between(1, 8); count > 0; --count) add_step();
    return std::move(program_);
  }

 private:
  void add_readings() {
    static const std::vector<std::pair<std::string_view, std::string_view>> kReadings = {
        {"sie.arc.correct", "project"},
        {"sie.arc.correct", "programmed"},
        {"sie.cr.tolerance", "const"},
        {"sie.arc.correct", "start-radius"}};
    if (seldom(2)) program_.readings.push_back(kReadings[std::size_t(any_between(0, 3))]);
  }

  Step step_of(Kind kind) {
    Step step;
    step.kind = kind;
    step.plane = plane_;
    step.sense = seldom(2) ? 1 : -1;
    step.from = step.to = step.centre = step.via = at_;
    step.astray = astray_;
    return step;
  }

  void add(Step step, bool astray = false) {
    at_ = step.to;
    astray_ = astray;
    program_.steps.push_back(step);
  }

  void add_step() {
    if (seldom(4)) {
      plane_ = static_cast<Plane>(any_between(0, 2));
      has_pole_ = false;
    }
    static constexpr std::array kAny = {Kind::rapid,  Kind::feed,       Kind::centre,
                                        Kind::centre, Kind::radius,     Kind::angle_centre,
                                        Kind::cip,    Kind::angle_end,  Kind::polar_line,
                                        Kind::ct,     Kind::polar_line, Kind::ct};
    static constexpr std::array kTwoWay = {Kind::rapid, Kind::feed, Kind::centre, Kind::radius,
                                           Kind::cip};
    Kind kind =
        two_way_ ? kTwoWay[std::size_t(any_between(0, 4))] : kAny[std::size_t(any_between(0, 11))];
    if (astray_) kind = Kind::feed;
    if (kind == Kind::polar_line) return polar();
    Step step = step_of(kind);
    bool astray = false;
    switch (kind) {
      case Kind::rapid:
      case Kind::feed:
        step.to = any_place();
        break;
      case Kind::centre:
        centre(step);
        break;
      case Kind::radius:
        radius(step);
        break;
      case Kind::cip:
        cip(step);
        break;
      case Kind::ct:
        step.to = on_plane(at_, {any_between(-20'000, 20'000), any_between(-20'000, 20'000)});
        if (seldom(5)) step.to[step.third()] += any_between(-9'000, 9'000);
        break;
      default:
        astray = by_angle(step);
    }
    add(step, astray);
  }

  Vector on_plane(Vector place, Pair by) const {
    const PlaneAxes axes = axes_of(plane_);
    place[index(axes.p)] += by[0];
    place[index(axes.q)] += by[1];
    return place;
  }

  void third_axis(Step& step) {
    if (seldom(3)) step.to[step.third()] += any_between(-20'000, 20'000);
    if (seldom(4)) step.turns = static_cast<int>(any_between(0, 3));
  }

  // By quarter turns, so that the end lies on the circle; sometimes a little beside it.
  void centre(Step& step) {
    const Pair spoke = {any_sign(any_between(1, 20'000)), any_between(-20'000, 20'000)};
    Pair end = spoke;
    for (std::int64_t quarters = any_between(0, 3); quarters > 0; --quarters) {
      end = {-end[1], end[0]};
    }
    if (!two_way_ && seldom(3)) end[0] += any_between(-13, 13);
    step.centre = on_plane(at_, {-spoke[0], -spoke[1]});
    step.to = on_plane(step.centre, end);
    third_axis(step);
  }

  // Sometimes about half the chord.
  void radius(Step& step) {
    const std::int64_t k = any_sign(any_between(1, 5'000));
    const bool pythagorean = seldom(3);
    const Pair by = pythagorean ? Pair{6 * k, 8 * k} : Pair{2 * k, any_between(-20'000, 20'000)};
    step.to = on_plane(at_, by);
    step.radius = std::abs(by[0]) + std::abs(by[1]) + any_between(0, 5'000);
    if (pythagorean) {
      step.radius = 5 * std::abs(k) + (two_way_ ? 0 : any_between(-7, 3));
      if (step.radius <= 0) step.radius = 10;
    }
    if (seldom(3)) step.radius = -step.radius;
    third_axis(step);
  }

  void cip(Step& step) {
    if (seldom(5)) {  // in line
      const Vector by = any_place();
      const std::int64_t to_via = two_way_ ? 1 : any_between(-1, 3);
      for (std::size_t i = 0; i < 3; ++i) {
        step.via[i] = at_[i] + to_via * by[i];
        step.to[i] = at_[i] + 2 * by[i];
      }
      return;
    }
    step.via = any_place();
    step.to = any_place();
  }

  // Whether the tool ends where no decimal says.
  bool by_angle(Step& step) {
    step.angle = seldom(3) ? 90'000 * any_between(1, 3) : any_between(1, 359'999);
    if (step.kind == Kind::angle_end) {
      step.to = on_plane(at_, {any_sign(any_between(1, 20'000)), any_between(-20'000, 20'000)});
    } else {
      step.centre = on_plane(at_, {any_sign(any_between(1, 20'000)), any_between(-20'000, 20'000)});
    }
    third_axis(step);
    return step.kind == Kind::angle_centre;
  }

  // A pole, a line to a circle about it, and often an arc on that circle.
  void polar() {
    Step pole = step_of(Kind::pole);
    pole.base = static_cast<int>(any_between(110, has_pole_ ? 112 : 111));
    pole.base_at = pole.base == 110 ? at_ : pole.base == 112 ? pole_ : Vector{};
    pole.centre = pole_ =
        on_plane({}, {any_between(-30'000, 30'000), any_between(-30'000, 30'000)});
    has_pole_ = true;
    add(pole);
    Step line = step_of(Kind::polar_line);
    line.angle = any_between(-360, 360) * 1'000 / (seldom(3) ? 7 : 1);
    line.radius = any_between(1'000, 30'000);
    if (seldom(4)) line.to[line.third()] += any_between(-9'000, 9'000);
    add(line, true);
    if (seldom(3)) return;
    Step arc = step_of(Kind::polar_arc);
    // Not a half turn, where the last bit would decide.
    arc.angle = line.angle + any_sign(any_between(3'000, 170'000));
    if (std::abs(arc.angle) > 360'000) arc.angle = line.angle;
    // Beside its circle; not by the radius through the start, which has the centre on it.
    const bool misses = arc.angle != line.angle && seldom(4);
    arc.radius = line.radius + (misses ? any_between(1, 7) : 0);
    third_axis(arc);
    add(arc, true);
  }

  Program program_;
  bool two_way_ = false;
  Plane plane_ = Plane::g17;
  Vector at_ = {0, 0, 0};
  Vector pole_ = {0, 0, 0};
  bool has_pole_ = false;
  bool astray_ = false;
};

template <typename Move>
Program moved(Program program, Move move) {
  move(program.start);
  for (Step& step : program.steps) {
    for (Vector* place : {&step.from, &step.to, &step.centre, &step.via, &step.base_at}) {
      move(*place);
    }
  }
  return program;
}

}  // namespace

// At the full size in each case: a range of size 0 is its lower end.
rc::Gen<Program> programs() {
  return rc::gen::resize(rc::kNominalSize, rc::gen::exec([] { return Maker().make(false); }));
}

rc::Gen<Program> two_way_programs() {
  return rc::gen::resize(rc::kNominalSize, rc::gen::exec([] { return Maker().make(true); }));
}

Program reversed(Program program) {
  if (!program.steps.empty()) program.start = program.steps.back().to;
  std::reverse(program.steps.begin(), program.steps.end());
  for (Step& step : program.steps) {
    std::swap(step.from, step.to);
    step.sense = -step.sense;
  }
  return program;
}

Program scaled(Program program, int times) {
  program = moved(std::move(program), [&](Vector& place) {
    for (std::int64_t& coordinate : place) coordinate *= times;
  });
  for (Step& step : program.steps) step.radius *= times;
  return program;
}

void operator<<(std::ostream& out, const Program& program) {
  out << "from " << decimal(program.start[0]) << " " << decimal(program.start[1]) << " "
      << decimal(program.start[2]) << "\n"
      << text(write(program, {}));
  for (const auto& [reading, value] : program.readings) out << reading << "=" << value << "\n";
}

}  // namespace gonogo::reference::testing::sie
