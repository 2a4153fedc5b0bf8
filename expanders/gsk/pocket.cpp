// SPDX-License-Identifier: GPL-3.0-or-later
// G110 and G111: roughing of a circular pocket.
#include <algorithm>
#include <cmath>

#include "expanders/gsk/site.hpp"

namespace gonogo::expanders::gsk {
namespace {

struct Pocket {
  Site site;
  Fixed step_down = 0;
  Fixed clearance = 0;
  Fixed step = 0;
  Fixed reach = 0;  ///< I - D: radius of the last circle
  int rot = 0;
};

// GSK-G110-02, GSK-MOD-02, GSK-MOD-03: I L Q D are modal; R and P hold for the block, or are modal
// by reading gsk.pocket.R.
void take_pocket_words(Machine& machine, const Block& block) {
  PocketStore& store = machine.state.pocket;
  if (!machine.follows("gsk.pocket.R=modal"_reading)) {
    store.r_plane = {};
    store.clearance = {};
  }
  if (machine.has("step-down-forgotten"_fault)) store.step_down = {};
  take(machine, block, 'I', store.radius);
  take(machine, block, 'L', store.step);
  take(machine, block, 'Q', store.step_down);
  take(machine, block, 'D', store.tool_radius);
  take(machine, block, 'R', store.r_plane);
  take(machine, block, 'P', store.clearance);
}

// GSK-G110-02.
void check_modal_words(Machine& machine) {
  const PocketStore& store = machine.state.pocket;
  check_present(machine, {{'I', store.radius}, {'L', store.step}});
  if (!machine.has("missing-step-down-accepted"_fault)) {
    check_present(machine, {{'Q', store.step_down}});
  }
  check_present(machine, {{'D', store.tool_radius}});
}

// GSK-G110-16, GSK-G110-03.
void check_sizes(Machine& machine) {
  const PocketStore& store = machine.state.pocket;
  check_positive(machine, {{'I', store.radius}, {'L', store.step}, {'D', store.tool_radius}});
  // GSK-G110-20
  if (machine.follows("gsk.pocket.q-zero=alarm"_reading)) {
    check_positive(machine, {{'Q', store.step_down}});
  }
  const Fixed tool = store.tool_radius.value;
  const bool fits = machine.has("tool-equality-accepted"_fault) ? store.radius.value >= tool
                                                                : store.radius.value > tool;
  if (!fits) machine.raise(AlarmKind::kToolTooLarge, 'I');
  const bool covers = machine.has("step-equality-accepted"_fault) ? store.step.value <= 2 * tool
                                                                  : store.step.value < 2 * tool;
  if (!covers) machine.raise(AlarmKind::kStepTooLarge, 'L');
}

int commanded_sense(const Machine& machine) {
  int rot = sense_of(machine.state.cycle);
  if (machine.has("g111-as-g110"_fault)) rot = -1;
  if (machine.has("sense-in-g18"_fault) && machine.plane().number == 18) rot = -rot;
  return rot;
}

void prepare_milling(Machine& machine, const Block& block, Pocket& pocket) {
  const PocketStore& store = machine.state.pocket;
  check_modal_words(machine);
  check_sizes(machine);
  const DepthRules rules{.from_initial = machine.has("depth-from-initial-plane"_fault)};
  find_depth(machine, block, store.r_plane, rules, pocket.site);
  if (pocket.site.depth != 0) machine.check_feed();
  const bool in_layers = store.step_down.present && store.step_down.value > 0;
  pocket.step_down = in_layers ? store.step_down.value : magnitude(pocket.site.depth);
  pocket.clearance = magnitude(store.clearance.value);
  if (machine.has("clearance-signed"_fault)) pocket.clearance = store.clearance.value;
  if (machine.has("clearance-twice"_fault)) pocket.clearance *= 2;
  pocket.step = store.step.value;
  pocket.reach = store.radius.value - store.tool_radius.value;
  pocket.rot = commanded_sense(machine);
}

// Circles L, 2L, ... and at last I - D, each reached by a straight cut along +p: no point of the
// disc is further than L/2 from a circle or from the plunge point (GSK-G110-09).
bool clear_layer(Machine& machine, const Pocket& pocket) {
  const Plane& plane = machine.plane();
  const Fixed centre_p = pocket.site.centre[plane.p];
  Fixed reach = pocket.reach;
  if (machine.has("closing-circle-missing"_fault) && reach > pocket.step) {
    reach -= reach % pocket.step;
  }
  Fixed radius = 0;
  for (Fixed ring = 1; radius < reach; ++ring) {
    radius = std::min(radius + pocket.step, reach);
    if (machine.has("island"_fault) && ring == 2 && radius < reach) continue;
    Fixed cut = radius;
    if (machine.has("gouge"_fault) && radius == reach)
      cut += machine.state.pocket.tool_radius.value;
    if (!machine.cut_axis(plane.p, centre_p + cut)) return false;
    if (!machine.arc(centre_p, pocket.site.centre[plane.q], pocket.rot, machine.state.position,
                     0)) {
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
    if (machine_.has("extra-layer"_fault)) return next_in_binary32(cut);
    if (cut >= depth_) return false;
    const bool overshoots = machine_.has("last-layer-overshoots"_fault);
    const Fixed deeper = overshoots ? cut + step_ : std::min(cut + step_, depth_);
    if (machine_.has("last-layer-dropped"_fault) && cut != 0 && deeper - cut < step_) return false;
    if (machine_.has("endless-layers"_fault)) {
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
  const std::size_t d = machine.plane().d;
  const Fixed down = sign_of(pocket.site.depth);
  Layers layers(machine, pocket);
  Fixed cut = 0;
  bool more = layers.next(cut);
  while (more) {
    if (!machine.cut_axis(d, pocket.site.r_plane + down * cut)) return false;  // GSK-G110-08, 11
    if (!clear_layer(machine, pocket)) return false;
    const Fixed last = cut;
    more = layers.next(cut);
    // GSK-G110-10
    const bool retracts = !more || !machine.has("no-retract"_fault);
    if (retracts && !machine.tracer.rapid_axis(d, pocket.site.r_plane)) return false;
    Point centre = pocket.site.centre;
    centre[d] = machine.state.position[d];
    if (!machine.tracer.rapid(centre, axis_bit(machine.plane().p) | axis_bit(machine.plane().q))) {
      return false;
    }
    if (!more) break;
    // GSK-G110-11: beyond the R plane under a reading.
    Fixed entry = last - pocket.clearance;
    const bool beyond = machine.follows("gsk.pocket.p-beyond=literal"_reading) !=
                        machine.has("clearance-unclamped"_fault);
    if (!beyond) entry = std::max<Fixed>(entry, 0);
    if (!machine.tracer.rapid_axis(d, pocket.site.r_plane + down * entry)) return false;
  }
  return true;
}

bool mill_pocket(Machine& machine, const Pocket& pocket) {
  if (!approach(machine, pocket.site)) return false;  // GSK-G110-06, 07
  if (!mill_layers(machine, pocket)) return false;    // GSK-G110-08 to 12
  if (machine.has("initial-plane-drifts"_fault)) machine.state.initial_plane = pocket.site.r_plane;
  // GSK-G110-13, GSK-G110-17; readings gsk.pocket.end, gsk.zero-depth-end.
  const bool may_stay =
      pocket.site.depth != 0 || machine.follows("gsk.zero-depth-end=r-plane"_reading);
  const bool stays = machine.follows("gsk.pocket.end=r-plane"_reading) && may_stay;
  if (stays || machine.has("ends-at-r-plane"_fault)) return true;
  return machine.tracer.rapid_axis(machine.plane().d, pocket.site.initial_plane);
}

}  // namespace

void prepare_pocket(Machine& machine, const Block& block, bool entering, bool mills, Plan& plan) {
  check_ranges(machine, block);
  take_pocket_words(machine, block);
  if (entering) check_modal_words(machine);
  Pocket pocket;
  if (machine.in_alarm() || !mills || !find_centre(machine, block, pocket.site, plan)) return;
  if (machine.has("late-alarm"_fault)) machine.tracer.rapid(pocket.site.centre, pocket.site.axes);
  prepare_milling(machine, block, pocket);
  plan = [&machine, pocket] { return mill_pocket(machine, pocket); };
}

}  // namespace gonogo::expanders::gsk
