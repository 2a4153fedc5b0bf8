// SPDX-License-Identifier: GPL-3.0-or-later
#include "sinumerik_motions.hpp"

#include <cstdio>
#include <sstream>

namespace gonogo::expanders::testing {
namespace {

constexpr std::string_view kAxes = "xyz";

Motion parse(const std::string& record, const std::array<double, 3>& from) {
  Motion motion;
  motion.from = motion.to = from;
  std::istringstream words(record);
  std::string word;
  words >> word;
  motion.kind = word[0];
  std::string kept = word;
  while (words >> word) {
    const std::size_t axis = word[1] == '=' ? kAxes.find(word[0]) : std::string_view::npos;
    if (axis != std::string_view::npos) {
      motion.to[axis] = std::stod(word.substr(2));
      if (motion.kind != 'a' && motion.to[axis] == from[axis]) continue;
    } else if (word.starts_with("c=")) {
      std::sscanf(word.c_str(), "c=%lf,%lf", &motion.centre[0], &motion.centre[1]);
    } else if (word.starts_with("rot=")) {
      motion.rot = std::stoi(word.substr(4));
    } else if (word.starts_with("f=")) {
      motion.f = std::stod(word.substr(2));
    }
    kept += " " + word;
  }
  motion.text = kept + "\n";
  return motion;
}

}  // namespace

std::vector<Motion> motions_of(const Outcome& outcome) {
  std::vector<Motion> motions;
  std::array<double, 3> place{};
  for (std::size_t i = 0; i < outcome.records.size(); ++i) {
    if (std::string_view("rfad").find(outcome.records[i][0]) == std::string_view::npos) continue;
    motions.push_back(parse(outcome.records[i], place));
    motions.back().block = outcome.blocks[i];
    place = motions.back().to;
  }
  return motions;
}

std::string moving(const Outcome& outcome) {
  std::string text;
  for (const Motion& motion : motions_of(outcome)) text += motion.text;
  return text;
}

std::vector<double> plunges(const Outcome& outcome, std::size_t axis) {
  std::vector<double> depths;
  for (const Motion& motion : motions_of(outcome)) {
    if (motion.kind == 'f' && motion.to[axis] != motion.from[axis]) {
      depths.push_back(motion.to[axis]);
    }
  }
  return depths;
}

}  // namespace gonogo::expanders::testing
