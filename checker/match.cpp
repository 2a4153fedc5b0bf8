// SPDX-License-Identifier: GPL-3.0-or-later
#include "checker/match.hpp"

#include <algorithm>

#include "checker/motion_match.hpp"
#include "checker/profile.hpp"

namespace gonogo::checker {
namespace {

std::string text(const Motion& motion) {
  return text(motion.record);
}

// Whether it is one of the names between blanks.
bool is_among(const std::string& name, const std::string& names) {
  return (" " + names + " ").find(" " + name + " ") != std::string::npos;
}

class Match {
 public:
  Match(const Vector& vector, const Expectation& expectation, const Trace& trace,
        const Tolerances& tolerances)
      : vector_(vector),
        expectation_(expectation),
        trace_(trace),
        tolerances_(tolerances),
        want_(make_path(expectation.records, path_terms(true))),
        got_(make_path(trace.records, path_terms(false))) {}

  Judgement find() {
    const bool is_alarm = expectation_.ending == Expectation::Ending::alarm;
    const bool at_load = is_alarm && alarms_at_load(vector_.profile) && got_.motions.empty() &&
                         trace_.ending != TraceEnd::end;
    if (at_load) {
      const Judgement alarm = find_alarm();
      return alarm.answer == Answer::fits ? find_functions(expectation_.any_of.front().block, true)
                                          : alarm;
    }
    if (Judgement path = follow(0, 0); path.answer != Answer::fits) return path;
    switch (expectation_.ending) {
      case Expectation::Ending::not_covered:
        return {};
      case Expectation::Ending::alarm:
        if (Judgement alarm = find_alarm(); alarm.answer != Answer::fits) return alarm;
        return find_functions(expectation_.any_of.front().block, false);
      case Expectation::Ending::end:
        return find_end();
    }
    return {};
  }

  bool is_doubtful() const {
    return want_.is_doubtful || got_.is_doubtful || want_.drops || got_.drops;
  }

 private:
  PathTolerances path_terms(bool wanted) const {
    PathTolerances tolerances{initial_position(vector_.profile), tolerances_.tolerance,
                              renaming_line(vector_.dialect, vector_.program)};
    tolerances.keeps_short_arcs = !wanted;
    if (wanted) {
      tolerances.is_open = [this](const Record& record) {
        return is_open_path(record, vector_.dialect, vector_.profile);
      };
    }
    return tolerances;
  }

  // At motion `at` of what must come.
  Judgement departure(std::size_t at, const std::string& why) const {
    const auto is_open = [&](std::size_t i) {
      return i < want_.motions.size() && want_.motions[i].is_open;
    };
    if (is_open(at) || (at > 0 && is_open(at - 1))) return {Answer::undecided, kOpenPath};
    if (want_.is_doubtful || got_.is_doubtful) {
      return {Answer::undecided, "how motions are dropped and joined"};
    }
    return {Answer::departs, why};
  }

  // Whether two motions to one end start beside each other by little more than the tolerance: each
  // side may have dropped motions before it that led as far as that.
  bool starts_nearby(std::size_t at, std::size_t next) const {
    if (at == want_.motions.size() || next == got_.motions.size()) return false;
    const Motion& want = want_.motions[at];
    const Motion& got = got_.motions[next];
    const Real near = Real(3) * tolerances_.tolerance;
    return agree(want.from, got.from, tolerances_.tolerance) != Truth::yes &&
           agree(want.from, got.from, near) != Truth::no &&
           agree(want.to, got.to, near) != Truth::no;
  }

  // A motion that one side may have dropped.
  bool is_short(const Motion& motion) const {
    return is_straight(motion) &&
           stays_by(motion, motion.from, Real(3) * tolerances_.tolerance) != Truth::no;
  }
  // Whether it ends about where the subject may be before motion `at` is done. Short motions that
  // lead away from there are not dropped.
  bool is_nearby(const Motion& motion, std::size_t at) const {
    const bool is_last = at == want_.motions.size();
    if (!is_last && !is_straight(want_.motions[at])) return true;
    const Real near = Real(3) * tolerances_.tolerance;
    const Position& from = is_last ? want_.end : want_.motions[at].from;
    const Position& to = is_last ? want_.end : want_.motions[at].to;
    Truth answer = Truth::yes;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (!from[axis] || !to[axis] || !motion.to[axis]) continue;
      const Real before = *motion.to[axis] - *from[axis];
      const Real behind = *motion.to[axis] - *to[axis];
      const Truth is_above = at_most(near, before) && at_most(near, behind);
      const Truth is_below = at_most(before, -near) && at_most(behind, -near);
      answer = answer && !is_above && !is_below;
    }
    return answer != Truth::no;
  }
  static bool is_straight(const Motion& motion) {
    return motion.record.kind != RecordKind::dwell && motion.record.kind != RecordKind::arc;
  }

