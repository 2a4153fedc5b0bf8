// SPDX-License-Identifier: GPL-3.0-or-later
//
// Models of the SINUMERIK 802S: the cycles LCYC82 and LCYC75, frames, and what comes one after the
// other.
#include <fmt/format.h>

#include <array>

#include "fuzz/generate/cover/model.hpp"

namespace gonogo::cover {
namespace {

std::string parameter(int number, Length value) {
  return fmt::format("R{}={}", number, value.text(3));
}

// A frame before the cycle, and the plane axes' letters as everywhere.
void put_frame(const Pick& pick, Drawing& drawing) {
  if (pick.is("frame", "none")) return;
  drawing.features.emplace_back("frames");
  const std::string p(1, drawing.letter(Role::p));
  if (!pick.is("frame", "turned")) drawing.put({"G158", p + "12.5"});
  if (pick.is("frame", "turned")) drawing.put({"G258 RPL=90"});
  if (pick.is("frame", "both")) drawing.put({"G259 RPL=45"});
}

// R101 to R104: planes by their relation, the reference plane being R103.
std::vector<std::string> planes(const Pick& pick) {
  const Length reference = pick.length("R103");
  const Length clearance = pick.length("R102");
  Length depth = reference - mm(4);
  if (pick.is("R104", "just")) depth = reference - Length{0, 1};
  if (pick.is("R104", "at")) depth = reference;
  if (pick.is("R104", "above")) depth = reference + mm(1);
  Length retract = reference + clearance + mm(3);
  if (pick.is("R101", "at")) retract = reference + clearance;
  if (pick.is("R101", "below")) retract = reference + clearance - Length{0, 1};
  return {parameter(101, retract), parameter(102, clearance), parameter(103, reference),
          parameter(104, depth)};
}

constexpr std::string_view k802sHead = R"(
plane: G17 G18 G19
frame: none moved turned both
R102: typical=2 zero=0 least=e !?minus=-0.5@value-sign
R103: zero=0 minus=-3.5 plus=10
R104: typical just !at@reference-plane !above@reference-plane
R101: above at !?below@reference-plane
start: above=30 below=-30
)";

void draw_lcyc82(const Pick& pick, Drawing& drawing) {
  drawing.stand(mm(40), mm(30), pick.length("start"), pick.is("F", "before") ? "F120" : "");
  put_frame(pick, drawing);
  drawing.put(planes(pick));
  if (!pick.is("R105", "none")) drawing.put({"R105=" + pick["R105"]});
  drawing.test({pick.is("fault", "none") ? "LCYC82" : pick["fault"]});
  if (pick.is("then", "again")) {
    drawing.put({std::string("G0 ") + drawing.letter(Role::p) + "=IC(10)"});
    drawing.put({"LCYC82"});
  }
  if (pick.is("then", "line")) drawing.put({std::string("G1 ") + drawing.letter(Role::q) + "7"});
}

constexpr std::string_view kLcyc82 = R"(
R105: none zero=0 typical=2 least=0.001 !?minus=-1@value-sign
F: before !none@feed-missing
fault: none !?X=LCYC82&X5@conflicting-words !?M=LCYC82&M8@conflicting-words !unknown=LCYC99@undefined-code
then: nothing again line
)";

