// SPDX-License-Identifier: GPL-3.0-or-later
//
// A code taken for another one or passed over.
#include <fmt/format.h>

#include <set>

#include "fuzz/identify/variant.hpp"

namespace gonogo::identify {
namespace {

using reference::Number;

// Codes of a maker that one may be taken for another.
std::vector<std::string> codes_of(std::string_view dialect) {
  if (dialect == "gsk988ta") {
    return {"G0",   "G1",   "G2",   "G3",   "G90",  "G92",  "G94", "G110",
            "G111", "G112", "G113", "G114", "G115", "G116", "G117"};
  }
  if (dialect == "hnc21t") {
    return {"G0", "G1", "G2", "G3", "G32", "G74", "G75", "G80", "G81", "G82"};
  }
  if (dialect == "rs274") return {"G0", "G1", "G2", "G3"};
  return {"G0", "G1", "G2", "G3", "G110", "G111", "G112", "G158", "G258", "G259"};
}

using CodeMap = std::function<std::optional<std::string>(const TextBlock&, const std::string&)>;

void add_codes(std::string name, const CodeMap& map, Variants& out) {
  out.push_back({std::move(name), [map](const Observation& seen) -> std::optional<Trial> {
                   auto text = edited(ProgramText(seen.profile, seen.program),
                                      [&](const TextBlock& block,
                                          const TextWord& word) -> std::optional<std::string> {
                                        if (!word.is_code()) return std::nullopt;
                                        return map(block, word.code());
                                      });
                   if (!text) return std::nullopt;
                   return Trial{std::move(*text), seen.profile, seen.outcome, std::nullopt};
                 }});
}

void add_taken_for(const std::string& code, const std::string& other, Variants& out) {
  add_codes(
      fmt::format("{} does what {} does", code, other),
      [=](const TextBlock&, const std::string& word) -> std::optional<std::string> {
        return word == code ? std::optional(other) : std::nullopt;
      },
      out);
}

// Sense: the two codes change places, in every plane or in one.
void add_exchanged(const std::string& a, const std::string& b, int plane, Variants& out) {
  add_codes(
      fmt::format("{} and {} change places{}", a, b,
                  plane == 0 ? "" : fmt::format(" in G{}", plane)),
      [=](const TextBlock& block, const std::string& word) -> std::optional<std::string> {
        if (plane != 0 && block.plane != plane) return std::nullopt;
        if (word == a) return b;
        if (word == b) return a;
        return std::nullopt;
      },
      out);
}

// Two pairs of codes, the second of each as the first.
void add_right_as_left(const std::string& left, const std::string& right,
                       const std::string& other_left, const std::string& other_right,
                       Variants& out) {
  add_codes(
      fmt::format("{} and {} do what {} and {} do", right, other_right, left, other_left),
      [=](const TextBlock&, const std::string& word) -> std::optional<std::string> {
        if (word == right) return left;
        if (word == other_right) return other_left;
        return std::nullopt;
      },
      out);
}

// Two cycles with one table of axes, the taper word of each read as that of the other.
void add_facing(Variants& out) {
  for (const auto& [code, taper, other, other_taper] :
       {std::tuple("G80", "I", "G81", "K"), std::tuple("G81", "K", "G80", "I")}) {
    out.push_back(
        {fmt::format("{} does what {} does, {} as {}", code, other, taper, other_taper),
         [=](const Observation& seen) -> std::optional<Trial> {
           auto text = edited(
               ProgramText(seen.profile, seen.program),
               [&](const TextBlock& block, const TextWord& word) -> std::optional<std::string> {
                 if (block.motion != code) return std::nullopt;
                 if (word.code() == code) return other;
                 if (word.address != taper) return std::nullopt;
                 return other_taper + block.text.substr(word.where.begin + 1,
                                                        word.where.end - word.where.begin - 1);
               });
           if (!text) return std::nullopt;
           return Trial{std::move(*text), seen.profile, seen.outcome, std::nullopt};
         }});
  }
}

}  // namespace

void add_code_variants(const Observation& departure, Variants& out) {
  const ProgramText program(departure.profile, departure.program);
  std::set<std::string> codes;
  for (const TextBlock& block : program.blocks) {
    for (const TextWord& word : block.words) {
      if (word.is_code()) codes.insert(word.code());
    }
  }
  for (const int plane : {0, 17, 18, 19}) add_exchanged("G2", "G3", plane, out);
  for (const auto& [a, b] : {std::pair("G110", "G111"), std::pair("G112", "G113"),
                             std::pair("G90", "G91"), std::pair("G114", "G115")}) {
    if (codes.contains(a) || codes.contains(b)) add_exchanged(a, b, 0, out);
  }
  if (departure.profile.dialect == "gsk988ta") {
    add_right_as_left("G114", "G115", "G116", "G117", out);
    add_right_as_left("G114", "G116", "G115", "G117", out);
    add_exchanged("G114", "G116", 0, out);
  }
  if (departure.profile.dialect == "hnc21t") add_facing(out);
  for (const std::string& code : codes) {
    const std::size_t point = code.find('.');
    if (point != std::string::npos) add_taken_for(code, code.substr(0, point), out);
  }
  const std::vector<std::string> known = codes_of(departure.profile.dialect);
  for (const std::string& code : codes) {
    for (const std::string& other : known) {
      if (code != other && code.front() == 'G') add_taken_for(code, other, out);
    }
    add_codes(
        fmt::format("{} is ignored", code),
        [=](const TextBlock&, const std::string& word) -> std::optional<std::string> {
          return word == code ? std::optional<std::string>("") : std::nullopt;
        },
        out);
  }
}

}  // namespace gonogo::identify
