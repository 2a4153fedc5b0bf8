// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/sinumerik/circles.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "expanders/common/product.hpp"

namespace gonogo::expanders::sinumerik {
namespace {

// The sign of |sqrt(a) - sqrt(b)| - t: with a the larger, that of a - b - t^2 - 2 t sqrt(b).
int compare_difference(Wide a, Wide b, Fixed limit) {
  if (a < b) std::swap(a, b);
  const Wide square = squared(limit);
  const Wide rest = a - b - square;
  if (rest < 0) return -1;
  const auto order = multiply(rest, rest) <=> multiply(4 * square, b);
  return order < 0 ? -1 : order > 0 ? 1 : 0;
}

// The sign of |sqrt(a) - sqrt(b)| - factor sqrt(reference), where one of a and b is the reference.
int compare_relative(Wide reference, Wide other, Fixed factor) {
  const Product scaled_other = multiply(squared(kOne), other);
  const auto above = scaled_other <=> multiply(squared(kOne + factor), reference);
  if (above >= 0) return above > 0 ? 1 : 0;
  if (factor > kOne) return -1;
  const auto below = multiply(squared(kOne - factor), reference) <=> scaled_other;
  return below > 0 ? 1 : below < 0 ? -1 : 0;
}

}  // namespace

Vector on_bisector(const Vector& chord, Real side) {
  return {(chord.p - side * chord.q) / 2, (chord.q + side * chord.p) / 2};
}

Real side_of_radius(const Chord& chord, Wide radius_square) {
  const Wide rest = 4 * radius_square - chord.square();
  if (rest <= 0) return 0;
  return std::sqrt(static_cast<Real>(rest) / static_cast<Real>(chord.square()));
}

Real side_of_radius(const Vector& chord, Real radius_square) {
  const Real rest = 4 * radius_square - chord.square();
  return rest <= 0 ? 0 : std::sqrt(rest / chord.square());
}

Real side_of_angle(Fixed angle) {
  constexpr Fixed kHalfTurn = 180 * kOne;
  // Both parts of the cotangent from the nearest of 0, 180 and 360 degrees: no digits are lost.
  auto tangent = [](Fixed part) {
    return std::tan(static_cast<Real>(part) * (std::numbers::pi_v<Real> / kFullTurn));
  };
  if (angle > kHalfTurn / 2 && angle < kFullTurn - kHalfTurn / 2) return tangent(kHalfTurn - angle);
  return angle < kHalfTurn ? 1 / tangent(angle) : -1 / tangent(kFullTurn - angle);
}

Real side_of_projection(const Vector& chord, const Vector& centre) {
  return 2 * cross(chord, centre) / chord.square();
}

bool too_far_turned(const Vector& programmed, const Vector& corrected) {
  const Real turn = std::atan2(std::fabs(cross(programmed, corrected)), dot(programmed, corrected));
  return turn > std::sqrt(Real{1} / 1000);
}

Agreement compare_radii(Wide start_square, Wide end_square, Wide reference_square,
                        const RadiusTolerance& tolerance) {
  if (start_square == end_square) return Agreement::kEqual;
  const Wide other = reference_square == start_square ? end_square : start_square;
  const int constant = compare_difference(start_square, end_square, tolerance.constant);
  const int relative = compare_relative(reference_square, other, tolerance.factor);
  const int most = tolerance.strict ? -1 : 0;
  return constant <= most || relative <= most ? Agreement::kWithin : Agreement::kApart;
}

Real coarse_rounding(Real farthest) {
  constexpr Real kCountOfInch = 25.4L;  // in counts of a millimetre
  return std::fmax(kCountOfInch, farthest * 1e-13L);
}

Real fine_rounding(Real length) {
  return std::fmax(Real{1e-6L}, length * 1e-15L);
}

Agreement compare_radii(Real start, Real end, Real reference, const RadiusTolerance& tolerance,
                        Real rounding) {
  const Real difference = std::fabs(start - end);
  const Real relative = static_cast<Real>(tolerance.factor) / kOne * reference;
  const Real limit = std::fmax(static_cast<Real>(tolerance.constant), relative);
  if (difference == 0) return Agreement::kEqual;
  if (std::fabs(difference - limit) <= rounding) return Agreement::kUnclear;
  if (difference <= rounding) return Agreement::kEqual;
  return difference <= limit ? Agreement::kWithin : Agreement::kApart;
}

ChordFit fit_chord(const Chord& chord, Fixed radius, Fixed tolerance, bool rounded) {
  const Wide square = chord.square();
  const Fixed slack = rounded ? kRounding : 0;
  const Fixed diameter = 2 * radius;
  if (square < squared(diameter > slack ? diameter - slack : 0)) return ChordFit::kShorter;
  const Fixed most = diameter + tolerance;
  if (square > squared(most + slack)) return ChordFit::kLonger;
  const bool unclear = rounded && square >= squared(most > slack ? most - slack : 0);
  return unclear ? ChordFit::kUnclear : ChordFit::kDiameter;
}

ChordFit fit_chord(const Vector& chord, Fixed radius, Fixed tolerance) {
  const Real length = std::sqrt(chord.square());
  const Real slack = fine_rounding(length);
  const Real diameter = 2 * static_cast<Real>(radius);
  // Along an axis nothing cancels out.
  const Real longer = std::fmax(std::fabs(chord.p), std::fabs(chord.q));
  const Real shorter = std::fmin(std::fabs(chord.p), std::fabs(chord.q));
  const Real above =
      ((longer - diameter) * (longer + diameter) + shorter * shorter) / (length + diameter);
  if (above < -slack) return ChordFit::kShorter;
  const Real beyond = above - static_cast<Real>(tolerance);
  if (beyond == 0) return ChordFit::kDiameter;
  if (std::fabs(beyond) <= slack) return ChordFit::kUnclear;
  return beyond < 0 ? ChordFit::kDiameter : ChordFit::kLonger;
}

}  // namespace gonogo::expanders::sinumerik