  // Whether nothing may be left of what must come: it is short, or the subject stands at its end,
  // where motions that it made and that were dropped have led.
  bool may_be_done(std::size_t at, std::size_t next) const {
    const Motion& want = want_.motions[at];
    if (is_short(want)) return true;
    return is_straight(want) && next < got_.motions.size() &&
           agree(got_.motions[next].from, want.to, tolerances_.tolerance) != Truth::no;
  }

  // An arc so short that its ends agree: where nothing of it is wanted it is a nil motion.
  bool is_short_arc(const Motion& motion) const {
    const long turns = motion.record.rotation;
    return motion.record.kind == RecordKind::arc && (turns == 1 || turns == -1) &&
           agree(motion.from, motion.to, tolerances_.tolerance) == Truth::yes;
  }
  // Whether it goes the long way round, or a whole turn in so many words.
  static bool may_go_round(const Motion& arc) {
    const Plane& plane = arc.record.plane;
    if (!arc.from[plane.first] || !arc.from[plane.second]) return true;
    const Real side = cross(plane, arc.record.centre, arc.from, arc.to);
    return (arc.record.rotation < 0 ? -side : side).is_positive() != Truth::yes;
  }

  // From motion `at` of what must come and motion `next` of the subject on.
  Judgement follow(std::size_t at, std::size_t next) {
    std::optional<MotionMatch> current;
    for (; next < got_.motions.size(); ++next) {
      const Motion& got = got_.motions[next];
      if (at == want_.motions.size()) {
        if (expectation_.ending == Expectation::Ending::not_covered) return {};
        return without_short(at, next, departure(at, "One motion too many: " + text(got) + "."));
      }
      const Motion& want = want_.motions[at];
      if (!current) current.emplace(want, tolerances_);
      const StepAnswer step = current->take(got);
      if (step.step == Step::undecided) return {Answer::undecided, step.why};
      if (step.step == Step::departs) {
        const std::string where = "Record " + std::to_string(got.place) + ", " + step.why + ": ";
        return without_short(at, next,
                             departure(at, where + text(got) + " for " + text(want) + "."));
      }
      if (step.step == Step::part) continue;
      ++at;
      current.reset();
    }
    if (at == want_.motions.size()) return {};
    return without_short(at, next,
                         departure(at, "This motion is missing: " + text(want_.motions[at]) + "."));
  }

  // A motion about as short as the tolerance may have been dropped by one side and kept by the
  // other. Where the departure is gone without such motions, whether it is one is open.
  Judgement without_short(std::size_t at, std::size_t next, Judgement departure) {
    if (departure.answer != Answer::departs) return departure;
    const Judgement unknown{Answer::undecided, "a motion about as short as the tolerance"};
    if (tries_ == 0 || starts_nearby(at, next)) return unknown;
    --tries_;
    if (at < want_.motions.size() && may_be_done(at, next) &&
        follow(at + 1, next).answer != Answer::departs) {
      return unknown;
    }
    if (next == got_.motions.size()) return departure;
    const Motion& got = got_.motions[next];
    const bool is_arc = is_short_arc(got);
    if (!is_arc && !(is_short(got) && is_nearby(got, at))) return departure;
    const Judgement rest = follow(at, next + 1);
    if (rest.answer == Answer::departs) return departure;
    return is_arc && !may_go_round(got) ? rest : unknown;
  }

  Judgement find_alarm() const {
    std::string wanted;
    for (const ExpectedAlarm& alarm : expectation_.any_of) {
      wanted += " " + alarm.kind + " in line " + std::to_string(alarm.block);
    }
    if (trace_.ending == TraceEnd::unknown) return {Answer::undecided, "the alarm is not kept"};
    if (trace_.ending == TraceEnd::end)
      return {Answer::departs, "The alarm is missing:" + wanted + "."};
    if (trace_.end) return {Answer::departs, "The alarm follows the end of the trace."};
    if (trace_.alarm.kind.empty()) return {Answer::undecided, "an alarm without a class"};
    const bool is_right = std::ranges::any_of(expectation_.any_of, [&](const auto& alarm) {
      return is_among(alarm.kind, trace_.alarm.kind) &&
             (!tolerances_.has_blocks || alarm.block == trace_.alarm.block);
    });
    if (is_right) return {};
    return {Answer::departs, "The alarm is " + trace_.alarm.kind + " in line " +
                                 std::to_string(trace_.alarm.block) + " for" + wanted + "."};
  }

