// SPDX-License-Identifier: GPL-3.0-or-later
//
// Models of the HNC-21T: the cutting cycles G80, G81 and G82, the drilling and grooving cycles G74
// and G75, the thread G32, and arcs.
#include <array>

#include "fuzz/generate/cover/arcs.hpp"
#include "fuzz/generate/cover/model.hpp"

namespace gonogo::cover {
namespace {

// On this lathe p is Z and q is X.
std::string way_of(const Pick& pick, const Drawing& drawing, Role role, std::string_view name) {
  return pick.is(name, "missing") ? "" : drawing.travel(role, pick.length(name));
}

// Words that a block must not have.
std::string stray_word(const Pick& pick, const Drawing& drawing) {
  if (pick.is("fault", "both")) {
    const bool letters = pick.is("distance", "letters");
    return letters ? drawing.absolute(Role::p, mm(2)) : drawing.letters(Role::p, mm(2));
  }
  return pick.is("fault", "none") ? "" : pick["fault"];
}

void draw_after(const Pick& pick, Drawing& drawing, const std::string& code) {
  const std::string x = drawing.travel(Role::q, mm(-9));
  const std::string z = drawing.travel(Role::p, mm(-21));
  if (pick.is("then", "again")) drawing.put({x, z});
  if (pick.is("then", "code")) drawing.put({code, z, x});
  if (pick.is("then", "dwell")) drawing.put({"G04 P250"}), drawing.put({x, z});
  if (pick.is("then", "rapid")) drawing.put({"G00", x});
}

// G80 with I and G81 with K.
void draw_hnc_cutting(const Pick& pick, Drawing& drawing, const std::string& code,
                      std::string_view taper) {
  drawing.stand(mm(4), mm(30), {}, pick.is("F", "before") ? "F120" : "");
  drawing.test({code, way_of(pick, drawing, Role::q, "X"), way_of(pick, drawing, Role::p, "Z"),
                drawing.word(taper, "taper"), pick.is("F", "here") ? "F200" : "",
                pick.is("F", "minus") ? "F-5" : "", stray_word(pick, drawing)});
  draw_after(pick, drawing, code);
}

void draw_g80(const Pick& pick, Drawing& drawing) {
  draw_hnc_cutting(pick, drawing, "G80", "I");
}
void draw_g81(const Pick& pick, Drawing& drawing) {
  draw_hnc_cutting(pick, drawing, "G81", "K");
}

// What all cycles have in common.
constexpr std::string_view kHncHead = R"(
x: diameter radius
units: mm inch
distance: absolute letters modal
)";
constexpr std::string_view kHncFeed = R"(
F: here before !none@feed-missing !?minus@value-sign+feed-missing
)";
constexpr std::string_view kHncFaults = R"(
fault: none !?both@conflicting-words !?twice=S100&S200@duplicate-word !?Y=Y5@undefined-code !?plane=G17@plane-not-allowed
then: nothing again code dwell rapid
)";

constexpr std::string_view kHncCutting = R"(
X: minus=-8 plus=6.25 zero=0 least=-e !missing@missing-word
Z: minus=-30 plus=12.5 zero=0 least=-e !missing@missing-word
taper: none zero=0 minus=-2.5 plus=1.75 least=e large=400
reading: default none=hnc.missing-axis=none
no: reading=none X=missing
no: reading=none Z=missing
)";

// Run-outs of G82 by their ratio to 20, X short and Z long: Z travels farther.
void draw_g82(const Pick& pick, Drawing& drawing) {
  drawing.stand(mm(4), mm(30), {});
  std::vector<std::string> words = {"G82", way_of(pick, drawing, Role::q, "X"),
                                    way_of(pick, drawing, Role::p, "Z"), drawing.word("I", "I")};
  if (!pick.is("run-out", "none")) {
    const bool pair = !pick.is("run-out", "R-alone") && !pick.is("run-out", "E-alone");
    if (pair || pick.is("run-out", "R-alone")) words.push_back(drawing.word("R", Length{-500, 0}));
    if (pair || pick.is("run-out", "E-alone")) words.push_back(drawing.word("E", "run-out"));
  }
  for (const char* name : {"Q", "C", "P"}) {
    if (!pick.is(name, "none")) words.push_back(name + pick[name]);
  }
  if (!pick.is("lead", "none")) words.push_back(pick["lead"]);
  words.push_back(stray_word(pick, drawing));
  drawing.test(words);
  draw_after(pick, drawing, "G82");
}

