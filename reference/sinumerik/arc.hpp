// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the files of G2 and G3 share: the arc of a block before and after its centre is found.
#pragma once

#include "reference/geometry/arc_centre.hpp"
#include "reference/sinumerik/machine.hpp"

namespace gonogo::reference::sinumerik {

inline const Number kHalf = Number::millionths(500'000);

// The arc of a block. Geometry is seen from the start: enclosures of the position then stay out.
struct ArcCommand {
  Plane plane;
  PlaneAxes axes;
  int sense;  // sign of rot
  EndPoint end;
  // Whether the end point is named in the plane.
  bool names_plane() const { return end.named.has(axes.p) || end.named.has(axes.q); }
  ArcEnds ends() const { return ArcEnds(geometry::vector_in(axes, end.by)); }
  // SIE-ARC-10: whether it ends where it starts, in its plane.
  bool closed() const;
};

// A centre, absolute and from the start; what is known of the radii beside the coordinates, mm^2.
struct ArcCentre {
  Point_2 at;
  Vector_2 offset;
  std::optional<Number> start_2;
  std::optional<Number> end_2;
};

// The centre that an arc really has, and what is known of its end.
struct FoundArc {
  Point_2 centre;
  Vector_2 offset;
  std::optional<PlaceMark> mark;
  bool is_corrected = false;
};

// In arc_correction.cpp. The square of the radius at the start where it is known beside the
// coordinates: the machine was sent there about this very centre.
std::optional<Number> known_start(const Machine& machine, const ArcCommand& arc,
                                  const ArcCentre& centre);
// SIE-ARC-07, SIE-ARC-08: the centre of an arc whose end may miss its
// circle. `word` is the one that alarms name. Nothing after an alarm.
std::optional<FoundArc> centre_in_force(BlockContext& block, const ArcCommand& arc,
                                        const ArcCentre& centre, WordName word);

// In arc_forms.cpp. Nothing after an alarm.
ArcCentre programmed_centre(const BlockContext& block, const ArcCommand& arc);
std::optional<FoundArc> arc_by_radius(BlockContext& block, const ArcCommand& arc);
std::optional<FoundArc> arc_by_angle_and_end(BlockContext& block, const ArcCommand& arc);
// Sets the end point.
std::optional<FoundArc> arc_by_angle_and_centre(BlockContext& block, ArcCommand& arc);

}  // namespace gonogo::reference::sinumerik
