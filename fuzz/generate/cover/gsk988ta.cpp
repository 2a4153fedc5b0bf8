// SPDX-License-Identifier: GPL-3.0-or-later
//
// Models of the GSK 988TA: the cutting cycles G90, G92 and G94, arcs, and what comes one after the
// other.
#include <fmt/format.h>

#include <array>

#include "fuzz/generate/cover/arcs.hpp"
#include "fuzz/generate/cover/model.hpp"

namespace gonogo::cover {
namespace {

// R, by its relation to the way that it lies along.
std::string taper_word(const Pick& pick, const Drawing& drawing) {
  const Length along = pick.length("along");
  const int sign = along.sign() < 0 ? -1 : 1;
  const std::string& relation = pick["R"];
  if (relation == "none") return "";
  if (relation == "below") return drawing.word("R", -sign * (abs(along) - Length{0, 1}));
  if (relation == "at") return drawing.word("R", -along);
  if (relation == "above") return drawing.word("R", -sign * (abs(along) + Length{0, 1}));
  return drawing.word("R", sign * Length::parse(relation));
}

// `along` is the way of the axis that R lies along, `across` that of the other.
void draw_gsk_cutting(const Pick& pick, Drawing& drawing, int code) {
  const Role along = code == 94 ? Role::p : Role::q;
  const Role across = code == 94 ? Role::q : Role::p;
  const std::string g = fmt::format("G{}", code);
  drawing.stand(mm(50), mm(100), mm(20), pick.is("F", "before") ? "F120" : "");
  std::vector<std::string> words = {g, drawing.travel(along, pick.length("along")),
                                    drawing.travel(across, pick.length("across")),
                                    taper_word(pick, drawing)};
  if (!pick.is("F", "before") && !pick.is("F", "none")) words.push_back("F" + pick["F"]);
  if (pick.is("fault", "stray")) words.push_back(drawing.letters(Role::d, mm(1)));
  if (pick.is("fault", "both")) {
    const bool letters = pick.is("distance", "letters");
    words.push_back(letters ? drawing.absolute(across, mm(2)) : drawing.letters(across, mm(2)));
  }
  if (pick.is("fault", "twice")) words.emplace_back("S100 S200");
  if (pick.is("fault", "unknown")) words.emplace_back("G69");
  drawing.test(words);
  const std::string next = drawing.letters(across, mm(-7));
  if (pick.is("then", "again")) drawing.put({next});
  if (pick.is("then", "code")) drawing.put({g, next});
  if (pick.is("then", "feed")) drawing.put({"F2"});
  if (pick.is("then", "dwell")) drawing.put({"G04 P250"}), drawing.put({next});
  if (pick.is("then", "rapid")) drawing.put({"G00", next});
}

void draw_g90(const Pick& pick, Drawing& drawing) {
  draw_gsk_cutting(pick, drawing, 90);
}
void draw_g92(const Pick& pick, Drawing& drawing) {
  draw_gsk_cutting(pick, drawing, 92);
}
void draw_g94(const Pick& pick, Drawing& drawing) {
  draw_gsk_cutting(pick, drawing, 94);
}

constexpr std::string_view kGskCutting = R"(
plane: G18 G17 G19
x: diameter radius
units: mm inch
increment: ISB ISC
distance: absolute letters
along: minus=-10 plus=20.5 zero=0 least=e
across: minus=-30 plus=12.345 zero=0
R: none zero=0 same=5 opposite=-5 below at !above@taper-limit most=999999999e !over=1000000000e@value-out-of-range
fault: none !stray@axis-not-in-plane !?both@conflicting-words !twice@duplicate-word !unknown@undefined-code
then: nothing again code feed dwell rapid
reading: default rewrite=gsk.g94.rewrite=clear empty=gsk.g94.empty-block=repeat
no: along=least R=opposite
no: along=zero R=opposite,below,at,above
)";
constexpr std::string_view kGskFeed = R"(
F: here=200 before !none@feed-missing !?zero=0@feed-missing !?minus=-5@value-sign+feed-missing
)";
constexpr std::string_view kLead = R"(
F: here=1.5 fine=0.001 coarse=20 !none@lead-missing !zero=0@lead-missing !minus=-5@value-sign+lead-missing
)";

void draw_gsk_arc(const Pick& pick, Drawing& drawing) {
  ArcWays ways = arc_ways(pick["centre"], pick["end"]);
  if (!pick.is("radii", "same")) ways.end[0] = ways.end[0] + pick.length("radii");
  drawing.stand(mm(40), mm(30), mm(20), pick.is("F", "before") ? "F120" : "");
  std::vector<std::string> words = arc_words(pick, drawing, ways);
  add_arc_form(pick, drawing, ways, words);
  if (pick.is("F", "here")) words.emplace_back("F200");
  drawing.test(words);
  if (pick.is("then", "line")) drawing.put({"G01", drawing.letters(Role::p, mm(2)), "F90"});
}

