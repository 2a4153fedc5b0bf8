// SPDX-License-Identifier: GPL-3.0-or-later
//
// Models of the canned cycles of RS274/NGC among what programs put around them: offsets, O words,
// and other cycles.
#include <algorithm>
#include <array>
#include <utility>

#include "fuzz/generate/cover/ngc_cycles.hpp"

namespace gonogo::cover {
namespace {

constexpr Length kPeck = {2'500, 0};

using Words = std::vector<std::string>;

std::string of_axis(const Drawing& drawing, Role role, Length value) {
  return drawing.word(std::string(1, drawing.letter(role)), value);
}

// What a cycle needs beside its place and levels.
std::string own_word(const Drawing& drawing, std::string_view code) {
  if (code == "G73" || code == "G83") return drawing.word("Q", kPeck);
  return code == "G82" || code == "G89" ? "P0.5" : "";
}

// A hole that lies so far from where the tool stood at first, and R so far from its level; or so
// far from where it stands, under G91 (NGC-CYC-05, NGC-CYC-06).
Words hole(const Drawing& drawing, const std::string& code, Length way, Length to_r, bool steps) {
  if (steps) {
    return {code, of_axis(drawing, Role::p, way), of_axis(drawing, Role::d, kHoleDepth),
            drawing.word("R", to_r), own_word(drawing, code)};
  }
  return {code, drawing.absolute(Role::p, way), drawing.absolute(Role::d, to_r + kHoleDepth),
          drawing.word("R", kHoleStart + to_r), own_word(drawing, code)};
}

void add_cycle_feature(Drawing& drawing, std::string_view code) {
  const std::string feature = code == "G82"   ? "g81"
                              : code == "G89" ? "g85"
                                              : "g" + std::string(code.substr(1));
  if (std::ranges::find(drawing.features, feature) == drawing.features.end()) {
    drawing.features.push_back(feature);
  }
}

void begin(const Pick& pick, Drawing& drawing) {
  if (drawing.plane() != 17) drawing.features.emplace_back("cycle-planes");
  drawing.features.emplace_back("cycle-modal");
  drawing.features.emplace_back("cycle-steps");
  drawing.stand(mm(4), mm(-3), kHoleStart, "F120 M3");
  drawing.put({pick["retract"]});
}

// NGC-OFS-01: an offset comes into force, or ends.
void move_zero(const std::string& offset, Drawing& drawing) {
  const std::string p = of_axis(drawing, Role::p, mm(5));
  const std::string d = of_axis(drawing, Role::d, mm(-2));
  const std::string level = of_axis(drawing, Role::d, mm(30));
  if (offset == "system") drawing.put({"G10 L2 P1", p, d});
  if (offset == "here") drawing.put({"G10 L20 P0", p, level});
  if (offset == "other") {
    drawing.put({"G10 L2 P2", p, d});
    drawing.put({"G55"});
  }
  if (offset == "g92" || offset == "all") drawing.put({"G92", p, level});
  if (offset == "tool" || offset == "all") drawing.put({"G43.1", d});
}

void end_offset(const std::string& offset, Drawing& drawing) {
  if (offset == "system" || offset == "here") drawing.put({"G10 L2 P1 X0 Y0 Z0"});
  if (offset == "other") drawing.put({"G54"});
  if (offset == "g92" || offset == "all") drawing.put({"G92.2"});
  if (offset == "tool" || offset == "all") drawing.put({"G49"});
}

void draw_moved(const Pick& pick, Drawing& drawing) {
  const bool steps = pick.is("distance", "modal");
  const std::string& code = pick["code"];
  add_cycle_feature(drawing, code);
  begin(pick, drawing);
  if (!pick.is("when", "between")) move_zero(pick["offset"], drawing);
  Words first = hole(drawing, code, mm(10), pick.length("R"), steps);
  if (!pick.is("L", "none")) first.push_back("L" + pick["L"]);
  drawing.test(first);
  if (pick.is("when", "between")) move_zero(pick["offset"], drawing);
  if (pick.is("when", "until")) end_offset(pick["offset"], drawing);
  if (pick.is("then", "again")) drawing.put({drawing.travel(Role::p, mm(25))});
  if (pick.is("then", "line")) drawing.put({"G1", drawing.travel(Role::d, mm(2))});
  if (pick.is("then", "machine")) drawing.put({"G53 G0", drawing.absolute(Role::d, mm(6))});
  if (pick.is("then", "other")) {
    add_cycle_feature(drawing, "G81");
    drawing.put(hole(drawing, "G81", mm(25), mm(-1), steps));
  }
}

constexpr std::string_view kAround = R"(
plane: G17 G18 G19
units: mm inch
distance: absolute modal
retract: G98 G99
)";
// Coordinates of the machine are absolute (NGC-OFS-14).
constexpr std::string_view kMoved = R"(
code: G81 G82 G83 G73 G85
offset: system here other g92 tool all
when: before between until
R: below=-2 above=5
L: none two=2
then: again other line machine
no: distance=modal then=machine
)";

// The lines of a loop, and its end.
struct Loop {
  std::string_view name;
  std::string_view head;
  std::string_view tail;
};

constexpr std::array<Loop, 5> kLoops = {{
    {"repeat", "o1 repeat [#9]", "o1 endrepeat"},
    {"while", "o1 while [#1 LT #9]", "o1 endwhile"},
    {"do", "o1 do", "o1 while [#1 LT #9]"},
    {"sub", "o1 sub", "o1 endsub"},
    {"if", "o1 if [#1 LT #9]", "o1 endif"},
}};

// NGC-OWD-06: out of the loop, or to its condition, before the second hole.
void leave(const Pick& pick, Drawing& drawing) {
  if (pick.is("exit", "none")) return;
  drawing.put({"o2 if [#1 EQ 2]"});
  drawing.put({"o1", pick["exit"]});
  drawing.put({"o2 endif"});
}

void draw_looped(const Pick& pick, Drawing& drawing) {
  const bool steps = pick.is("distance", "modal");
  const std::string& code = pick["code"];
  add_cycle_feature(drawing, code);
  drawing.features.emplace_back("parameters");
  drawing.features.emplace_back("o-words");
  const Loop& loop = *std::ranges::find(kLoops, pick["loop"], &Loop::name);
  Words words = hole(drawing, code, mm(10), mm(-2), steps);
  words[1] = drawing.letter(Role::p) + std::string(steps ? "[10]" : "[#1*10]");
  const Words place = {words[1]};
  const bool named_inside = pick.is("cycle", "inside");
  begin(pick, drawing);
  drawing.put({"#1=0 #9=" + pick["count"]});
  if (loop.name == "sub") {
    drawing.put({std::string(loop.head)});
    drawing.put(named_inside ? words : place);
    drawing.put({std::string(loop.tail)});
    if (!named_inside) drawing.put(words);
    drawing.put({"o3 repeat [#9]"});
    drawing.put({"#1=[#1+1]"});
    drawing.put({"o1 call [#1]"});
    drawing.put({"o3 endrepeat"});
  } else {
    if (!named_inside) drawing.put(words);
    drawing.put({std::string(loop.head)});
    drawing.put({"#1=[#1+1]"});
    leave(pick, drawing);
    drawing.put(named_inside ? words : place);
    drawing.put({std::string(loop.tail)});
  }
  std::string last = of_axis(drawing, Role::q, mm(7));
  if (!pick.is("fault", "none")) last = drawing.letter(Role::q) + pick["fault"];
  drawing.test({last});
}

constexpr std::string_view kLooped = R"(
code: G81 G82 G83 G73 G85
loop: repeat while do sub if
count: none=0 one=1 four=4
cycle: inside outside
exit: none break continue
fault: none !unset=#<depth>@value-out-of-range !nothing=[1/0]@value-out-of-range !root=SQRT[-4]@value-out-of-range !open=[1@syntax
no: loop=repeat,sub,if exit=break,continue
no: loop=repeat,sub,while,if count=none cycle=inside
)";

