// SPDX-License-Identifier: GPL-3.0-or-later
//
// Models of the SINUMERIK 840D's path commands: lines, the forms of an arc, polar targets, CIP and
// CT, and what comes one after the other.
#include <fmt/format.h>

#include <array>

#include "fuzz/generate/cover/arcs.hpp"
#include "fuzz/generate/cover/model.hpp"

namespace gonogo::cover {
namespace {

constexpr std::string_view k840dHead = R"(
plane: G17 G18 G19
units: mm inch
distance: absolute modal IC AC
F: here before !none@feed-missing
then: nothing line
)";
constexpr std::string_view kHelix = R"(
helix: none up=6 down=-0.5 least=e
turn: none zero=0 one=1 three=3 !part=1.5@not-an-integer !over=1000@value-out-of-range
)";

void add_840d_features(const Pick& pick, Drawing& drawing) {
  if (drawing.plane() != 17) drawing.features.emplace_back("planes");
  if (!pick.is("helix", "none") || (pick.has("turn") && !pick.is("turn", "none"))) {
    drawing.features.emplace_back("helix");
  }
}

void stand(const Pick& pick, Drawing& drawing) {
  drawing.stand(mm(40), mm(30), mm(20), pick.is("F", "before") ? "F120" : "");
}

// The block under test: its words, and what every model has.
void finish(const Pick& pick, Drawing& drawing, std::vector<std::string> words) {
  if (pick.has("helix") && !pick.is("helix", "none")) {
    words.push_back(drawing.travel(Role::d, pick.length("helix")));
  }
  if (pick.has("turn") && !pick.is("turn", "none")) words.push_back("TURN=" + pick["turn"]);
  if (pick.is("F", "here")) words.emplace_back("F200");
  if (pick.has("fault") && !pick.is("fault", "none")) words.push_back(pick["fault"]);
  drawing.test(words);
  if (pick.is("then", "line")) drawing.put({"G1", drawing.travel(Role::p, mm(2)), "F90"});
}

void add_end(const Drawing& drawing, const ArcWays& ways, std::vector<std::string>& words) {
  words.push_back(drawing.travel(Role::p, ways.end[0]));
  words.push_back(drawing.travel(Role::q, ways.end[1]));
}

// The centre as an offset, or as a point by AC().
void add_centre(const Pick& pick, const Drawing& drawing, const ArcWays& ways,
                std::vector<std::string>& words) {
  const std::array<Length, 2> start = {mm(40), mm(30)};
  for (const Role role : {Role::p, Role::q}) {
    const auto i = static_cast<std::size_t>(role);
    if (pick.is("offsets", "AC")) {
      const std::string offset = drawing.offset(role, start[i] + ways.centre[i]);
      words.push_back(fmt::format("{}=AC({})", offset.substr(0, 1), offset.substr(1)));
    } else if (ways.centre[i].sign() != 0 || pick.is("offsets", "written")) {
      words.push_back(drawing.offset(role, ways.centre[i]));
    }
  }
}

void draw_840d_centre(const Pick& pick, Drawing& drawing) {
  add_840d_features(pick, drawing);
  ArcWays ways = arc_ways(pick["centre"], pick["end"]);
  if (!pick.is("radii", "same")) {
    // Away from the centre at (10, 0), to the right or down.
    if (pick.is("end", "opposite")) ways.end[0] = ways.end[0] + pick.length("radii");
    if (pick.is("end", "left")) ways.end[1] = ways.end[1] - pick.length("radii");
  }
  stand(pick, drawing);
  std::vector<std::string> words = {pick["code"]};
  if (!pick.is("end", "full") || pick.is("full", "written")) add_end(drawing, ways, words);
  add_centre(pick, drawing, ways, words);
  finish(pick, drawing, std::move(words));
}

constexpr std::string_view k840dCentre = R"(
centre: along-p along-q both
end: opposite left right full
full: omitted written
offsets: omitted written AC
radii: same least=e below=0.01-e at=0.01 !above=0.01+e@arc-end-point
fault: none !CR=CR=10@conflicting-words !twice=S100&S200@duplicate-word !unknown=G99@undefined-code
no: end=opposite,left,right full=written
no: radii=least,below,at,above end=right,full
no: radii=least,below,at,above centre=along-q,both
no: radii=least,below,at,above units=inch
)";

void draw_840d_radius(const Pick& pick, Drawing& drawing) {
  add_840d_features(pick, drawing);
  drawing.features.emplace_back("cr");
  const ArcWays ways = arc_ways(pick["centre"], pick["end"]);
  stand(pick, drawing);
  std::vector<std::string> words = {pick["code"]};
  add_end(drawing, ways, words);
  if (!pick.is("CR", "none")) words.push_back(drawing.word("CR=", "CR"));
  finish(pick, drawing, std::move(words));
}

