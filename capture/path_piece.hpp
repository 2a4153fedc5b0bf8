// SPDX-License-Identifier: GPL-3.0-or-later
//
// A motion of the reference as sampled positions see it: where it lies within the tube of a sample,
// how long it is and how fast the machine may pass it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "capture/round_tube.hpp"
#include "oracle/motion/motion.hpp"
#include "oracle/records/verdict.hpp"

namespace gonogo::oracle {

inline constexpr double kSecondsAMinute = 60;

enum class PieceKind : std::uint8_t {
  line,      // straight cut, thread
  traverse,  // anywhere in the box of its ends, monotone on each axis
  round,
  dwell,
  stand,  // the end of the path: by the program's end or an alarm
  open,   // what sampled positions do not decide; the text says why
};

// A part of a piece within the tube of a sample. A traverse has a coordinate for each axis, counted
// in its direction; everything else has one, the first.
struct Stretch {
  std::array<Number, reference::kAxes> low;
  std::array<Number, reference::kAxes> high;
  // The same after `reached`; false when all of it lies before.
  bool go_on_from(const std::array<Number, reference::kAxes>& reached);
};

class PathPiece {
 public:
  // `fastest` is the speed of what has none of its own, mm/s.
  PathPiece(Motion motion, std::string text, double fastest);
  static std::unique_ptr<PathPiece> dwelling(const Record& record, const Position& at);
  static std::unique_ptr<PathPiece> at_rest(const Position& at);
  static std::unique_ptr<PathPiece> undecided(GapReason reason, std::string why);

  PieceKind kind() const { return kind_; }
  bool is_motion() const {
    return kind_ == PieceKind::line || kind_ == PieceKind::traverse || kind_ == PieceKind::round;
  }
  const Motion& motion() const { return motion_; }
  const std::string& text() const { return text_; }         // of an open piece: why it is
  Verdict gap() const { return gap_verdict(gap_, text_); }  // of an open piece
  reference::ClauseId clause() const { return motion_.record.clause; }
  std::uint64_t block() const { return motion_.record.block; }

  void stretches(const SamplePoint& sample, const Tube& tube, std::vector<Stretch>& out) const;
  // mm of path (degrees of a rotary axis that moves alone) from the start to a stretch's low end,
  // and from its high end to the end of the piece.
  double before(const Stretch& stretch) const;
  double after(const Stretch& stretch) const;
  // mm of path from the start, of a coordinate of a piece that has one.
  double along(const Number& coordinate) const;
  double length() const { return length_; }
  double speed() const { return speed_; }      // mm/s, the most that it may be run with
  bool has_feed() const { return has_feed_; }  // a path speed is programmed
  double time() const;                         // s, the least that it takes
  // About the same for a sample, for estimates; mm.
  double off(const SamplePoint& sample) const;
  // How far a point lies from the piece, on the axis where it is most.
  Number deviation(const Position& point) const;

 private:
  PathPiece() = default;
  void measure(double fastest);
  bool near(const SamplePoint& sample, double half) const;
  std::optional<Stretch> line_stretch(const SamplePoint& sample, const Tube& tube) const;
  std::optional<Stretch> traverse_stretch(const SamplePoint& sample, const Tube& tube) const;
  Number line_deviation(const Position& point) const;

  PieceKind kind_ = PieceKind::open;
  GapReason gap_ = GapReason::none;
  Motion motion_;
  std::string text_;
  std::array<Number, reference::kAxes> travel_;
  std::array<int, reference::kAxes> direction_{};
  std::array<double, reference::kAxes> low_{};  // of its box
  std::array<double, reference::kAxes> high_{};
  std::size_t longest_ = 0;  // the axis that a line's coordinate counts
  double scale_ = 1;         // mm of path for each of the coordinate
  double length_ = 0;
  double speed_ = 0;
  bool has_feed_ = false;
  std::unique_ptr<RoundTube> round_;
};

}  // namespace gonogo::oracle
