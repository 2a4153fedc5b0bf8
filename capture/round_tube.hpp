// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which part of a round motion (arc, helix, circle in space) lies within the tube of a sample: the
// box of the tolerance round it. Whether a flat arc passes the box is decided exactly; where along
// the arc it does, and the height of a helix, to 1e-6 mm: on the safe side that is asked for.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "capture/sample_point.hpp"
#include "oracle/motion/round_curve.hpp"

namespace gonogo::oracle {

class RoundTube {
 public:
  explicit RoundTube(const Motion& motion);
  RoundTube(const RoundTube&) = delete;

  // Part of the sweep, in turns from the start.
  struct Span {
    double low = 0;
    double high = 0;
  };
  // In ascending order, several where the motion makes several turns.
  void spans(const SamplePoint& sample, const Tube& tube, std::vector<Span>& out) const;
  // How far the sample lies from the circle, about; mm. Nothing is known of circles in space: 0.
  double off(const SamplePoint& sample) const;
  double whole() const { return whole_; }    // turns
  double length() const { return length_; }  // mm
  // How far the point lies from the curve: of the radius, or of the nearer end where the sweep does
  // not reach it.
  Number deviation(const Position& point) const;

 private:
  struct Angles {
    double low = 0;  // turns, about the direction of the sample
    double high = 0;
  };
  std::optional<Angles> angles_in_plane(const SamplePoint& sample, double half) const;
  std::optional<Angles> angles(const SamplePoint& sample, const Tube& tube) const;
  std::optional<Angles> angles_in_space(const SamplePoint& sample, const Tube& tube) const;
  // Narrows by the axes that run along with the angle; false when one of them excludes the sample.
  bool heights(const SamplePoint& sample, const Tube& tube, Span& within) const;
  double turns_to(const SamplePoint& sample) const;

  Motion motion_;
  std::optional<OpenArc> none_;
  RoundCurve curve_;
  double whole_ = 0;
  double length_ = 0;
  double radius_ = 0;      // at the start
  double end_radius_ = 0;  // the same except for the tolerance of arcs
  std::array<double, 2> centre_{};
  std::array<double, 2> start_{};  // from the centre
  int sense_ = 1;
};

}  // namespace gonogo::oracle
