// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo hunt: generated programs, led by what they exercise of the reference, against a subject.
// Each departure of a new kind is reduced and shown.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <limits>

#include "cli/commands.hpp"
#include "cli/hunt_causes.hpp"
#include "cli/hunt_words.hpp"
#include "cli/output.hpp"
#include "oracle/records/run_scope.hpp"

namespace gonogo::cli {
namespace {

using Clock = std::chrono::steady_clock;

// A line that is rewritten in place on a terminal; nothing in a pipe.
class HuntProgress {
 public:
  explicit HuntProgress(const HuntEnd& end) : end_(end), on_(::isatty(STDERR_FILENO) == 1) {}
  ~HuntProgress() { clear(); }
  void clear() const {
    if (on_) draw("\r\033[K");
  }
  void show(const hunt::Hunt& hunt, std::size_t findings) {
    if (!on_ || Clock::now() - shown_ < std::chrono::milliseconds(100)) return;
    shown_ = Clock::now();
    const hunt::HuntCount& count = hunt.count();
    draw("\r\033[K{} programs, {} % skipped, {} features, {} findings, about {:.0f} s left",
         count.programs, count.skipped * 100 / std::max<std::size_t>(1, count.programs),
         hunt.pool().features(), findings, end_.seconds_left(hunt.count().programs));
  }

