// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/captured_samples.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

#include "capture/noise_watch.hpp"
#include "capture/sample_thinner.hpp"
#include "oracle/judge/mismatch.hpp"
#include "oracle/steps/step_text.hpp"

namespace gonogo::oracle {

// One judgement: runs over the file until an answer holds with all that the arithmetic left unsure.
class CapturedSamples::Judging {
 public:
  Judging(const CapturedSamples& samples, const reference::Profile& profile,
          const ProgramText& program, const Tolerances& tolerances, const RunEnd& end)
      : samples_(samples),
        profile_(profile),
        program_(program),
        tolerances_(tolerances),
        end_(end),
        sampled_(samples.sampled_) {
    Number tau = profile.resolution();
    if (tolerances.resolution) tau = min(tau, *tolerances.resolution);
    tolerances_.tolerance = tau + tolerances.granted;
    tolerances_.compare_blocks = true;
    tolerances_.compare_m = false;
  }

  SampledVerdict judge();

 private:
  // What is said at the tolerance in force.
  SampledVerdict judge_here();
  // The least tolerance at which it would be GO, in steps of 1e-4 mm; nothing up to 1 mm.
  std::optional<Number> go_from();
  bool go_at(const Number& tolerance);
  // What NO-GO means where the tolerance is finer than the samples are, or X a diameter.
  void explain(Verdict& verdict, const Number& noise, const std::optional<Number>& go_from);
  bool go_with_half_x();
  bool has_hole() const { return quick(longest_) > sampled_.longest_interval; }
  std::vector<std::string> drawn_samples(const Verdict& verdict) const;
  std::unique_ptr<SampledRun> run(bool strict, double way_factor);
  SampledVerdict complete(const SampledRun& run) const;
  SampledVerdict departed(const SampledRun& run) const;
  // What a judge of records says of the end when the samples are those of so many pieces.
  Verdict judge_end(const SampledRun& run) const;

