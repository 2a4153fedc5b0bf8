// SPDX-License-Identifier: GPL-3.0-or-later
// Relations that the expander of sinumerik840d keeps: one arc written in another form, a tangent
// that goes on.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "expanders/common/axes.hpp"
#include "harness.hpp"
#include "random_numbers.hpp"

namespace gonogo::expanders::testing {
namespace {

/// Along the first, second and third axis of the plane; thousandths.
using Vector = std::array<long, 3>;

/// How an arc is written.
enum class Form { kCentre, kAbsoluteCentre, kAngleAndCentre, kAngleAndEnd, kRadius, kPolar };

struct Step {
  enum class Kind { kRapid, kFeed, kArc, kThroughPoint, kTangent } kind = Kind::kRapid;
  bool incremental = false;
  Vector from{};
  Vector to{};
  Vector via{};
  // Of an arc: a spoke of the start that is turned by quarters.
  Form form = Form::kCentre;
  int sense = 1;
  long quarters = 1;  // 4: full
  long turns = 0;
  Vector centre{};
  long radius = 0;  // 0: not whole
};
using Program = std::vector<Step>;

long length() {
  return between(-200'000, 200'000);
}

// Any that the arc can be written in.
Form some_form(const Step& step) {
  const bool full = step.quarters == 4;
  std::vector<Form> forms = {Form::kCentre, Form::kAbsoluteCentre};
  if (!full) forms.insert(forms.end(), {Form::kAngleAndCentre, Form::kAngleAndEnd});
  if (step.radius != 0) forms.push_back(Form::kPolar);
  if (step.radius != 0 && !full) forms.push_back(Form::kRadius);
  return *rc::gen::elementOf(forms);
}

void make_arc(Step& step) {
  const bool along_axis = between(0, 1) == 1;
  std::array<long, 2> spoke{between(1, 90'000), along_axis ? 0 : length()};
  step.radius = along_axis ? spoke[0] : 0;
  for (long quarters = between(0, 3); quarters > 0; --quarters) spoke = {-spoke[1], spoke[0]};
  step.sense = between(0, 1) == 1 ? 1 : -1;
  step.quarters = between(1, 4);
  step.turns = between(0, 2);
  step.centre = {step.from[0] - spoke[0], step.from[1] - spoke[1], step.from[2]};
  for (long quarters = step.quarters; quarters > 0; --quarters) {
    spoke = {-step.sense * spoke[1], step.sense * spoke[0]};
  }
  step.to = {step.centre[0] + spoke[0], step.centre[1] + spoke[1],
             between(0, 1) == 1 ? length() : step.from[2]};
  step.form = some_form(step);
}

Step some_step(const Vector& from, Step::Kind last_kind) {
  Step step;
  step.kind = static_cast<Step::Kind>(between(0, static_cast<long>(last_kind)));
  step.incremental = between(0, 1) == 1;
  step.from = from;
  step.to = {length(), length(), length()};
  step.via = {length(), length(), length()};
  if (step.kind == Step::Kind::kArc) make_arc(step);
  return step;
}

Program some_program(Step::Kind last_kind) {
  Program program;
  Vector at{};
  for (long steps = between(1, 8); steps > 0; --steps) {
    program.push_back(some_step(at, last_kind));
    at = program.back().to;
  }
  return program;
}

/// A plane and where its zero lies.
struct Setting {
  const Plane* plane = &kPlanes[0];
  Vector shift{};

  std::size_t axis(std::size_t index) const {
    return index == 0 ? plane->p : index == 1 ? plane->q : plane->d;
  }
  std::string letter(std::size_t index, const char* letters) const {
    return std::string(" ") + letters[axis(index)];
  }
};

class Writer {
 public:
  Writer(const Setting& setting, bool all_incremental)
      : setting_(setting), flip_(all_incremental) {}

  std::string write(const Program& program) {
    text_ = "G" + std::to_string(setting_.plane->number) + "\n";
    for (const Step& step : program) write(step);
    return text_;
  }

 private:
  void write(const Step& step) {
    if (step.kind == Step::Kind::kArc && step.form == Form::kPolar) write_pole(step);
    const bool incremental = step.incremental != flip_;
    text_ += incremental ? "G91" : "G90";
    text_ += " F60";
    switch (step.kind) {
      case Step::Kind::kRapid:
        text_ += " G0";
        break;
      case Step::Kind::kFeed:
        text_ += " G1";
        break;
      case Step::Kind::kThroughPoint:
        text_ += " CIP";
        put_place("IJK", "1=", step.via, step.from, incremental, 3);
        break;
      case Step::Kind::kTangent:
        text_ += " CT";
        break;
      case Step::Kind::kArc:
        return write_arc(step, incremental);
    }
    put_place("XYZ", "", step.to, step.from, incremental, 3);
    text_ += "\n";
  }

  void put_place(const char* letters, const char* sign, const Vector& to, const Vector& from,
                 bool incremental, std::size_t axes, std::size_t first = 0) {
    for (std::size_t i = first; i < axes; ++i) {
      const long value = incremental ? to[i] - from[i] : to[i] + setting_.shift[i];
      text_ += setting_.letter(i, letters) + sign + millimetres(value);
    }
  }

  void write_pole(const Step& step) {
    text_ += "G111";
    put_place("XYZ", "", step.centre, {}, false, 2);
    text_ += "\n";
  }

  void write_arc(const Step& step, bool incremental) {
    text_ += step.sense > 0 ? " G3" : " G2";
    text_ += " TURN=" + std::to_string(step.turns);
    const bool end = step.form != Form::kPolar && step.form != Form::kAngleAndCentre;
    put_place("XYZ", "", step.to, step.from, incremental, 3, end ? 0 : 2);
    const std::string angle = " AR=" + std::to_string(90 * step.quarters);
    switch (step.form) {
      case Form::kAngleAndCentre:
        text_ += angle;
        [[fallthrough]];
      case Form::kCentre:
        put_place("IJK", "", step.centre, step.from, true, 2);
        break;
      case Form::kAbsoluteCentre:
        for (std::size_t i = 0; i < 2; ++i) {
          text_ += setting_.letter(i, "IJK") + "=AC(" +
                   millimetres(step.centre[i] + setting_.shift[i]) + ")";
        }
        break;
      case Form::kAngleAndEnd:
        text_ += angle;
        break;
      case Form::kRadius:
        text_ += " CR=" + millimetres(step.quarters == 3 ? -step.radius : step.radius);
        break;
      case Form::kPolar:
        text_ += " RP=" + millimetres(step.radius) + " AP=" + std::to_string(polar_angle(step));
        break;
    }
    text_ += "\n";
  }

  static int polar_angle(const Step& step) {
    const long p = step.to[0] - step.centre[0];
    const long q = step.to[1] - step.centre[1];
    if (q == 0) return p > 0 ? 0 : 180;
    return q > 0 ? 90 : 270;
  }

  const Setting& setting_;
  bool flip_;
  std::string text_;
};

std::string profile_at(const Setting& setting) {
  Vector at{};
  for (std::size_t i = 0; i < 3; ++i) at[setting.axis(i)] = setting.shift[i];
  return R"({"initial":{"x":")" + millimetres(at[0]) + R"(","y":")" + millimetres(at[1]) +
         R"(","z":")" + millimetres(at[2]) + R"("}})";
}

