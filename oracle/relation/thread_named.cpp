// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/relation/thread_site.hpp"
#include "reference/gsk988ta/milling.hpp"
#include "reference/gsk988ta/thread_path.hpp"

namespace gonogo::relation {

using reference::ThreadMilling;
using reference::ThreadRunOut;

namespace {

// About the axis, by half a turn.
void turn_over(reference::Record& record, const ThreadMilling& thread) {
  const reference::PlaneAxes axes = reference::axes_of(thread.plane);
  record.to[axes.p] = thread.centre[0] * 2 - record.to[axes.p];
  record.to[axes.q] = thread.centre[1] * 2 - record.to[axes.q];
  record.centre = {thread.centre[0] * 2 - record.centre[0],
                   thread.centre[1] * 2 - record.centre[1]};
}

std::vector<reference::Record> named_path(const ThreadMilling& thread, const Position& from,
                                          bool is_turned) {
  reference::gsk988ta::MillingSite site;
  site.block = thread.block;
  site.plane = thread.plane;
  site.axes = reference::axes_of(thread.plane);
  site.centre = from;
  site.centre[site.axes.p] = thread.centre[0];
  site.centre[site.axes.q] = thread.centre[1];
  site.r_plane = thread.r_plane;
  site.bottom = thread.bottom;
  site.travel = thread.travel;
  site.feed = thread.feed;
  site.feed_mode = thread.feed_mode;
  std::vector<reference::Record> path;
  auto passes = thread_passes(site, thread);
  while (const reference::Record* record = passes.next()) {
    path.push_back(*record);
    if (is_turned) turn_over(path.back(), thread);
  }
  // The last one says where all axes are.
  Position end = from;
  for (const reference::Record& record : path) end = end_of(record, end);
  path.back().axes = reference::kEveryAxis;
  path.back().to = end;
  return path;
}

}  // namespace

std::vector<std::vector<reference::Record>> paths_of(const ThreadMilling& thread,
                                                     const Position& from, const Followed& way,
                                                     std::size_t most) {
  std::vector<std::vector<reference::Record>> paths;
  if (thread.passes() > Number(static_cast<std::int64_t>(most))) return paths;
  for (const ThreadRunOut one :
       {ThreadRunOut::polar, ThreadRunOut::radial, ThreadRunOut::tangent}) {
    if (thread.runout != ThreadRunOut::open && thread.runout != one) continue;
    ThreadMilling named = thread;
    named.runout = one;
    if (is_unfit(named, way, most) && !is_unfit(thread, way, most)) continue;
    for (const bool is_turned : {false, true}) paths.push_back(named_path(named, from, is_turned));
    if (thread.runout_length.sign() == 0) break;
  }
  return paths;
}

bool is_unfit(const ThreadMilling& thread, const Followed& way, std::size_t most) {
  const ThreadSite site(thread, way);
  const Number last = min(thread.passes(), static_cast<std::int64_t>(most));
  for (std::int64_t number = 1; number <= last; ++number) {
    if (site.is_unfit(number)) return true;
  }
  return false;
}

}  // namespace gonogo::relation