  const CapturedSamples& samples_;
  const reference::Profile& profile_;
  ProgramText program_;
  Tolerances tolerances_;
  const RunEnd& end_;
  Sample last_;
  reference::AxisSet seen_;
  double following_ = 0;
  WorstSample worst_;
  Number longest_ = 0;  // s, between two samples of the program
  SampledTolerances sampled_;
};

namespace {

// Where motions after the end are put.
constexpr std::uint64_t kAfterAllBlocks = std::numeric_limits<std::uint32_t>::max();

// Steps of 1e-4 mm, upward.
Number upward(double value) {
  constexpr double kSteps = 1e4;
  return Number::millionths(100 * static_cast<std::int64_t>(std::ceil(value * kSteps - 1e-6)));
}

}  // namespace

std::unique_ptr<SampledRun> CapturedSamples::Judging::run(bool strict, double way_factor) {
  SampleReader reader(samples_.path_, sampled_.columns);
  seen_ = reader.axes();
  auto run = std::make_unique<SampledRun>(profile_, program_, tolerances_, sampled_, seen_, strict,
                                          way_factor);
  NoiseWatch noise;
  Sample sample;
  while (reader.next(sample)) {
    last_ = sample;
    if (!run->take(sample)) break;
    noise.add(SamplePoint(sample), quick(sample.time), run->off());
  }
  run->finish(reader.ends_in_hole());
  following_ = noise.figures().following;
  return run;
}

bool CapturedSamples::Judging::go_at(const Number& tolerance) {
  const Number kept = std::exchange(tolerances_.tolerance, tolerance);
  const Verdict verdict = judge_here().verdict;
  tolerances_.tolerance = kept;
  // No tolerance fills a hole, or makes a stand shorter.
  return decision(verdict.kind) == Decision::go || verdict.gap == GapReason::samples_hole ||
         verdict.gap == GapReason::samples_stand;
}

std::optional<Number> CapturedSamples::Judging::go_from() {
  const Number step = Number::millionths(100);
  std::int64_t low = (tolerances_.tolerance / step).floor().to_int64().value_or(0);
  std::int64_t high = std::max<std::int64_t>(2 * low, 1);
  constexpr std::int64_t kMost = 10'000;
  while (!go_at(step * high)) {
    low = high;
    if (high == kMost) return std::nullopt;
    high = std::min(2 * high, kMost);
  }
  while (high - low > 1) {
    const std::int64_t half = (low + high) / 2;
    (go_at(step * half) ? high : low) = half;
  }
  return step * high;
}

SampledVerdict CapturedSamples::Judging::judge() {
  SampledVerdict said = judge_here();
  if (!tolerances_.measure) return said;
  auto figures = std::make_shared<SampledFigures>();
  figures->samples = sampled_.samples;
  figures->tolerance = tolerances_.tolerance.text();
  const VerdictKind kind = said.verdict.kind;
  if (decision(kind) == Decision::go) {
    figures->worst = worst_.deviation.text();
    figures->worst_at = worst_.sample;
    figures->worst_block = worst_.block;
  }
  const bool of_the_path = kind == VerdictKind::fail_geometry || kind == VerdictKind::fail_order ||
                           kind == VerdictKind::fail_overrun;
  const Number noise = upward(sampled_.noise);
  figures->noise = noise.text();
  figures->following = upward(following_).text();
  figures->longest = longest_.text();
  figures->unseen = upward(approximate(sampled_.fastest) * quick(longest_) / 2).text();
  if (of_the_path) {
    const std::optional<Number> from = go_from();
    if (from) figures->go_from = from->text();
    explain(said.verdict, noise, from);
  }
  if (decision(kind) != Decision::go) figures->drawn = drawn_samples(said.verdict);
  said.verdict.sampled = std::move(figures);
  return said;
}

// A machine that goes twice as far and one whose log says diameters look the same in one
// file: it stays NO-GO, and the sentence says what to look at.
bool CapturedSamples::Judging::go_with_half_x() {
  if (!seen_.has(reference::Axis::x)) return false;
  sampled_.x_scale = Number(1) / Number(2);
  const bool is_go = decision(judge_here().verdict.kind) == Decision::go;
  sampled_.x_scale = 1;
  return is_go;
}

void CapturedSamples::Judging::explain(Verdict& verdict, const Number& noise,
                                       const std::optional<Number>& go_from) {
  if (!go_from) {
    if (go_with_half_x()) {
      verdict.message +=
          " With half of X it is GO: is the column a diameter? Then say so with --columns, as "
          "x=NAME:diameter.";
    }
    return;
  }
  const std::string least =
      fmt::format("GO from {} mm up{}.", go_from->text(), has_hole() ? ", but for the hole" : "");
  // J-RUN-11.
  constexpr int kPeak = 3;  // times the noise: what scatters like it comes as far as that
  const bool too_fine = tolerances_.tolerance * 3 < noise * 2 && *go_from <= noise * kPeak;
  if (!too_fine) {
    verdict.message += " " + least;
    return;
  }
  Verdict open = gap_verdict(
      GapReason::samples_scatter,
      fmt::format("The samples scatter by {} mm, more than the tolerance of {} mm, which they "
                  "therefore cannot be held to. {} Say which tolerance counts with --tolerance.",
                  noise.text(), tolerances_.tolerance.text(), least));
  open.want = verdict.want;
  open.got = verdict.got;
  open.block = verdict.block;
  open.record = verdict.record;
  open.clause = verdict.clause;
  open.witness = verdict.witness;
  open.deviation_exact = verdict.deviation_exact;
  open.deviation_mm = verdict.deviation_mm;
  verdict = std::move(open);
}

// Those of the program's own lines that a drawing needs, and the one that the verdict speaks of.
std::vector<std::string> CapturedSamples::Judging::drawn_samples(const Verdict& verdict) const {
  SampleReader reader(samples_.path_, sampled_.columns);
  SampleThinner thinner(seen_, sampled_.header_lines, verdict.record);
  Sample sample;
  while (reader.next(sample)) thinner.add(sample);
  return thinner.finish();
}

SampledVerdict CapturedSamples::Judging::judge_here() {
  constexpr double kTwice = 2;
  const auto sure = run(true, 1);
  worst_ = sure->worst();
  longest_ = max(longest_, sure->holes().longest());
  if (!sure->departure()) return complete(*sure);
  const auto doubtful = run(false, 1);
  if (!doubtful->departure()) {
    if (doubtful->feed_fault()) return {*doubtful->feed_fault(), doubtful->progress()};
    return {gap_verdict(GapReason::comparison,
                        "A sample lies too close to the tolerance of an arc to say."),
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
  if (run.open()) return {*run.open(), run.progress()};
  Verdict verdict = judge_end(run);
  if (decision(verdict.kind) == Decision::go) {
    verdict.kind = VerdictKind::pass_tolerance;
    verdict.message = run.summary();
    // Those of the reference's own motions, which stand for the samples here.
    verdict.coordinates.reset();
    verdict.property_motions = 0;
    if (run.not_shown() != GapReason::none) {
      verdict = gap_verdict(run.not_shown(), std::move(verdict.message));
    }
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
  Tolerances tolerances = tolerances_;
  tolerances.compare_blocks = end_.kind != RunEnd::Kind::alarm || end_.alarm.block != 0;
  // A control that has moved did not check at load.
  reference::Profile profile = profile_;
  if (run.moved()) profile.alarm_timing = reference::AlarmTiming::block;
  ProgramJudge judge(profile, program_, tolerances);
  const bool whole = run.at_end() || run.left_end();
  const std::size_t pieces = whole ? std::numeric_limits<std::size_t>::max() : run.progress();
  SampledPath::replay(profile_, program_, tolerances_, pieces, judge);
  if (run.left_end()) {
    Record beyond;
    beyond.kind = RecordKind::feed;
    beyond.axes = reference::kEveryAxis;
    beyond.to = run.last();
    beyond.block = kAfterAllBlocks;
    judge.record(beyond);
  }
  Verdict verdict = judge.finish(end_);
  if (verdict.block == kAfterAllBlocks) verdict.block = 0;  // of no line of the program
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

CapturedSamples::CapturedSamples(std::string path, SampledTolerances sampled)
    : path_(std::move(path)), sampled_(std::move(sampled)) {}

SampledVerdict CapturedSamples::judge(const reference::Profile& profile, const ProgramText& program,
                                      const Tolerances& tolerances, const RunEnd& end) const {
  try {
    return Judging(*this, profile, program, tolerances, end).judge();
  } catch (const exact::Undecided& undecided) {
    return {undecided_verdict(undecided), 0};
  } catch (const SampleFault& fault) {
    Verdict verdict;
    verdict.kind = VerdictKind::protocol;
    verdict.message = fault.what();
    return {std::move(verdict), 0};
  }
}

RunEnd check_samples(const std::string& path, SampledTolerances& sampled) {
  SampleReader reader(path, sampled.columns);
  Sample sample;
  NoiseWatch noise;
  SampleRhythm rhythm;
  sampled.samples = 0;
  for (; reader.next(sample); ++sampled.samples) {
    rhythm.add(quick(sample.time));
    noise.add(SamplePoint(sample), quick(sample.time), 0);
  }
  if (sampled.samples == 0) throw SampleFault(fmt::format("{}: There is no sample.", path));
  sampled.time_decimals = reader.time_decimals();
  sampled.noise = noise.figures().noise;
  sampled.usual_interval = rhythm.usual();
  sampled.longest_interval = rhythm.limit(0.5 * std::pow(10.0, -sampled.time_decimals));
  RunEnd end;
  if (reader.alarm()) {
    end.kind = RunEnd::Kind::alarm;
    end.alarm = *reader.alarm();
  }
  return end;
}

}  // namespace gonogo::oracle