constexpr std::string_view k840dRadius = R"(
centre: along-p along-q both
end: opposite left right !full@arc-end-point
CR: short=10 long=-10 larger=12.5 !less=10-e@arc-radius !zero=0@arc-radius !none@missing-word
fault: none !AP=AP=30&RP=5@conflicting-words !twice=S100&S200@duplicate-word !unknown=G99@undefined-code
no: CR=less end=left,right
)";

void draw_angle(const Pick& pick, Drawing& drawing) {
  add_840d_features(pick, drawing);
  drawing.features.emplace_back("ar");
  const ArcWays ways = arc_ways(pick["centre"], pick["end"]);
  stand(pick, drawing);
  std::vector<std::string> words = {pick["code"]};
  if (!pick.is("with", "centre")) add_end(drawing, ways, words);
  if (!pick.is("with", "end")) add_centre(pick, drawing, ways, words);
  words.push_back("AR=" + pick["AR"]);
  finish(pick, drawing, std::move(words));
}

constexpr std::string_view kAngle = R"(
centre: along-p along-q both
end: opposite left right
with: centre end !both@conflicting-words
AR: 90 180 270 odd=33.3 much=359.9 !zero=0@value-out-of-range !full=360@value-out-of-range !minus=-90@value-out-of-range
fault: none !CR=CR=10@conflicting-words !twice=S100&S200@duplicate-word
offsets: omitted written AC
no: with=end offsets=written,AC
no: with=centre end=left,right
)";

// The start is a polar target about the same pole, so that an arc finds its radius there.
void draw_polar(const Pick& pick, Drawing& drawing) {
  if (drawing.plane() != 17) drawing.features.emplace_back("planes");
  if (!pick.is("helix", "none")) drawing.features.emplace_back("helix");
  stand(pick, drawing);
  if (!pick.is("pole", "none")) {
    drawing.put({pick["pole"], drawing.word(std::string(1, drawing.letter(Role::p)), mm(5)),
                 drawing.word(std::string(1, drawing.letter(Role::q)), mm(-6))});
  }
  const std::string rp = pick.is("RP", "none") ? "" : drawing.word("RP=", "RP");
  const std::string start = pick.is("RP", "minus") ? "RP=20" : rp;
  if (!start.empty()) drawing.put({"G0 AP=180", start});
  const std::string ap = pick.is("AP", "step") ? "AP=IC(60)" : "AP=" + pick["AP"];
  finish(pick, drawing, {pick["code"], ap, rp});
}

constexpr std::string_view kPolar = R"(
code: G1 G0 G2 G3
pole: none G110 G111 G112
AP: 90 zero=0 -135 45 odd=33.3 most=360 least=-0.001 step !over=360.001@value-out-of-range
RP: typical=20 small=0.5 least=e !none@missing-word !minus=-1@value-sign
helix: none up=6 least=e
fault: none !CR=CR=10@conflicting-words !twice=S100&S200@duplicate-word
no: F=none code=G0
no: RP=none AP=step
no: fault=CR code=G0,G1
no: RP=none,minus code=G2,G3
)";

void draw_cip(const Pick& pick, Drawing& drawing) {
  stand(pick, drawing);
  drawing.features.emplace_back("cip");
  const Length up = pick.length("up");
  const bool line = pick.is("via", "line") || pick.is("via", "beyond");
  std::array<Length, 3> via = {mm(5), mm(5), up};
  if (pick.is("via", "near")) via = {Length{0, 1}, mm(1), {}};
  if (pick.is("via", "large")) via = {mm(-30), mm(40), up};
  if (line) via = {mm(pick.is("via", "line") ? 5 : 15), {}, {}};
  if (pick.is("via", "start")) via = {};
  if (pick.is("via", "end")) via = {mm(10), {}, up};
  std::vector<std::string> words = {"CIP", drawing.travel(Role::p, mm(10)),
                                    drawing.travel(Role::q, {}),
                                    drawing.travel(Role::d, line ? Length{} : up)};
  for (const Role role : {Role::p, Role::q, Role::d}) {
    if (pick.is("via", "none")) break;
    const std::string address = {static_cast<char>(drawing.letter(role) - 'X' + 'I'), '1'};
    words.push_back(drawing.target(address, role, via[static_cast<std::size_t>(role)]));
  }
  finish(pick, drawing, std::move(words));
}

constexpr std::string_view kIntermediate = R"(
via: half near large line !beyond@arc-intermediate-point !start@arc-intermediate-point !end@arc-intermediate-point !none@missing-word
up: flat=0 up=7 down=-0.5 least=e
fault: none !?CR=CR=10@conflicting-words !twice=S100&S200@duplicate-word !turn=TURN=2@conflicting-words
no: via=line,beyond up=up,down,least
)";

