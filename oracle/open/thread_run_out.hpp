// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the tool leaves a thread at the bottom of a pass: by one of the run-outs that readings name,
// each held to its shape and its end (J-THR-05, GSK-G114-11).
#pragma once

#include <array>
#include <optional>
#include <string>

#include "oracle/motion/curve_follower.hpp"
#include "oracle/motion/swept_turns.hpp"
#include "oracle/open/open_helix.hpp"
#include "oracle/open/thread_geometry.hpp"

namespace gonogo::oracle {

using reference::ThreadRunOut;
inline constexpr std::array<ThreadRunOut, 3> kRunOuts = {ThreadRunOut::polar, ThreadRunOut::radial,
                                                         ThreadRunOut::tangent};

constexpr std::size_t place_of(ThreadRunOut run_out) {
  return static_cast<std::size_t>(run_out) - static_cast<std::size_t>(ThreadRunOut::polar);
}

// Which of the named run-outs explain all passes so far: a whole program has one.
class RunOutSet {
 public:
  bool has(ThreadRunOut run_out) const { return left_[place_of(run_out)]; }
  void remove(ThreadRunOut run_out) { left_[place_of(run_out)] = false; }
  void add(ThreadRunOut run_out) { left_[place_of(run_out)] = true; }
  bool empty() const { return !left_[0] && !left_[1] && !left_[2]; }
  static RunOutSet none() {
    RunOutSet set;
    set.left_ = {};
    return set;
  }

 private:
  std::array<bool, 3> left_ = {true, true, true};
};

// The run-out of one pass.
class ThreadRunOutJudge {
 public:
  // `helix` has been followed to `from`, `to_end` leads from its start to its end; these and
  // `geometry` outlive the judge. `allowed`: what earlier passes have left of `named`, those that
  // the reading names.
  ThreadRunOutJudge(const ThreadGeometry& geometry, const Number& pass, const OpenHelix& helix,
                    const Similarity& to_end, const Position& from, const RunOutSet& allowed,
                    const RunOutSet& named);
  ThreadRunOutJudge(const ThreadRunOutJudge&) = delete;

  // On the named path in a bore: an arc that leaves the helix tangentially turns as the helix does.
  void turn_with_helix() { turns_with_helix_ = true; }

  // A cut in the plane, without its height. False: it belongs to none of the run-outs.
  bool take(const Motion& flat);
  // A straight cut that is admissible as a chord of the polar arc alone (J-THR-01).
  bool take_chord(const Motion& flat);
  // The run-outs that end here. Throws exact::Undecided where that is not known of the only ones.
  RunOutSet ending_at(const Position& here) const;
  // For the evidence: whether one of them ends here, on any way to it; whether one does that the
  // passes before rule out.
  bool is_end(const Position& here) const;
  bool is_end_of_another(const Position& here) const;
  bool has_begun() const { return begun_; }
  // How far arcs have turned, in turns; an estimate.
  double swept() const { return swept_.estimate(); }
  // How far along an axis a point is from the nearest of their ends.
  Number distance_from_end(const Position& here) const;
  // J-THR-05: whether the run-out of the reading leads into the material by itself. Where the
  // reading is open the polar one decides: where that does, the straight ones do.
  bool is_unfit() const;

 private:
  bool take_polar(const Motion& flat);
  bool take_arc(const Motion& arc);
  bool take_line(ThreadRunOut run_out, const Motion& flat);
  bool leaves_region(const Motion& flat) const;
  bool ends_at(ThreadRunOut run_out, const Position& here) const;
  bool surely_ends_at(ThreadRunOut run_out, const Position& here) const;
  Similarity map_of(ThreadRunOut run_out) const;  // from the start of the helix to the end
  Position end_of(ThreadRunOut run_out) const;

  const ThreadGeometry& geometry_;
  const OpenHelix& helix_;
  const Similarity& to_end_;
  Number radius_;  // of the pass
  Position from_;
  RunOutSet allowed_;
  RunOutSet named_;
  RunOutSet left_;
  bool begun_ = false;

  struct Line {
    Line(Motion motion, const Tolerances& tolerances)
        : want(std::move(motion)), match(want, tolerances) {}
    Line(const Line&) = delete;
    Motion want;
    CurveFollower match;
  };
  std::array<std::optional<Line>, 3> lines_;
  std::array<bool, 3> off_line_ = {};
  // For the polar run-out as an arc.
  std::optional<Record> arc_;  // its first piece
  SweptTurns swept_;           // by all of them
  bool arc_departed_ = false;
  std::vector<PlaneVector> chords_;
  bool turns_with_helix_ = false;
};

}  // namespace gonogo::oracle
