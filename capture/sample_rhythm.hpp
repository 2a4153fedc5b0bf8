// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rhythm of samples: the usual time between two of them. A longer time is a
// hole (J-RUN-11), in which the machine may have been anywhere.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "capture/sample_point.hpp"

namespace gonogo::oracle {

class SampleRhythm {
 public:
  // s; the times of all samples, in their order.
  void add(double time);
  // s: a quarter of the intervals is no longer than this. 0: there are none.
  double usual() const { return quantile(4); }
  // s; an interval that is longer is a hole. `clock`: half a unit of the last decimal of the times.
  double limit(double clock) const;

 private:
  // What one in `parts` of the intervals does not exceed.
  double quantile(std::size_t parts) const;
  double last_ = 0;
  bool begun_ = false;
  std::vector<double> intervals_;
};

// The holes of one run, and the longest time that passes between two samples of it.
class HoleWatch {
 public:
  // s, see SampleRhythm.
  HoleWatch(double usual, double limit) : usual_(usual), limit_(limit) {}
  // The next sample. `counts`: what came since the one before is of the program, of line `block`.
  void take(const Sample& sample, bool counts, std::uint64_t block);
  // The last samples have no time.
  void end_in_hole() { note(before_ ? before_->text() + " s to the end" : "all of them"); }
  bool any() const { return count_ > 0; }
  const Number& longest() const { return longest_; }
  // Sentences: the holes with their times; what the rate cannot show. Each begins with a blank.
  std::string holes_text() const;
  std::string rate_text(double fastest) const;

 private:
  double usual_;
  double limit_;
  void note(std::string hole);
  std::optional<Number> before_;
  Number longest_ = 0;
  std::size_t count_ = 0;
  std::vector<std::string> named_;  // the first ones
};

}  // namespace gonogo::oracle
