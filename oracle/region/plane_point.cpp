// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/level.hpp"
#include "reference/geometry/kernel.hpp"

namespace gonogo::oracle::region {
namespace {

using geometry::Vector_2;

Vector_2 way(const PlanePoint& v) {
  return {v.p, v.q};
}

PlanePoint coordinates(const Vector_2& v) {
  return {v.x(), v.y()};
}

}  // namespace

PlanePoint operator+(const PlanePoint& a, const PlanePoint& b) {
  return coordinates(way(a) + way(b));
}

PlanePoint operator-(const PlanePoint& a, const PlanePoint& b) {
  return coordinates(way(a) - way(b));
}

bool operator==(const PlanePoint& a, const PlanePoint& b) {
  return way(a) == way(b);
}

Number dot(const PlanePoint& a, const PlanePoint& b) {
  return CGAL::scalar_product(way(a), way(b));
}

Number cross(const PlanePoint& a, const PlanePoint& b) {
  return CGAL::determinant(way(a), way(b));
}

Number norm_squared(const PlanePoint& a) {
  return way(a).squared_length();
}

}  // namespace gonogo::oracle::region
