// SPDX-License-Identifier: GPL-3.0-or-later
// The pecks of G74 and G75: at multiples of dK from A, counted in whole counts.
#include <algorithm>
#include <cmath>

#include "expanders/hnc/machine.hpp"

namespace gonogo::expanders::hnc {
namespace {

// A way down along one axis; depths count from where it begins.
class Descent {
 public:
  Descent(Machine& machine, const Pecks& pecks)
      : machine_(machine),
        pecks_(pecks),
        start_(machine.state.position[pecks.axis]),
        down_(sign_of(pecks.bottom - start_)),
        depth_(magnitude(pecks.bottom - start_)) {}

  bool run();
  bool run_summed();

 private:
  Wide count() const;
  Wide depth_of(Wide peck) const;
  bool feed_to(Wide depth);
  bool withdraw_from(Wide depth);

  Machine& machine_;
  const Pecks& pecks_;
  Fixed start_;
  int down_;
  Fixed depth_;
};

// From one peck to the next it gets deeper by this much.
Fixed net_infeed(const Machine& machine, const Pecks& pecks) {
  const bool net = machine.follows("hnc.peck.from=withdrawn"_reading);
  return net ? pecks.infeed - pecks.withdrawal : pecks.infeed;
}

// HNC-G74-02: as many as it takes to reach the bottom.
Wide Descent::count() const {
  if (depth_ == 0) return 0;
  const Wide net = net_infeed(machine_, pecks_);
  const Wide after_first = static_cast<Wide>(depth_) - pecks_.infeed;
  if (machine_.has("extra-peck-at-multiple"_fault)) return 2 + std::max<Wide>(after_first, 0) / net;
  if (after_first <= 0) return 1;
  return 1 + (after_first + net - 1) / net;
}

Wide Descent::depth_of(Wide peck) const {
  constexpr Fixed kHundredth = kOne / 100;
  const Wide net = net_infeed(machine_, pecks_);
  const bool stuck = machine_.has("endless-pecks"_fault) && pecks_.infeed < kHundredth;
  const Wide depth = pecks_.infeed + (stuck ? 0 : (peck - 1) * net);
  if (machine_.has("last-peck-overshoots"_fault)) return depth;
  return std::min<Wide>(depth, depth_);
}

bool Descent::feed_to(Wide depth) {
  return machine_.tracer.feed_axis(pecks_.axis, static_cast<Fixed>(start_ + down_ * depth),
                                   pecks_.feed);
}

bool Descent::withdraw_from(Wide depth) {
  Wide left = depth - pecks_.withdrawal;
  if (machine_.has("withdrawal-twice"_fault)) left -= pecks_.withdrawal;
  if (machine_.follows("hnc.peck.clamp=start"_reading) && left < 0) left = 0;  // HNC-G74-04
  const bool at_feed = machine_.follows("hnc.peck.withdraw=feed"_reading) !=
                       machine_.has("withdrawal-at-feed"_fault);
  if (at_feed) return feed_to(left);
  return machine_.tracer.rapid_axis(pecks_.axis, static_cast<Fixed>(start_ + down_ * left));
}

bool Descent::run() {
  const Wide pecks = count();
  // Not without depth: what stands still puts out nothing, and nothing could stop it.
  const bool endless =
      machine_.has("endless-pecks"_fault) && pecks_.infeed < kOne / 100 && depth_ != 0;
  for (Wide peck = 1; peck <= pecks || endless; ++peck) {
    const Wide depth = depth_of(peck);
    if (!feed_to(depth)) return false;
    const bool last = peck == pecks && !endless;
    if (last && !machine_.has("withdrawal-at-bottom"_fault)) break;
    if (!withdraw_from(depth)) return false;
  }
  return true;
}

// The fault of that name.
bool Descent::run_summed() {
  constexpr auto kScale = static_cast<double>(kOne);
  const double bottom = static_cast<double>(depth_) / kScale;
  const double net = static_cast<double>(net_infeed(machine_, pecks_)) / kScale;
  double infeed = static_cast<double>(pecks_.infeed) / kScale;
  double sum = 0;
  while (sum < bottom) {
    sum += infeed;
    infeed = net;
    const Wide depth = std::min<Wide>(std::llround(sum * kScale), depth_);
    if (!feed_to(depth)) return false;
    if (sum < bottom && !withdraw_from(depth)) return false;
  }
  return true;
}

void halve(bool halved, Retained& length) {
  if (halved) length.value = static_cast<Fixed>(scaled(length.value, 1, 2));
}

}  // namespace

void take_pecks(Machine& machine, const Block& block, bool halved) {
  CycleStore& store = machine.state.store;
  if (block.has('R')) {
    take_length(machine, block, 'R', store.withdrawal);
    halve(halved, store.withdrawal);
    if (machine.has("withdrawal-sign-unchecked"_fault)) {
      store.withdrawal.value = magnitude(store.withdrawal.value);
    }
    if (store.withdrawal.value < 0) machine.complain(AlarmKind::kValueSign, 'R', block);
  }
  if (block.has('Q')) {
    take_length(machine, block, 'Q', store.infeed);
    halve(halved, store.infeed);
    if (store.infeed.value <= 0) machine.complain(AlarmKind::kValueSign, 'Q', block);
  }
}

void prepare_pecks(Machine& machine, const Block& block, Pecks& pecks) {
  const CycleStore& store = machine.state.store;
  pecks.feed = cycle_feed(machine);
  pecks.withdrawal = store.withdrawal.value;
  if (pecks.withdrawal <= 0) return;  // HNC-G74-03, HNC-G75-03
  if (!store.infeed.present) return machine.complain(AlarmKind::kMissingWord, 'Q', kNowhere);
  pecks.infeed = store.infeed.value;
  // Reading hnc.peck.from: what one peck does not reach is never reached.
  const Fixed depth = magnitude(pecks.bottom - machine.state.position[pecks.axis]);
  const bool is_peck = pecks.infeed > 0;  // else HNC-G74-01
  if (machine.follows("hnc.peck.from=withdrawn"_reading) && is_peck &&
      pecks.withdrawal >= pecks.infeed && depth > pecks.infeed) {
    machine.complain(AlarmKind::kValueOutOfRange, 'R', block);
  }
}

void prepare_approach(Machine& machine, bool is_on, Pecks& pecks) {
  const Retained& infeed = machine.state.store.infeed;
  if (!is_on || pecks.withdrawal != 0 || !infeed.present) return;
  const int inwards = sign_of(pecks.bottom - machine.state.position[pecks.axis]);
  if (inwards == 0) return machine.complain(AlarmKind::kDirectionConflict);
  pecks.approached = true;
  pecks.approach = pecks.bottom;
  pecks.bottom = moved(machine, pecks.approach, inwards * infeed.value);
}

bool perform_pecks(Machine& machine, const Pecks& pecks) {
  if (pecks.approached && !machine.tracer.rapid_axis(pecks.axis, pecks.approach)) return false;
  if (pecks.withdrawal == 0) {
    return machine.tracer.feed_axis(pecks.axis, pecks.bottom, pecks.feed);
  }
  Descent descent(machine, pecks);
  return machine.has("peck-running-sum"_fault) ? descent.run_summed() : descent.run();
}

}  // namespace gonogo::expanders::hnc
