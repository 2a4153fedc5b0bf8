// SPDX-License-Identifier: GPL-3.0-or-later
//
// Models of the canned cycles and the threads of RS274/NGC.
#include "fuzz/generate/cover/ngc_cycles.hpp"

#include <utility>

namespace gonogo::cover {
namespace {

// The words of a hole that lies so far from where the tool stands (NGC-CYC-05, NGC-CYC-06).
std::vector<std::string> hole_words(const Pick& pick, const Drawing& drawing) {
  const bool steps = pick.is("distance", "modal");
  const Length to_r = pick.length("R");
  std::vector<std::string> words = {pick["code"], drawing.travel(Role::p, mm(10))};
  if (!pick.is("q", "none")) words.push_back(drawing.travel(Role::q, pick.length("q")));
  words.push_back(drawing.travel(Role::d, steps ? kHoleDepth : to_r + kHoleDepth));
  words.push_back(drawing.word("R", steps ? to_r : kHoleStart + to_r));
  if (!pick.is("L", "none")) words.push_back("L" + pick["L"]);
  return words;
}

void add_hole_features(const Pick& pick, Drawing& drawing) {
  const std::string& code = pick["code"];
  const bool shares = code == "G82" || code == "G89";
  drawing.features.push_back(code == "G82" ? "g81" : shares ? "g85" : "g" + code.substr(1));
  if (drawing.plane() != 17) drawing.features.emplace_back("cycle-planes");
  const bool steps = pick.is("distance", "modal") || !pick.is("L", "none");
  if (steps) drawing.features.emplace_back("cycle-steps");
  if (pick.is("then", "again")) drawing.features.emplace_back("cycle-modal");
}

void draw_holes(const Pick& pick, Drawing& drawing, std::string_view own) {
  add_hole_features(pick, drawing);
  const std::string spindle = pick["code"] == "G74" ? "M4" : "M3";
  drawing.stand(mm(4), mm(-3), kHoleStart, "F120 " + spindle);
  drawing.put({pick["retract"]});
  std::vector<std::string> words = hole_words(pick, drawing);
  words.emplace_back(own);
  if (pick.has("D") && !pick.is("D", "none")) words.push_back(drawing.word("D", pick.length("D")));
  if (!pick.is("fault", "none")) words.push_back(pick["fault"]);
  drawing.test(words);
  if (pick.is("then", "again")) drawing.put({drawing.travel(Role::p, mm(25))});
  if (pick.is("then", "line")) drawing.put({"G1", drawing.travel(Role::p, mm(2))});
}

void draw_plain_hole(const Pick& pick, Drawing& drawing) {
  draw_holes(pick, drawing, "");
}
void draw_dwelling_hole(const Pick& pick, Drawing& drawing) {
  draw_holes(pick, drawing, pick.is("P", "none") ? "" : "P" + pick["P"]);
}
void draw_pecking_hole(const Pick& pick, Drawing& drawing) {
  draw_holes(pick, drawing, pick.is("Q", "none") ? "" : drawing.word("Q", pick.length("Q")));
}

constexpr std::string_view kHoles = R"(
plane: G17 G18 G19
units: mm inch
distance: absolute modal
retract: G98 G99
q: none plus=3
R: below=-8 at=0 above=5 least=e
L: none two=2 !zero=0@value-out-of-range !minus=-1@value-sign !part=1.5@not-an-integer
then: nothing again line
)";
constexpr std::string_view kPlain = R"(
fault: none !P=P1@unused-word !rotary=A1@axis-not-in-plane
)";
constexpr std::string_view kDwelling = R"(
P: second=1 half=0.5 none-at-all=0 !minus=-1@value-sign
fault: none !Q=Q1@unused-word
)";
constexpr std::string_view kPecking = R"(
Q: four=2.5 uneven=3 whole=10 deeper=11 !zero=0@value-sign !none@missing-word
D: none half=0.5
reading: default clearance=ngc.peck.d=clearance
fault: none !P=P1@unused-word
no: reading=default D=half
)";

