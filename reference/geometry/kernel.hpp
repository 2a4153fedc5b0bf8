// SPDX-License-Identifier: GPL-3.0-or-later
//
// The geometry of the house: CGAL's kernel over the exact number. Constructions and predicates are
// CGAL's functions (circumcenter, midpoint, cross_product, orientation). Only .cpp files include
// this, because it costs seconds; headers keep Position and arrays, and the functions below are the
// way over.
#pragma once

#include "reference/geometry/number_traits.hpp"  // before the kernel, which asks for them

#include <CGAL/Simple_cartesian.h>

#include <array>

#include "reference/axis.hpp"

namespace gonogo::geometry {

using exact::Number;

using Kernel = CGAL::Simple_cartesian<Number>;
using Point_2 = Kernel::Point_2;
using Vector_2 = Kernel::Vector_2;
using Aff_transformation_2 = Kernel::Aff_transformation_2;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using CGAL::ORIGIN;

// The two coordinates of records and descriptors of items, along p and q.
using Pair = std::array<Number, 2>;
inline Point_2 point(const Pair& at) {
  return {at[0], at[1]};
}
inline Pair pair(const Point_2& at) {
  return {at.x(), at.y()};
}

// The projection of a place, and of a way, on the plane; and the way back.
inline Point_2 point_in(const reference::PlaneAxes& axes, const reference::Position& at) {
  return {at[axes.p], at[axes.q]};
}
inline Vector_2 vector_in(const reference::PlaneAxes& axes, const reference::Position& way) {
  return {way[axes.p], way[axes.q]};
}
template <typename T>  // Point_2, Vector_2
void put_in(reference::Position& out, const reference::PlaneAxes& axes, const T& coordinates) {
  out[axes.p] = coordinates.x();
  out[axes.q] = coordinates.y();
}

// X, Y and Z of a way; and the way back.
inline Vector_3 vector_of(const reference::Position& way) {
  using reference::Axis;
  return {way[Axis::x], way[Axis::y], way[Axis::z]};
}
inline reference::Position position_of(const Vector_3& way) {
  return {{way.x(), way.y(), way.z(), 0, 0}};
}

}  // namespace gonogo::geometry
