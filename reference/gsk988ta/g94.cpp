// SPDX-License-Identifier: GPL-3.0-or-later
//
// G94, the radial cutting cycle: face and taper. From A, where the tool stands, to B, C, D and
// back.
#include "reference/clause_literal.hpp"
#include "reference/gsk988ta/cutting_cycle.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::reference::gsk988ta {

void run_g94(BlockContext& block) {
  const PlaneAxes plane = axes_of(block.machine.plane);
  const CuttingAxes axes{plane.p, plane.q};  // GSK-G94-01
  // GSK-G94-08: neither the third axis of the plane nor any other may be commanded.
  refuse_other_axes(block, axes, "GSK-G94-08"_clause);
  retain_cut_words(block, axes);       // GSK-G94-06
  if (!runs_cut(block, axes)) return;  // GSK-G94-12

  const Position a = block.machine.position;
  const Number c_p = cut_end_point(block, plane.p);  // GSK-G94-12: no travel without a word
  const Number c_q = cut_end_point(block, plane.q);
  // GSK-G94-09: the limit stands below figures alone.
  check_taper(block, c_p - a[plane.p], "GSK-G94-09"_clause, "gsk.g94.taper-limit=alarm"_reading);
  block.need_feed();
  const Number& taper = block.machine.cut.taper;  // GSK-G94-11: a true length, like the travel

  name_corners(block, axes, {c_p, c_q});
  // GSK-G94-10: all motions are those of this block.
  block.rapid("GSK-G94-02"_clause, {{plane.p, c_p + taper}});
  block.feed("GSK-G94-03"_clause, {{plane.p, c_p}, {plane.q, c_q}});
  block.feed("GSK-G94-04"_clause, {{plane.p, a[plane.p]}});
  block.rapid("GSK-G94-05"_clause, {{plane.q, a[plane.q]}});
}

}  // namespace gonogo::reference::gsk988ta
