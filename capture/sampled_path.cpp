// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/sampled_path.hpp"

#include <fmt/format.h>

#include "oracle/judge/mismatch.hpp"
#include "oracle/steps/step_text.hpp"

namespace gonogo::oracle {
namespace {

using reference::Axis;
using reference::kAllAxes;

constexpr std::size_t kKept = 64;

constexpr const char* kOpenPath =
    "The manual leaves the path of this cycle open: sampled positions are judged up to it. Say "
    "which path the machine follows (--reading), or bring its records as JSON lines.";

Motion back_to_start(Motion motion, const Position& shift) {
  Position back;
  for (Axis axis : kAllAxes) back[axis] = -shift[axis];
  oracle::shift(motion.from, back);
  oracle::shift(motion.record.to, back);
  oracle::shift(motion.record.via, back);
  if (motion.record.kind == RecordKind::arc) {
    const reference::PlaneAxes axes = reference::axes_of(motion.record.plane);
    motion.record.centre[0] -= shift[axes.p];
    motion.record.centre[1] -= shift[axes.q];
  }
  return motion;
}

}  // namespace

SampledPath::SampledPath(const reference::Profile& profile, const ProgramText& program,
                         const Tolerances& tolerances, reference::AxisSet seen, double fastest)
    : input_(program),
      stream_(profile, input_.lines, tolerances),
      seen_(seen),
      fastest_(fastest),
      tolerance_(tolerances.tolerance),
      at_(profile.initial.at) {}

std::unique_ptr<PathPiece> SampledPath::make(const Motion& motion) const {
  AxisSet moved = moved_axes(motion, tolerance_);
  if (motion.record.kind == RecordKind::arc) {
    const reference::PlaneAxes axes = reference::axes_of(motion.record.plane);
    moved = moved | AxisSet{axes.p, axes.q};
  }
  for (Axis axis : kAllAxes) {
    if (!moved.has(axis) || seen_.has(axis)) continue;
    return PathPiece::undecided(
        GapReason::samples_open,
        fmt::format("The program moves the axis {}, of which the samples have no column.",
                    letter(axis)));
  }
  return std::make_unique<PathPiece>(back_to_start(motion, shift_), record_text(motion.record),
                                     fastest_);
}

bool SampledPath::pull() {
  if (complete_) return false;
  while (true) {
    const ReferenceStep& step = stream_.current();
    const auto* record = std::get_if<Record>(&step);
    if (const auto* motion = std::get_if<Motion>(&step)) {
      pieces_.push_back(make(*motion));
      complete_ = pieces_.back()->kind() == PieceKind::open;
      if (!complete_) at_ = pieces_.back()->motion().to();
    } else if (const auto* renaming = std::get_if<reference::Renaming>(&step)) {
      shift(shift_, renaming->shift);
      stream_.advance();
      continue;
    } else if (record != nullptr && record->kind == RecordKind::dwell) {
      pieces_.push_back(PathPiece::dwelling(*record, at_));
    } else {
      complete_ = true;
      const auto* outside = std::get_if<reference::NotCovered>(&step);
      if (outside != nullptr) {
        pieces_.push_back(PathPiece::undecided(reason_of(*outside), outside->message));
      } else {
        pieces_.push_back(stream_.at_end()
                              ? PathPiece::at_rest(at_)
                              : PathPiece::undecided(GapReason::samples_open, kOpenPath));
      }
    }
    if (!complete_) stream_.advance();
    return true;
  }
}

const PathPiece* SampledPath::piece(std::size_t i) {
  while (i >= first_ + pieces_.size()) {
    if (!pull()) return nullptr;
  }
  return pieces_[i - first_].get();
}

void SampledPath::drop_before(std::size_t i) {
  while (first_ + kKept < i && !pieces_.empty()) {
    pieces_.pop_front();
    ++first_;
  }
}

void SampledPath::replay(const reference::Profile& profile, const ProgramText& program,
                         const Tolerances& tolerances, std::size_t pieces, ProgramJudge& judge) {
  ProgramInput input(program);
  JoinedReference stream(profile, input.lines, tolerances);
  for (std::size_t i = 0; i < pieces && !stream.at_end();) {
    const ReferenceStep& step = stream.current();
    if (const auto* motion = std::get_if<Motion>(&step)) {
      Record record = motion->record;
      record.axes = reference::kEveryAxis;
      judge.record(record);
      ++i;
    } else if (const auto* record = std::get_if<Record>(&step)) {
      if (record->kind == RecordKind::dwell) {
        judge.record(*record);
        ++i;
      }
    }
    stream.advance();
  }
}

}  // namespace gonogo::oracle
