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

Agreement compare_rounded(Wide start_square, Wide end_square, Wide reference_square,
                          const RadiusTolerance& tolerance) {
  const double difference = std::fabs(std::sqrt(static_cast<double>(start_square)) -
                                      std::sqrt(static_cast<double>(end_square)));
  if (difference <= kRounding) return Agreement::kEqual;
  const double relative = static_cast<double>(tolerance.factor) / kOne *
                          std::sqrt(static_cast<double>(reference_square));
  const double limit = std::fmax(static_cast<double>(tolerance.constant), relative);
  const double slack = tolerance.strict ? -kRounding : kRounding;
  return difference <= limit + slack ? Agreement::kWithin : Agreement::kApart;
}

}  // namespace

Vector on_bisector(const Chord& chord, double side) {
  const Vector d = vector_of(chord);
  return {(d.p - side * d.q) / 2, (d.q + side * d.p) / 2};
}

double side_of_radius(const Chord& chord, Wide radius_square) {
  const Wide rest = 4 * radius_square - chord.square();
  if (rest <= 0) return 0;
  return std::sqrt(static_cast<double>(rest) / static_cast<double>(chord.square()));
}

double side_of_angle(double degrees) {
  if (degrees == 180) return 0;
  // Both parts of the cotangent from the nearer of 0, 180 and 360 degrees: no digits are lost.
  constexpr double kHalf = std::numbers::pi / 360;
  if (degrees > 90 && degrees < 270) return std::tan((180 - degrees) * kHalf);
  return degrees <= 90 ? 1 / std::tan(degrees * kHalf) : -1 / std::tan((360 - degrees) * kHalf);
}

double side_of_projection(const Chord& chord, const Chord& centre) {
  return 2 * static_cast<double>(cross(chord, centre)) / static_cast<double>(chord.square());
}

bool too_far_turned(const Vector& programmed, const Vector& corrected) {
  const double across = programmed.p * corrected.q - programmed.q * corrected.p;
  const double along = programmed.p * corrected.p + programmed.q * corrected.q;
  return std::atan2(std::fabs(across), along) > std::sqrt(0.001);
}

Agreement compare_radii(Wide start_square, Wide end_square, Wide reference_square,
                        const RadiusTolerance& tolerance, bool rounded) {
  if (start_square == end_square) return Agreement::kEqual;
  if (rounded) return compare_rounded(start_square, end_square, reference_square, tolerance);
  const Wide other = reference_square == start_square ? end_square : start_square;
  const int constant = compare_difference(start_square, end_square, tolerance.constant);
  const int relative = compare_relative(reference_square, other, tolerance.factor);
  const int most = tolerance.strict ? -1 : 0;
  return constant <= most || relative <= most ? Agreement::kWithin : Agreement::kApart;
}

ChordFit fit_chord(const Chord& chord, Fixed radius, Fixed tolerance, bool rounded) {
  const Wide square = chord.square();
  const Fixed slack = rounded ? kRounding : 0;
  const Fixed diameter = 2 * radius;
  const Fixed least = diameter > slack ? diameter - slack : 0;
  if (square < squared(least)) return ChordFit::kShorter;
  return square <= squared(diameter + tolerance + slack) ? ChordFit::kDiameter : ChordFit::kLonger;
}

}  // namespace gonogo::expanders::sinumerik
