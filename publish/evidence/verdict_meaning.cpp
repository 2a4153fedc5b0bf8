// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/verdict_meaning.hpp"

#include <algorithm>
#include <array>

namespace gonogo::oracle::evidence {
namespace {

using Kind = VerdictKind;

struct Meaning {
  VerdictKind kind;
  std::string_view text;
};
constexpr auto kMeanings = std::to_array<Meaning>({
    {Kind::pass_exact, "The path is exactly that of the reference."},
    {Kind::pass_rounded, "Every end and centre is the correctly rounded value."},
    {Kind::pass_tolerance, "The path agrees with the reference within the tolerance."},
    {Kind::pass_properties,
     "The manual leaves the path open, and the path has every property that it asks for."},
    {Kind::xfail, "The case fails."},
    {Kind::skip, "The subject does not have what the case needs."},
    {Kind::advice, "The subject departs from what no text states: our judgement alone."},
    {Kind::fail_geometry, "A motion, dwell or M function is not that of the reference."},
    {Kind::fail_order, "Motions, dwells or M functions come in another order."},
    {Kind::fail_feed, "Only a feed, a lead or the time of a dwell differs."},
    {Kind::fail_region,
     "The clearing of a pocket breaks a rule: it gouges, leaves material, steps too wide or turns "
     "the wrong way."},
    {Kind::fail_reading,
     "No single combination of the open readings explains all cases that pass."},
    {Kind::fail_overrun,
     "There is motion after the end, or far more of it than the reference has."},
    {Kind::fail_alarm_missing, "The program had to alarm and did not."},
    {Kind::fail_alarm_spurious, "The subject alarms where the reference does not."},
    {Kind::fail_alarm_class, "The alarm is of another class."},
    {Kind::fail_alarm_late, "The alarm comes in a later block, or after motion of its own."},
    {Kind::fail_declaration, "The subject declares what the case needs, and skips it."},
    {Kind::state_leak, "The same program gave another answer in a fresh process."},
    {Kind::crash, "The subject died or said that it failed."},
    {Kind::timeout, "The subject did not answer in time."},
    {Kind::out_of_memory, "The subject went above its memory limit."},
    {Kind::protocol, "The subject's answer is not what the protocol allows."},
    {Kind::unmapped_alarm, "The subject's alarm is in no alarm map."},
    {Kind::xpass, "The case is known to fail, but it passes: the known-failures file is stale."},
    {Kind::oracle_gap, "The gauge cannot say."},
    {Kind::oracle_error, "The gauge itself failed."},
});

}  // namespace

std::string_view meaning_of(VerdictKind kind) {
  return std::ranges::find(kMeanings, kind, &Meaning::kind)->text;
}

}  // namespace gonogo::oracle::evidence
