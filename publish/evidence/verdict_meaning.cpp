// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/verdict_meaning.hpp"

namespace gonogo::oracle::evidence {
namespace {

std::string_view meaning_of_go(VerdictKind kind) {
  switch (kind) {
    case VerdictKind::pass_exact:
      return "The path is exactly that of the reference.";
    case VerdictKind::pass_rounded:
      return "Every end and centre is the correctly rounded value.";
    case VerdictKind::pass_tolerance:
      return "The path agrees with the reference within the tolerance.";
    case VerdictKind::pass_properties:
      return "The manual leaves the path open, and the path has every property that it asks for.";
    default:
      return "The case fails as the known-failures file says.";
  }
}

std::string_view meaning_of_failure(VerdictKind kind) {
  switch (kind) {
    case VerdictKind::fail_geometry:
      return "A motion, dwell or M function is not that of the reference.";
    case VerdictKind::fail_order:
      return "Motions, dwells or M functions come in another order.";
    case VerdictKind::fail_feed:
      return "Only a feed, a lead or the time of a dwell differs.";
    case VerdictKind::fail_region:
      return "The clearing of a pocket breaks a rule: it gouges, leaves material, steps too wide "
             "or turns the wrong way.";
    case VerdictKind::fail_reading:
      return "No single combination of the open readings explains all cases that pass.";
    case VerdictKind::fail_overrun:
      return "There is motion after the end, or far more of it than the reference has.";
    case VerdictKind::fail_alarm_missing:
      return "The program had to alarm and did not.";
    case VerdictKind::fail_alarm_spurious:
      return "The subject alarms where the reference does not.";
    case VerdictKind::fail_alarm_class:
      return "The alarm is of another class.";
    case VerdictKind::fail_alarm_late:
      return "The alarm comes in a later block, or after motion of its own.";
    case VerdictKind::fail_declaration:
      return "The subject declares what the case needs, and skips it.";
    default:
      return "The case fails.";
  }
}

}  // namespace

std::string_view meaning_of(VerdictKind kind) {
  if (decision(kind) == Decision::go) return meaning_of_go(kind);
  switch (kind) {
    case VerdictKind::skip:
      return "The subject does not have what the case needs.";
    case VerdictKind::advice:
      return "The subject departs from what no text states: our judgement alone.";
    case VerdictKind::state_leak:
      return "The same program gave another answer in a fresh process.";
    case VerdictKind::crash:
      return "The subject died or said that it failed.";
    case VerdictKind::timeout:
      return "The subject did not answer in time.";
    case VerdictKind::out_of_memory:
      return "The subject went above its memory limit.";
    case VerdictKind::protocol:
      return "The subject's answer is not what the protocol allows.";
    case VerdictKind::unmapped_alarm:
      return "The subject's alarm is in no alarm map.";
    case VerdictKind::xpass:
      return "The case is known to fail, but it passes: the known-failures file is stale.";
    case VerdictKind::oracle_gap:
      return "The gauge cannot say.";
    case VerdictKind::oracle_error:
      return "The gauge itself failed.";
    default:
      return meaning_of_failure(kind);
  }
}

}  // namespace gonogo::oracle::evidence
