// SPDX-License-Identifier: GPL-3.0-or-later
// The words of the hole cycles: places, levels, repeats, dwells and pecks of a block.
#include "expanders/ngc/cycle.hpp"

#include <algorithm>

namespace gonogo::expanders::ngc {
namespace {

bool is_peck(Motion code) {
  return code == Motion::kG73 || code == Motion::kG83;
}
bool is_tap(Motion code) {
  return code == Motion::kG74 || code == Motion::kG84;
}

// NGC-CYC-23
bool takes_dwell(const Machine& machine, Motion code) {
  if (is_tap(code)) return !machine.follows("ngc.tap.p=barred"_reading);
  return code == Motion::kG82 || code == Motion::kG86 || code == Motion::kG89;
}

bool needs_dwell(const Machine& machine, Motion code) {
  if (is_tap(code)) return machine.follows("ngc.tap.p=needed"_reading);
  return takes_dwell(machine, code);
}

/// One block of a cycle on its way to the plan.
class CycleBlock {
 public:
  CycleBlock(Machine& machine, const Block& block)
      : machine_(machine),
        block_(block),
        state_(machine.state),
        store_(machine.state.cycle),
        plane_(plane_of(machine.alters("cycle-plane-ignored"_fault, state_.plane, 17))),
        depth_word_(kAxisAddress[plane_.d]) {
    cycle_.code = state_.motion;
    cycle_.plane = &plane_;
  }

  void prepare(Plan& plan);

 private:
  void check_axes();
  void take_words();
  void take(char address, std::optional<Fixed>& number, bool checks_sign);
  void take_initial();
  Fixed level_under_r() const;
  void take_levels();
  void take_places();
  void take_polar_places();
  void take_count();
  bool stands_still() const;
  bool leads_through_origin() const;
  void take_dwell();
  void take_pecks();
  void check_late(Plan& plan);
  void check_spindle();
  void complain_late(const AlarmText& kind, char word, Cycle::Extent extent);
  Fixed offset(std::size_t axis) const;

  void complain(const AlarmText& kind, char word) { machine_.complain(kind, word, block_); }