void draw_ct(const Pick& pick, Drawing& drawing) {
  stand(pick, drawing);
  drawing.features.emplace_back("ct");
  const bool upright = pick.is("before", "upright");
  const std::string p = std::string(1, drawing.letter(Role::p));
  const std::string q = std::string(1, drawing.letter(Role::q));
  const std::string d = std::string(1, drawing.letter(Role::d));
  const auto step = [&](const std::string& letter, std::int64_t way) {
    return letter + drawing.word("=IC(", mm(way)) + ")";
  };
  // One motion to the right, which is undone before it, so that the tool stands where it did.
  if (pick.is("before", "line") || pick.is("before", "rapid")) {
    const char* code = pick.is("before", "line") ? "G1" : "G0";
    drawing.put({"G0", step(p, -3)});
    drawing.put({code, step(p, 3), pick.is("before", "line") ? "F80" : ""});
  } else if (pick.is("before", "arc")) {
    drawing.put({"G0", step(p, -3), step(q, -3)});
    drawing.put({"G3", step(p, 3), step(q, 3), "CR=3 F80"});
  } else if (upright) {
    drawing.put({"G0", step(d, -3)});
    drawing.put({"G0", step(d, 3)});
  }
  ArcWays ways;
  ways.end = {pick.length("along"), pick.length("aside")};
  std::vector<std::string> words = {"CT"};
  add_end(drawing, ways, words);
  finish(pick, drawing, std::move(words));
}

constexpr std::string_view kTangent = R"(
before: line rapid arc !upright@arc-tangent
along: ahead=10 none=0 back=-6 least=e
aside: left=8 right=-8 least=e
helix: none up=6 least=e
fault: none !?CR=CR=10@conflicting-words !twice=S100&S200@duplicate-word !?centre=I1@conflicting-words
no: F=none before=line,arc
# Behind an arc that ends along q.
no: before=arc along=none aside=right
)";

void draw_840d_line(const Pick& pick, Drawing& drawing) {
  stand(pick, drawing);
  std::vector<std::string> words = {pick["code"]};
  for (const auto& [role, name] : {std::pair{Role::p, "p"}, {Role::q, "q"}, {Role::d, "d"}}) {
    if (!pick.is(name, "none")) words.push_back(drawing.travel(role, pick.length(name)));
  }
  if (!pick.is("A", "none")) {
    drawing.features.emplace_back("rotary");
    words.push_back(pick["A"]);
  }
  finish(pick, drawing, std::move(words));
}

constexpr std::string_view k840dLine = R"(
code: G1 G0
p: none zero=0 plus=12.5 minus=-7.25 least=e
q: none plus=3 minus=-80
d: none plus=5 least=-e
A: none A90 least=A-0.001 IC=A=IC(30) AC=A=AC(-45)
fault: none !twice=S100&S200@duplicate-word !unknown=G99@undefined-code !AP=AP=30&RP=5@conflicting-words
no: F=none code=G0
no: p=none q=none d=none
no: fault=AP p=none q=none
)";

}  // namespace

// NOLINTNEXTLINE(readability-function-size): a table.
std::span<const Model> sinumerik840d_models() {
  static const std::array kModels = {
      Model{"s840.line",
            1,
            "sinumerik840d",
            "line",
            {3, 3},
            "basic",
            "SIE-G1-01 SIE-G1-03 SIE-ADDR-01 SIE-COM-01",
            joined({k840dHead, k840dLine}),
            draw_840d_line},
      Model{"s840.centre",
            1,
            "sinumerik840d",
            "arc",
            {3, 3},
            "basic arc",
            "SIE-ARC-01..03 SIE-ARC-07..09 SIE-ARC-13",
            joined({k840dHead, kHelix, codes_of("sinumerik840d", {"arc"}), k840dCentre}),
            draw_840d_centre},
      Model{"s840.radius",
            1,
            "sinumerik840d",
            "cr",
            {3, 3},
            "basic",
            "SIE-ARC-04 SIE-ARC-09 SIE-ARC-11",
            joined({k840dHead, kHelix, codes_of("sinumerik840d", {"arc"}), k840dRadius}),
            draw_840d_radius},
      Model{"s840.angle",
            1,
            "sinumerik840d",
            "ar",
            {3, 3},
            "basic",
            "SIE-ARC-05 SIE-ARC-09 SIE-ARC-11",
            joined({k840dHead, kHelix, codes_of("sinumerik840d", {"arc"}), kAngle}),
            draw_angle},
      Model{"s840.polar",
            1,
            "sinumerik840d",
            "polar",
            {3, 3},
            "basic polar",
            "SIE-ARC-06 SIE-ARC-10 SIE-POL-01 SIE-POL-02",
            joined({k840dHead, kPolar}),
            draw_polar},
      Model{"s840.cip",
            1,
            "sinumerik840d",
            "cip",
            {3, 3},
            "basic",
            "SIE-CIP-01 SIE-CIP-02",
            joined({k840dHead, kIntermediate}),
            draw_cip},
      Model{"s840.ct",
            1,
            "sinumerik840d",
            "ct",
            {3, 3},
            "basic cr",
            "SIE-CT-01 SIE-CT-02",
            joined({k840dHead, kTangent}),
            draw_ct},
      sinumerik840d_sequence_model(),
  };
  return kModels;
}

}  // namespace gonogo::cover
