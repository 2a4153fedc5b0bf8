// SPDX-License-Identifier: GPL-3.0-or-later
//
// What G90, G92 and G94 have in common: the words that they retain, and from them the corners of
// the path. A is where the tool stands, C the programmed end point.
#pragma once

#include "reference/gsk988ta/machine.hpp"

namespace gonogo::reference::gsk988ta {

// The axes of a cutting cycle in the plane: the tool is positioned along one and cuts along the
// other. R lies along the positioning axis.
struct CuttingAxes {
  Axis positioning;
  Axis cutting;
};

// GSK-MOD-07: what the cycle retains, where the plane has changed, or the units.
void carry_cut(Machine& machine, const ReadingsInUse& readings, bool units_change);
// An alarm for a word of any other axis.
void refuse_other_axes(BlockContext& block, const CuttingAxes& axes, ClauseId clause);
// Words of this block replace the retained ones.
void retain_cut_words(BlockContext& block, const CuttingAxes& axes);
// Whether the block runs the cycle: it has an axis word or R, or it speaks of the cycle and repeats
// the retained ones.
bool runs_cut(const BlockContext& block, const CuttingAxes& axes);
// C along one axis: absolute, an increment from A (GSK-MOD-07), or no travel.
Number cut_end_point(const BlockContext& block, Axis axis);
// A to D, where the cycle is put out; C lies at these places along p and q.
void name_corners(const BlockContext& block, const CuttingAxes& axes,
                  const std::array<Number, 2>& c);
// An alarm where R and the travel from A to C have opposite signs and R is the larger.
// `refused_by`: the alternative under which it is one, where the text leaves that open.
void check_taper(BlockContext& block, const Number& travel, ClauseId clause,
                 std::optional<ReadingAlternative> refused_by = std::nullopt);

}  // namespace gonogo::reference::gsk988ta
