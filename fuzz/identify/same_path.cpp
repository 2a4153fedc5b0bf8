// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/identify/same_path.hpp"

#include "oracle/motion/motion.hpp"

namespace gonogo::identify {

using oracle::agree;
using oracle::Motion;
using oracle::RunEnd;
using reference::RecordKind;

namespace {

std::vector<Motion> motions_of(const KeptOutcome& outcome, reference::Position at,
                               const oracle::Number& tolerance) {
  std::vector<Motion> motions;
  for (const Record& record : outcome.records) {
    if (!is_motion(record.kind) && record.kind != RecordKind::dwell) continue;
    Motion motion = oracle::motion_from(at, record, 0);
    if (record.kind == RecordKind::dwell) {
      motion.record.to = at;
      if (record.seconds.sign() == 0) continue;
    } else if (agree(motion.from, motion.to(), tolerance) && !goes_round(motion, tolerance)) {
      continue;
    }
    at = motion.to();
    const bool joins = !motions.empty() && is_motion(record.kind) &&
                       is_motion(motions.back().record.kind) && join(motions.back(), motion);
    if (!joins) motions.push_back(std::move(motion));
  }
  return motions;
}

bool same_motion(const Motion& a, const Motion& b, const oracle::Tolerances& tolerances) {
  const Record& x = a.record;
  const Record& y = b.record;
  if (x.kind != y.kind || !agree(a.to(), b.to(), tolerances.tolerance)) return false;
  if (tolerances.compare_blocks && x.block != y.block) return false;
  const oracle::Number fine =
      tolerances.feed_resolution ? *tolerances.feed_resolution : oracle::Number::millionths(1);
  if (x.feed_mode != y.feed_mode || !agree(x.feed, y.feed, fine)) return false;
  if (!agree(x.lead, y.lead, tolerances.tolerance) || !agree(x.seconds, y.seconds, fine))
    return false;
  if (x.kind != RecordKind::arc) return true;
  return x.plane == y.plane && x.rot == y.rot &&
         agree(x.centre[0], y.centre[0], tolerances.tolerance) &&
         agree(x.centre[1], y.centre[1], tolerances.tolerance);
}

bool same_end(const RunEnd& model, const RunEnd& subject) {
  if (model.kind != subject.kind) return false;
  if (model.kind != RunEnd::Kind::alarm) return true;
  return model.alarm.block == subject.alarm.block &&
         reference::share_a_name(model.alarm.alarm_class, subject.alarm.alarm_class);
}

}  // namespace

bool same_path(const KeptOutcome& model, const KeptOutcome& subject,
               const reference::Position& start, const oracle::Tolerances& tolerances) {
  if (!same_end(model.end, subject.end)) return false;
  try {
    const std::vector<Motion> a = motions_of(model, start, tolerances.tolerance);
    const std::vector<Motion> b = motions_of(subject, start, tolerances.tolerance);
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (!same_motion(a[i], b[i], tolerances)) return false;
    }
    return true;
  } catch (const exact::Undecided&) {
    return false;
  }
}

}  // namespace gonogo::identify
