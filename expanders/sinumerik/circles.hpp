// SPDX-License-Identifier: GPL-3.0-or-later
// Circles through two points of a plane. Places are counted from the start of the arc. What decides
// is reckoned in whole numbers where places are whole.
#pragma once

#include "expanders/common/circle.hpp"
#include "expanders/sinumerik/real.hpp"

namespace gonogo::expanders::sinumerik {

/// A place or direction in the plane, counts.
struct Vector {
  Real p = 0;
  Real q = 0;
  constexpr Real square() const { return p * p + q * q; }
  friend constexpr Vector operator-(const Vector& a, const Vector& b) {
    return {a.p - b.p, a.q - b.q};
  }
};
inline constexpr Vector vector_of(const Chord& chord) {
  return {static_cast<Real>(chord.p), static_cast<Real>(chord.q)};
}
inline constexpr Real cross(const Vector& a, const Vector& b) {
  return a.p * b.q - a.q * b.p;
}
inline constexpr Real dot(const Vector& a, const Vector& b) {
  return a.p * b.p + a.q * b.q;
}

inline constexpr Wide cross(const Chord& a, const Chord& b) {
  return static_cast<Wide>(a.p) * b.q - static_cast<Wide>(a.q) * b.p;
}
inline constexpr Wide dot(const Chord& a, const Chord& b) {
  return static_cast<Wide>(a.p) * b.p + static_cast<Wide>(a.q) * b.q;
}

/// The centre that lies `side` half chords to the left of the middle of the chord. All circles
/// through start and end are of this form.
Vector on_bisector(const Vector& chord, Real side);

/// The side of the centre for a radius with this square: of the two the one not to the right. A
/// radius below half the chord gives the middle.
Real side_of_radius(const Chord& chord, Wide radius_square);
Real side_of_radius(const Vector& chord, Real radius_square);

/// The side of the centre of a counterclockwise arc over `angle`, above 0 and below 360 degrees.
Real side_of_angle(Fixed angle);

/// The side of `centre` moved square onto the bisector.
Real side_of_projection(const Vector& chord, const Vector& centre);

/// Whether the directions from the start to the two centres are more than sqrt(0.001) rad apart.
bool too_far_turned(const Vector& programmed, const Vector& corrected);

enum class Agreement {
  kEqual,
  kWithin,  ///< the tolerance
  kApart,
  kUnclear  ///< so near the tolerance that rounding decides
};

/// How far the radii at the start and at the end of an arc may be apart.
struct RadiusTolerance {
  Fixed constant = 0;   ///< mm
  Fixed factor = 0;     ///< of `reference_square`'s root
  bool strict = false;  ///< a difference of just the tolerance is too much
};

/// Compares radii by their squares.
Agreement compare_radii(Wide start_square, Wide end_square, Wide reference_square,
                        const RadiusTolerance& tolerance);
/// Compares radii that are known to `rounding` only.
Agreement compare_radii(Real start, Real end, Real reference, const RadiusTolerance& tolerance,
                        Real rounding);

/// What a place that many counts from zero is known to where what rounding took is not known: an
/// expression may have lost more than a count.
Real coarse_rounding(Real farthest);

/// What a length of that many counts is known to where nothing but the processor rounds.
Real fine_rounding(Real length);

enum class ChordFit { kShorter, kDiameter, kLonger, kUnclear };

/// A chord against twice the radius; up to `tolerance` above it counts as equal.
ChordFit fit_chord(const Chord& chord, Fixed radius, Fixed tolerance, bool rounded);
/// The same of a chord that is known to far less than a count.
ChordFit fit_chord(const Vector& chord, Fixed radius, Fixed tolerance);

}  // namespace gonogo::expanders::sinumerik
