// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/generate/cover/arcs.hpp"

namespace gonogo::cover {

ArcWays arc_ways(std::string_view centre, std::string_view end) {
  ArcWays ways;
  ways.radius = mm(10);
  ways.centre = {mm(10), mm(0)};
  if (centre == "along-q") ways.centre = {mm(0), mm(-10)};
  if (centre == "both") ways.centre = {mm(6), mm(8)};
  const auto [a, b] = ways.centre;
  // From the centre the start lies at (-a, -b); a quarter on at (b, -a) or (-b, a).
  if (end == "left") ways.end = {a + b, b - a};
  if (end == "right") ways.end = {a - b, b + a};
  if (end == "opposite") ways.end = {2 * a, 2 * b};
  return ways;
}

std::vector<std::string> arc_words(const Pick& pick, const Drawing& drawing, const ArcWays& ways) {
  std::vector<std::string> words = {pick["code"]};
  const bool named = !pick.is("end", "full") || pick.is("full", "written");
  if (named) words.push_back(drawing.travel(Role::p, ways.end[0]));
  if (named) words.push_back(drawing.travel(Role::q, ways.end[1]));
  if (pick.has("helix") && !pick.is("helix", "none"))
    words.push_back(drawing.travel(Role::d, pick.length("helix")));
  return words;
}

void add_arc_form(const Pick& pick, const Drawing& drawing, const ArcWays& ways,
                  std::vector<std::string>& words) {
  if (pick.is("form", "centre")) {
    for (const Role role : {Role::p, Role::q}) {
      const Length way = ways.centre[static_cast<std::size_t>(role)];
      if (way.sign() != 0 || pick.is("zeros", "written"))
        words.push_back(drawing.offset(role, way));
    }
  } else if (!pick.is("form", "none")) {
    words.push_back(drawing.word("R", "form"));
  }
}

}  // namespace gonogo::cover
