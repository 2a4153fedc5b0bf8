// SPDX-License-Identifier: GPL-3.0-or-later
// The words of G76, in G18 along Z.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "expanders/ngc/plan.hpp"

namespace gonogo::expanders::ngc {
namespace {

constexpr Fixed kRightAngle = 90 * kOne;
// No length or lead of a thread is larger, mm.
constexpr long double kFarthest = 1e8L * kOne;

/// One block of G76 on its way to the plan.
class ThreadingBlock {
 public:
  ThreadingBlock(Machine& machine, const Block& block, Plan& plan)
      : machine_(machine),
        block_(block),
        plan_(plan),
        lenient_(machine.follows("ngc.g76.checks=linuxcnc"_reading)) {}

  void prepare();

 private:
  void check_axes();
  void take_lead();
  void take_depths();
  void take_degression();
  void take_springs();
  void take_tapers();
  void take_slide();
  void take_end();
  Fixed within_reach(long double length);
  // The length of a word, 0 without it.
  Fixed length(char address) const {
    return block_.has(address) ? length_of(machine_, block_, address) : 0;
  }
  // Under G7 a diameter (NGC-DIA-01).
  Fixed across(char address) const { return length(address) / (machine_.state.diameter ? 2 : 1); }
  Fixed number(char address) const {
    return block_.has(address) ? block_.number(address).value : 0;
  }
  void complain(const AlarmText& kind, char word) { machine_.complain(kind, word, block_); }

