// SPDX-License-Identifier: GPL-3.0-or-later
//
// What comes one after the other on the HNC-21T.
#include <array>

#include "fuzz/generate/cover/model.hpp"

namespace gonogo::cover {
namespace {

// A block without a code, as the motion in force takes it: an arc has its radius, and G74 no X.
void put_bare(const std::string& in_force, std::int64_t x, std::int64_t z, const char* radius,
              Drawing& drawing) {
  drawing.put({in_force == "G74" ? "" : drawing.letters(Role::q, mm(x)),
               drawing.letters(Role::p, mm(z)), in_force == "arc" ? radius : ""});
}

// Each step in increments, so that it can follow any other.
void draw_hnc_step(const std::string& step, const std::string& in_force, Drawing& drawing) {
  const auto x = [&](std::int64_t length) { return drawing.letters(Role::q, mm(length)); };
  const auto z = [&](std::int64_t length) { return drawing.letters(Role::p, mm(length)); };
  if (step == "rapid") drawing.put({"G00", x(4), z(-3)});
  if (step == "feed") drawing.put({"G01", x(-2), z(-5), "F100"});
  if (step == "arc") drawing.put({"G03", x(8), z(6), "R13 F110"});
  if (step == "dwell") drawing.put({"G04 P120"});
  if (step == "rename") drawing.put({"G92 X80 Z10"});
  if (step == "offset") drawing.put({"G55"});
  if (step == "bare") put_bare(in_force, 3, -6, "R13", drawing);
  if (step == "G32") drawing.put({"G32", z(-20), "F1.5"});
  if (step == "G74") drawing.put({"G74 R0.5 Q4", z(-10), "F120"});
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
  std::string in_force;
  for (const char* place : {"first", "second", "third"}) {
    const std::string& step = pick[place];
    draw_hnc_step(step, in_force, drawing);
    constexpr std::string_view kWithoutMotion = "dwell rename offset bare radius inch turn modal";
    if (kWithoutMotion.find(step) == std::string_view::npos) in_force = step;
  }
  put_bare(in_force, -2, -3, "R5", drawing);
  drawing.put({"M30"});
}

constexpr std::string_view kHncSteps =
    "rapid feed arc dwell rename offset bare G32 G74 G75 G80 G81 G82 radius inch turn modal\n";

}  // namespace

Model hnc_sequence_model() {
  return {"hnc.sequence",
          2,
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
