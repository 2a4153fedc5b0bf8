// SPDX-License-Identifier: GPL-3.0-or-later
#include "word_bench.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "grammar/line_source.hpp"

namespace gonogo::reference::testing {
namespace {

using Words = std::map<std::string, std::string>;

Bench hnc_bench(std::string_view code) {
  Bench bench{"G00 X50 Z5 F90", {{"X", "40"}, {"Z", "-5"}}, "X38 Z-6\nG01 X37 Z-7"};
  static const std::map<std::string_view, Words> kWords = {
      {"G2", {{"X", "40"}, {"Z", "-10"}, {"R", "20"}}},
      {"G3", {{"X", "40"}, {"Z", "-10"}, {"R", "20"}}},
      {"G4", {{"P", "100"}}},
      {"G32", {{"X", "40"}, {"Z", "-5"}, {"F", "2"}}},
      {"G74", {{"Z", "-20"}, {"R", "1"}, {"Q", "3"}}},
      {"G75", {{"X", "20"}, {"Z", "0"}, {"R", "1"}, {"Q", "3"}, {"I", "3"}}},
      {"G82", {{"X", "40"}, {"Z", "-5"}, {"F", "2"}, {"P", "10"}}},
  };
  if (const auto own = kWords.find(code); own != kWords.end()) bench.words = own->second;
  if (code == "G2" || code == "G3" || code == "G4" || code == "G92") bench.behind = "G01 X37 Z-7";
  return bench;
}

Bench gsk_bench(std::string_view code) {
  Bench bench{"G18 G00 X50 Y9 Z5 F90", {{"X", "40"}, {"Z", "-5"}}, "X38 Z-6\nG01 X37 Z-7 C1"};
  const Words pocket = {{"X", "20"}, {"Z", "10"}, {"Y", "-9"}, {"I", "9"}, {"L", "1.5"},
                        {"Q", "4"},  {"D", "3"},  {"R", "-1"}, {"P", "1"}};
  Words helix = pocket;
  helix["L"] = "3";
  const Words thread = {{"X", "20"},  {"Z", "10"}, {"Y", "-9"}, {"I", "2"}, {"E", "24"}, {"P", "1"},
                        {"Q", "0.4"}, {"D", "3"},  {"R", "-1"}, {"J", "1"}, {"K", "45"}};
  const std::map<std::string_view, Words> words = {
      {"G2", {{"X", "40"}, {"Z", "-10"}, {"R", "20"}}},
      {"G3", {{"X", "40"}, {"Z", "-10"}, {"K", "-10"}, {"I", "0"}}},
      {"G4", {{"P", "100"}}},
      {"G92", {{"X", "40"}, {"Z", "-5"}, {"F", "2"}, {"J", "0"}, {"K", "0"}}},
      {"G110", pocket},
      {"G111", pocket},
      {"G112", helix},
      {"G113", helix},
      {"G114", thread},
      {"G115", thread},
      {"G116", thread},
      {"G117", thread}};
  if (const auto own = words.find(code); own != words.end()) bench.words = own->second;
  const std::string cut = "G01 X37 Z-7";
  if (code == "G90" || code == "G92" || code == "G94") bench.behind = "X38\n" + cut;
  if (code == "G2" || code == "G3" || code == "G4" || code >= "G114") bench.behind = cut;
  if (code.starts_with("G110") || code.starts_with("G111") || code.starts_with("G112") ||
      code.starts_with("G113")) {
    bench.behind = "X1 Z1 Y-8\n" + cut;
  }
  return bench;
}

Bench ngc_bench(std::string_view code) {
  Bench bench{"G17 G0 X50 Y9 Z5 F90", {{"X", "40"}, {"Y", "-5"}}, "X38 Y-6\nG1 X37 Y-7\nM2"};
  if (code == "G2" || code == "G3") {
    bench.words = {{"X", "40"}, {"Y", "9"}, {"I", "-5"}, {"J", "0"}};
    bench.behind = "G1 X37 Y-7\nM2";
  }
  if (code == "G4") bench.words = {{"P", "1"}};
  // Holes: from above the R plane, with a spindle that turns as G74 or the others have it. The
  // thread has few passes with any degression.
  const Words hole = {{"X", "40"}, {"Y", "-5"}, {"Z", "-4"}, {"R", "3"}};
  const Words dwelling = {{"X", "40"}, {"Y", "-5"}, {"Z", "-4"}, {"R", "3"}, {"P", "1"}};
  const Words pecks = {{"X", "40"}, {"Y", "-5"}, {"Z", "-4"}, {"R", "3"}, {"Q", "3"}};
  const std::map<std::string_view, Words> words = {
      {"G33", {{"X", "40"}, {"Y", "-5"}, {"K", "1"}}},
      {"G33.1", {{"X", "40"}, {"Y", "-5"}, {"K", "1"}}},
      {"G73", pecks},
      {"G74", dwelling},
      {"G76",
       {{"Z", "-20"},
        {"P", "1"},
        {"I", "-1"},
        {"J", "0.5"},
        {"K", "0.65"},
        {"R", "3"},
        {"E", "1"},
        {"L", "1"}}},
      {"G81", hole},
      {"G82", dwelling},
      {"G83", pecks},
      {"G84", dwelling},
      {"G85", hole},
      {"G86", dwelling},
      {"G89", dwelling}};
  if (const auto own = words.find(code); own != words.end()) {
    bench.words = own->second;
    bench.before += code == "G74" ? " M4" : " M3";
    bench.behind = "G1 X37 Y-7\nM2";
  }
  if (code == "G76") {
    bench.before.replace(0, 3, "G18");
    bench.before += " G91";  // the next thread begins where this one ends
  }
  if (code == "G80") {
    bench.words.clear();
    bench.behind = "G1 X37 Y-7\nM2";
  }
  // What an offset of each axis does is seen where all of them move.
  if (code == "G10") bench.words = {{"L", "2"}, {"P", "1"}, {"X", "40"}};
  if (code == "G43") bench.words = {{"H", "1"}};
  if (code == "G43.2") bench.words = {{"H", "1"}};
  if (code == "G7") bench.words = {{"Y", "-5"}};  // NGC-DIA-02
  const bool moves_origin = code == "G10" || code == "G52" || code == "G92";
  if (moves_origin || code.starts_with("G43")) {
    bench.behind = "G0 X38 Y-6 Z1 A1 C1\nG1 X37 Y-7\nM2";
  }
  return bench;
}

Bench sinumerik_bench(std::string_view code) {
  const std::string before = "G17 G90 G1 X50 Y9 Z5 F90 S100 M3";
  const std::string cut = "G1 X38 Y-6";
  const std::map<std::string_view, Bench> benches = {
      {"G2", {before, {{"X", "40"}, {"Y", "9"}, {"CR=", "20"}}, cut}},
      {"G3", {before, {{"X", "40"}, {"Y", "9"}, {"I", "-5"}, {"J", "0"}}, cut}},
      {"G4", {before, {{"F", "2"}}, cut}},
      {"G110", {before, {{"X", "4"}, {"Y", "9"}}, "G1 AP=30 RP=10"}},
      {"G111", {before, {{"X", "4"}, {"Y", "9"}}, "G1 AP=30 RP=10"}},
      {"G112", {before, {{"X", "4"}, {"Y", "9"}}, "G1 AP=30 RP=10"}},
      {"G258", {before, {{"RPL=", "45"}}, cut}},
      {"G259", {before, {{"RPL=", "45"}}, cut}},
      {"CIP", {before, {{"X", "40"}, {"Y", "9"}, {"I1=", "45"}, {"J1=", "14"}}, cut}},
      {"CT", {before, {{"X", "40"}, {"Y", "19"}}, cut}}};
  const auto own = benches.find(code);
  if (own != benches.end()) return own->second;
  return {before, {{"X", "40"}, {"Y", "-5"}}, "G1 X38 Y-6 Z1 A1"};
}

// Whether it is the word that cannot stand there, and not its value.
bool is_refused(const Said& with, const std::string& name) {
  if (with.not_covered) {
    const std::string& message = with.not_covered->message;
    return with.not_covered->code == name &&
           (message.find("does not read the word") != std::string::npos ||
            message.find("program for a mill") != std::string::npos ||
            message.find("is not read by the gauge") != std::string::npos ||
            message.find("is one that the gauge does not read") != std::string::npos);
  }
  const std::string& message = with.alarm->message;
  return with.alarm->alarm == AlarmClass::unused_word ||
         with.alarm->alarm == AlarmClass::undefined_code ||
         message.find("has no meaning for the motion") != std::string::npos ||
         message.find("does not stand beside") != std::string::npos ||
         message.find("is the angle of G258") != std::string::npos;
}

}  // namespace

std::string Said::ending() const {
  if (alarm) return fmt::format("alarm {}", name(alarm->alarm));
  return not_covered ? "not covered: " + not_covered->code : "end";
}

Said said_of(const std::string& program, const Profile& profile) {
  grammar::MemorySource bytes(program);
  grammar::LineSource lines(bytes);
  Expander expander(profile, lines, OpenPaths::shown);
  Said said;
  while (const Item* item = expander.next()) {
    if (auto* record = std::get_if<Record>(item)) {
      append_json(*record, said.records);
    } else if (auto* renaming = std::get_if<Renaming>(item)) {
      for (const Axis axis : kAllAxes) said.records += renaming->shift[axis].text() + " ";
    } else if (auto* report = std::get_if<AlarmReport>(item)) {
      said.alarm = report->alarms.front();
    } else if (auto* outside = std::get_if<NotCovered>(item)) {
      said.not_covered = *outside;
    }
  }
  return said;
}

std::string Bench::program(const Code& code) const {
  std::string block(code.name);
  for (const auto& [address, value] : words) block += " " + address + value;
  return before + "\n" + block + "\n" + behind + "\n";
}

Bench bench_of(const Dialect& dialect, const Code& code) {
  if (dialect.name == "hnc21t") return hnc_bench(code.name);
  if (dialect.name == "gsk988ta") return gsk_bench(code.name);
  if (dialect.name == "rs274") return ngc_bench(code.name);
  return sinumerik_bench(code.name);
}

Profile bench_profile(const Dialect& dialect) {
  Profile profile = std::get<Profile>(default_profile(dialect.name));
  if (dialect.name == "hnc21t") set_reading(profile, "hnc.g75.mode3", "off");
  if (dialect.name == "rs274") {
    set_reading(profile, "ngc.peck.d", "clearance");
    profile.tools = {{"1", {0, 5}}, {"2", {0, 7}}, {"30", {0, 9}}};
  }
  return profile;
}

std::vector<const Code*> codes_with_words(const Dialect& dialect) {
  std::vector<const Code*> codes;
  for (const Code& code : dialect.descriptor->codes) {
    // The words of the 802S's cycles are parameters that stand before the call.
    const bool is_call = code.tenths < 0 && code.kind == Kind::cycle;
    const bool is_g_or_name = code.is_g() || code.kind == Kind::circle;
    if (code.treatment != Treatment::outside && is_g_or_name && !is_call) codes.push_back(&code);
  }
  return codes;
}

std::vector<std::string> candidate_words(const Dialect& dialect) {
  if (dialect.name.starts_with("sinumerik")) {
    return {"A",    "B",     "C",     "D",     "E",      "F",      "H",     "I",   "J",   "K",
            "M",    "O",     "P",     "Q",     "S",      "T",      "U",     "V",   "W",   "X",
            "Y",    "Z",     "L",     "I1=",   "J1=",    "K1=",    "CR=",   "AR=", "AP=", "RP=",
            "H3=",  "RPL=",  "TURN=", "CHF=",  "CHR=",   "RND=",   "L1=",   "E=",  "X1=", "M2=",
            "FRC=", "FRCM=", "ANG=",  "RNDM=", "SETAL=", "DEPTH=", "OFFN=", "F1="};
  }
  std::vector<std::string> words;
  for (const char letter : std::string_view("ABCDEFHIJKLMPQRSTUVWXYZ")) {
    words.emplace_back(1, letter);
  }
  return words;
}

Fate fate_of(const Profile& profile, const Bench& bench, const Code& code,
             const std::string& address, const std::string& value) {
  const Said without = said_of(bench.program(code), profile);
  Bench more = bench;
  more.words[address] = value;
  const Said with = said_of(more.program(code), profile);
  const std::string name = address.back() == '=' ? address.substr(0, address.size() - 1) : address;
  if (with.alarm || with.not_covered) return is_refused(with, name) ? Fate::refused : Fate::wrong;
  return with == without ? Fate::idle : Fate::used;
}

}  // namespace gonogo::reference::testing
