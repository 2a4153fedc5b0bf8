// SPDX-License-Identifier: GPL-3.0-or-later
//
// The points, planes and axes of a cycle under the names that its clauses give them, read from the
// texts of the catalog: a motion of "Traverse from A to B along p alone" ends at B and moves p.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "oracle/report/path.hpp"

namespace gonogo::oracle::report {

struct NamedPoint {
  std::string name;  // "A"
  Point3 at;
};
struct NamedPlane {
  std::string name;  // "R plane"
  char axis = 'Z';   // that it stands across
  double at = 0;     // mm
};
struct Names {
  std::vector<NamedPoint> points;
  std::vector<NamedPlane> planes;
  std::map<char, char> axes;  // 'p' -> 'Z'
};

// Of the motions of one block; 0: of the first block that has names.
Names names_in(const Path& path, std::uint64_t block);

}  // namespace gonogo::oracle::report