// Lengths of the pocket by its shape; its narrowest width is 20 but where the tool just fits.
void draw_lcyc75(const Pick& pick, Drawing& drawing) {
  drawing.profile.tools["1"].radius = reference::Number(5);
  drawing.profile.tools["2"].radius = reference::Number(5) / reference::Number(2);
  const bool roughs = !pick.is("R127", "finish");
  const Length tool = pick.is("tool", "T2") ? Length{2500, 0} : mm(5);
  const Length allowance = pick.length("R124");
  Length width = mm(20);
  const Length least = 2 * (roughs ? tool + allowance : tool);
  if (pick.is("width", "fit")) width = least;
  if (pick.is("width", "narrow")) width = least - Length{0, 1};
  const Length length = pick.is("shape", "circle") ? width : mm(30);
  Length corner = {};
  if (pick.is("shape", "rounded")) corner = mm(2);
  if (pick.is("shape", "slot") || pick.is("shape", "circle")) {
    corner = {width.thousandths / 2, width.increments / 2};
  }

  const std::string spindle = pick.is("spindle", "turns") ? "S400 M3" : "";
  const std::string in_force = pick.is("tool", "none") ? "" : pick["tool"] + " D1";
  drawing.stand(mm(40), mm(30), pick.length("start"));
  drawing.put({spindle, in_force});
  put_frame(pick, drawing);
  drawing.put(planes(pick));
  drawing.put(
      {"R116=3 R117=-2.5", parameter(118, length), parameter(119, width), parameter(120, corner)});
  drawing.put({"R121=" + pick["R121"], "R122=" + pick["R122"], "R123=" + pick["R123"]});
  drawing.put({parameter(124, allowance), "R125=" + pick["R125"], "R126=" + pick["R126"],
               "R127=" + pick["R127"]});
  drawing.test({"LCYC75"});
}

constexpr std::string_view kLcyc75 = R"(
shape: rounded sharp slot circle
width: typical fit !narrow@tool-too-large
tool: T1 T2 !none@no-tool
spindle: turns !stands@spindle-stopped
R121: typical=2 more=50 part=1.5 !?zero=0@value-sign !?minus=-1@value-sign
R122: typical=100 !zero=0@feed-missing
R123: typical=300 !zero=0@feed-missing
R124: none=0 some=0.5
R125: none=0 some=0.25 !?minus=-1@value-sign
R126: 2 3 !other=4@direction-parameter
R127: rough=1 finish=2 !other=3@machining-type
# Where nothing is left to rough, and a depth of one increment, are limits of their own.
no: R104=just R125=some
no: R104=at,above R125=some
no: shape=circle,slot width=narrow
)";

void draw_frame(const Pick& pick, Drawing& drawing) {
  drawing.stand(mm(4), mm(-3), mm(20), "F120");
  const std::string p(1, drawing.letter(Role::p));
  const std::string q(1, drawing.letter(Role::q));
  const std::string d(1, drawing.letter(Role::d));
  for (const char* place : {"first", "second"}) {
    const std::string& code = pick[place];
    if (code == "moved") drawing.put({"G158", p + "10", q + "-5.5"});
    if (code == "raised") drawing.put({"G158", d + "2.5"});
    if (code == "turned") drawing.put({"G258", "RPL=" + pick["angle"]});
    if (code == "added") drawing.put({"G259", "RPL=" + pick["angle"]});
    if (code == "G158" || code == "G258") drawing.put({code});
  }
  std::vector<std::string> words;
  if (pick.is("motion", "line")) words = {"G1", drawing.travel(Role::p, mm(6))};
  if (pick.is("motion", "rapid")) words = {"G0", drawing.travel(Role::q, mm(6))};
  if (pick.is("motion", "arc"))
    words = {"G2", drawing.offset(Role::p, mm(6)), drawing.offset(Role::q, mm(8))};
  if (pick.is("motion", "depth")) words = {"G1", drawing.travel(Role::d, mm(-6))};
  if (pick.is("motion", "polar")) words = {"G1 AP=30 RP=25"};
  drawing.put(words);
  if (!pick.is("fault", "none")) drawing.test({pick["fault"]});
  drawing.put({"G1", p + "1", q + "2", d + "3"});
}

constexpr std::string_view kFrame = R"(
plane: G17 G18 G19
units: mm inch
distance: absolute modal
first: none moved raised turned added G158 G258
second: none moved raised turned added G158 G258
angle: 90 45 30 odd=33.3 minus=-45 full=360 zero=0
motion: line rapid arc depth polar
fault: none !G259@missing-word !axis=G258&X5@conflicting-words !angle=G158&RPL=30@conflicting-words !AC=G158&X=AC(5)@conflicting-words
reading: default additive=sie.g158=additive only=sie.g258=rotation-only
)";

