// SPDX-License-Identifier: GPL-3.0-or-later
// G110 and G111: roughing of a circular pocket.
#include <algorithm>
#include <cmath>

#include "expanders/gsk/site.hpp"

namespace gonogo::expanders::gsk {
namespace {

// GSK-G110-02, GSK-MOD-02, GSK-MOD-03: I L Q D are modal; R and P hold for the block, or are modal
// by reading gsk.pocket.R.
void take_pocket_words(Machine& machine, const Block& block) {
  PocketStore& store = machine.state.pocket;
  if (!machine.configuration.pocket_r_modal) {
    store.r_plane = {};
    store.clearance = {};
  }
  if (machine.has(Fault::kStepDownForgotten)) store.step_down = {};
  take(machine, block, 'I', store.radius);
  take(machine, block, 'L', store.step);
  take(machine, block, 'Q', store.step_down);
  take(machine, block, 'D', store.tool_radius);
  take(machine, block, 'R', store.r_plane);
  take(machine, block, 'P', store.clearance);
}

// GSK-G110-02.
Flow check_pocket_modal_words(Machine& machine) {
  const PocketStore& store = machine.state.pocket;
  const bool one_layer = machine.has(Fault::kMissingStepDownAccepted);
  if (!store.radius.present) return machine.raise(AlarmKind::kMissingWord, 'I');
  if (!store.step.present) return machine.raise(AlarmKind::kMissingWord, 'L');
  if (!store.step_down.present && !one_layer) return machine.raise(AlarmKind::kMissingWord, 'Q');
  if (!store.tool_radius.present) return machine.raise(AlarmKind::kMissingWord, 'D');
  return Flow::kContinue;
}

// GSK-G110-16, GSK-G110-03.
Flow check_pocket_sizes(Machine& machine) {
  const PocketStore& store = machine.state.pocket;
  const Fixed radius = store.radius.value;
  const Fixed step = store.step.value;
  const Fixed tool = store.tool_radius.value;
  if (radius <= 0) return machine.raise(AlarmKind::kValueOutOfRange, 'I');
  if (step <= 0) return machine.raise(AlarmKind::kValueOutOfRange, 'L');
  if (store.step_down.present && store.step_down.value <= 0) {
    return machine.raise(AlarmKind::kValueOutOfRange, 'Q');
  }
  if (tool <= 0) return machine.raise(AlarmKind::kValueOutOfRange, 'D');
  if (radius < tool || (radius == tool && !machine.has(Fault::kToolEqualityAccepted))) {
    return machine.raise(AlarmKind::kToolTooLarge, 'I');
  }
  if (step > 2 * tool || (step == 2 * tool && !machine.has(Fault::kStepEqualityAccepted))) {
    return machine.raise(AlarmKind::kStepTooLarge, 'L');
  }
  return Flow::kContinue;
}

int commanded_sense(const Machine& machine) {
  int rot = sense_of(machine.state.cycle);
  if (machine.has(Fault::kG111AsG110)) rot = -1;
  if (machine.has(Fault::kSenseInG18) && machine.state.plane->number == 18) rot = -rot;
  return rot;
}

Flow prepare_milling(Machine& machine, const Block& block, Pocket& pocket) {
  const PocketStore& store = machine.state.pocket;
  Flow flow = check_pocket_modal_words(machine);
  if (flow == Flow::kContinue) flow = check_pocket_sizes(machine);
  const DepthRules rules{.from_initial = machine.has(Fault::kDepthFromInitialPlane)};
  if (flow == Flow::kContinue) {
    flow = find_depth(machine, block, store.r_plane, rules, pocket.site);
  }
  if (flow != Flow::kContinue) return flow;
  if (pocket.site.depth != 0 && machine.state.feed == 0) {
    return machine.raise(AlarmKind::kFeedMissing, 0);  // GSK-COM-04
  }
  pocket.step_down = store.step_down.present ? store.step_down.value : magnitude(pocket.site.depth);
  pocket.clearance = magnitude(store.clearance.value);
  if (machine.has(Fault::kClearanceSigned)) pocket.clearance = store.clearance.value;
  if (machine.has(Fault::kClearanceTwice)) pocket.clearance *= 2;
  pocket.step = store.step.value;
  pocket.reach = store.radius.value - store.tool_radius.value;
  pocket.rot = commanded_sense(machine);
  return Flow::kContinue;
}

// Circles L, 2L, ... and at last I - D, each reached by a straight cut along +p: no point of the
// disc is further than L/2 from a circle or from the plunge point (GSK-G110-09).
bool clear_layer(Machine& machine, const Pocket& pocket) {
  const Plane& plane = *machine.state.plane;
  Trace& trace = machine.trace;
  const Fixed centre_p = pocket.site.centre[plane.p];
  Fixed reach = pocket.reach;
  if (machine.has(Fault::kClosingCircleMissing) && reach > pocket.step) {
    reach -= reach % pocket.step;
  }
  Fixed radius = 0;
  for (Fixed ring = 1; radius < reach; ++ring) {
    radius = std::min(radius + pocket.step, reach);
    if (machine.has(Fault::kIsland) && ring == 2 && radius < reach) continue;
    Fixed cut = radius;
    if (machine.has(Fault::kGouge) && radius == reach)
      cut += machine.state.pocket.tool_radius.value;
    if (!trace.feed_axis(plane.p, centre_p + cut)) return false;
    if (!trace.arc(centre_p, pocket.site.centre[plane.q], pocket.rot, machine.state.position, 0)) {
      return false;
    }
  }
  return true;
}

// How deep the layer after `cut` goes, from the R plane; the last takes what remains
// (GSK-G110-08, GSK-G110-12).
class Layers {
 public:
  Layers(const Machine& machine, const Pocket& pocket)
      : machine_(machine), step_(pocket.step_down), depth_(magnitude(pocket.site.depth)) {}

