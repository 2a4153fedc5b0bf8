// SPDX-License-Identifier: GPL-3.0-or-later
//
// G92, the thread cutting cycle: straight and taper. The path of G90 with a thread in place of the
// cut. Its run-out follows the acceleration of the drives, so a program that has one is not
// covered.
#include <fmt/format.h>

#include "reference/clause_literal.hpp"
#include "reference/gsk988ta/cutting_cycle.hpp"
#include "reference/predicate.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::reference::gsk988ta {
namespace {

// GSK-G92-06: the lead in force.
Number lead_of(const BlockContext& block) {
  const Machine& machine = block.machine;
  return block.readings.is("gsk.g92.lead=own"_reading) ? machine.thread_lead : machine.feed;
}

// GSK-G92-13: the inch thread, the face thread, more than one start, and a shifted start angle.
bool has_other_form(BlockContext& block) {
  if (block.words.has('I')) {
    block.not_covered(92, 'I',
                      "G92 with the word I (threads to the inch) is a form of the code that the "
                      "gauge does not read.");
    return true;
  }
  struct Form {
    char address;
    int usual;
    std::string_view what;
  };
  for (const Form& form : {Form{'P', 0, "the kind of thread"}, Form{'L', 1, "the number of starts"},
                           Form{'Q', 0, "the start angle"}}) {
    if (!block.words.has(form.address)) continue;
    if (block.words.written(form.address) == Number(form.usual)) continue;
    block.not_covered(92, form.address,
                      fmt::format("G92 with the word {} other than {} ({}) is a form of the code "
                                  "that the gauge does not read.",
                                  form.address, form.usual, form.what));
    return true;
  }
  return false;
}

// GSK-G92-07: J along the short axis and K along the long one; where neither was given, parameter
// 5130 in tenths of the lead.
bool has_run_out(BlockContext& block, bool runs) {
  bool given = false;
  for (char address : {'J', 'K'}) {
    if (!block.words.has(address)) continue;
    given = true;
    if (block.words.written(address).sign() == 0) continue;
    block.not_covered(92, address,
                      fmt::format("G92 with the run-out word {} above 0: the path of the run-out "
                                  "follows the drives, and the gauge does not read it.",
                                  address));
    return true;
  }
  if (given) block.machine.thread_run_out_off = true;
  const Number parameter = block.profile.parameter("5130").value_or(0);
  if (!runs || block.machine.thread_run_out_off || parameter.sign() == 0) return false;
  block.not_covered(92, 'J',
                    "G92 without J and K runs out by parameter 5130: the path of the run-out "
                    "follows the drives, and the gauge does not read it.");
  return true;
}

}  // namespace

void run_g92(BlockContext& block) {
  const PlaneAxes plane = axes_of(block.machine.plane);
  const CuttingAxes axes{plane.q, plane.p};  // GSK-G92-01
  refuse_other_axes(block, axes, "GSK-G92-08"_clause);
  retain_cut_words(block, axes);  // GSK-G92-06
  if (has_other_form(block)) return;
  const bool runs = runs_cut(block, axes);  // GSK-G92-12
  if (has_run_out(block, runs) || !runs) return;

  const Number lead = lead_of(block);
  if (decided("GSK-G92-03"_clause, "F", lead) <= 0) {
    block.alarm(AlarmClass::lead_missing, "GSK-G92-03"_clause, 'F',
                "The block cuts a thread, but no lead is in force.");
  }
  const Position a = block.machine.position;
  const Number c_p = cut_end_point(block, plane.p);
  const Number c_q = cut_end_point(block, plane.q);
  check_taper(block, c_q - a[plane.q], "GSK-G92-09"_clause);

  name_corners(block, axes, {c_p, c_q});
  // GSK-G92-10: all motions are those of this block.
  block.rapid("GSK-G92-02"_clause, {{plane.q, c_q + block.machine.cut.taper}});
  Record thread =
      block.motion(RecordKind::thread, "GSK-G92-03"_clause, {{plane.p, c_p}, {plane.q, c_q}});
  thread.lead = lead;
  block.put(std::move(thread));
  block.rapid("GSK-G92-04"_clause, {{plane.q, a[plane.q]}});
  block.rapid("GSK-G92-05"_clause, {{plane.p, a[plane.p]}});
}

}  // namespace gonogo::reference::gsk988ta
