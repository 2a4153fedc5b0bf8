// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/open/free_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oracle/steps/step_text.hpp"
#include "reference/compared.hpp"

namespace gonogo::oracle {

using reference::kAllAxes;

bool turns_rotary_axis(const Position& from, const Position& to, const Number& tolerance) {
  return std::ranges::any_of(kAllAxes, [&](Axis axis) {
    return !reference::is_linear(axis) && !agree(from[axis], to[axis], tolerance);
  });
}

Verdict departure_from(VerdictKind kind, reference::ClauseId clause, std::uint64_t block,
                       const Motion& motion, std::string want, std::string message) {
  Verdict verdict = verdict_on(kind, motion.record, motion.number, std::move(message));
  verdict.clause = clause;
  verdict.block = block;
  verdict.want = std::move(want);
  if (kind == VerdictKind::fail_feed) {
    verdict.word = 'F';
  } else {
    verdict.witness = point_text(motion.to(), {Axis::x, Axis::y, Axis::z});
  }
  return verdict;
}

Verdict ended_elsewhere(reference::ClauseId clause, std::uint64_t block, const Motion& last,
                        const Position& due, std::string want, std::string message) {
  Verdict verdict = departure_from(VerdictKind::fail_geometry, clause, block, last, std::move(want),
                                   std::move(message));
  verdict.record = last.number + last.behind_first;
  try {
    set_deviation(verdict, largest_difference(last.to(), due));
  } catch (const exact::Undecided&) {
  }
  return verdict;
}

std::string turns_that_came(const Number& due, double missing) {
  const double whole = std::round(missing);
  if (whole < 1) return {};
  return reference::with_values(" It makes {} of {} turns.",
                                {due - Number(static_cast<std::int64_t>(whole)), due});
}

std::string feed_in_place_of(const reference::Record& got, const Number& feed,
                             reference::FeedMode mode, bool in_degrees) {
  return reference::with_values(fmt::format(" It is {{}} {} in place of {{}} {}.",
                                            reference::feed_unit(got.feed_mode, in_degrees),
                                            reference::feed_unit(mode, in_degrees)),
                                {got.feed, feed});
}

Verdict fault_of_step(VerdictKind kind, reference::ClauseId clause, std::uint64_t block,
                      std::string want, const Position& at, std::string message) {
  Verdict verdict;
  verdict.kind = kind;
  verdict.clause = clause;
  verdict.block = block;
  verdict.want = std::move(want);
  verdict.witness = point_text(at, {Axis::x, Axis::y, Axis::z});
  verdict.message = std::move(message);
  return verdict;
}

void add_finding(Verdict& verdict, const region::Finding& finding,
                 std::span<const region::LevelMotion> cuts, std::span<const Record> records) {
  const auto guilty = std::ranges::find(cuts, finding.record, &region::LevelMotion::record);
  const auto shown = guilty != cuts.end() || cuts.empty() ? guilty : std::prev(cuts.end());
  if (shown != cuts.end()) {
    verdict.record = shown->record;
    verdict.got = record_text(records[static_cast<std::size_t>(shown - cuts.begin())]);
  }
  set_deviation(verdict, finding.deviation);
}

void set_deviation(Verdict& verdict, const Number& deviation) {
  if (deviation.sign() == 0) return;
  verdict.deviation_exact = exact_text(deviation);
  verdict.deviation_mm = millimetres_text(deviation);
}

}  // namespace gonogo::oracle
