// SPDX-License-Identifier: GPL-3.0-or-later
//
// G112 and G113, the circular pocket: milled along a helix, clockwise and counterclockwise.
#include "reference/clause_literal.hpp"
#include "reference/geometry/kernel.hpp"
#include "reference/gsk988ta/milling.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::reference::gsk988ta {
namespace {

// GSK-G112-04 to GSK-G112-06, from the centre back to the centre. The semicircles leave and meet
// the circle of radius I - D tangentially and turn as commanded (GSK-G112-09); they lie on +p.
Generator<Item> mill_along_helix(const MillingSite& site, const HelixPocket& pocket) {
  const geometry::Pair& centre = pocket.centre;
  const geometry::Point_2 tangential =
      geometry::point(centre) + geometry::Vector_2(pocket.radius, 0);
  const geometry::Pair side = geometry::pair(tangential);
  const geometry::Pair middle = geometry::pair(CGAL::midpoint(geometry::point(centre), tangential));
  co_yield site.arc_to("GSK-G112-04"_clause, side, middle, pocket.sense);

  Record helix = site.arc_to("GSK-G112-05"_clause, side, centre, pocket.sense * pocket.turns);
  helix.axes.add(site.axes.d);
  helix.to[site.axes.d] = pocket.bottom;
  co_yield helix;
  if (pocket.flat) co_yield site.arc_to("GSK-G112-05"_clause, side, centre, pocket.sense);

  co_yield site.arc_to("GSK-G112-06"_clause, centre, middle, pocket.sense);
}

Generator<Item> mill(MillingSite site, HelixPocket pocket, bool open_side, bool feeds_back) {
  if (!site.positioned.empty()) {
    co_yield site.rapid_to_centre("GSK-G112-03"_clause, site.positioned);
  }
  co_yield site.rapid_depth("GSK-G112-03"_clause, site.r_plane);
  if (site.depth().sign() == 0) {
    // GSK-G110-17: no depth, no cut.
    co_yield site.rapid_depth("GSK-G110-17"_clause, site.initial_plane);
    co_return;
  }
  if (open_side) {
    co_yield pocket;
  } else {
    Generator<Item> path = mill_along_helix(site, pocket);
    while (const Item* item = path.next()) co_yield *item;
  }
  co_yield site.return_at(feeds_back, "GSK-G112-07"_clause);
}

// GSK-G112-01: L of the block, or the one that the mode retains; 1 without it.
Number pocket_turns_of(const BlockContext& block) {
  if (block.words.has('L')) return block.words.written('L');
  const std::optional<Number>& retained = block.machine.milling.turns;
  return retained && block.readings.is("gsk.helix.L=modal"_reading) ? *retained : Number(1);
}

HelixPocket make_helix_pocket(BlockContext& block, const MillingSite& site) {
  const MillingMode& mode = block.machine.milling;
  HelixPocket pocket;
  pocket.block = block.line;
  pocket.clause = "GSK-G112-04"_clause;
  pocket.plane = site.plane;
  pocket.centre = site.plane_centre();
  pocket.r_plane = site.r_plane;
  pocket.bottom = site.bottom;
  pocket.radius = mode.radius.value() - mode.tool.value();
  pocket.turns = static_cast<std::int32_t>(pocket_turns_of(block).to_int64().value());
  pocket.sense = sense_of(mode.code);
  pocket.flat = block.readings.is("gsk.helix.flat=on"_reading);
  pocket.feed = site.feed;  // GSK-G112-08: along the helix
  pocket.feed_mode = site.feed_mode;
  return pocket;
}

}  // namespace

// GSK-MOD-02: the entry block and every block that mills need both.
void latch_g112(BlockContext& block, bool mills) {
  latch_pocket_words(block);
  if (!is_entry(block) && !mills) return;
  const MillingMode& mode = block.machine.milling;
  const std::array<NeededWord, 2> needed = {{{'I', mode.radius}, {'D', mode.tool}}};
  check_needed(block, needed, mills, "GSK-G112-01"_clause, "GSK-G110-16"_clause);
}

void run_g112(BlockContext& block) {
  const bool mills = names_site(block);
  latch_g112(block, mills);
  if (!mills) {
    position_only(block);  // GSK-G110-14
    return;
  }
  check_tool_radius(block, "GSK-G112-02"_clause);
  const MillingSite site = place_site(block, r_of_pocket(block));
  check_direction(block, site, "GSK-G112-10"_clause);
  check_depth(block, site);
  if (!block.out.alarms.empty()) return;

  name_planes(block, site);
  const bool cuts = site.depth().sign() != 0;
  Position& position = block.machine.position;
  position = site.centre;
  position[site.axes.d] = site.initial_plane;
  // The side of the entry is open unless a reading names one.
  const bool any = cuts && block.readings.is("gsk.helix.entry-side=any"_reading);
  HelixPocket pocket = cuts ? make_helix_pocket(block, site) : HelixPocket{};
  const bool feeds_back = cuts && block.readings.is("gsk.helix.return=feed"_reading);
  block.out.cycle =
      mill(site, std::move(pocket), any && block.open_paths == OpenPaths::judged, feeds_back);
}

}  // namespace gonogo::reference::gsk988ta
