// SPDX-License-Identifier: GPL-3.0-or-later
//
// The 802S for the tests that share sie_expanding.hpp.
#pragma once

#include <fmt/format.h>

#include "sie_expanding.hpp"

namespace gonogo::reference::testing::sie {

// The default profile of the 802S with these readings and the tools 1 (radius 10), 4 and 10 (5).
inline Profile s802(
    std::initializer_list<std::pair<std::string_view, std::string_view>> readings = {}) {
  Profile profile = std::get<Profile>(default_profile("sinumerik802s"));
  profile.tools = {{"1", {10, 0}}, {"4", {5, 0}}, {"10", {5, 0}}};
  for (const auto& [name, value] : readings) {
    if (auto error = set_reading(profile, name, value)) throw std::invalid_argument(error->message);
  }
  return profile;
}

// The programs of the manual: the rectangle, the circle and the four slots, where `plane` stands
// for R103, `sense` for R126, and what the seed's misprints make of them is the caller's choice.
inline std::string rectangle_program(std::string_view reference_plane = "0",
                                     std::string_view clearance = "2") {
  return fmt::format(
      "N10 G0 G17 G90 F200 S300 M3 T4 D1\nN20 X60 Y40 Z5\n"
      "N30 R101=5 R102={} R103={} R104=-17.5 R105=2\nN40 LCYC82\nN50\n"
      "N60 R116=60 R117=40 R118=60 R119=40 R120=8\n"
      "N70 R121=4 R122=120 R123=300 R124=0.75 R125=0.5\nN80 R126=2 R127=1\nN90 LCYC75\nN100\n"
      "N110 R127=2\nN120 LCYC75\nN130 M2\n",
      clearance, reference_plane);
}
inline std::string circle_program(std::string_view sense = "2") {
  return fmt::format(
      "N10 G0 G19 G90 S200 M3 T1 D1\nN20 Z60 X40 Y5\n"
      "N30 R101=4 R102=2 R103=0 R104=-20 R116=50 R117=50\n"
      "N40 R118=50 R119=50 R120=50 R121=4 R122=100\n"
      "N50 R123=200 R124=0 R125=0R126={} R127=1\nN60 LCYC75\nN70 M2\n",
      sense);
}
inline std::string slots_program() {
  return "N10 G0 G19 G90 T10 D1 S400 M3\nN20 Y20 Z50 X5\n"
         "N30 R101=5 R102=1 R103=0 R104=-23 R116=35 R117=0\n"
         "N40 R118=30 R119=15 R120=15 R121=6 R122=200\n"
         "N50 R123=300 R124=0 R125=0 R126=2 R127=1\n"
         "N60 G158 Y40 Z45\nN70 G259 RPL45\nN80 LCYC75\nN90 G259 RPL90\nN100 LCYC75\n"
         "N110 G259 RPL90\nN120 LCYC75\nN130 G259 RPL90\nN140 LCYC75\nN150 G259 RPL45\n"
         "N160 G158 Y-40 Z-45\nN170 Y20 Z50 X5\nM2\n";
}

// LCYC75 as an item of the judge, all of a program in order.
inline std::vector<PocketMilling> pockets(std::string_view program, const Profile& profile) {
  std::vector<PocketMilling> found;
  for (const Item& item : expand(program, profile, OpenPaths::judged)) {
    if (const auto* pocket = std::get_if<PocketMilling>(&item)) found.push_back(*pocket);
  }
  return found;
}

// The cycle of LCYC75 that the tests vary, after what is set before it.
inline std::string pocket_program(std::string_view changes = "", std::string_view before = "") {
  return fmt::format(
      "F200 S300 M3 T4 D1\n{}\n"
      "R101=5 R102=2 R103=0 R104=-8 R116=60 R117=40 R118=60 R119=40 R120=8\n"
      "R121=4 R122=120 R123=300 R124=0.75 R125=0.5 R126=2 R127=1\n{}\nLCYC75\n",
      before, changes);
}

}  // namespace gonogo::reference::testing::sie
