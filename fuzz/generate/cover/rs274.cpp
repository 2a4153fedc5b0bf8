// SPDX-License-Identifier: GPL-3.0-or-later
//
// Models of RS274/NGC: arcs by their centre and by their radius, lines, and what comes one after
// the other.
#include <algorithm>
#include <array>
#include <iterator>

#include "fuzz/generate/cover/arcs.hpp"
#include "fuzz/generate/cover/model.hpp"
#include "fuzz/generate/cover/ngc_cycles.hpp"

namespace gonogo::cover {
namespace {

// What the arc needs of a subject beyond arcs in G17.
void add_ngc_features(const Pick& pick, Drawing& drawing) {
  if (drawing.plane() != 17) drawing.features.emplace_back("planes");
  if (!pick.is("helix", "none")) drawing.features.emplace_back("helix");
  if (!pick.is("P", "none")) drawing.features.emplace_back("turns");
  if (pick.has("offsets")) drawing.features.emplace_back("arc-distance");
}

void finish_arc(const Pick& pick, Drawing& drawing, std::vector<std::string> words) {
  if (!pick.is("P", "none")) words.push_back("P" + pick["P"]);
  if (pick.is("F", "here")) words.emplace_back("F200");
  if (pick.is("F", "zero")) words.emplace_back("F0");
  if (!pick.is("fault", "none")) words.push_back(pick["fault"]);
  drawing.test(words);
  if (pick.is("then", "line")) drawing.put({"G1", drawing.travel(Role::p, mm(2)), "F90"});
}

void draw_ngc_centre(const Pick& pick, Drawing& drawing) {
  add_ngc_features(pick, drawing);
  ArcWays ways = arc_ways(pick["centre"], pick["end"]);
  if (!pick.is("radii", "same")) ways.end[0] = ways.end[0] + pick.length("radii");
  drawing.stand(mm(40), mm(30), mm(20), pick.is("F", "before") ? "F120" : "");
  const bool absolute = pick.is("offsets", "absolute");
  drawing.put({absolute ? "G90.1" : "G91.1"});
  std::vector<std::string> words = arc_words(pick, drawing, ways);
  const std::array<Length, 2> start = {mm(40), mm(30)};
  for (const Role role : {Role::p, Role::q}) {
    const auto i = static_cast<std::size_t>(role);
    const bool needed = absolute || ways.centre[i].sign() != 0;
    if (!needed && pick.is("zeros", "omitted")) continue;
    words.push_back(drawing.offset(role, absolute ? start[i] + ways.centre[i] : ways.centre[i]));
  }
  if (pick.is("fault", "stray")) {
    words.push_back(drawing.offset(Role::d, mm(1)));
    return finish_arc(pick, drawing, words);
  }
  finish_arc(pick, drawing, std::move(words));
}

constexpr std::string_view kNgcHead = R"(
plane: G17 G18 G19
units: mm inch
distance: absolute modal
helix: none up=6 down=-0.5 least=e
P: none one=1 three=3 !zero=0@value-sign !part=1.5@not-an-integer
F: here before !none@feed-missing !zero@feed-missing
then: nothing line
)";

constexpr std::string_view kNgcCentre = R"(
offsets: incremental absolute
centre: along-p along-q both
end: opposite left right full
full: omitted written
zeros: omitted written
radii: same least=e below=0.002-e at=0.002 !above=0.002+e@arc-end-point
fault: none !R=R10@conflicting-words !twice=S100&S200@duplicate-word !unknown=G69@undefined-code
reading: default tolerance=ngc.arc-tolerance=linuxcnc
no: end=opposite,left,right full=written
no: radii=least,below,at,above end=left,right,full
no: radii=least,below,at,above centre=along-q,both
no: radii=least,below,at,above units=inch
no: reading=tolerance radii=above
)";

void draw_ngc_radius(const Pick& pick, Drawing& drawing) {
  add_ngc_features(pick, drawing);
  ArcWays ways = arc_ways(pick["centre"], pick["end"]);
  drawing.stand(mm(40), mm(30), mm(20), pick.is("F", "before") ? "F120" : "");
  std::vector<std::string> words = arc_words(pick, drawing, ways);
  if (!pick.is("R", "none")) words.push_back(drawing.word("R", "R"));
  finish_arc(pick, drawing, std::move(words));
}

constexpr std::string_view kNgcRadius = R"(
centre: along-p along-q both
end: opposite left right !full@arc-end-point
full: written
R: short=10 long=-10 larger=12.5 !less=10-e@arc-radius !none@missing-word
fault: none !I=I1&J1&K1@conflicting-words+axis-not-in-plane !twice=S100&S200@duplicate-word !unknown=G69@undefined-code
no: R=less end=left,right
no: R=larger end=opposite,left,right
no: R=less units=inch helix=least
)";