  Machine& machine_;
  const Block& block_;
  State& state_;
  CycleStore& store_;
  const Plane& plane_;
  char depth_word_;
  Cycle cycle_;
};

void CycleBlock::prepare(Plan& plan) {
  check_axes();
  take_words();
  take_initial();
  if (store_.r && store_.depth) take_levels();
  take_places();
  take_count();
  take_dwell();
  take_pecks();
  if (leads_through_origin()) plan.outside = "holes through the origin";
  if (stands_still()) cycle_.count = std::min<Fixed>(cycle_.count, 1);
  cycle_.spindle = state_.spindle;
  cycle_.feed = feed_of(state_);
  // NGC-CYC-21
  if (state_.feed_mode == FeedMode::kInverseTime) {
    machine_.complain(AlarmKind::kConflictingWords, 'G', kNowhere);
  }
  // NGC-CYC-20
  if (state_.feed.linear == 0 && !machine_.follows("ngc.cycle.feed=free"_reading)) {
    machine_.complain(AlarmKind::kFeedMissing);
  }
  check_late(plan);
  const bool drills = block_.code(Group::kMotion) != nullptr ||
                      machine_.spares("repeat-drops-holes"_fault, cycle_.extent == Cycle::kAll);
  if (!drills) cycle_.extent = std::min(cycle_.extent, Cycle::kApproach);
  plan.motion = [&machine = machine_, cycle = cycle_] { return run_cycle(machine, cycle); };
}

// NGC-CYC-04, 18
void CycleBlock::check_axes() {
  const bool named = block_.code(Group::kMotion) != nullptr;
  const bool linear = block_.has_any(kLinearWords);
  if (!linear && named && machine_.spares("cycle-needs-no-axis"_fault)) {
    machine_.complain(AlarmKind::kMissingWord, 'X', kNowhere);
  }
  for (const char address : {'A', 'C'}) {
    if (!block_.has(address)) continue;
    if (!named && machine_.adds("rotary-passed-in-repeat"_fault)) continue;
    complain(AlarmKind::kAxisNotInPlane, address);
  }
}

// NGC-CYC-22
void CycleBlock::take(char address, std::optional<Fixed>& number, bool checks_sign) {
  if (!block_.has(address)) return;
  const Fixed written = block_.number(address).value;
  if (checks_sign && written == -kOne && machine_.adds("minus-one-unwritten"_fault)) return;
  number = written;
  if (address != 'P' || !checks_sign || written >= 0) return;
  number = machine_.alters("negative-dwell-passed"_fault, written, -written);
  if (*number < 0) complain(AlarmKind::kValueSign, 'P');
}

// NGC-CYC-02, 03
void CycleBlock::take_words() {
  constexpr std::optional<Fixed> kNothing;
  if (state_.first) {
    store_.r = machine_.alters("sticky-survives-cycle"_fault, kNothing, store_.r);
    store_.depth = machine_.alters("sticky-survives-cycle"_fault, kNothing, store_.depth);
    store_.p = store_.q = kNothing;
  } else {
    store_.r = machine_.alters("r-not-sticky"_fault, store_.r, kNothing);
    store_.q = machine_.alters("q-not-sticky"_fault, store_.q, kNothing);
    if (store_.p) {
      store_.p = machine_.alters("p-not-sticky"_fault, store_.p, 0);
    }
  }
  check_sizes(machine_, block_, AddressSet{"QDL"});
  take('R', store_.r, false);
  take(depth_word_, store_.depth, false);
  if (takes_dwell(machine_, cycle_.code)) take('P', store_.p, true);
  if (is_peck(cycle_.code)) take('Q', store_.q, true);
  if (!store_.r) complain(AlarmKind::kMissingWord, 'R');
  if (!store_.depth) complain(AlarmKind::kMissingWord, depth_word_);
}

// NGC-CYC-08, 09: the initial level of the series; under the reading `number` one that was taken in
// other units is read in those in force.
void CycleBlock::take_initial() {
  const Fixed tool = state_.position[plane_.d];
  const bool renewed = state_.first && machine_.adds("initial-renewed-by-cycle"_fault,
                                                     state_.in_series && state_.initial != tool);
  if (!state_.in_series || renewed || machine_.follows("ngc.cycle.initial=block"_reading)) {
    state_.initial = tool;
    state_.initial_in_inch = state_.inch;
  }
  state_.in_series = true;
  cycle_.initial = state_.initial;
  if (!machine_.follows("ngc.cycle.initial-kept=number"_reading) ||
      state_.initial_in_inch == state_.inch)
    return;
  const Wide other =
      state_.inch ? scaled(state_.initial, 254, 10) : scaled(state_.initial, 10, 254);
  cycle_.initial = reached(machine_, block_, other, depth_word_);
}

// Nil for absolute words, except the fault that counts from where the machine was switched on.
Fixed CycleBlock::offset(std::size_t axis) const {
  return machine_.alters<Fixed>("cycle-ignores-offset"_fault, 0, machine_.profile.position[axis]);
}

// From where R counts.
Fixed CycleBlock::level_under_r() const {
  if (!state_.incremental) return offset(plane_.d);
  if (machine_.follows("ngc.cycle.g91-r=current"_reading)) return state_.position[plane_.d];
  return machine_.follows("ngc.cycle.g91-r=initial"_reading) ? cycle_.initial : 0;
}

// NGC-CYC-05, 06, 07, 10
void CycleBlock::take_levels() {
  const Fixed tool = state_.position[plane_.d];
  const Fixed from = level_under_r();
  const Fixed r =
      machine_.alters("inch-r-unscaled"_fault, length_of(machine_, *store_.r), *store_.r);
  // Reading ngc.cycle.sticky: the number, or the level that came of it.
  if (!machine_.follows("ngc.cycle.sticky=level"_reading) || block_.has('R')) {
    store_.r_level = reached(machine_, block_, Wide{from} + r, 'R');
  }
  if (!machine_.follows("ngc.cycle.sticky=level"_reading) || block_.has(depth_word_)) {
    const Fixed above = state_.incremental
                            ? machine_.alters("depth-from-tool"_fault, store_.r_level, tool)
                            : offset(plane_.d);
    const Fixed depth = length_of(machine_, *store_.depth);
    store_.bottom = reached(machine_, block_, Wide{above} + depth, depth_word_);
  }
  cycle_.r = store_.r_level;
  cycle_.bottom = store_.bottom;
  if (machine_.alters("reference-equality-refused"_fault, cycle_.r < cycle_.bottom,
                      cycle_.r <= cycle_.bottom)) {
    if (machine_.adds("reference-plane-silent"_fault)) {
      cycle_.count = 0;
    } else {
      complain(AlarmKind::kReferencePlane, 'R');
    }
  }
  cycle_.clear = cycle_.r;
  if (!state_.to_initial) return;
  const Fixed clear = std::max(cycle_.initial, cycle_.r);
  cycle_.clear = machine_.alters("g98-below-r"_fault, clear, cycle_.initial);
  cycle_.clear = machine_.alters("g98-retracts-to-r"_fault, cycle_.clear, cycle_.r);
}

// NGC-CYC-05, 06
void CycleBlock::take_places() {
  if (is_polar(block_)) return take_polar_places();
  for (const std::size_t axis : {plane_.p, plane_.q}) {
    const char address = kAxisAddress[axis];
    const Fixed tool = state_.position[axis];
    const bool written = block_.has(address);
    const Fixed length = written ? length_along(machine_, block_, axis) : 0;
    if (state_.incremental) {
      const Fixed step =
          written ? length
                  : machine_.alters<Fixed>("stale-step"_fault, 0, state_.leftovers.steps[axis]);
      cycle_.first[axis] = reached(machine_, block_, Wide{tool} + step, address);
      cycle_.step[axis] = machine_.alters("l-in-place"_fault, step, 0);
    } else {
      const Wide place = written ? Wide{offset(axis)} + length : tool;
      cycle_.first[axis] = reached(machine_, block_, place, address);
      cycle_.step[axis] =
          machine_.alters<Fixed>("l-steps-under-g90"_fault, 0, cycle_.first[axis] - tool);
    }
  }
}

// NGC-POL-01
void CycleBlock::take_polar_places() {
  cycle_.polar = polar_way(machine_, block_);
  lead_to(machine_, block_, *cycle_.polar, 0, cycle_.first);
}

// NGC-CYC-13, 14, 15
void CycleBlock::take_count() {
  std::optional<Fixed>& last = state_.leftovers.count;
  std::optional<Fixed> count = block_.has('L') ? machine_.whole.repeats(block_.number('L')) : 1;
  if (!block_.has('L')) count = machine_.alters("l-sticky"_fault, count, last ? last : count);
  // What counts as 0 is not below it.
  if (block_.has('L') && count.value_or(block_.number('L').value) < 0) {
    complain(AlarmKind::kValueSign, 'L');
  } else if (!count) {
    complain(AlarmKind::kNotAnInteger, 'L');
  } else if (*count == 0 && machine_.spares("l-zero-passed"_fault)) {
    complain(AlarmKind::kValueOutOfRange, 'L');
  }
  last = count;
  if (!count || cycle_.count == 0) return;
  cycle_.count = machine_.alters("l-ignored"_fault, *count, 1);
  for (const std::size_t axis : {plane_.p, plane_.q}) {
    const Wide end = cycle_.first[axis] + Wide{cycle_.count} * cycle_.step[axis];
    reached(machine_, block_, end, 'L');
  }
  // The fault takes the levels of each hole from where the one before has ended.
  const bool more = state_.incremental && cycle_.count > 1;
  const Fixed drift = more ? cycle_.clear - state_.position[plane_.d] : 0;
  const bool stays = fits(Wide{drift} * cycle_.count);
  cycle_.drift = machine_.alters<Fixed>("levels-drift"_fault, 0, stays ? drift : 0);
}

// Whether a repeat would put nothing out: no loop may run on without a record.
bool CycleBlock::stands_still() const {
  const bool turns = is_tap(cycle_.code) || cycle_.code == Motion::kG86;
  const bool dwells = cycle_.dwell != 0 || machine_.follows("ngc.peck.dwell=quarter"_reading);
  const bool goes_on = cycle_.polar && (cycle_.polar->further != 0 || cycle_.polar->turn != 0);
  return !turns && !dwells && !goes_on && cycle_.r == cycle_.bottom && cycle_.r == cycle_.clear &&
         cycle_.drift == 0 && cycle_.step[plane_.p] == 0 && cycle_.step[plane_.q] == 0;
}

// NGC-POL-04
bool CycleBlock::leads_through_origin() const {
  if (!cycle_.polar || cycle_.count < 2) return false;
  const auto behind_first = static_cast<long double>(cycle_.count - 2);
  return cycle_.polar->distance + behind_first * cycle_.polar->further <= 0;
}

// Reading ngc.tap.p: without P a tap has the dwell of the cycle before.
void CycleBlock::take_dwell() {
  if (!takes_dwell(machine_, cycle_.code)) return;
  const bool of_last = is_tap(cycle_.code) && machine_.follows("ngc.tap.p=last"_reading);
  cycle_.dwell = store_.p.value_or(of_last ? state_.dwell : 0);
  state_.dwell = cycle_.dwell;
  const Wide thousandfold = Wide{cycle_.dwell} * 1000;
  cycle_.dwell = machine_.alters("cycle-dwell-milliseconds"_fault, cycle_.dwell,
                                 fits(thousandfold) ? static_cast<Fixed>(thousandfold) : kLargest);
}

// NGC-G83-04, 07, 08
void CycleBlock::take_pecks() {
  if (!is_peck(cycle_.code)) return;
  const Fixed number = store_.q.value_or(0);
  const Fixed one = machine_.profile.inch ? kOne / 20 : kOne;
  cycle_.infeed = machine_.alters("inch-q-unscaled"_fault, length_of(machine_, number), number);
  const bool one_unit = machine_.follows("ngc.peck.clearance=one-mm"_reading);
  cycle_.clearance = one_unit ? length_of(machine_, one) : kOne / 1000 * 254;
  cycle_.clearance = machine_.alters("clearance-in-program-unit"_fault, cycle_.clearance,
                                     length_of(machine_, kOne / 100));
  if (machine_.follows("ngc.peck.clearance=tenth-mm"_reading)) cycle_.clearance = kOne / 10;
  if (machine_.follows("ngc.peck.clearance=twentieth"_reading)) {
    cycle_.clearance = static_cast<Fixed>(scaled(cycle_.infeed, 1, 20));
  }
  if (!machine_.follows("ngc.peck.d=clearance"_reading) || !block_.has('D')) return;
  cycle_.clearance = length_of(machine_, block_, 'D');
  if (cycle_.clearance < 0) complain(AlarmKind::kValueSign, 'D');
}

// Reading ngc.cycle.alarm-at: what a machine may find after the first rapids only.
void CycleBlock::check_late(Plan& plan) {
  const bool clean = !machine_.in_alarm();
  if (needs_dwell(machine_, cycle_.code) && !store_.p) {
    complain_late(AlarmKind::kMissingWord, 'P', Cycle::kLift);
  }
  if (is_peck(cycle_.code) && !store_.q) {
    if (machine_.spares("missing-q-whole-depth"_fault)) {
      complain_late(AlarmKind::kMissingWord, 'Q', Cycle::kLift);
    }
    cycle_.infeed = std::max<Fixed>(1, cycle_.r - cycle_.bottom);
  } else if (is_peck(cycle_.code) && *store_.q <= 0) {
    complain_late(AlarmKind::kValueSign, 'Q', Cycle::kApproach);
    if (machine_.follows("ngc.cycle.alarm-at-q=block"_reading)) return;
  }
  check_spindle();
  plan.alarms_late =
      clean && machine_.in_alarm() && machine_.follows("ngc.cycle.alarm-at=late"_reading);
}

// NGC-G84-01, NGC-G86-01
void CycleBlock::check_spindle() {
  const bool stands = cycle_.spindle == 5;
  if (cycle_.code == Motion::kG86 && machine_.spares("g86-stopped-passed"_fault, stands)) {
    complain_late(AlarmKind::kSpindleStopped, 0, Cycle::kApproach);
  }
  if (!is_tap(cycle_.code) || cycle_.spindle == sense_of_tap(machine_, cycle_.code)) return;
  if (!stands && machine_.adds("tap-direction-passed"_fault)) return;
  const bool said_to_stand = stands || machine_.adds("tap-direction-class"_fault);
  complain_late(said_to_stand ? AlarmKind::kSpindleStopped : AlarmKind::kDirectionConflict, 0,
                Cycle::kApproach);
}

void CycleBlock::complain_late(const AlarmText& kind, char word, Cycle::Extent extent) {
  machine_.complain(kind, word, word == 0 ? kNowhere : block_.position(word));
  cycle_.extent = std::min(cycle_.extent, extent);
}

}  // namespace

void prepare_cycle(Machine& machine, const Block& block, Plan& plan) {
  CycleBlock(machine, block).prepare(plan);
}

AddressSet words_of(const Machine& machine, Motion motion) {
  if (is_arc(motion)) return AddressSet{"IJKPR"};
  if (motion == Motion::kG33) return AddressSet{"K"};
  if (motion == Motion::kG331) return AddressSet{"IK"};
  if (motion == Motion::kG76) return AddressSet{"EHIJKLPQR"};
  if (!is_cycle(motion)) return {};
  AddressSet words{"R"};
  if (motion != Motion::kG74 || !machine.follows("ngc.g74.l=barred"_reading)) words.add('L');
  if (takes_dwell(machine, motion)) words.add('P');
  if (is_peck(motion)) words.add('Q');
  if (is_peck(motion) && machine.follows("ngc.peck.d=clearance"_reading)) words.add('D');
  return words;
}

}  // namespace gonogo::expanders::ngc
