// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances and intersections of the kernel's objects, which CGAL keeps in headers of their own.
#pragma once

#include "reference/geometry/kernel.hpp"

#include <CGAL/Intersections_3/Iso_cuboid_3_Plane_3.h>
#include <CGAL/squared_distance_2.h>
#include <CGAL/squared_distance_3.h>

namespace gonogo::geometry {

using Segment_2 = Kernel::Segment_2;
using Segment_3 = Kernel::Segment_3;
using Triangle_3 = Kernel::Triangle_3;
using Plane_3 = Kernel::Plane_3;
using Iso_cuboid_3 = Kernel::Iso_cuboid_3;

}  // namespace gonogo::geometry
