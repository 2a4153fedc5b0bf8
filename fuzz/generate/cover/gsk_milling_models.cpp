// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/generate/cover/model.hpp"

namespace gonogo::cover {
namespace {

// The centre 7 and -5.5 from where the tool stands, the depth beyond R.
std::vector<std::string> site(const Pick& pick, const Drawing& drawing) {
  const Length depth = pick.length("depth");
  const int down = depth.sign() == 0 ? -1 : depth.sign();
  Length r;
  if (!pick.is("R", "none")) r = down * pick.length("R");
  std::vector<std::string> words;
  if (!pick.is("site", "no-p")) words.push_back(drawing.travel(Role::p, mm(7)));
  words.push_back(drawing.travel(Role::q, Length{-5500, 0}));
  if (!pick.is("site", "no-d")) {
    const bool letters = pick.is("distance", "letters");
    words.push_back(letters ? drawing.letters(Role::d, depth)
                            : drawing.absolute(Role::d, r + depth));
  }
  if (!pick.is("R", "none")) words.push_back(drawing.word("R", r));
  return words;
}

void add_words(std::vector<std::string>& words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
}

// The head, the block with the code, and what follows it.
void draw_mill(const Pick& pick, Drawing& drawing, const std::vector<std::string>& own) {
  drawing.stand(mm(12), mm(30), mm(25), pick.is("F", "before") ? "F150" : "");
  std::vector<std::string> words = {pick["code"]};
  add_words(words, site(pick, drawing));
  add_words(words, own);
  if (pick.is("F", "here")) words.emplace_back("F200");
  if (!pick.is("extra", "none")) words.push_back(pick["extra"]);
  if (pick.is("fault", "both"))
    words.push_back(drawing.letters(Role::q, mm(1)) + " " + drawing.absolute(Role::q, mm(1)));
  if (pick.is("fault", "unknown")) words.emplace_back("G69");
  drawing.test(words);
  if (pick.is("then", "off")) drawing.put({"G80", drawing.letters(Role::p, mm(3))});
  if (pick.is("then", "line")) drawing.put({"G01", drawing.letters(Role::q, mm(-3)), "F80"});
}

void draw_gsk_pocket(const Pick& pick, Drawing& drawing) {
  draw_mill(pick, drawing,
            {drawing.word("I", "I"), drawing.word("L", "L"), drawing.word("Q", "Q"),
             drawing.word("D", "D"), drawing.word("P", "P")});
  // The sizes stay: another pocket beside it.
  if (pick.is("then", "again")) {
    drawing.put({drawing.letters(Role::p, mm(40)), drawing.letters(Role::q, mm(-2)),
                 drawing.letters(Role::d, mm(-3)), "F90"});
  }
}

void draw_gsk_helix(const Pick& pick, Drawing& drawing) {
  draw_mill(pick, drawing,
            {drawing.word("I", "I"), drawing.word("D", "D"),
             pick.is("L", "none") ? "" : "L" + pick["L"]});
  if (pick.is("then", "again")) {
    drawing.put({drawing.letters(Role::p, mm(40)), drawing.letters(Role::q, mm(-2)),
                 drawing.letters(Role::d, mm(-3)), "F90"});
  }
}

// GSK-G114-11: what the block leaves out the machine's parameters give.
void draw_gsk_thread(const Pick& pick, Drawing& drawing) {
  if (pick.is("J", "none")) drawing.profile.parameters["5921"] = 0;
  if (pick.is("K", "none")) drawing.profile.parameters["5920"] = 0;
  const std::string k = pick.is("K", "none") ? "" : "K" + pick["K"];
  draw_mill(pick, drawing,
            {drawing.word("I", "I"), drawing.word("P", "P"), drawing.word("Q", "Q"),
             drawing.word("D", "D"), drawing.word("E", "E"), drawing.word("J", "J"), k});
}

constexpr const char* kPocketParameters = R"(
plane: G18 G17 G19
x: diameter radius
units: mm inch
increment: ISB ISC
distance: absolute letters
depth: down=-9 up=9 zero=0 least=-e whole=-8
R: none zero=0 agreeing=3 !against=-3@direction-conflict
site: whole no-p no-d
I: typical=20 just=5+e !equal=5@tool-too-large !below=5-e@tool-too-large !zero=0@value-out-of-range+tool-too-large !none@missing-word
L: typical=4 just=10-e small=2.5 !equal=10@step-too-large !above=10+e@step-too-large !zero=0@value-out-of-range !none@missing-word
Q: typical=4 whole=9 more=50 !zero=0@value-out-of-range !none@missing-word
D: typical=5 !zero=0@value-out-of-range+step-too-large !none@missing-word
P: none zero=0 typical=1 minus=-1 more=50
F: here before !none@feed-missing
extra: none C=C45 H=H-30 M=M8
fault: none !?both@conflicting-words+duplicate-word !unknown@undefined-code
then: nothing again off line
reading: default end=gsk.pocket.end=r-plane path=gsk.pocket.path=concentric missing=gsk.missing-axis=position
no: R=against depth=zero
no: F=none depth=zero
no: site=no-p,no-d R=against
no: site=no-p,no-d F=none
no: site=no-p,no-d I=equal,below,zero
no: site=no-p,no-d L=equal,above,zero
no: site=no-p,no-d Q=zero
no: site=no-p,no-d D=zero
# A step of 5 - e and less would be cut in rings by the thousand.
no: I=just D=zero
)";

constexpr const char* kHelixParameters = R"(
plane: G18 G17 G19
x: diameter radius
units: mm inch
increment: ISB ISC
distance: absolute letters
depth: down=-9 up=9 zero=0 least=-e
R: none zero=0 agreeing=3 !against=-3@direction-conflict
site: whole no-p no-d
I: typical=20 just=5+e !equal=5@tool-too-large !below=5-e@tool-too-large !zero=0@value-out-of-range+tool-too-large !none@missing-word
D: typical=5 !?zero=0@value-out-of-range !none@missing-word
L: none one=1 many=7 most=99999 !zero=0@value-out-of-range !part=1.5@not-an-integer !over=100000@value-out-of-range
F: here before !none@feed-missing
extra: none C=C45 H=H-30 M=M35
fault: none !?both@conflicting-words+duplicate-word !unknown@undefined-code
then: nothing again off line
reading: default flat=gsk.helix.flat=on side=gsk.helix.entry-side=+p turns=gsk.helix.L=modal end=gsk.missing-axis=position
no: R=against depth=zero
no: F=none depth=zero
no: site=no-p,no-d R=against
no: site=no-p,no-d F=none
no: site=no-p,no-d I=equal,below,zero
no: site=no-p,no-d D=zero
)";

