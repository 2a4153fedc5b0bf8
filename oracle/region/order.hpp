// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-PKT-05: the order in which a level is cut (GSK-CYC-02): from the plunge outwards, each place
// within reach of what was cut before it.
//
// The reach is the step and what places may be off. A place of the path is supported when it lies
// within reach of the plunge; on a link, when it lies within reach of an arc made before the link;
// on an arc, when it lies within reach of a place of an arc, and the path has since been farther
// off than that place and than the step: the groove behind the tool supports nothing.
#pragma once

#include <array>
#include <optional>
#include <variant>
#include <vector>

#include "oracle/region/grid.hpp"
#include "oracle/region/piece.hpp"

namespace gonogo::oracle::region {

// At most 90 degrees of an arc, or a line. Enclosures only.
struct CutUnit {
  bool is_line = false;
  bool clears = true;            // an arc, or a chord of one; else a link
  bool counterclockwise = true;  // arcs
  IntervalVector begin;
  IntervalVector end;
  IntervalVector c;  // arcs: the centre
  Stretch stretch;   // arcs: counterclockwise, whichever way the arc goes
  std::size_t record = 0;
  std::size_t bands = 0;  // where its bands begin
};

struct CutOrder {
  enum class Kind { fine, broken, undecided } kind = Kind::fine;
  std::size_t record = 0;  // broken: the motion at fault
  PlanePoint witness;      // within 1e-9 of it
  Number distance;         // from what could support it: at least so far
};

// The path of one level in the order of time, about the middle of the pocket.
class CutSequence {
 public:
  // `width`: how finely the bands of spirals are cut.
  CutSequence(const PlanePoint& plunge, const Number& step, const Number& reach, double width);

  void add(const Arc& arc, bool counterclockwise);
  void add_line(const Line& line, bool clears, std::size_t record);
  // `half_side`: of a square about the middle that holds the path.
  CutOrder check(double half_side) const;

 private:
  friend class OrderCheck;
  void add_part(const Arc& arc, const Stretch& stretch, bool counterclockwise);
  // With its bands, which are the last.
  void add_unit(const CutUnit& unit);

  IntervalVector plunge_;
  Interval step_;
  Interval reach_;
  double width_;
  std::vector<CutUnit> units_;
  std::vector<Band> bands_;  // of what clears; the plunge's is the first
  bool too_long_ = false;
};

}  // namespace gonogo::oracle::region
