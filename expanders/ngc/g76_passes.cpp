// SPDX-License-Identifier: GPL-3.0-or-later
// The passes of G76. Depths count from the peak of the thread, away from the drive line.
#include <cmath>

#include "expanders/ngc/plan.hpp"

namespace gonogo::expanders::ngc {
namespace {

constexpr long double kClose = 1e-15L;  // of a depth: beyond what a block can say

Fixed rounded(long double value) {
  return static_cast<Fixed>(std::llround(value));
}

/// The passes of one block.
class Passes {
 public:
  Passes(Machine& machine, const Threading& thread) : machine_(machine), thread_(thread) {}
  bool run();

 private:
  long double depth_of(Fixed pass) const;
  bool is_full(Fixed pass);
  bool cut(Fixed depth);
  bool enter(Fixed to, Fixed z);
  Fixed slid(Fixed depth) const { return rounded(thread_.slide * static_cast<long double>(depth)); }
  bool rapid(Fixed x, Fixed z);
  bool thread(Fixed x, Fixed z, Fixed lead);
  Point at(Fixed x, Fixed z) const;

  static constexpr Axes kBoth = axis_bit(GONOGO_X) | axis_bit(GONOGO_Z);
  Machine& machine_;
  const Threading& thread_;
  double sum_ = 0;
};

// NGC-G76-05
long double Passes::depth_of(Fixed pass) const {
  const auto infeed = static_cast<long double>(thread_.infeed);
  return infeed * std::pow(static_cast<long double>(pass), 1 / thread_.degression);
}

bool Passes::is_full(Fixed pass) {
  const auto full = static_cast<long double>(thread_.depth);
  const bool right = depth_of(pass) >= full - full * kClose;
  if (thread_.degression != 1) return right;
  constexpr auto kScale = static_cast<double>(kOne);
  sum_ += static_cast<double>(thread_.infeed) / kScale;
  return machine_.alters("g76-binary-sum"_fault, right,
                         sum_ >= static_cast<double>(thread_.depth) / kScale);
}

bool Passes::run() {
  for (Fixed pass = 1; !is_full(pass); ++pass) {
    if (!cut(rounded(depth_of(pass)))) return false;
  }
  for (Fixed pass = 0; pass <= thread_.springs; ++pass) {
    if (!cut(thread_.depth)) return false;
  }
  return machine_.tracer.rapid(thread_.end, thread_.end_axes);
}

Point Passes::at(Fixed x, Fixed z) const {
  Point point = machine_.state.position;
  point[GONOGO_X] = x;
  point[GONOGO_Z] = z;
  return point;
}

bool Passes::rapid(Fixed x, Fixed z) {
  return machine_.tracer.rapid(at(x, z), kBoth);
}

bool Passes::thread(Fixed x, Fixed z, Fixed lead) {
  return machine_.tracer.thread(at(x, z), kBoth, lead);
}

// NGC-G76-09
bool Passes::enter(Fixed to, Fixed z) {
  if (machine_.follows("ngc.g76.entry=feed"_reading)) {
    return machine_.tracer.feed(at(to, z), kBoth, thread_.feed);
  }
  if (machine_.follows("ngc.g76.entry=rapid"_reading)) return rapid(to, z);
  return thread(to, z, thread_.entry_lead);
}

// NGC-G76-06 to 12: one pass, from beside the drive line and back.
bool Passes::cut(Fixed depth) {
  const Fixed left = thread_.depth - depth;
  const Fixed x = thread_.x + thread_.side * (thread_.peak + depth);
  const Fixed out = x - thread_.side * thread_.depth;
  const Fixed beside =
      machine_.alters("g76-plain-withdrawal"_fault, thread_.x - thread_.side * left, thread_.x);
  const int way = thread_.way;
  const int slide_way = machine_.alters("g76-slide-backwards"_fault, way, -1);
  const bool from_start = machine_.follows("ngc.g76.slide=start"_reading);
  const Fixed start =
      thread_.z_start + (from_start ? slide_way * slid(depth) : -slide_way * slid(left));
  const Fixed end = thread_.z_end - slide_way * slid(left);
  if (!rapid(beside, start)) return false;
  if (thread_.tapers_in) {
    if (!enter(out, start) || !thread(x, start + way * thread_.taper, thread_.taper_lead))
      return false;
  } else if (!rapid(x, start)) {
    return false;
  }
  if (thread_.tapers_out) {
    if (!thread(x, end - way * thread_.taper, thread_.lead) ||
        !thread(out, end, thread_.taper_lead))
      return false;
  } else if (!thread(x, end, thread_.lead)) {
    return false;
  }
  return rapid(beside, end);
}

}  // namespace

bool run_passes(Machine& machine, const Threading& thread) {
  return Passes(machine, thread).run();
}

}  // namespace gonogo::expanders::ngc