  Machine& machine_;
  const Block& block_;
  Plan& plan_;
  bool lenient_;  // reading ngc.g76.checks
  Threading thread_;
};

void ThreadingBlock::prepare() {
  const State& state = machine_.state;
  check_sizes(machine_, block_, AddressSet{"EHLQ"});
  check_axes();
  thread_.x = state.position[GONOGO_X];
  thread_.z_start = thread_.z_end = state.position[GONOGO_Z];
  take_end();
  take_depths();
  take_degression();
  take_springs();
  take_lead();
  take_tapers();
  take_slide();
  if (state.spindle == 5) machine_.complain(AlarmKind::kSpindleStopped);  // NGC-G76-04
  thread_.feed = feed_of(state);
  for (const Fixed place : {thread_.x, thread_.z_start, thread_.z_end, thread_.peak, thread_.depth,
                            thread_.taper, thread_.lead}) {
    within_reach(static_cast<long double>(place));
  }
  plan_.motion = [&machine = machine_, thread = thread_] { return run_passes(machine, thread); };
}

// NGC-G76-02
void ThreadingBlock::check_axes() {
  for (const char address : {'A', 'C'}) {
    if (block_.has(address)) complain(AlarmKind::kAxisNotInPlane, address);
  }
  if (!block_.has('Z') && (!lenient_ || !block_.has_any(kAxisWords))) {
    complain(AlarmKind::kMissingWord, 'Z');
  }
  if (lenient_) return;
  if (machine_.state.plane != 18) machine_.complain(AlarmKind::kPlaneNotAllowed);
  for (const char address : {'X', 'Y'}) {
    if (block_.has(address)) complain(AlarmKind::kAxisNotInPlane, address);
  }
}

// NGC-G76-12: on the drive line, at the end of the thread.
void ThreadingBlock::take_end() {
  thread_.end = commanded_point(machine_, block_, thread_.end_axes);
  thread_.end_axes |= axis_bit(GONOGO_X) | axis_bit(GONOGO_Z);
  thread_.z_end = thread_.end[GONOGO_Z];
  thread_.way = thread_.z_end > thread_.z_start ? 1 : -1;
  thread_.end[GONOGO_Z] =
      machine_.alters("g76-ends-at-start"_fault, thread_.z_end, thread_.z_start);
}

// NGC-G76-01
void ThreadingBlock::take_lead() {
  if (!block_.has('P')) {
    const bool is_feed = machine_.adds("g76-lead-class"_fault);
    complain(is_feed ? AlarmKind::kFeedMissing : AlarmKind::kLeadMissing, 'P');
  }
  thread_.lead = machine_.alters("g76-inch-lead-unscaled"_fault, length('P'), number('P'));
  if (block_.has('P') && thread_.lead <= 0 && !lenient_) complain(AlarmKind::kValueSign, 'P');
}

// NGC-G76-01, 03, 06
void ThreadingBlock::take_depths() {
  for (const char address : {'I', 'J', 'K'}) {
    if (!block_.has(address)) complain(AlarmKind::kMissingWord, address);
  }
  const Fixed peak = across('I');
  thread_.side = machine_.alters("g76-inside-out"_fault, peak > 0 ? 1 : -1, -1);
  thread_.peak = machine_.alters("g76-from-drive-line"_fault, magnitude(peak), 0);
  thread_.infeed = across('J');
  thread_.depth = across('K');
  if (block_.has('I') && peak == 0) complain(AlarmKind::kValueOutOfRange, 'I');
  if (block_.has('J') && thread_.infeed <= 0) complain(AlarmKind::kValueSign, 'J');
  if (thread_.depth < 0 && !lenient_) complain(AlarmKind::kValueSign, 'K');
  if (!block_.has('J') || !block_.has('K')) return;
  if (machine_.alters("g76-equal-k-passed"_fault, thread_.depth <= thread_.infeed,
                      thread_.depth < thread_.infeed)) {
    complain(AlarmKind::kValueOutOfRange, 'K');
  }
}

// NGC-G76-03, 05
void ThreadingBlock::take_degression() {
  if (!block_.has('R')) return;
  const Fixed written = number('R');
  if (written < kOne && !lenient_) complain(AlarmKind::kValueOutOfRange, 'R');
  const Fixed degression = machine_.alters("g76-equal-infeed"_fault, std::max(written, kOne), kOne);
  thread_.degression = static_cast<long double>(degression) / kOne;
}

void ThreadingBlock::take_springs() {
  if (!block_.has('H')) return;
  const Decimal& written = block_.number('H');
  const std::optional<Fixed> count = machine_.whole.repeats(written);
  if (!count && !written.overflow) complain(AlarmKind::kNotAnInteger, 'H');
  thread_.springs = count.value_or(0);
  const Fixed least = lenient_ ? -1 : 0;
  if (written.value < 0 && count.value_or(-2) < least) complain(AlarmKind::kValueSign, 'H');
  const Fixed less = std::max<Fixed>(0, thread_.springs - 1);
  thread_.springs = machine_.alters("g76-h-total"_fault, thread_.springs, less);
}

// NGC-G76-03, 09, 10, 11
void ThreadingBlock::take_tapers() {
  Fixed ends = 0;
  if (block_.has('L')) {
    const std::optional<Fixed> written = machine_.whole.repeats(block_.number('L'));
    if (!written) complain(AlarmKind::kNotAnInteger, 'L');
    ends = written.value_or(0);
    if (ends < 0 || (ends > 3 && !lenient_)) complain(AlarmKind::kValueOutOfRange, 'L');
  }
  thread_.taper = length('E');
  if (thread_.taper < 0 && !lenient_) complain(AlarmKind::kValueSign, 'E');
  const Wide way = magnitude(thread_.z_end - thread_.z_start);
  if (!lenient_ && ends != 0 && block_.has('Z') && 2 * Wide{thread_.taper} > way) {
    complain(AlarmKind::kValueOutOfRange, 'E');
  }
  if (thread_.taper <= 0) return;
  const bool swapped = machine_.adds("g76-taper-ends-swapped"_fault, ends == 1 || ends == 2);
  thread_.tapers_in = (ends & (swapped ? 2 : 1)) != 0;
  thread_.tapers_out = (ends & (swapped ? 1 : 2)) != 0;
  const auto taper = static_cast<long double>(thread_.taper);
  const auto depth = static_cast<long double>(thread_.depth);
  const auto lead = static_cast<long double>(thread_.lead);
  const Fixed axial = within_reach(lead * std::max(taper, depth) / taper);
  thread_.taper_lead = machine_.alters("g76-taper-lead-plain"_fault, axial, thread_.lead);
  thread_.entry_lead = within_reach(lead * std::hypot(taper, depth) / taper);
  // Reading ngc.g76.entry
  const bool by_feed = machine_.follows("ngc.g76.entry=feed"_reading);
  if (thread_.tapers_in && by_feed && machine_.state.feed.linear == 0) {
    machine_.complain(AlarmKind::kFeedMissing);
  }
}

// NGC-G76-08
void ThreadingBlock::take_slide() {
  const Fixed written = number('Q');
  if (written == 0 || (lenient_ && written == -kOne)) return;
  if (magnitude(written) % (2 * kRightAngle) == kRightAngle) {
    plan_.outside = "G76 with Q of a right angle";
    return;
  }
  const long double degrees = static_cast<long double>(written) / kOne;
  thread_.slide = std::tan(degrees * std::numbers::pi_v<long double> / 180);
  within_reach(thread_.slide * static_cast<long double>(thread_.depth));
}

// To the nearest count; what is larger is not implemented.
Fixed ThreadingBlock::within_reach(long double length) {
  if (std::abs(length) <= kFarthest) return static_cast<Fixed>(std::llround(length));
  plan_.outside = "G76 of that size";
  return 0;
}

}  // namespace

void prepare_threading(Machine& machine, const Block& block, Plan& plan) {
  ThreadingBlock(machine, block, plan).prepare();
}

}  // namespace gonogo::expanders::ngc
