// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/capture/captured_samples.hpp"

#include <fmt/format.h>

#include <limits>

#include "oracle/judge/step_text.hpp"

namespace gonogo::oracle {

// One judgement: runs over the file until an answer holds whatever the arithmetic left unsure.
class CapturedSamples::Judging {
 public:
  Judging(const CapturedSamples& samples, const reference::Profile& profile,
          const ProgramText& program, const JudgeTerms& terms, const RunEnd& end)
      : samples_(samples), profile_(profile), program_(program), terms_(terms), end_(end) {
    Number tau = profile.resolution();
    if (terms.resolution) tau = min(tau, *terms.resolution);
    terms_.tolerance = tau + terms.granted;
    terms_.compare_blocks = true;
    terms_.compare_m = false;
  }

  SampledVerdict judge();

 private:
  std::unique_ptr<SampledRun> run(bool strict, double patience) const;
  SampledVerdict complete(const SampledRun& run) const;
  SampledVerdict departed(const SampledRun& run) const;
  // What a judge of records says of the end when the samples are those of so many pieces.
  Verdict judge_end(const SampledRun& run) const;

  const CapturedSamples& samples_;
  const reference::Profile& profile_;
  ProgramText program_;
  JudgeTerms terms_;
  const RunEnd& end_;
  mutable Sample last_;
  mutable reference::AxisSet seen_;
};

namespace {

Verdict gap(std::string message) {
  Verdict verdict;
  verdict.kind = VerdictKind::oracle_gap;
  verdict.message = std::move(message);
  return verdict;
}

}  // namespace

std::unique_ptr<SampledRun> CapturedSamples::Judging::run(bool strict, double patience) const {
  SampleReader reader(samples_.path_);
  seen_ = reader.axes();
  auto run = std::make_unique<SampledRun>(profile_, program_, terms_, samples_.sampled_, seen_,
                                          strict, patience);
  Sample sample;
  while (reader.next(sample)) {
    last_ = sample;
    if (!run->take(sample)) break;
  }
  run->finish();
  return run;
}

SampledVerdict CapturedSamples::Judging::judge() {
  constexpr double kTwice = 2;
  const auto sure = run(true, 1);
  if (!sure->departure()) return complete(*sure);
  const auto doubtful = run(false, 1);
  if (!doubtful->departure()) {
    if (doubtful->feed_fault()) return {*doubtful->feed_fault(), doubtful->progress()};
    return {gap("A sample lies too close to the tolerance of an arc to say."),
            doubtful->progress()};
  }
  if (doubtful->feed_fault()) return {*doubtful->feed_fault(), doubtful->progress()};
  // A corner may be missed because the machine is too fast: then its feed says so.
  const auto fast = run(false, kTwice);
  if (fast->feed_fault() && fast->progress() > doubtful->progress()) {
    return {*fast->feed_fault(), fast->progress()};
  }
  return departed(*doubtful);
}

SampledVerdict CapturedSamples::Judging::complete(const SampledRun& run) const {
  if (run.feed_fault()) return {*run.feed_fault(), run.progress()};
  if (!run.open().empty()) return {gap(run.open()), run.progress()};
  Verdict verdict = judge_end(run);
  if (decision(verdict.kind) == Decision::go) {
    verdict.kind = run.unseen() ? VerdictKind::oracle_gap : VerdictKind::pass_tolerance;
    verdict.message = run.summary();
  }
  return {std::move(verdict), run.progress()};
}

// Motion after the end is that of an alarm that did not stop the machine, where one was due.
SampledVerdict CapturedSamples::Judging::departed(const SampledRun& run) const {
  if (run.left_end()) {
    Verdict verdict = judge_end(run);
    if (decision(verdict.kind) != Decision::go) {
      verdict.record = run.departure()->record;
      verdict.got = run.departure()->got;
      verdict.witness = run.departure()->witness;
      return {std::move(verdict), run.progress()};
    }
  }
  return {*run.departure(), run.progress()};
}

Verdict CapturedSamples::Judging::judge_end(const SampledRun& run) const {
  JudgeTerms terms = terms_;
  terms.compare_blocks = end_.kind != RunEnd::Kind::alarm || end_.alarm.block != 0;
  // A control that has moved did not check at load.
  reference::Profile profile = profile_;
  if (run.moved()) profile.alarm_timing = reference::AlarmTiming::block;
  ProgramJudge judge(profile, program_, terms);
  const bool whole = run.at_end() || run.left_end();
  const std::size_t pieces = whole ? std::numeric_limits<std::size_t>::max() : run.progress();
  SampledPath::replay(profile_, program_, terms_, pieces, judge);
  if (run.left_end()) {
    Record beyond;
    beyond.kind = RecordKind::feed;
    beyond.axes = reference::kEveryAxis;
    beyond.to = run.last();
    beyond.block = std::numeric_limits<std::uint32_t>::max();  // after all blocks
    judge.record(beyond);
  }
  Verdict verdict = judge.finish(end_);
  if (decision(verdict.kind) == Decision::no_go && !whole) {
    verdict.record = last_.number;
    if (end_.kind == RunEnd::Kind::ok) {
      verdict.got = sample_text(last_, seen_);
      verdict.message = "The samples end before this motion is done.";
    }
    verdict.witness = point_text(run.last(), seen_);
  }
  return verdict;
}

CapturedSamples::CapturedSamples(std::string path, SampledTerms sampled)
    : path_(std::move(path)), sampled_(std::move(sampled)) {}

SampledVerdict CapturedSamples::judge(const reference::Profile& profile, const ProgramText& program,
                                      const JudgeTerms& terms, const RunEnd& end) const {
  try {
    return Judging(*this, profile, program, terms, end).judge();
  } catch (const exact::Undecided& undecided) {
    return {gap(fmt::format("A comparison could not be decided: {}.", undecided.what())), 0};
  } catch (const SampleFault& fault) {
    Verdict verdict;
    verdict.kind = VerdictKind::protocol;
    verdict.message = fault.what();
    return {std::move(verdict), 0};
  }
}

RunEnd check_samples(const std::string& path, SampledTerms& sampled) {
  SampleReader reader(path);
  Sample sample;
  std::size_t count = 0;
  while (reader.next(sample)) ++count;
  if (count == 0) throw SampleFault(fmt::format("{}: There is no sample.", path));
  sampled.time_decimals = reader.time_decimals();
  RunEnd end;
  if (reader.alarm()) {
    end.kind = RunEnd::Kind::alarm;
    end.alarm = *reader.alarm();
  }
  return end;
}

}  // namespace gonogo::oracle