  bool next(Fixed& cut) {
    if (machine_.has(Fault::kExtraLayer)) return next_in_binary32(cut);
    if (cut >= depth_) return false;
    const bool overshoots = machine_.has(Fault::kLastLayerOvershoots);
    const Fixed deeper = overshoots ? cut + step_ : std::min(cut + step_, depth_);
    if (machine_.has(Fault::kLastLayerDropped) && cut != 0 && deeper - cut < step_) return false;
    if (machine_.has(Fault::kEndlessLayers)) {
      cut = std::min(step_, depth_);
      return true;
    }
    cut = deeper;
    return true;
  }

 private:
  bool next_in_binary32(Fixed& cut) {
    constexpr auto kUnit = static_cast<float>(kOne);
    if (sum_ >= static_cast<float>(depth_) / kUnit) return false;
    sum_ += static_cast<float>(step_) / kUnit;
    cut = std::min(static_cast<Fixed>(std::llround(static_cast<double>(sum_) * 1e9)), depth_);
    return true;
  }

  const Machine& machine_;
  Fixed step_;
  Fixed depth_;
  float sum_ = 0;
};

bool mill_layers(Machine& machine, const Pocket& pocket) {
  const std::size_t d = machine.state.plane->d;
  Trace& trace = machine.trace;
  const Fixed down = sign_of(pocket.site.depth);
  Layers layers(machine, pocket);
  Fixed cut = 0;
  bool more = layers.next(cut);
  while (more) {
    if (!trace.feed_axis(d, pocket.site.r_plane + down * cut)) return false;  // GSK-G110-08, 11
    if (!clear_layer(machine, pocket)) return false;
    const Fixed last = cut;
    more = layers.next(cut);
    // GSK-G110-10
    const bool retracts = !more || !machine.has(Fault::kNoRetract);
    if (retracts && !trace.rapid_axis(d, pocket.site.r_plane)) return false;
    Point centre = pocket.site.centre;
    centre[d] = machine.state.position[d];
    if (!trace.rapid(centre, axis_bit(machine.state.plane->p) | axis_bit(machine.state.plane->q))) {
      return false;
    }
    if (!more) break;
    // GSK-G110-11: not beyond the R plane.
    Fixed entry = last - pocket.clearance;
    if (!machine.has(Fault::kClearanceUnclamped)) entry = std::max<Fixed>(entry, 0);
    if (!trace.rapid_axis(d, pocket.site.r_plane + down * entry)) return false;
  }
  return true;
}

}  // namespace

Flow prepare_pocket(Machine& machine, const Block& block, bool entering, bool mills, Plan& plan) {
  const Flow ranges = check_ranges(machine, block);
  if (ranges != Flow::kContinue) return ranges;
  take_pocket_words(machine, block);
  if (entering) {
    const Flow missing = check_pocket_modal_words(machine);
    if (missing != Flow::kContinue) return missing;
  }
  if (!mills) return Flow::kContinue;
  Pocket pocket;
  Placing placing = Placing::kNothing;
  const Flow centre = find_centre(machine, block, pocket.site, placing);
  if (centre != Flow::kContinue) return centre;
  if (placing == Placing::kPosition) plan = positioning(pocket.site);
  if (placing != Placing::kMill) return Flow::kContinue;
  if (machine.has(Fault::kLateAlarm)) machine.trace.rapid(pocket.site.centre, pocket.site.axes);
  const Flow milling = prepare_milling(machine, block, pocket);
  if (milling == Flow::kContinue) plan = pocket;
  return milling;
}

bool perform(Machine& machine, const Pocket& pocket) {
  const std::size_t d = machine.state.plane->d;
  const Configuration& configuration = machine.configuration;
  if (!approach(machine, pocket.site)) return false;  // GSK-G110-06, 07
  if (!mill_layers(machine, pocket)) return false;    // GSK-G110-08 to 12
  if (machine.has(Fault::kInitialPlaneDrifts)) machine.state.initial_plane = pocket.site.r_plane;
  // GSK-G110-13, GSK-G110-17; readings gsk.pocket.end, gsk.zero-depth-end.
  const bool may_stay = pocket.site.depth != 0 || configuration.zero_depth_ends_at_r_plane;
  const bool stays = configuration.pocket_ends_at_r_plane && may_stay;
  if (stays || machine.has(Fault::kEndsAtRPlane)) return true;
  return machine.trace.rapid_axis(d, pocket.site.initial_plane);
}

}  // namespace gonogo::expanders::gsk