  Judgement find_end() const {
    if (trace_.ending == TraceEnd::unknown) return {Answer::undecided, "the ending is not kept"};
    if (trace_.ending == TraceEnd::alarm) {
      return {Answer::departs, "There is an alarm, " + trace_.alarm.kind + ", and none must come."};
    }
    if (trace_.end) {
      const Truth ends = agree(expectation_.end, *trace_.end, tolerances_.tolerance);
      if (ends == Truth::no) {
        return {Answer::departs, "The end is at " + checker::text(*trace_.end) + ", not at " +
                                     checker::text(expectation_.end) + "."};
      }
      if (ends == Truth::unknown) return {Answer::undecided, "the end may differ"};
    }
    return find_functions(0, false);
  }

  // The M functions in their order; those that the line of an alarm says may come or not. Without
  // lines they may be the last ones. At load the first of them will do.
  Judgement find_functions(long alarm_block, bool at_load) const {
    if (!tolerances_.has_functions) return {};
    // A program without an end alarms in its last line, whose functions have run (NGC-COM-08).
    std::vector<Record> want = want_.functions;
    std::erase_if(want,
                  [&](const Record& due) { return alarm_block != 0 && due.block == alarm_block; });
    std::vector<Record> told;
    for (const Record& function : got_.functions) {
      // A cycle has some of its own: where its alarm comes late, they are among the records before.
      const bool is_due_there = std::ranges::any_of(want_.functions, [&](const Record& due) {
        return due.block == alarm_block && due.m == function.m;
      });
      const bool is_of_line =
          is_due_there || says_m_function(vector_.program, alarm_block, function.m);
      const bool may_be_of_alarm = alarm_block != 0 && is_of_line &&
                                   (tolerances_.has_blocks ? function.block == alarm_block
                                                           : told.size() == want.size() || at_load);
      if (!may_be_of_alarm) told.push_back(function);
    }
    if (at_load && told.size() < want.size()) want.resize(told.size());
    const bool same = std::ranges::equal(want, told, [&](const auto& x, const auto& y) {
      return x.m == y.m && (!tolerances_.has_blocks || x.block == y.block);
    });
    if (same) return find_places();
    return {Answer::departs, "The M functions are not " + list(want) + " but " + list(told) + "."};
  }

  // An M function stands before or after the motions of its block, not among those of another.
  // Whether it may stand elsewhere than where it is due is left open here.
  Judgement find_places() const {
    const bool as_due = got_.behind == want_.behind && !got_.joins_over_function;
    if (as_due || got_.motions.empty()) return {};
    const Judgement unknown{Answer::undecided, "the place of an M function in its block"};
    if (!tolerances_.has_blocks) return unknown;
    for (std::size_t i = 0; i < got_.functions.size(); ++i) {
      const long block = got_.functions[i].block;
      for (std::size_t k = 0; k < got_.motions.size(); ++k) {
        const long other = got_.motions[k].record.block;
        const bool in_order = k < got_.behind[i] ? other <= block : other >= block;
        if (!in_order) {
          return {Answer::departs, "An M function of line " + std::to_string(block) +
                                       " stands among the motions of line " +
                                       std::to_string(other) + "."};
        }
      }
    }
    return unknown;
  }

  static std::string list(const std::vector<Record>& functions) {
    std::string all;
    for (const Record& function : functions) {
      if (!all.empty()) all += ", ";
      all += checker::text(function);
    }
    return all.empty() ? "none" : all;
  }

  const Vector& vector_;
  const Expectation& expectation_;
  const Trace& trace_;
  const Tolerances& tolerances_;
  Path want_;
  Path got_;
  int tries_ = 64;
};

}  // namespace

Judgement match(const Vector& vector, const Expectation& expectation, const Trace& trace,
                const Tolerances& tolerances) {
  Match made(vector, expectation, trace, tolerances);
  Judgement finding = made.find();
  finding.is_doubtful = made.is_doubtful();
  return finding;
}

}  // namespace gonogo::checker