/// A number of a record: what it is, in the names p, q and d of the plane, and how much.
struct Quantity {
  std::string name;
  Fixed value = 0;
  bool operator<(const Quantity& other) const { return name < other.name; }
};
/// A record: its kind, and its numbers in the order of their names.
struct PlaneMotion {
  std::string kind;
  std::vector<Quantity> numbers;
};

Fixed number(const std::string& text) {
  const char* cursor = text.data();
  Decimal result;
  if (!read_decimal(cursor, text.data() + text.size(), result)) throw std::logic_error(text);
  return result.value;
}

// Adds a coordinate of the axis `axis`.
void add_place(PlaneMotion& motion, const char* what, std::size_t axis, const std::string& text,
               const Setting& setting) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (setting.axis(i) != axis) continue;
    motion.numbers.push_back(
        {std::string(what) + "pqd"[i], number(text) - setting.shift[i] * (kOne / 1000)});
  }
}

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, at);) parts.push_back(part);
  return parts;
}

PlaneMotion plane_motion_of(const std::string& record, const Setting& setting) {
  PlaneMotion motion;
  for (const std::string& part : split(record, ' ')) {
    const std::size_t sign = part.find('=');
    const std::string value = sign == std::string::npos ? "" : part.substr(sign + 1);
    if (part.starts_with("arc1")) {
      const bool same = part == "arc" + std::to_string(setting.plane->number);
      motion.kind = same ? "arc" : "arc in another plane";
    } else if (sign == std::string::npos) {
      motion.kind = part;
    } else if (part.starts_with("c=") && value.find(',') != std::string::npos) {
      const std::vector<std::string> both = split(value, ',');
      add_place(motion, "c", setting.plane->p, both.at(0), setting);
      add_place(motion, "c", setting.plane->q, both.at(1), setting);
    } else if (part.starts_with("via=")) {
      const std::vector<std::string> all = split(value, ',');
      for (std::size_t axis = 0; axis < 3; ++axis) {
        add_place(motion, "via", axis, all.at(axis), setting);
      }
    } else if (part[0] >= 'x' && part[0] <= 'z') {
      add_place(motion, "", static_cast<std::size_t>(part[0] - 'x'), value, setting);
    } else {
      motion.numbers.push_back({part.substr(0, sign), number(value)});
    }
  }
  std::sort(motion.numbers.begin(), motion.numbers.end());
  return motion;
}