 private:
  const HuntEnd& end_;
  bool on_;
  Clock::time_point shown_{};
};

// One line that shows the finding again.
std::string again(const HuntWords& words, const hunt::Finding& finding, const std::string& id) {
  if (id.empty() || !finding.reproducer.before.empty()) {
    return fmt::format("{} --programs {}", command_of(words), finding.program);
  }
  return reduce_command(fmt::format("{}/findings/{}", words.trial.out, id), words.trial);
}

struct HuntTally {
  std::size_t no_go = 0;
  std::size_t oracle_errors = 0;
  std::size_t known = 0;  // symptoms of what was known before
  bool complete = true;
  std::vector<hunt::Finding> told;  // as they came
  std::size_t findings() const { return no_go + oracle_errors; }
};

// Whether the finding is printed as one more symptom of what was known before.
bool take_known(const HuntBefore& before, const hunt::Finding& finding, HuntTally& tally) {
  const std::string cause = before.known_cause ? before.known_cause(finding) : std::string();
  if (cause.empty()) return false;
  ++tally.known;
  Output output;
  output.text() = fmt::format("known: {}, a new symptom of: {}\n", finding.signature.text(), cause);
  output.tell();
  return true;
}

void take(const HuntWords& words, const HuntBefore& before, hunt::Hunt& hunt,
          hunt::Finding& finding, HuntTally& tally) {
  hunt.reduce(finding, {});
  if (take_known(before, finding, tally)) return;
  const std::string id =
      keep_finding(words.trial, static_cast<std::uint64_t>(words.seed), hunt.trial(), finding);
  const bool is_error = finding.verdict.kind == oracle::VerdictKind::oracle_error;
  ++(is_error ? tally.oracle_errors : tally.no_go);
  Output output;
  output.text() = fmt::format("{}. {}{}\n", tally.findings(), finding.signature.text(),
                              id.empty() ? "" : "  " + id);
  output.text() += finding_text(finding, again(words, finding, id)) + "\n";
  output.tell();
  tally.told.push_back(finding);
}

std::string summary(const HuntWords& words, const hunt::Hunt& hunt, const HuntTally& tally,
                    const std::string& found) {
  const hunt::HuntCount& count = hunt.count();
  return fmt::format(
      "{}, {}: {} programs from seed {}, {} judged ({} with motion), {} skipped, {} undecided, {} "
      "too long{}; {} features of the reference in {} programs; {}{}{}\n",
      words.trial.subject, words.dialect, count.programs, words.seed, count.judged, count.moved,
      count.skipped, count.gaps, count.too_long,
      count.outside == 0 ? "" : fmt::format(", {} departures outside the domain", count.outside),
      hunt.pool().features(), hunt.pool().size(), found,
      tally.known == 0
          ? ""
          : ", " + oracle::counted(tally.known, "new symptom", "new symptoms") + " of known causes",
      tally.complete ? "" : "; the hunt is incomplete");
}

// What the subject skipped: also where it was little, for then the hunt knew what to leave out.
std::string skipped_text(hunt::Hunt& hunt, const std::string& dialect) {
  const hunt::HuntCount& count = hunt.count();
  std::string text;
  const std::string out = hunt.supported().left_out();
  if (!out.empty()) {
    text = fmt::format(
        "The subject skips programs with: {}\nThat nothing was found in them says nothing.\n", out);
  }
  if (judged_little(count)) {
    text += fmt::format(
        "Only {} of {} programs moved the subject and were judged. That nothing was found in the "
        "others says nothing: declare what the subject does (dialects and features of its answer "
        "to `start`), or draw programs that it runs (--settings, --profile).\n",
        count.moved, count.programs);
    if (!hunt.trial().info().declares(dialect, "basic")) {
      text += "The subject does not declare the feature basic, which every drawn program needs.\n";
    }
  }
  return text;
}

int hunt(const HuntWords& words) {
  if (words.method != "reference" && !words.known_failures.empty()) {
    throw UsageError("--known-failures is for --method reference, whose verdicts it names.");
  }
  if (words.known_failures.empty() && !words.corpus.empty()) {
    throw UsageError("--corpus is the corpus of --known-failures, which is not given.");
  }
  if (words.method == "operations") return hunt_operations(words);
  if (!words.beside.empty()) {
    throw UsageError("--beside is for --method operations, which compares subjects.");
  }
  if (words.campaign.empty() && (words.jobs != 1 || words.shard != "1/1")) {
    throw UsageError("--jobs and --shard are of a long hunt: give --campaign DIR too.");
  }
  if (words.method == "properties") return hunt_properties(words);
  if (!words.campaign.empty()) return hunt_campaign(words);
  return hunt_programs(words, {});
}

}  // namespace

hunt::HuntOptions hunt_options(const HuntWords& words) {
  hunt::HuntOptions options;
  const reference::Profile profile = load_profile({words.dialect, words.profile, words.readings});
  options.dialect = profile.dialect;
  options.seed = static_cast<std::uint64_t>(words.seed);
  if (!words.profile.empty()) options.profile = profile;
  options.readings = readings_of(words.readings);
  options.settings = settings_option(words.settings);
  options.everywhere = words.everywhere;
  return options;
}

int hunt_programs(HuntWords words, const HuntBefore& before) {
  hunt::HuntOptions options = hunt_options(words);
  words.dialect = options.dialect;
  know_failures(words, options);
  const HuntEnd end(words);
  hunt::Hunt hunt(trial_subject(words.trial), trial_options(words.trial), std::move(options));
  check_dialect(hunt.trial().info(), words.dialect);
  if (before.prepare) before.prepare(hunt);
  HuntTally tally;
  {
    HuntProgress progress(end);
    try {
      while (!end.reached(hunt.count().programs, tally.findings())) {
        std::optional<hunt::Finding> finding = hunt.step();
        if (finding) {
          progress.clear();
          take(words, before, hunt, *finding, tally);
        }
        progress.show(hunt, tally.findings());
      }
    } catch (const oracle::SubjectUnusable& error) {
      // It could be used at first.
      tally.complete = false;
      progress.clear();
      complain("gonogo: {}\n", error.what());
    }
  }
  Output output;
  hunt::HuntSummary grouped;
  if (!tally.told.empty()) {
    grouped = tell_findings(tally.told, hunt.pool(), words.trial);
    output.text() =
        "The findings by their causes, the gravest first:\n" + finding_list_text(grouped) + "\n";
  }
  output.text() +=
      summary(words, hunt, tally, findings_text(grouped)) + skipped_text(hunt, words.dialect);
  output.tell();
  if (tally.no_go > 0) return kNoGo;
  const bool undecided = tally.oracle_errors > 0 || !tally.complete || judged_little(hunt.count());
  return undecided ? kUndecided : kGo;
}

void add_hunt(Command& program) {
  auto words = std::make_shared<HuntWords>();
  Command command =
      program.add_command("hunt", "Look for programs on which a subject departs from the gauge");
  add_trial_options(command, words->trial);
  command.option("--dialect", words->dialect, "dialect of the programs");
  command.choice("--method", words->method, {"reference", "properties", "operations"},
                 "held against the reference, against the subject's own answers, or one list of "
                 "operations in every dialect (reference)");
  command.repeated_option("--beside", words->beside,
                          "a further subject that has to make the same path of operations");
  add_program_options(command, *words);
  constexpr long kMost = std::numeric_limits<long>::max();
  command.number("--seed", words->seed, 0, kMost, "the same seed tries the same programs (1)");
  command.number("--programs", words->programs, 1, kMost, "how many programs");
  command.number("--stop-after", words->stop_after, 1, kMost, "how many findings");
  add_known_failures(command, words->known_failures, words->corpus);
  command.option("--campaign", words->campaign,
                 "folder of a long hunt, which goes on where it was broken off");
  command.option("--shard", words->shard, "i/n: the campaign's rounds of machine i of n (1/1)");
  command.number("--jobs", words->jobs, 1, 1'000,
                 "subjects of a campaign that run side by side (1)");
  command.number("--round", words->round, 1, 1'000'000, "programs of a round of a campaign (2000)");
  command.run([words] {
    words->trial.limits.stated = stated_machine({words->dialect, words->profile, words->readings});
    return hunt(*words);
  });
}

}  // namespace gonogo::cli
