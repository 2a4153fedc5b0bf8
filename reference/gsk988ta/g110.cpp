// SPDX-License-Identifier: GPL-3.0-or-later
//
// G110 and G111, the circular pocket: roughed layer by layer, clockwise and counterclockwise.
#include <fmt/format.h>

#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/gsk988ta/milling.hpp"
#include "reference/gsk988ta/pocket_paths.hpp"
#include "reference/predicate.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::reference::gsk988ta {
namespace {

// Everything that the motions of one pocket need; mm as true lengths.
struct Pocket {
  MillingSite site;
  PocketLevel level;  // of every layer; `depth` is filled in layer by layer
  Number infeed;      // Q; the whole depth where Q is 0
  Number clearance;   // abs(P)
  bool stays_below_r_plane = true;
  bool ends_at_initial_plane = true;
  bool open_path = true;    // judged by what it clears
  bool concentric = false;  // of the two given paths

  Number end_depth() const { return ends_at_initial_plane ? site.initial_plane : site.r_plane; }
};

// The depth of a layer: k Q below the R plane, the last one at the bottom.
Number layer_depth(const Pocket& pocket, const Number& k) {
  const MillingSite& site = pocket.site;
  return site.below_r_plane(min(k * pocket.infeed, site.depth()));
}

// GSK-G110-11: abs(P) above layer k; beyond the R plane only under a reading.
Number approach_depth(const Pocket& pocket, const Number& k) {
  const Number last = k * pocket.infeed;
  const bool ends_at_r_plane = pocket.stays_below_r_plane && pocket.clearance > last;
  return pocket.site.below_r_plane(ends_at_r_plane ? 0 : last - pocket.clearance);
}

Generator<Item> mill(Pocket pocket) {
  const MillingSite& site = pocket.site;
  const AxisSet plane_axes = {site.axes.p, site.axes.q};
  // GSK-CYC-02: from the centre.
  if (!site.positioned.empty()) {
    co_yield site.rapid_to_centre("GSK-G110-06"_clause, site.positioned);
  }
  co_yield site.rapid_depth("GSK-G110-07"_clause, site.r_plane);
  if (site.depth().sign() == 0) {
    // GSK-G110-17: no depth, no cut.
    if (pocket.ends_at_initial_plane) {
      co_yield site.rapid_depth("GSK-G110-17"_clause, site.initial_plane);
    }
    co_return;
  }
  const Number layers = (site.depth() / pocket.infeed).ceil();
  for (Number k = 1; k <= layers; k += 1) {  // GSK-G110-12
    const Number depth = layer_depth(pocket, k);
    if (k > 1) {
      co_yield site.rapid_depth("GSK-G110-11"_clause, approach_depth(pocket, k - 1));
    }
    co_yield site.feed_depth(k > 1 ? "GSK-G110-11"_clause : "GSK-G110-08"_clause, depth);
    pocket.level.depth = depth;
    if (pocket.open_path) {
      co_yield pocket.level;
    } else {
      Generator<Record> path =
          pocket.concentric ? concentric_circles(pocket.level) : semicircles(pocket.level);
      while (const Record* record = path.next()) co_yield *record;
    }
    co_yield site.rapid_depth("GSK-G110-10"_clause, site.r_plane);
    co_yield site.rapid_to_centre("GSK-G110-10"_clause, plane_axes);
  }
  if (pocket.ends_at_initial_plane) {
    co_yield site.rapid_depth("GSK-G110-13"_clause, site.initial_plane);
  }
}

// GSK-G110-03: equality is an alarm in both.
void check_tool(BlockContext& block) {
  check_tool_radius(block, "GSK-G110-03"_clause);
  const MillingMode& mode = block.machine.milling;
  if (mode.step && mode.tool &&
      decided("GSK-G110-03"_clause, "L - 2 D", *mode.step, *mode.tool * 2) >= 0) {
    block.alarm(AlarmClass::step_too_large, "GSK-G110-03"_clause, 'L',
                with_values("The step of {} mm is not smaller than the tool's diameter of {} mm.",
                            {*mode.step, *mode.tool * 2}));
  }
}

// abs(P); GSK-MOD-03: P holds for its block.
std::optional<Number> clearance_of(const BlockContext& block) {
  const bool modal = block.readings.is("gsk.pocket.R=modal"_reading);
  const std::optional<Number> clearance =
      modal ? block.machine.milling.retained_clearance : block.words.length('P');
  return clearance ? std::optional(abs(*clearance)) : std::nullopt;
}

// GSK-G110-11: asked where a P that is given leads beyond the R plane, which is above the first
// layer if at all. A clearance of the control's own ends there.
void take_clearance(const BlockContext& block, Pocket& pocket) {
  const std::optional<Number> given = clearance_of(block);
  pocket.clearance = given ? *given : block.readings.length("gsk.pocket.p-omitted"_key);
  if (!given || pocket.site.depth() <= pocket.infeed || *given <= pocket.infeed) return;
  pocket.stays_below_r_plane = block.readings.is("gsk.pocket.p-beyond=r-plane"_reading);
}

// GSK-G110-13; GSK-G110-17 for a pocket without depth.
bool ends_at_initial_plane(const BlockContext& block, const MillingSite& site) {
  if (block.readings.is("gsk.pocket.end=initial"_reading)) return true;
  return site.depth().sign() == 0 && block.readings.is("gsk.zero-depth-end=initial"_reading);
}

Pocket make_pocket(BlockContext& block, MillingSite site) {
  const Machine& machine = block.machine;
  const MillingMode& mode = machine.milling;
  Pocket pocket;
  PocketLevel& level = pocket.level;
  level.block = block.line;
  level.clause = "GSK-G110-09"_clause;
  level.plane = machine.plane;
  level.centre = site.plane_centre();
  level.pocket_radius = mode.radius.value_or(0);
  level.tool_radius = mode.tool.value_or(0);
  level.step = mode.step.value_or(0);
  level.sense = sense_of(mode.code);
  level.feed = machine.feed;
  level.feed_mode = machine.feed_mode;
  pocket.infeed = mode.infeed.value_or(0);
  if (pocket.infeed.sign() == 0) pocket.infeed = site.depth();  // GSK-G110-20
  // GSK-G110-09: the path is open unless a reading names one.
  const bool any = block.readings.is("gsk.pocket.path=any"_reading);
  pocket.open_path = any && block.open_paths == OpenPaths::judged;
  pocket.concentric = block.readings.is("gsk.pocket.path=concentric"_reading);
  pocket.ends_at_initial_plane = ends_at_initial_plane(block, site);
  pocket.site = std::move(site);
  take_clearance(block, pocket);
  return pocket;
}

}  // namespace