constexpr std::string_view kGskArc = R"(
plane: G18 G17 G19
x: diameter radius
units: mm inch
increment: ISB ISC
distance: absolute letters
form: centre R=10 large=-10 !short=10-e@arc-radius !none@missing-word
centre: along-p along-q both
end: opposite left right full
full: omitted written
zeros: omitted written
helix: none up=6 down=-0.5 least=e
radii: same least=e below=0.01-e at=0.01 !above=0.01+e@arc-end-point
F: here before !none@feed-missing
then: nothing line
# The end of a whole turn is the start, which R cannot say.
no: end=full form=R,large,short
no: form=short end=left,right
no: end=opposite,left,right full=written
no: form=R,large,short,none zeros=written
no: radii=least,below,at,above form=R,large,short
no: radii=least,below,at,above end=left,right,full
no: radii=least,below,at,above centre=along-q,both
no: radii=least,below,at,above units=inch
no: form=none end=full
)";

// Each step in increments, so that it can follow any other. `arc`: an arc is the motion in force,
// so that a block of axis words alone needs a radius.
void draw_gsk_step(const std::string& step, bool arc, Drawing& drawing) {
  const auto way = [&](Role role, std::int64_t length) {
    return drawing.letters(role, mm(length));
  };
  const std::string p = way(Role::p, -5);
  const std::string q = way(Role::q, -4);
  if (step == "rapid") drawing.put({"G00", p, q});
  if (step == "feed") drawing.put({"G01", way(Role::p, 3), way(Role::d, 2), "F100"});
  if (step == "arc") drawing.put({"G02", way(Role::p, 6), way(Role::q, 8), "R13 F110"});
  if (step == "dwell") drawing.put({"G04 P120"});
  if (step == "home") drawing.put({"G28", way(Role::p, 1)});
  if (step == "rename") drawing.put({"G50", drawing.absolute(Role::p, mm(33))});
  if (step == "bare") drawing.put({p, q, arc ? "R13" : ""});
  if (step == "G90") drawing.put({"G90", p, q, "R1 F130"});
  if (step == "G92") drawing.put({"G92", p, q, "F1.5"});
  if (step == "G94") drawing.put({"G94", p, q, "R2 F140"});
  if (step == "pocket") {
    drawing.put({"G110", way(Role::p, 9), way(Role::q, 9), way(Role::d, -4), "I12 L5 Q3 D4 F150"});
  }
  if (step == "helix") {
    drawing.put({"G113", way(Role::p, 2), way(Role::q, 9), way(Role::d, -4), "R-1 I12 D4 L2 F160"});
  }
  if (step == "thread") {
    drawing.profile.parameters["5921"] = 0;  // no run-out
    drawing.put(
        {"G114", way(Role::p, 9), way(Role::q, 1), way(Role::d, -6), "I2 E20 P1 D3 Q0.6 F170"});
  }
  if (step == "off") drawing.put({"G80"});
  if (step == "plane") {
    drawing.plane(17);
    drawing.put({"G17"});
  }
  if (step == "inch") drawing.put({"G20"});
  if (step == "turn") drawing.put({"G99 F0.2"});
}

void draw_gsk_sequence(const Pick& pick, Drawing& drawing) {
  drawing.stand(mm(40), mm(30), mm(20), "F90");
  bool arc = false;
  for (const char* place : {"first", "second", "third"}) {
    const std::string& step = pick[place];
    draw_gsk_step(step, arc, drawing);
    constexpr std::string_view kWithoutMotion = "dwell home rename bare plane inch turn";
    if (kWithoutMotion.find(step) == std::string_view::npos) arc = step == "arc";
  }
  drawing.put({drawing.letters(Role::q, mm(-2)), arc ? "R5" : ""});
  drawing.put({"M30"});
}

constexpr std::string_view kGskSteps =
    "rapid feed arc dwell home rename bare G90 G92 G94 pocket helix thread off plane inch turn\n";

}  // namespace

std::span<const Model> gsk_models() {
  static const std::array kModels = {
      Model{"gsk.g90",
            1,
            "gsk988ta",
            "g90",
            {3, 2},
            "basic g90",
            "GSK-G90-01..12 GSK-COM-01",
            joined({kGskCutting, kGskFeed}),
            draw_g90},
      Model{"gsk.g92",
            1,
            "gsk988ta",
            "g92",
            {3, 2},
            "basic g92",
            "GSK-G92-01..06 GSK-G92-08..12 GSK-COM-01",
            joined({kGskCutting, kLead}),
            draw_g92},
      Model{"gsk.g94",
            1,
            "gsk988ta",
            "g94",
            {3, 3},
            "basic g94",
            "GSK-G94-01..12 GSK-COM-01",
            joined({kGskCutting, kGskFeed}),
            draw_g94},
      gsk_g110_model(),
      gsk_g112_model(),
      gsk_g114_model(),
      Model{"gsk.arc",
            1,
            "gsk988ta",
            "arcs",
            {3, 3},
            "basic arc",
            "GSK-COM-05 GSK-COM-04",
            joined({codes_of("gsk988ta", {"arc"}), kGskArc}),
            draw_gsk_arc},
      Model{"gsk.sequence",
            1,
            "gsk988ta",
            "modes",
            {2, 2},
            "basic arc g90 g92 g94 g110 g112 g114",
            "GSK-MOD-01..08 GSK-G94-06 GSK-G94-07 GSK-G110-15",
            joined({"first: ", kGskSteps, "second: ", kGskSteps, "third: ", kGskSteps,
                    "x: diameter radius\n"}),
            draw_gsk_sequence},
  };
  return kModels;
}

}  // namespace gonogo::cover