void draw_synchronous(const Pick& pick, Drawing& drawing) {
  drawing.features.push_back("g" + pick["code"].substr(1));
  drawing.stand(mm(4), mm(-3), kHoleStart, pick["spindle"]);
  std::vector<std::string> words = {pick["code"]};
  for (const auto& [role, name] : {std::pair{Role::p, "p"}, {Role::q, "q"}, {Role::d, "d"}}) {
    if (!pick.is(name, "none")) words.push_back(drawing.travel(role, pick.length(name)));
  }
  if (!pick.is("K", "none")) words.push_back(drawing.word("K", pick.length("K")));
  if (!pick.is("fault", "none")) words.push_back(pick["fault"]);
  drawing.test(words);
  if (pick.is("then", "line")) drawing.put({"G1", drawing.travel(Role::p, mm(2)), "F90"});
}

constexpr std::string_view kSynchronous = R"(
code: G33 G33.1
plane: G17 G18 G19
units: mm inch
distance: absolute modal
spindle: M3 M4 !stopped=M5@spindle-stopped
p: none plus=12
q: none minus=-5
d: minus=-9 plus=16
K: whole=1 part=0.75 !none@lead-missing !zero=0@value-sign
then: nothing line
fault: none !F=F100@conflicting-words !R=R1@unused-word
)";

void draw_threading(const Pick& pick, Drawing& drawing) {
  drawing.stand(mm(2), mm(20), mm(0), pick["spindle"]);
  std::vector<std::string> words = {"G76", drawing.travel(Role::p, pick.length("Z"))};
  for (const char* name : {"P", "I", "J", "K", "E"}) {
    if (!pick.is(name, "none")) words.push_back(drawing.word(name, pick.length(name)));
  }
  for (const char* name : {"R", "Q", "H", "L"}) {
    if (!pick.is(name, "none")) words.push_back(name + pick[name]);
  }
  if (!pick.is("fault", "none")) words.push_back(pick["fault"]);
  drawing.test(words);
}

constexpr std::string_view kThreading = R"(
code: G76
plane: G18
units: mm inch
distance: absolute modal
spindle: M3 M4 !stopped=M5@spindle-stopped
Z: minus=-22 plus=18
P: two=2 !none@lead-missing !zero=0@value-sign
I: outside=-1 inside=1 !none@missing-word !zero=0@value-out-of-range
J: half=0.5 !none@missing-word !zero=0@value-sign
K: three=1.5 uneven=1.2 !none@missing-word !shallow=0.5@value-out-of-range
E: none short=0.5 long=4
R: none two=2 !less=0.5@value-out-of-range
Q: none half=29.5
H: none two=2 !minus=-1@value-sign !part=1.5@not-an-integer
L: none start=1 end=2 both=3 !more=4@value-out-of-range
fault: none !X=X1@axis-not-in-plane
)";

Model model_of(std::string_view name, std::string_view cycle, std::string_view features,
               std::string_view clauses, std::string parameters,
               void (*draw)(const Pick& pick, Drawing& drawing)) {
  return {name, 1, "rs274", cycle, {2, 2}, features, clauses, std::move(parameters), draw};
}

}  // namespace

std::vector<Model> ngc_cycle_models() {
  return {
      model_of("ngc.hole", "cycles", "basic", "NGC-CYC-01..02 NGC-CYC-05..13 NGC-G81-01 NGC-G85-01",
               joined({"code: G81 G85", kHoles, kPlain}), draw_plain_hole),
      model_of("ngc.dwelling", "cycles", "basic",
               "NGC-CYC-01..02 NGC-CYC-28 NGC-G82-01 NGC-G84-02 NGC-G86-02 NGC-G89-01",
               joined({"code: G74 G82 G84 G86 G89", kHoles, kDwelling}), draw_dwelling_hole),
      model_of("ngc.peck", "cycles", "basic", "NGC-CYC-01..02 NGC-G73-01 NGC-G83-01..07",
               joined({"code: G73 G83", kHoles, kPecking}), draw_pecking_hole),
      model_of("ngc.synchronous", "threads", "basic", "NGC-G33-01..05 NGC-G331-01..02",
               std::string(kSynchronous), draw_synchronous),
      model_of("ngc.threading", "threads", "basic g76", "NGC-G76-01..12", std::string(kThreading),
               draw_threading),
  };
}

}  // namespace gonogo::cover
