// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/advice.hpp"

namespace gonogo::oracle {

namespace {

// J-ALM-03: a crash, a broken protocol, an alarm without a class, ... is one whatever a text says.
bool is_of_meaning(VerdictKind kind) {
  switch (kind) {
    case VerdictKind::fail_geometry:
    case VerdictKind::fail_order:
    case VerdictKind::fail_feed:
    case VerdictKind::fail_region:
    case VerdictKind::fail_overrun:
    case VerdictKind::fail_alarm_missing:
    case VerdictKind::fail_alarm_spurious:
    case VerdictKind::fail_alarm_class:
    case VerdictKind::fail_alarm_late:
      return true;
    default:
      return false;
  }
}

}  // namespace

bool is_advice(const Verdict& departure, const JudgeTerms& terms) {
  if (terms.strict || departure.clause == reference::kNoClause) return false;
  return is_of_meaning(departure.kind) &&
         reference::clause(departure.clause).basis() == reference::Basis::silent;
}

Verdict advised(Verdict departure, const JudgeTerms& terms) {
  if (!is_advice(departure, terms)) return departure;
  departure.departure = departure.kind;
  departure.kind = VerdictKind::advice;
  return departure;
}

}  // namespace gonogo::oracle