// What stands between two blocks of a series, and whether it ends it (NGC-CYC-24, NGC-CYC-25).
void put_between(const Pick& pick, Drawing& drawing) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 7> kBlocks = {
      {{"cancel", "G80"},
       {"dwell", "G4 P0.25"},
       {"feed", "F200"},
       {"comment", "(next row)"},
       {"other-level", "G99"},
       {"initial-level", "G98"},
       {"turn", "M3"}}};
  for (const auto& [name, block] : kBlocks) {
    if (pick.is("between", name)) drawing.put({std::string(block)});
  }
  if (pick.is("between", "units")) drawing.put({pick.is("units", "inch") ? "G21" : "G20"});
  if (pick.is("between", "distance")) drawing.put({pick.is("distance", "modal") ? "G90" : "G91"});
  if (pick.is("between", "lift")) drawing.put({"G0", drawing.travel(Role::d, mm(3))});
  if (pick.is("between", "plane")) {
    drawing.plane(drawing.plane() == 19 ? 17 : drawing.plane() + 1);
    drawing.put({"G" + std::to_string(drawing.plane())});
  }
}

void draw_chain(const Pick& pick, Drawing& drawing) {
  const bool steps = pick.is("distance", "modal");
  const bool then_steps = steps != pick.is("between", "distance");
  const std::string& code = pick["code"];
  const std::string& second = pick.is("second", "same") ? code : pick["second"];
  add_cycle_feature(drawing, code);
  add_cycle_feature(drawing, second);
  begin(pick, drawing);
  const bool is_named = drawing.plane() != 17;
  if (pick.is("between", "plane") && !is_named) drawing.features.emplace_back("cycle-planes");
  Words first = hole(drawing, code, mm(10), pick.length("R"), steps);
  if (!pick.is("L", "none")) first.push_back("L" + pick["L"]);
  drawing.put(first);
  put_between(pick, drawing);
  Words next = hole(drawing, second, mm(25), mm(-1), then_steps);
  // Words of the block before hold only for the same cycle (NGC-CYC-03).
  if (pick.is("words", "without-r")) next[3].clear();
  if (pick.is("words", "without-depth")) next[2].clear();
  if (pick.is("words", "twice")) next.emplace_back("L2");
  drawing.test(next);
  drawing.put({drawing.travel(Role::q, mm(5))});
}

