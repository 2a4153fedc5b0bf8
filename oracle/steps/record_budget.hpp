// SPDX-License-Identifier: GPL-3.0-or-later
//
// How many records a subject may send before it counts as endless.
#pragma once

#include <cstddef>
#include <optional>

#include "oracle/region/constants.hpp"
#include "oracle/steps/program_input.hpp"
#include "reference/expander.hpp"

namespace gonogo::oracle {

// J-CYC-02: records that make no progress may be 10 times those of the reference, and 1,000. The
// reference's are counted only as far as needed.
class RecordBudget {
 public:
  // `profile` must outlive the budget.
  RecordBudget(const reference::Profile& profile, const ProgramText& program)
      : profile_(profile), program_(program) {}
  // `live` counts what the judge's own reference has put out. It counts too, because a subject's
  // own path may end elsewhere than the one that is shown, and other blocks follow from that.
  bool allows(std::size_t records, std::size_t live);
  // Whether so few are left that it is worth looking for progress.
  bool runs_low(std::size_t records, std::size_t live) const;
  // Records that led to progress (J-CYC-02), or do not count because something else limits how
  // many of their kind there are: a chord that goes on along an arc of the reference, a cut of a
  // level of a pocket.
  void forgive(std::size_t records = 1) { forgiven_ += records; }
  // A cut of a level whose rings the reference counts. Where the path that is shown ends in an
  // alarm that the subject's own path does not lead to, nothing counts them, and it is forgiven.
  void count_level_cuts(std::size_t cuts) { level_cuts_ += cuts; }

 private:
  // Those that count. One may have been forgiven twice.
  std::size_t counting(std::size_t records) const {
    return records > forgiven() ? records - forgiven() : 0;
  }

  // The path that is shown, which most programs are too short to need.
  struct ShownPath {
    ShownPath(const reference::Profile& profile, const ProgramText& program)
        : input(program), expander(profile, input.lines, reference::OpenPaths::shown) {}
    ProgramInput input;
    reference::Expander expander;
  };

  std::size_t forgiven() const {
    const bool is_cut_short = complete_ && !has_end_;
    return forgiven_ + (is_cut_short ? level_cuts_ : 0);
  }

  const reference::Profile& profile_;
  ProgramText program_;
  std::optional<ShownPath> shown_;
  std::size_t counted_ = 0;
  std::size_t forgiven_ = 0;
  std::size_t level_cuts_ = 0;
  bool complete_ = false;
  bool has_end_ = false;  // the last one counted is that of the program's end
};

}  // namespace gonogo::oracle