void draw_802s_step(const std::string& step, Drawing& drawing) {
  if (step == "rapid") drawing.put({"G0 X4 Y-3 Z20"});
  if (step == "feed") drawing.put({"G1 X=IC(-2) Z=IC(5) F100"});
  if (step == "circle") drawing.put({"G2 I9 J-12 F110"});
  if (step == "radius") drawing.put({"G3 X=IC(6) Y=IC(8) CR=13 F120"});
  if (step == "polar") drawing.put({"G1 AP=30 RP=25 F140"});
  if (step == "pole") drawing.put({"G111 X3 Y1"});
  if (step == "CT") drawing.put({"CT X=IC(7) Y=IC(11) F160"});
  if (step == "G158") drawing.put({"G158 X10 Y5"});
  if (step == "G258") drawing.put({"G258 RPL=90"});
  if (step == "G259") drawing.put({"G259 RPL=45"});
  if (step == "clear") drawing.put({"G158"});
  if (step == "LCYC82") {
    drawing.put({"R101=30 R102=2 R103=0 R104=-5 R105=1"});
    drawing.put({"LCYC82"});
  }
  if (step == "LCYC75") {
    drawing.put({"R101=30 R102=2 R103=0 R104=-3 R116=5 R117=5 R118=30 R119=24 R120=6"});
    drawing.put({"R121=2 R122=100 R123=300 R124=0 R125=0 R126=2 R127=1"});
    drawing.put({"LCYC75"});
  }
  if (step == "inch") drawing.put({"G70"});
  if (step == "modal") drawing.put({"G91"});
}

void draw_802s_sequence(const Pick& pick, Drawing& drawing) {
  for (const char* feature : {"cr", "polar", "ct", "frames", "lcyc82", "lcyc75"}) {
    drawing.features.emplace_back(feature);
  }
  drawing.profile.tools["1"].radius = reference::Number(5);
  drawing.stand(mm(1), mm(2), mm(30), "S400 M3 T1 D1");
  drawing.put({"G1 X3 Y14 F90"});
  for (const char* place : {"first", "second", "third"}) draw_802s_step(pick[place], drawing);
  drawing.put({"G1 X=IC(1) Y12"});
  drawing.put({"M2"});
}

constexpr std::string_view k802sSteps =
    "rapid feed circle radius polar pole CT G158 G258 G259 clear LCYC82 LCYC75 inch modal\n";
// A cycle ends upright on the plane: nothing for an arc to be tangent to.
constexpr std::string_view k802sSequence = R"(
no: first=LCYC82,LCYC75 second=CT
no: second=LCYC82,LCYC75 third=CT
no: first=LCYC82,LCYC75 second=pole,G158,G258,G259,clear,inch,modal third=CT
)";

}  // namespace

std::span<const Model> sinumerik802s_models() {
  static const std::array kModels = {
      Model{"s802.lcyc82",
            1,
            "sinumerik802s",
            "lcyc82",
            {3, 3},
            "basic lcyc82",
            "SIE-LC82-01..03",
            joined({k802sHead, kLcyc82}),
            draw_lcyc82},
      Model{"s802.lcyc75",
            1,
            "sinumerik802s",
            "lcyc75",
            {3, 2},
            "basic lcyc75",
            "SIE-LC75-01..13",
            joined({k802sHead, kLcyc75}),
            draw_lcyc75},
      Model{"s802.frame",
            1,
            "sinumerik802s",
            "frames",
            {3, 2},
            "basic arc polar frames",
            "SIE-FRM-01 SIE-FRM-02 SIE-FRM-04",
            std::string(kFrame),
            draw_frame},
      Model{"s802.sequence",
            1,
            "sinumerik802s",
            "modes",
            {2, 2},
            "basic arc",
            "SIE-MOD-01 SIE-FRM-01..02 SIE-FRM-04 SIE-LC82-03 SIE-LC75-13",
            joined({"first: ", k802sSteps, "second: ", k802sSteps, "third: ", k802sSteps,
                    k802sSequence}),
            draw_802s_sequence},
  };
  return kModels;
}

}  // namespace gonogo::cover
