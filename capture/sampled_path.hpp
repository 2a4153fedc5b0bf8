// SPDX-License-Identifier: GPL-3.0-or-later
//
// The reference's path piece by piece, computed as far as the samples need it. All coordinates are
// those in force at the start of the program: a machine's own do not follow a renaming (G50).
#pragma once

#include <deque>
#include <memory>

#include "capture/joined_reference.hpp"
#include "capture/path_piece.hpp"
#include "oracle/judge/program_judge.hpp"

namespace gonogo::oracle {

class SampledPath {
 public:
  // `profile`, `program` and `terms` must outlive the path. `seen`: the axes that samples have.
  SampledPath(const reference::Profile& profile, const ProgramText& program,
              const Tolerances& tolerances, reference::AxisSet seen, double fastest);

  // Piece `i`; null after the last one, a `stand` or an `open`. It must not have been dropped.
  const PathPiece* piece(std::size_t i);
  // Keeps a few before piece `i`, for the report.
  void drop_before(std::size_t i);
  std::size_t first_kept() const { return first_; }
  const PathPiece& kept(std::size_t i) const { return *pieces_[i - first_]; }

  // The reference's own records up to, not including, piece `i`, to a judge of records.
  static void replay(const reference::Profile& profile, const ProgramText& program,
                     const Tolerances& tolerances, std::size_t pieces, ProgramJudge& judge);

 private:
  bool pull();
  std::unique_ptr<PathPiece> make(const Motion& motion) const;

  ProgramInput input_;
  JoinedReference stream_;
  reference::AxisSet seen_;
  double fastest_;
  Number tolerance_;
  Position shift_;  // by which the reference's coordinates are new ones
  Position at_;     // where the pieces so far end
  std::deque<std::unique_ptr<PathPiece>> pieces_;
  std::size_t first_ = 0;  // number of the first piece that is kept
  bool complete_ = false;
};

}  // namespace gonogo::oracle