constexpr const char* kThreadParameters = R"(
plane: G18 G17 G19
x: diameter radius
units: mm inch
increment: ISB ISC
distance: absolute letters
depth: down=-9 up=9 zero=0
R: none zero=0 agreeing=3 !against=-3@direction-conflict
site: whole no-d
I: typical=2 whole=3 large=20 !none@missing-word !zero=0@value-out-of-range
P: typical=1 at=5 !above=5+e@depth-exceeds-tool !none@missing-word !?zero=0@value-out-of-range
Q: none zero=0 typical=0.4 more=6
D: typical=5 fit=15-e !?equal=15@tool-too-large !none@missing-word
E: typical=30 !none@missing-word !?zero=0@value-out-of-range
J: none zero=0 typical=2
K: none zero=0 typical=45 at=360 !above=360.001@value-out-of-range !minus=-1@value-out-of-range
F: here before !none@feed-missing
extra: none C=C45 H=H-30
fault: none !?both@conflicting-words+duplicate-word !unknown@undefined-code
then: nothing off line
reading: default path=gsk.thread.path=arc polar=gsk.thread.runout=polar radial=gsk.thread.runout=radial from=gsk.thread.v-from=initial
no: R=against depth=zero
no: F=none depth=zero
no: D=equal code=G114,G115
no: D=fit J=typical
no: D=fit P=above
no: E=zero code=G116,G117
no: site=no-d R=against
no: site=no-d F=none
no: site=no-d I=none,zero
no: site=no-d P=above,none,zero
no: site=no-d D=equal,none
no: site=no-d E=none,zero
no: reading=from R=against
no: reading=from distance=letters R=agreeing
)";

}  // namespace

Model gsk_g110_model() {
  return {"gsk.g110",
          1,
          "gsk988ta",
          "g110",
          {3, 2},
          "basic g110",
          "GSK-G110-01..04 GSK-G110-06..18 GSK-COM-01 GSK-COM-06",
          joined({codes_of("gsk988ta", {"g110"}), kPocketParameters}),
          draw_gsk_pocket};
}

Model gsk_g112_model() {
  return {"gsk.g112",
          1,
          "gsk988ta",
          "g112",
          {3, 2},
          "basic g112",
          "GSK-G112-01..09 GSK-G110-16..18 GSK-COM-01 GSK-COM-06",
          joined({codes_of("gsk988ta", {"g112"}), kHelixParameters}),
          draw_gsk_helix};
}

Model gsk_g114_model() {
  return {"gsk.g114",
          1,
          "gsk988ta",
          "g114",
          {3, 2},
          "basic g114 g116",
          "GSK-G114-01..13 GSK-COM-01 GSK-COM-06",
          joined({codes_of("gsk988ta", {"g114", "g116"}), kThreadParameters}),
          draw_gsk_thread};
}

}  // namespace gonogo::cover
