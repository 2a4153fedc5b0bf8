// SPDX-License-Identifier: GPL-3.0-or-later
//
// What samples show of the feed of one motion: bounds. A sample lies somewhere in its tube and its
// time within the resolution of the clock, so that the mean speed between two samples lies between
// two values. A motion speeds up and slows down, so
//   too fast: a mean speed between two samples (neighbours, quarters of the middle half, the whole
//             of the inside) whose lower bound is above the feed by more than was granted;
//   too slow: the mean speed over the middle half of the inside of the motion has an upper bound
//             below the feed by more than was granted, where the speed there is steady: that of its
//             four quarters is the same except for the part that was granted. Where it is not, each
//             quarter has such a bound, which neither a ripple nor a stop explains. A motion too
//             short to come to a steady speed is not found too slow: one that only speeds up and
//             then slows down, in no more than kLongestRamp (J-RUN-11).
// A motion begins with the last sample that may lie at its start: rest before it has no speed.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace gonogo::oracle {

struct FeedBounds {
  double low = 0;  // mm/s
  double high = 0;
};

class FeedWatch {
 public:
  // mm/s; the part of it by which it may differ; s, half a unit of the last decimal of the times.
  FeedWatch(double feed, double granted, double clock)
      : feed_(feed), granted_(granted), clock_(clock) {}
  // A sample inside the motion: where along it, mm from its start, it lies at least and at most.
  void add(double time, double low, double high, std::size_t number);
  // The bounds that exclude the feed; and the sample at which they do.
  struct Fault {
    FeedBounds bounds;
    std::size_t number = 0;
  };
  std::optional<Fault> too_fast_now() const;  // between the last two
  struct Finding {
    std::optional<Fault> fault;
    bool is_bounded = false;  // from above and from below
  };
  Finding finding() const;

 private:
  struct Place {
    double time, low, high;
    std::size_t number;
  };
  FeedBounds between(const Place& a, const Place& b) const;
  Finding slowness(std::size_t first, std::size_t last) const;
  bool too_fast(const FeedBounds& bounds) const { return bounds.low > feed_ * (1 + granted_); }
  double feed_;
  double granted_;
  double clock_;
  std::vector<Place> places_;
};

}  // namespace gonogo::oracle