constexpr std::string_view kHncThread = R"(
X: minus=-2 plus=1.25 zero=0 !missing@missing-word
Z: minus=-30 plus=12.5 !missing@missing-word
I: none zero=0 minus=-1.5 plus=0.75
run-out: none both=2 below=10-e at=10 !above=10+e@retract-ratio !R-alone@retract-pair !E-alone=2@retract-pair
Q: none zero=0 typical=20 !minus=-1@value-sign
C: none zero=0 one=1 two=2 five=5 !minus=-1@value-sign !part=1.5@not-an-integer
P: none zero=0 typical=72 over=400
lead: F1.5 J8 fine=F0.001 !none@lead-missing !both=F1.5&J8@conflicting-words !?zero=F0@value-sign !?minus=J-8@value-sign
reading: default feed=hnc.g82.exit=feed one=hnc.g82.starts=one scale=hnc.g82.e-scale=diameter
# Several starts need their angle.
no: C=two,five P=none
no: reading=scale x=diameter run-out=above
no: Z=missing run-out=below,at,above
)";

void draw_pecks(const Pick& pick, Drawing& drawing, const std::string& code) {
  const bool groove = code == "G75";
  drawing.stand(mm(4), mm(30), {}, pick.is("F", "before") ? "F120" : "");
  std::vector<std::string> words = {code};
  words.push_back(drawing.word("R", "e"));
  words.push_back(drawing.word("Q", "Q"));
  if (groove) {
    words.push_back(way_of(pick, drawing, Role::q, "depth"));
    if (!pick.is("width", "none")) words.push_back(drawing.travel(Role::p, pick.length("width")));
    if (!pick.is("I", "none")) words.push_back("I" + pick["I"]);
  } else {
    words.push_back(way_of(pick, drawing, Role::p, "depth"));
  }
  if (pick.is("F", "here")) words.emplace_back("F200");
  if (pick.is("F", "minus")) words.emplace_back("F-5");
  words.push_back(stray_word(pick, drawing));
  drawing.test(words);
  if (pick.is("then", "again")) drawing.put({drawing.travel(groove ? Role::q : Role::p, mm(-3))});
  if (pick.is("then", "rapid")) drawing.put({"G00", drawing.travel(Role::q, mm(2))});
}

void draw_g74(const Pick& pick, Drawing& drawing) {
  draw_pecks(pick, drawing, "G74");
}
void draw_g75(const Pick& pick, Drawing& drawing) {
  draw_pecks(pick, drawing, "G75");
}

constexpr std::string_view kPecks = R"(
e: none zero=0 typical=0.5 least=e over=4 !minus=-e@value-sign
Q: none typical=2.5 whole=3 more=50 !zero=0@value-sign !minus=-2@value-sign
F: here before !none@feed-missing !?minus@value-sign+feed-missing
then: nothing again rapid
# A withdrawal needs a depth of a peck; pecks that gain nothing never end.
no: e=typical,least,over Q=none
no: reading=withdrawn e=over Q=typical,whole
)";

constexpr std::string_view kDrill = R"(
depth: minus=-9 plus=7.25 zero=0 least=-e
fault: none !?twice=S100&S200@duplicate-word !?Y=Y5@undefined-code !?plane=G19@plane-not-allowed
reading: default withdrawn=hnc.peck.from=withdrawn feed=hnc.peck.withdraw=feed clamp=hnc.peck.clamp=start
)";

constexpr std::string_view kGroove = R"(
depth: minus=-9 plus=7.25 zero=0 !missing@missing-word
width: none minus=-8 plus=5 zero=0
I: none one=1 three=3 !zero=0@not-an-integer !part=1.5@not-an-integer !minus=-2@not-an-integer
fault: none !?twice=S100&S200@duplicate-word !?Y=Y5@undefined-code !?plane=G19@plane-not-allowed
reading: default withdrawn=hnc.peck.from=withdrawn steps=hnc.g75.steps=i end=hnc.g75.end=last scale=hnc.g75.depth-scale=diameter
no: depth=missing width=none
# A width and a number of steps need each other.
no: width=none I=one,three,zero,part,minus
no: width=minus,plus,zero I=none
)";

void draw_g32(const Pick& pick, Drawing& drawing) {
  drawing.stand(mm(4), mm(30), {});
  drawing.test({"G32", way_of(pick, drawing, Role::q, "X"), way_of(pick, drawing, Role::p, "Z"),
                pick.is("lead", "none") ? "" : pick["lead"], stray_word(pick, drawing)});
  if (pick.is("then", "again")) drawing.put({drawing.travel(Role::p, mm(-50))});
  if (pick.is("then", "rapid")) drawing.put({"G00", drawing.travel(Role::q, mm(2))});
}

