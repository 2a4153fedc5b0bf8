// SPDX-License-Identifier: GPL-3.0-or-later
//
// A drawing sheet as SVG: front, top, right side and isometric view in third-angle projection, one
// or two paths, the departure, scale bar and title block. Points and planes have the names of their
// clauses; a pocket shows what is cut, left and gouged at the level of the departure. Below stand,
// where they help, pecks or passes motion beside motion and a departure below a pixel drawn large.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "publish/report/figure.hpp"
#include "publish/report/path.hpp"

namespace gonogo::oracle::report {

struct Sheet {
  std::string title;  // program or case
  std::string dialect;
  std::string verdict;                          // empty: one path without a verdict
  std::string subject;                          // empty: none
  bool lathe = false;                           // Z to the right, X up
  const Path* reference = nullptr;              // drawn first; required
  const Path* departing = nullptr;              // the subject's; null: one path
  std::optional<Point3> witness;                // where the subject departs
  std::optional<Point3> expected;               // where the motion had to end
  std::optional<std::size_t> expected_motion;   // of the reference, which was due
  std::optional<std::size_t> departing_motion;  // of the subject
  std::uint64_t block = 0;                      // of the departure; 0: none
  std::vector<Limit> limits;                    // walls of pockets, and how far the tool may go

  // Whether nothing of the subject is recorded behind its departure. REQUIRES: there are two paths.
  bool ends_at_departure() const {
    return departing_motion && *departing_motion + 1 >= departing->motions.size();
  }
};

// A well-formed SVG document without external parts. Colours can be changed from outside by the
// CSS variables --gs-*. Each drawn <path> of a motion has data-p ("r" or "s": whose), data-m (the
// records, "0-3 7": the k-th subpath is the k-th of them); each view is a <g data-view>.
std::string svg_sheet(const Sheet& sheet);

// Whether a dialect belongs to lathes.
bool is_lathe(std::string_view dialect);

}  // namespace gonogo::oracle::report