std::vector<PlaneMotion> plane_motions_of(const Outcome& outcome, const Setting& setting) {
  std::vector<PlaneMotion> motions;
  for (const std::string& record : outcome.records)
    motions.push_back(plane_motion_of(record, setting));
  return motions;
}

// `tolerance` in counts of 1e-9.
void compare(const std::vector<PlaneMotion>& got, const std::vector<PlaneMotion>& want,
             Fixed tolerance) {
  RC_ASSERT(got.size() == want.size());
  for (std::size_t i = 0; i < got.size(); ++i) {
    RC_ASSERT(got[i].kind == want[i].kind);
    RC_ASSERT(got[i].numbers.size() == want[i].numbers.size());
    for (std::size_t j = 0; j < got[i].numbers.size(); ++j) {
      RC_ASSERT(got[i].numbers[j].name == want[i].numbers[j].name);
      RC_ASSERT(magnitude(got[i].numbers[j].value - want[i].numbers[j].value) <= tolerance);
    }
  }
}

Outcome run_written(const Program& program, const Setting& setting, bool flipped = false) {
  const std::string text = Writer(setting, flipped).write(program);
  RC_LOG() << text;
  return run_sinumerik(text, profile_at(setting));
}

// Where an end is reckoned it may be off by a count.
RC_GTEST_PROP(SinumerikRelations, FormsOfAnArcAgree, ()) {
  Program program = some_program(Step::Kind::kThroughPoint);
  const Setting setting{&kPlanes[between(0, 2)], {length(), length(), length()}};
  const Outcome one = run_written(program, setting);
  RC_ASSERT(one.alarm.empty());
  for (Step& step : program) {
    if (step.kind == Step::Kind::kArc) step.form = some_form(step);
  }
  const Outcome other = run_written(program, setting, true);
  RC_ASSERT(other.alarm.empty());
  // Names of plane axes stand in every arc, those of the third axis where they were written.
  compare(plane_motions_of(other, setting), plane_motions_of(one, setting), 10);
}

// The direction at the end of an arc is square to its radius: a CT to another of its points keeps
// its circle.
RC_GTEST_PROP(SinumerikRelations, TangentGoesOnRoundTheSameCircle, ()) {
  Step arc;
  arc.kind = Step::Kind::kArc;
  make_arc(arc);
  arc.quarters = 1;  // which every form can write
  arc.to = {arc.centre[0] + arc.sense * arc.centre[1], arc.centre[1] - arc.sense * arc.centre[0],
            0};
  arc.turns = 0;
  arc.form = some_form(arc);
  Step tangent;
  tangent.kind = Step::Kind::kTangent;
  tangent.from = arc.to;
  // Opposite of the start.
  tangent.to = {2 * arc.centre[0], 2 * arc.centre[1], 0};
  const Setting setting;
  const std::vector<PlaneMotion> motions =
      plane_motions_of(run_written({arc, tangent}, setting), setting);
  RC_ASSERT(motions.size() == 3u);
  const PlaneMotion& first = motions[0];
  const PlaneMotion& second = motions[1];
  RC_ASSERT(first.kind == "arc");
  RC_ASSERT(second.kind == "arc");
  for (const char* name : {"cp", "cq", "rot"}) {
    auto find = [&](const PlaneMotion& motion) {
      return std::find_if(motion.numbers.begin(), motion.numbers.end(),
                          [&](const Quantity& quantity) { return quantity.name == name; });
    };
    RC_ASSERT(magnitude(find(first)->value - find(second)->value) <= 10);
  }
}

}  // namespace
}  // namespace gonogo::expanders::testing