// GSK-MOD-02: the entry block and every block that mills need all four.
void latch_g110(BlockContext& block, bool mills) {
  latch_pocket_words(block);
  if (!is_entry(block) && !mills) return;
  const MillingMode& mode = block.machine.milling;
  const std::array<NeededWord, 4> needed = {
      {{'I', mode.radius},
       {'L', mode.step},
       {'Q', mode.infeed, "GSK-G110-20"_clause, "gsk.pocket.q-zero=one-layer"_reading},
       {'D', mode.tool}}};
  check_needed(block, needed, mills, "GSK-G110-02"_clause, "GSK-G110-16"_clause);
}

void run_g110(BlockContext& block) {
  const bool mills = names_site(block);
  latch_g110(block, mills);
  if (!mills) {
    position_only(block);  // GSK-G110-14
    return;
  }
  check_tool(block);
  const MillingSite site = place_site(block, r_of_pocket(block));
  check_direction(block, site, "GSK-G110-04"_clause);
  check_depth(block, site);
  Pocket pocket = make_pocket(block, site);
  if (!block.out.alarms.empty()) return;
  name_planes(block, site);

  Position& position = block.machine.position;
  position = site.centre;
  position[site.axes.d] = pocket.end_depth();
  block.out.cycle = mill(std::move(pocket));
}

}  // namespace gonogo::reference::gsk988ta