constexpr std::string_view kChain = R"(
code: G81 G83 G85
second: same G73 G89 G82
between: dwell feed comment other-level initial-level turn units distance lift plane cancel
words: all twice without-r without-depth
R: below=-2 above=5
L: none two=2
no: second=G73,G89,G82 words=without-r,without-depth
no: between=cancel,lift words=without-r,without-depth
no: between=distance,plane,units words=without-r,without-depth
)";

Model model_of(std::string_view name, Strength strength, std::string_view features,
               std::string_view clauses, std::string parameters,
               void (*draw)(const Pick& pick, Drawing& drawing)) {
  return {name, 1, "rs274", "cycles", strength, features, clauses, std::move(parameters), draw};
}

}  // namespace

std::vector<Model> ngc_series_models() {
  return {
      model_of("ngc.moved", {3, 2}, "basic offsets",
               "NGC-OFS-01..05 NGC-OFS-09 NGC-OFS-13 NGC-CYC-05..12", joined({kAround, kMoved}),
               draw_moved),
      model_of("ngc.looped", {2, 2}, "basic", "NGC-OWD-01..07 NGC-PAR-01..03 NGC-CYC-01..06",
               joined({kAround, kLooped}), draw_looped),
      model_of("ngc.chain", {2, 2}, "basic", "NGC-CYC-03 NGC-CYC-08..10 NGC-CYC-24..26",
               joined({kAround, kChain}), draw_chain),
  };
}

}  // namespace gonogo::cover
