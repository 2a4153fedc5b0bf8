// SPDX-License-Identifier: GPL-3.0-or-later
//
// G90, the axial cutting cycle: cylinder and taper, the mirror of G94. From A, where the tool
// stands, to B, C, D and back.
#include "reference/clause_literal.hpp"
#include "reference/gsk988ta/cutting_cycle.hpp"

namespace gonogo::reference::gsk988ta {

void run_g90(BlockContext& block) {
  const PlaneAxes plane = axes_of(block.machine.plane);
  const CuttingAxes axes{plane.q, plane.p};  // GSK-G90-01
  refuse_other_axes(block, axes, "GSK-G90-08"_clause);
  retain_cut_words(block, axes);       // GSK-G90-06
  if (!runs_cut(block, axes)) return;  // GSK-G90-12

  const Position a = block.machine.position;
  const Number c_p = cut_end_point(block, plane.p);  // GSK-G90-12: no travel without a word
  const Number c_q = cut_end_point(block, plane.q);
  check_taper(block, c_q - a[plane.q], "GSK-G90-09"_clause);
  block.need_feed();
  const Number& taper = block.machine.cut.taper;  // GSK-G90-11: a true length, like the travel

  name_corners(block, axes, {c_p, c_q});
  // GSK-G90-10: all motions are those of this block.
  block.rapid("GSK-G90-02"_clause, {{plane.q, c_q + taper}});
  block.feed("GSK-G90-03"_clause, {{plane.p, c_p}, {plane.q, c_q}});
  block.feed("GSK-G90-04"_clause, {{plane.q, a[plane.q]}});
  block.rapid("GSK-G90-05"_clause, {{plane.p, a[plane.p]}});
}

}  // namespace gonogo::reference::gsk988ta
