// SPDX-License-Identifier: GPL-3.0-or-later
// G76, in G18 along Z. Depths count from the peak of the thread, away from the drive line.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "expanders/ngc/plan.hpp"

namespace gonogo::expanders::ngc {
namespace {

constexpr Fixed kRightAngle = 90 * kOne;
constexpr long double kClose = 1e-15L;  // of a depth: beyond what a block can say

Fixed rounded(long double value) {
  return static_cast<Fixed>(std::llround(value));
}

/// One block of G76 on its way to the plan.
class ThreadingBlock {
 public:
  ThreadingBlock(Machine& machine, const Block& block)
      : machine_(machine), block_(block), lenient_(machine.configuration.lenient_g76 != 0) {}

  void prepare(Plan& plan);

 private:
  void check_axes();
  void take_lead();
  void take_depths();
  void take_degression();
  void take_springs();
  void take_tapers();
  void take_slide(Plan& plan);
  void take_end();
  // The length of a word, 0 without it.
  Fixed length(char address) const {
    return block_.has(address) ? length_of(machine_, block_, address) : 0;
  }
  Fixed number(char address) const {
    return block_.has(address) ? block_.number(address).value : 0;
  }
  void complain(const AlarmText& kind, char word) { machine_.complain(kind, word, block_); }

  Machine& machine_;
  const Block& block_;
  bool lenient_;  // reading ngc.g76.checks
  Threading thread_;
};

void ThreadingBlock::prepare(Plan& plan) {
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
  take_slide(plan);
  if (state.spindle == 5) machine_.complain(AlarmKind::kSpindleStopped);  // NGC-G76-04
  thread_.feed.value = state.feed.linear;
  plan.motion = thread_;
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
    const bool one_class = machine_.adds("g76-lead-class"_fault);
    complain(one_class ? AlarmKind::kMissingWord : AlarmKind::kLeadMissing, 'P');
  }
  thread_.lead = machine_.alters("g76-inch-lead-unscaled"_fault, length('P'), number('P'));
  if (block_.has('P') && thread_.lead <= 0 && !lenient_) complain(AlarmKind::kValueSign, 'P');
}

// NGC-G76-01, 03, 06
void ThreadingBlock::take_depths() {
  for (const char address : {'I', 'J', 'K'}) {
    if (!block_.has(address)) complain(AlarmKind::kMissingWord, address);
  }
  const Fixed peak = length('I');
  thread_.side = machine_.alters("g76-inside-out"_fault, peak > 0 ? 1 : -1, -1);
  thread_.peak = machine_.alters<Fixed>("g76-from-drive-line"_fault, magnitude(peak), 0);
  thread_.infeed = length('J');
  thread_.depth = length('K');
  if (block_.has('I') && peak == 0) complain(AlarmKind::kValueOutOfRange, 'I');
  if (block_.has('J') && thread_.infeed <= 0) complain(AlarmKind::kValueSign, 'J');
  if (!block_.has('K')) return;
  if (thread_.depth < 0 && !lenient_) complain(AlarmKind::kValueSign, 'K');
  if (machine_.alters("g76-equal-k-passed"_fault, thread_.depth <= thread_.infeed,
                      thread_.depth < thread_.infeed)) {
    complain(AlarmKind::kValueOutOfRange, 'K');
  }
  const Wide reach = Wide{magnitude(thread_.x)} + magnitude(peak) + magnitude(thread_.depth);
  reached(machine_, block_, reach, 'K');
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
  if (count ? *count < (lenient_ ? -1 : 0) : written.value < 0)
    complain(AlarmKind::kValueSign, 'H');
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
  if (!lenient_ && ends != 0 && 2 * Wide{thread_.taper} > way) {
    complain(AlarmKind::kValueOutOfRange, 'E');
  }
  if (thread_.taper <= 0) return;
  const bool swapped = machine_.adds("g76-taper-ends-swapped"_fault, ends == 1 || ends == 2);
  thread_.tapers_in = (ends & (swapped ? 2 : 1)) != 0;
  thread_.tapers_out = (ends & (swapped ? 1 : 2)) != 0;
  const auto taper = static_cast<long double>(thread_.taper);
  const auto depth = static_cast<long double>(thread_.depth);
  const bool steep = thread_.taper < thread_.depth;
  const Wide steeper = scaled(thread_.lead, thread_.depth, thread_.taper);
  const Fixed axial = steep ? reached(machine_, block_, steeper, 'E') : thread_.lead;
  thread_.taper_lead = machine_.alters("g76-taper-lead-plain"_fault, axial, thread_.lead);
  const long double path = std::sqrt(taper * taper + depth * depth) / taper;
  const auto entry = static_cast<Wide>(static_cast<long double>(thread_.lead) * path + 0.5L);
  thread_.entry_lead = reached(machine_, block_, entry, 'E');
  // Reading ngc.g76.entry
  const bool by_feed = machine_.configuration.g76_entry == kEnterByFeed;
  if (thread_.tapers_in && by_feed && machine_.state.feed.linear == 0) {
    machine_.complain(AlarmKind::kFeedMissing);
  }
}

// NGC-G76-08
void ThreadingBlock::take_slide(Plan& plan) {
  const Fixed written = number('Q');
  if (written == 0 || (lenient_ && written == -kOne)) return;
  if (magnitude(written) >= kRightAngle) {
    plan.outside = "G76 with Q of 90 degrees";
    return;
  }
  const long double degrees = static_cast<long double>(written) / kOne;
  thread_.slide = std::tan(degrees * std::numbers::pi_v<long double> / 180);
  const auto farthest = static_cast<Wide>(thread_.slide * static_cast<long double>(thread_.depth));
  reached(machine_, block_, farthest, 'Q');
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
  switch (machine_.configuration.g76_entry) {
    case kEnterByFeed:
      return machine_.tracer.feed(at(to, z), kBoth, thread_.feed);
    case kEnterByRapid:
      return rapid(to, z);
    default:
      return thread(to, z, thread_.entry_lead);
  }
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
  const bool from_start = machine_.configuration.slide_at_start == 0;
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

void prepare_threading(Machine& machine, const Block& block, Plan& plan) {
  ThreadingBlock(machine, block).prepare(plan);
}

bool perform(Machine& machine, const Threading& motion) {
  return Passes(machine, motion).run();
}

}  // namespace gonogo::expanders::ngc
