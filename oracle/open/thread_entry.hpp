// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a pass of a thread does at the R plane before its helix: an arc to the start of the thread
// and the straight infeed to the radius of the pass (J-THR-02; GSK-G114-10).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oracle/motion/swept_turns.hpp"
#include "oracle/open/thread_geometry.hpp"

namespace gonogo::oracle {

class ThreadEntry {
 public:
  // `geometry` must outlive it.
  explicit ThreadEntry(const ThreadGeometry& geometry) : geometry_(geometry) {}

  // A pass begins where the tool stands.
  void begin(const Position& from, const Number& pass);
  enum class Taken { progress, nothing, departs };
  // A motion at the R plane. `departs`: neither it nor what follows is part of entry and infeed.
  Taken add(const Motion& motion);
  // Why the helix of the pass may not begin here: a sentence; none: it may.
  std::optional<std::string> fault_before_helix(const Position& here) const;
  bool has_begun() const { return sense_ != 0 || points_.size() > 1 || !departure_.empty(); }
  // The sentence, where `add` said `departs`.
  const std::string& departure() const { return departure_; }

 private:
  std::optional<std::string> add_arc(const Motion& motion);
  std::optional<std::string> add_line(const Motion& motion);
  bool is_seen(const PlaneVector& arm) const;
  bool is_inside(const Motion& motion) const;
  bool leaves_region(const PlaneVector& start, std::span<const PlaneVector> chords) const;
  std::optional<std::string> wrong_traverse() const;
  std::optional<std::string> fault_of(std::size_t infeed, const PlaneVector& here) const;
  std::string bent_infeed(const PlaneVector& here) const;
  bool is_deep(const PlaneVector& from, const PlaneVector& to) const;  // a straight cut
  bool on_start_circle(const PlaneVector& at) const;
  Position at(const PlaneVector& v) const { return geometry_.place(v, stands_); }
  Motion line(const PlaneVector& from, const PlaneVector& to) const;
  bool chords_granted() const { return geometry_.tolerances().chord.sign() > 0; }

  const ThreadGeometry& geometry_;
  Number radius_;                    // of the pass
  Number reached_;                   // radius to which the passes before have cut
  Number reach_;                     // how far from the axis the entry may lead
  PlaneVector from_;                 // where it begins, from the axis
  Position stands_;                  // after the last motion that counts
  int sense_ = 0;                    // of the arcs; 0: none yet
  SweptTurns swept_;                 // by them
  PlaneVector end_arm_;              // of the last, from its centre to its end
  std::vector<Motion> far_;          // those of them that lead farther
  std::vector<PlaneVector> points_;  // from the axis: the ends of the straight cuts behind them
  std::string departure_;
};

}  // namespace gonogo::oracle