void draw_ngc_line(const Pick& pick, Drawing& drawing) {
  drawing.stand(mm(4), mm(-3), mm(20), pick.is("F", "before") ? "F120" : "");
  std::vector<std::string> words = {pick["code"]};
  for (const auto& [role, name] : {std::pair{Role::p, "p"}, {Role::q, "q"}, {Role::d, "d"}}) {
    if (!pick.is(name, "none")) words.push_back(drawing.travel(role, pick.length(name)));
  }
  if (pick.is("F", "here")) words.emplace_back("F200.5");
  if (!pick.is("fault", "none")) words.push_back(pick["fault"]);
  drawing.test(words);
  if (pick.is("then", "again")) drawing.put({drawing.travel(Role::q, mm(7))});
  if (pick.is("then", "dwell"))
    drawing.put({"G4 P0.5"}), drawing.put({drawing.travel(Role::p, mm(7))});
}

constexpr std::string_view kNgcLine = R"(
code: G0 G1
plane: G17 G18 G19
units: mm inch
distance: absolute modal
p: none zero=0 plus=12.5 minus=-7.25 least=e
q: none plus=3 minus=-80
d: none plus=5 least=-e
F: here before !none@feed-missing
fault: none !twice=X1&X2@duplicate-word !unknown=G69@undefined-code !group=G17&G18@duplicate-word
then: nothing again dwell
no: F=none code=G0
no: p=none q=none d=none
)";

void draw_ngc_step(const std::string& step, Drawing& drawing) {
  const auto to = [&](Role role, std::int64_t length) {
    return drawing.absolute(role, mm(length));
  };
  if (step == "rapid") drawing.put({"G0", to(Role::p, 4), to(Role::q, -3)});
  if (step == "feed") drawing.put({"G1", to(Role::p, -2), to(Role::d, 5), "F100"});
  // A whole turn about a centre that no position meets, as offset or as a point.
  if (step == "circle") {
    drawing.put({"G2", drawing.offset(Role::p, mm(77)), drawing.offset(Role::q, mm(99)), "F110"});
  }
  if (step == "helix") {
    drawing.put({"G3", drawing.offset(Role::p, mm(-91)), drawing.offset(Role::q, mm(83)),
                 to(Role::d, 9), "P2 F120"});
  }
  if (step == "bare") drawing.put({to(Role::p, 3), to(Role::q, -6)});
  if (step == "dwell") drawing.put({"G4 P0.25"});
  if (step == "plane") {
    drawing.plane(19);
    drawing.put({"G19"});
  }
  constexpr std::array<std::pair<std::string_view, std::string_view>, 7> kCodes = {
      {{"inch", "G20"},
       {"modal", "G91"},
       {"point", "G90"},
       {"centre", "G90.1"},
       {"offset", "G91.1"},
       {"off", "G80"},
       {"passed", "G64 M8 T1"}}};
  for (const auto& [name, code] : kCodes) {
    if (step == name) drawing.put({std::string(code)});
  }
}

void draw_ngc_sequence(const Pick& pick, Drawing& drawing) {
  for (const char* feature : {"planes", "helix", "turns", "arc-distance"}) {
    drawing.features.emplace_back(feature);
  }
  drawing.stand(mm(1), mm(2), mm(3), "F90");
  for (const char* place : {"first", "second", "third"}) draw_ngc_step(pick[place], drawing);
  drawing.put({"G1", drawing.absolute(Role::q, mm(12))});
  drawing.put({"M2"});
}

constexpr std::string_view kNgcSteps =
    "rapid feed circle helix bare dwell plane inch modal point centre offset off passed\n";
// Axis words alone need a motion that they are enough for.
constexpr std::string_view kNgcSequence = R"(
code: one
no: first=circle,helix,off second=bare
no: second=circle,helix,off third=bare
no: first=circle,helix,off second=dwell,plane,inch,modal,point,centre,offset,passed third=bare
)";

std::vector<Model> path_models() {
  return {
      Model{"ngc.line",
            1,
            "rs274",
            "basic",
            {3, 3},
            "basic",
            "NGC-G0-01 NGC-DIS-01 NGC-UNI-01",
            std::string(kNgcLine),
            draw_ngc_line},
      Model{"ngc.centre",
            1,
            "rs274",
            "arc",
            {3, 3},
            "basic arc",
            "NGC-ARC-01 NGC-ARC-02 NGC-ARC-03 NGC-ARC-05",
            joined({codes_of("rs274", {"arc"}), kNgcHead, kNgcCentre}),
            draw_ngc_centre},
      Model{"ngc.radius",
            1,
            "rs274",
            "arc-r",
            {3, 3},
            "basic arc-r",
            "NGC-ARC-01 NGC-ARC-04 NGC-ARC-05",
            joined({codes_of("rs274", {"arc"}), kNgcHead, kNgcRadius}),
            draw_ngc_radius},
      Model{
          "ngc.sequence",
          1,
          "rs274",
          "basic",
          {2, 2},
          "basic arc",
          "NGC-MOD-01 NGC-DIS-01",
          joined({"first: ", kNgcSteps, "second: ", kNgcSteps, "third: ", kNgcSteps, kNgcSequence}),
          draw_ngc_sequence},
  };
}

}  // namespace

std::span<const Model> ngc_models() {
  static const std::vector<Model> kModels = [] {
    std::vector<Model> all = path_models();
    std::ranges::move(ngc_cycle_models(), std::back_inserter(all));
    std::ranges::move(ngc_series_models(), std::back_inserter(all));
    return all;
  }();
  return kModels;
}

}  // namespace gonogo::cover