constexpr std::string_view kLineThread = R"(
X: missing minus=-2 plus=1.25 long=-60
Z: minus=-30 plus=12.5 short=-0.5
lead: F1.5 J8 fine=F0.001 !none@lead-missing !both=F1.5&J8@conflicting-words !?zero=F0@value-sign !?minus=F-2@value-sign
fault: none !?both@conflicting-words !?twice=S100&S200@duplicate-word !?plane=G17@plane-not-allowed
then: nothing again rapid
)";

void draw_hnc_arc(const Pick& pick, Drawing& drawing) {
  ArcWays ways = arc_ways(pick["centre"], pick["end"]);
  if (!pick.is("radii", "same")) ways.end[0] = ways.end[0] + pick.length("radii");
  drawing.stand(mm(-12), mm(40), {}, pick.is("F", "before") ? "F120" : "");
  std::vector<std::string> words = arc_words(pick, drawing, ways);
  add_arc_form(pick, drawing, ways, words);
  if (pick.is("F", "here")) words.emplace_back("F200");
  words.push_back(stray_word(pick, drawing));
  drawing.test(words);
  if (pick.is("then", "line")) drawing.put({"G01", drawing.travel(Role::p, mm(2)), "F90"});
}

constexpr std::string_view kHncArc = R"(
form: centre R=10 large=-10 !short=10-e@arc-radius !none@missing-word
centre: along-p along-q both
end: opposite left right full
full: omitted written
zeros: omitted written
radii: same least=e below=0.01-e at=0.01 !?above=0.01+e@arc-end-point
F: here before !none@feed-missing
fault: none !?twice=S100&S200@duplicate-word !?plane=G17@plane-not-allowed
then: nothing line
no: end=full form=R,large,short,none
no: form=short end=left,right
no: end=opposite,left,right full=written
no: form=R,large,short,none zeros=written
no: radii=least,below,at,above form=R,large,short
no: radii=least,below,at,above end=left,right,full
no: radii=least,below,at,above centre=along-q,both
no: radii=least,below,at,above units=inch
)";

}  // namespace

// NOLINTNEXTLINE(readability-function-size): a table.
std::span<const Model> hnc_models() {
  static const std::array kModels = {
      Model{"hnc.g74",
            2,
            "hnc21t",
            "g74",
            {3, 3},
            "basic g74",
            "HNC-G74-01..04 HNC-MOD-03",
            joined({kHncHead, kDrill, kPecks}),
            draw_g74},
      Model{"hnc.g75",
            1,
            "hnc21t",
            "g75",
            {3, 2},
            "basic g75",
            "HNC-G75-01..05 HNC-MOD-03",
            joined({kHncHead, kGroove, kPecks}),
            draw_g75},
      Model{"hnc.g80",
            1,
            "hnc21t",
            "g80",
            {3, 3},
            "basic g80",
            "HNC-G80-01 HNC-G80-02 HNC-MOD-02",
            joined({kHncHead, kHncFeed, kHncFaults, kHncCutting}),
            draw_g80},
      Model{"hnc.g81",
            1,
            "hnc21t",
            "g81",
            {3, 3},
            "basic g81",
            "HNC-G81-01 HNC-G81-02 HNC-MOD-02",
            joined({kHncHead, kHncFeed, kHncFaults, kHncCutting}),
            draw_g81},
      Model{"hnc.g82",
            1,
            "hnc21t",
            "g82",
            {3, 2},
            "basic g82",
            "HNC-G82-01..10 HNC-MOD-02",
            joined({kHncHead, kHncFaults, kHncThread}),
            draw_g82},
      Model{"hnc.g32",
            1,
            "hnc21t",
            "g32",
            {3, 3},
            "basic g32",
            "HNC-MOD-04 HNC-COM-01",
            joined({kHncHead, kLineThread}),
            draw_g32},
      Model{"hnc.arc",
            1,
            "hnc21t",
            "arcs",
            {3, 3},
            "basic arc",
            "HNC-COM-01",
            joined({kHncHead, codes_of("hnc21t", {"arc"}), kHncArc}),
            draw_hnc_arc},
      hnc_sequence_model(),
  };
  return kModels;
}

}  // namespace gonogo::cover
