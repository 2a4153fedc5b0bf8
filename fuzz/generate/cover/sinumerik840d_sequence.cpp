// SPDX-License-Identifier: GPL-3.0-or-later
//
// What comes one after the other on the SINUMERIK 840D.
#include <array>

#include "fuzz/generate/cover/model.hpp"

namespace gonogo::cover {
namespace {

void draw_840d_step(const std::string& step, Drawing& drawing) {
  const std::string p(1, drawing.letter(Role::p));
  const std::string q(1, drawing.letter(Role::q));
  const std::string d(1, drawing.letter(Role::d));
  const std::string i = drawing.offset(Role::p, mm(9));
  const std::string j = drawing.offset(Role::q, mm(-12));
  const std::string i1(1, static_cast<char>(p[0] - 'X' + 'I'));
  const std::string j1(1, static_cast<char>(q[0] - 'X' + 'I'));
  if (step == "rapid") drawing.put({"G0", p + "4", q + "-3"});
  if (step == "feed") drawing.put({"G1", p + "=IC(-2)", d + "=IC(5)", "F100"});
  if (step == "circle") drawing.put({"G2", i, j, "F110"});
  if (step == "radius") drawing.put({"G3", p + "=IC(6)", q + "=IC(8)", "CR=13 F120"});
  if (step == "angle") drawing.put({"G2", i, j, "AR=90 F130"});
  if (step == "polar") drawing.put({"G1 AP=30 RP=25 F140"});
  if (step == "pole") drawing.put({"G110", p + "3", q + "1"});
  if (step == "CIP") {
    drawing.put({"CIP", p + "=IC(10)", q + "=IC(0)", i1 + "1=IC(5)", j1 + "1=IC(5)", "F150"});
  }
  if (step == "CT") drawing.put({"CT", p + "=IC(7)", q + "=IC(11)", "F160"});
  if (step == "dwell") drawing.put({"G4 F0.5"});
  if (step == "plane") {
    drawing.plane(18);
    drawing.put({"G18"});
  }
  if (step == "inch") drawing.put({"G70"});
  if (step == "modal") drawing.put({"G91"});
  if (step == "turn") drawing.put({"G95 F0.2"});
}

void draw_840d_sequence(const Pick& pick, Drawing& drawing) {
  for (const char* feature : {"cr", "ar", "polar", "planes", "cip", "ct"}) {
    drawing.features.emplace_back(feature);
  }
  drawing.stand(mm(1), mm(2), mm(3));
  drawing.put({"G1 Y14 Z5 F90"});
  for (const char* place : {"first", "second", "third"}) draw_840d_step(pick[place], drawing);
  drawing.put({"G1", std::string(1, drawing.letter(Role::q)) + "12"});
  drawing.put({"M30"});
}

constexpr std::string_view k840dSteps =
    "rapid feed circle radius angle polar pole CIP CT dwell plane inch modal turn\n";

}  // namespace

Model sinumerik840d_sequence_model() {
  return {"s840.sequence",
          1,
          "sinumerik840d",
          "modes",
          {2, 2},
          "basic arc",
          "SIE-MOD-01 SIE-MOD-04 SIE-POL-02 SIE-ADDR-01",
          joined({"first: ", k840dSteps, "second: ", k840dSteps, "third: ", k840dSteps}),
          draw_840d_sequence};
}

}  // namespace gonogo::cover
