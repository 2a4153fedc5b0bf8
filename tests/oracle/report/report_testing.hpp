// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tests of the report share.
#pragma once

#include <cstddef>
#include <string>

#include "oracle/report/path.hpp"

namespace gonogo::oracle::report {

inline Motion line(Point3 from, Point3 to, bool rapid = false) {
  Motion motion;
  motion.rapid = rapid;
  motion.points = {from, to};
  return motion;
}

inline std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

}  // namespace gonogo::oracle::report
