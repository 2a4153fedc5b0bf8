// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/program_codes.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace gonogo::fuzz {
namespace {

// What shows that a program needs a feature: codes, or addresses of words.
struct FeatureSign {
  std::string_view feature;
  std::array<std::string_view, 8> codes;
  std::array<std::string_view, 8> addresses;
};

constexpr std::array<FeatureSign, 8> kGsk = {{
    {"arc", {"G2", "G3"}, {}},
    {"g90", {"G90"}, {}},
    {"g92", {"G92"}, {}},
    {"g94", {"G94"}, {}},
    {"g110", {"G110", "G111"}, {}},
    {"g112", {"G112", "G113"}, {}},
    {"g114", {"G114", "G115"}, {}},
    {"g116", {"G116", "G117"}, {}},
}};
constexpr std::array<FeatureSign, 7> kHnc = {{
    {"arc", {"G2", "G3"}, {}},
    {"g32", {"G32"}, {}},
    {"g74", {"G74"}, {}},
    {"g75", {"G75"}, {}},
    {"g80", {"G80"}, {}},
    {"g81", {"G81"}, {}},
    {"g82", {"G82"}, {}},
}};
constexpr std::array<FeatureSign, 5> kNgc = {{
    {"arc", {"G2", "G3"}, {}},
    {"arc-r", {}, {"R"}},
    {"planes", {"G18", "G19"}, {}},
    {"arc-distance", {"G90.1", "G91.1"}, {}},
    {"turns", {}, {"P"}},
}};
constexpr std::array<FeatureSign, 13> kSinumerik = {{
    {"arc", {"G2", "G3"}, {}},
    {"cr", {}, {"CR"}},
    {"ar", {}, {"AR"}},
    {"polar", {"G110", "G111", "G112"}, {"AP", "RP"}},
    {"planes", {"G18", "G19"}, {}},
    {"helix", {}, {"TURN"}},
    {"cip", {"CIP"}, {}},
    {"ct", {"CT"}, {}},
    {"expressions", {}, {"R"}},
    {"rotary", {}, {"A", "C"}},
    {"frames", {"G158", "G258", "G259"}, {"RPL"}},
    {"lcyc82", {"LCYC82"}, {}},
    {"lcyc75", {"LCYC75"}, {}},
}};

std::span<const FeatureSign> signs_of(std::string_view dialect) {
  if (dialect == "gsk988ta") return kGsk;
  if (dialect == "hnc21t") return kHnc;
  if (dialect == "rs274") return kNgc;
  return kSinumerik;
}

constexpr std::array<std::string_view, 15> kGskCodes = {"G0",   "G1",   "G2",   "G3",   "G90",
                                                        "G92",  "G94",  "G110", "G111", "G112",
                                                        "G113", "G114", "G115", "G116", "G117"};
constexpr std::array<std::string_view, 10> kHncCodes = {"G0",  "G1",  "G2",  "G3",  "G32",
                                                        "G74", "G75", "G80", "G81", "G82"};
constexpr std::array<std::string_view, 5> kNgcCodes = {"G0", "G1", "G2", "G3", "G80"};
constexpr std::array<std::string_view, 8> kSinumerikCodes = {"G0",  "G1", "G2",     "G3",
                                                             "CIP", "CT", "LCYC82", "LCYC75"};

std::span<const std::string_view> motion_codes(std::string_view dialect) {
  if (dialect == "gsk988ta") return kGskCodes;
  if (dialect == "hnc21t") return kHncCodes;
  if (dialect == "rs274") return kNgcCodes;
  return kSinumerikCodes;
}

template <typename Items>
bool holds(const Items& items, std::string_view item) {
  return !item.empty() && std::ranges::find(items, item) != std::ranges::end(items);
}

}  // namespace

bool is_motion_code(std::string_view dialect, std::string_view code) {
  return holds(motion_codes(dialect), code);
}

std::vector<std::string> codes_in_force(std::string_view dialect,
                                        const std::vector<TextLine>& lines) {
  std::vector<std::string> codes;
  std::string present;
  for (const TextLine& line : lines) {
    for (const TextWord& word : line.words) {
      const std::string code = code_of(word);
      if (is_motion_code(dialect, code)) present = code;
    }
    codes.push_back(present);
  }
  return codes;
}

std::set<std::string> features_needed(std::string_view dialect,
                                      const std::vector<TextLine>& lines) {
  std::set<std::string> features = {"basic"};
  const std::vector<std::string> codes = codes_in_force(dialect, lines);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const bool is_arc = codes[i] == "G2" || codes[i] == "G3";
    // R and P of RS274 belong to other codes too.
    const bool by_address = is_arc || dialect != "rs274";
    std::set<std::string> letters;
    for (const TextWord& word : lines[i].words) {
      const std::string code = code_of(word);
      const std::string address = address_of(word);
      letters.insert(address);
      for (const FeatureSign& sign : signs_of(dialect)) {
        if (holds(sign.codes, code) || (by_address && holds(sign.addresses, address))) {
          features.emplace(sign.feature);
        }
      }
    }
    const bool in_space = letters.contains("X") && letters.contains("Y") && letters.contains("Z");
    if (is_arc && in_space && (dialect == "rs274" || dialect.starts_with("sinumerik"))) {
      features.emplace("helix");
    }
  }
  return features;
}

}  // namespace gonogo::fuzz
