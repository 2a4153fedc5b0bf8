// SPDX-License-Identifier: GPL-3.0-or-later
//
// What comes one after the other on the HNC-21T.
#include <array>

#include "generate/cover/sequence_models.hpp"

namespace gonogo::cover {
namespace {

// Each step in increments, so that it can follow any other. `arc`: an arc is the motion in force.
void draw_hnc_step(const std::string& step, bool arc, Drawing& drawing) {
  const auto x = [&](std::int64_t length) { return drawing.letters(Role::q, mm(length)); };
  const auto z = [&](std::int64_t length) { return drawing.letters(Role::p, mm(length)); };
  if (step == "rapid") drawing.put({"G00", x(4), z(-3)});
  if (step == "feed") drawing.put({"G01", x(-2), z(-5), "F100"});
  if (step == "arc") drawing.put({"G03", x(8), z(6), "R13 F110"});
  if (step == "dwell") drawing.put({"G04 P120"});
  if (step == "rename") drawing.put({"G92 X80 Z10"});
  if (step == "offset") drawing.put({"G55"});
  if (step == "bare") drawing.put({x(3), z(-6), arc ? "R13" : ""});
  if (step == "G32") drawing.put({"G32", z(-20), "F1.5"});
  if (step == "G74") drawing.put({"G74 R0.5 Q4", x(1), z(-10), "F120"});
  if (step == "G75") drawing.put({"G75 R0.5 Q2", x(-5), z(-6), "I2 F130"});
  if (step == "G80") drawing.put({"G80", x(-4), z(-20), "I-1 F140"});
  if (step == "G81") drawing.put({"G81", x(-20), z(-4), "K2 F150"});
  if (step == "G82") drawing.put({"G82", x(-2), z(-20), "R-1 E1 C2 P180 F2"});
  if (step == "radius") drawing.put({"G37"});
  if (step == "inch") drawing.put({"G20"});
  if (step == "turn") drawing.put({"G95 F0.2"});
  if (step == "modal") drawing.put({"G91"});
}

void draw_hnc_sequence(const Pick& pick, Drawing& drawing) {
  drawing.profile.offsets["G55"][reference::Axis::x] = reference::Number(7);
  drawing.profile.offsets["G55"][reference::Axis::z] = reference::Number(-15);
  drawing.stand(mm(4), mm(50), {}, "F90");
  bool arc = false;
  for (const char* place : {"first", "second", "third"}) {
    const std::string& step = pick[place];
    draw_hnc_step(step, arc, drawing);
    constexpr std::string_view kWithoutMotion = "dwell rename offset bare radius inch turn modal";
    if (kWithoutMotion.find(step) == std::string_view::npos) arc = step == "arc";
  }
  drawing.put(
      {drawing.letters(Role::q, mm(-2)), drawing.letters(Role::p, mm(-3)), arc ? "R5" : ""});
  drawing.put({"M30"});
}

constexpr std::string_view kHncSteps =
    "rapid feed arc dwell rename offset bare G32 G74 G75 G80 G81 G82 radius inch turn modal\n";

}  // namespace

Model hnc_sequence_model() {
  return {"hnc.sequence",
          1,
          "hnc21t",
          "modes",
          {2, 2},
          "basic arc g32 g74 g75 g80 g81 g82",
          "HNC-MOD-01..05 HNC-COM-01",
          joined({"first: ", kHncSteps, "second: ", kHncSteps, "third: ", kHncSteps,
                  "x: diameter radius\n"}),
          draw_hnc_sequence};
}

}  // namespace gonogo::cover
