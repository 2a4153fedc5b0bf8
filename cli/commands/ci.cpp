// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo ci: the runs of a pipeline, a command each. `change` is for every push and ends in
// minutes, `batch` is for the night and goes on from its folder, `prune` keeps that folder small
// and true, `coverage` says what all of it reached.
#include <fmt/format.h>

#include <limits>
#include <memory>

#include "cli/certify_options.hpp"
#include "cli/ci_words.hpp"
#include "cli/commands.hpp"
#include "cli/hunt_causes.hpp"
#include "cli/output.hpp"
#include "fuzz/hunt/campaign_state.hpp"
#include "fuzz/hunt/finding_files.hpp"

namespace gonogo::cli {
namespace {

constexpr long kProgramsOfAChange = 5'000;
constexpr const char* kTimeOfABatch = "1h";

HuntWords hunt_words(const CiWords& words) {
  HuntWords hunt = words.hunt;
  hunt.trial.limits.stated = stated_machine({hunt.dialect, hunt.profile, hunt.readings});
  return hunt;
}

// What the nights found is where the hunt begins, and no news; what was mended is tried first, and
// is news where it comes back. How many findings that are known.
std::size_t begin_from(const std::string& campaign, const std::string& dialect, hunt::Hunt& hunt) {
  std::size_t known = 0;
  for (const std::string& shard : shards_in(campaign)) {
    const hunt::CampaignState state = state_for(shard, dialect);
    for (const generate::GeneratedProgram& program : hunt::read_inputs(shard, state)) {
      hunt.offer(program);
    }
    for (const auto& [signature, finding] : state.findings) {
      if (finding.stands()) {
        hunt.know(signature);
        ++known;
      } else {
        hunt.try_next(hunt::read_reproducer(shard + "/findings/" + finding.id, dialect).program);
      }
    }
  }
  return known;
}

// The departures of a campaign, if one is named, and other symptoms of what they come from.
HuntBefore what_is_known(const CiWords& words, const std::string& dialect) {
  if (words.hunt.campaign.empty()) return {};
  const auto mistakes = std::make_shared<KnownMistakes>(words.hunt.campaign, words.hunt.trial);
  HuntBefore before;
  before.prepare = [&words, dialect](hunt::Hunt& hunt) {
    const std::size_t known = begin_from(words.hunt.campaign, dialect, hunt);
    if (known == 0) return;
    Output output;
    output.text() =
        fmt::format("{}: {} departures that are known are no news\n", words.hunt.campaign, known);
    output.flush();
  };
  before.known_cause = [mistakes](const hunt::Finding& finding) {
    return mistakes->cause_of(finding);
  };
  return before;
}

// A NO-GO of one of them is one of both; what either could not decide is not decided.
int gravest(int one, int other) {
  if (one == kNoGo || other == kNoGo) return kNoGo;
  return one == kGo ? other : one;
}

int change(const CiWords& words) {
  HuntWords hunting = hunt_words(words);
  hunting.dialect = hunt_options(hunting).dialect;
  if (hunting.programs == 0) hunting.programs = kProgramsOfAChange;
  hunting.trial.out = words.report + "/found";
  if (!words.hunt.campaign.empty()) {  // before anything runs
    for (const std::string& shard : shards_in(words.hunt.campaign))
      state_for(shard, hunting.dialect);
  }
  const int judged = certify(certify_options(words));
  const int found = hunt_programs(hunting, what_is_known(words, hunting.dialect));
  return gravest(judged, found);
}

int batch(const CiWords& words) {
  HuntWords hunting = hunt_words(words);
  if (hunting.time.empty() && hunting.programs == 0) hunting.time = kTimeOfABatch;
  return hunt_campaign(hunting);
}

void add_subject(Command& command, CiWords& words) {
  add_tried_subject(command, words.hunt.trial);
  add_run_options(command, words.hunt.trial.limits);
}

void add_programs(Command& command, CiWords& words) {
  constexpr long kMost = std::numeric_limits<long>::max();
  command.option("--profile", words.hunt.profile, "the machine of every program; without: any");
  command.repeated_option("--reading", words.hunt.readings, "one reading as key=value");
  command.option("--settings", words.hunt.settings,
                 "what generated programs are like: valid=1,boundary=2,blocks=4");
  command.number("--seed", words.hunt.seed, 0, kMost, "the same seed tries the same programs (1)");
}

void add_change(Command& ci) {
  auto words = std::make_shared<CiWords>();
  Command command = ci.add_command(
      "change",
      "on every push: the corpus, and a short hunt that tries the same programs each time");
  add_subject(command, *words);
  command.option("--dialect", words->hunt.dialect, "dialect of cases and programs");
  command.option("--corpus", words->hunt.corpus, "folder of the corpus (the checked-in one)");
  command.option("--known-failures", words->hunt.known_failures,
                 "TOML file of cases that the subject is known to fail");
  command.option("--campaign", words->hunt.campaign,
                 "folder of the nights' hunt: its programs come first, its findings are no news");
  command.option("--report", words->report,
                 "folder for the report, and in found/ for what the hunt finds (report)");
  command.number("--programs", words->hunt.programs, 1, std::numeric_limits<long>::max(),
                 "programs of the hunt (5000)");
  command.number("--jobs", words->hunt.jobs, 1, 256,
                 "subjects that judge the corpus side by side (1)");
  add_programs(command, *words);
  command.run([words] { return change(*words); });
}

void add_batch(Command& ci) {
  auto words = std::make_shared<CiWords>();
  Command command =
      ci.add_command("batch", "in the night: the hunt goes on in its folder, for an hour");
  add_subject(command, *words);
  command.option("--dialect", words->hunt.dialect, "dialect of the programs");
  command.needed("--campaign", words->hunt.campaign, "folder of the hunt, which goes on there");
  add_known_failures(command, words->hunt.known_failures, words->hunt.corpus);
  command.option("--time", words->hunt.time, "how long: 90s, 10m, 2h (1h)");
  command.number("--programs", words->hunt.programs, 1, std::numeric_limits<long>::max(),
                 "how many programs, in place of a time");
  command.option("--shard", words->hunt.shard, "i/n: the rounds of machine i of n (1/1)");
  command.number("--jobs", words->hunt.jobs, 1, 1'000, "subjects that run side by side (1)");
  command.number("--round", words->hunt.round, 1, 1'000'000, "programs of a round (2000)");
  add_programs(command, *words);
  command.run([words] { return batch(*words); });
}

void add_prune(Command& ci) {
  auto words = std::make_shared<CiWords>();
  Command command = ci.add_command(
      "prune",
      "now and then: programs that show nothing of their own go, what is mended is marked");
  add_subject(command, *words);
  command.needed("--campaign", words->hunt.campaign, "folder of the hunt");
  command.option("--known-failures", words->hunt.known_failures,
                 "TOML file of cases that the subject is known to fail: it is pruned, too");
  command.option("--dialect", words->hunt.dialect, "only known failures of this dialect");
  command.option("--corpus", words->hunt.corpus,
                 "corpus of the known failures (the checked-in one)");
  command.run([words] { return ci_prune(*words); });
}

void add_coverage(Command& ci) {
  auto words = std::make_shared<CiWords>();
  Command command = ci.add_command(
      "coverage", "which clauses and features the programs reached, and what the subject answered");
  add_subject(command, *words);
  command.option("--dialect", words->hunt.dialect, "dialect of cases and programs");
  command.option("--campaign", words->hunt.campaign, "folder of a hunt, beside the corpus");
  command.option("--corpus", words->hunt.corpus, "folder of the corpus (the checked-in one)");
  command.option("--out", words->out, "the same as JSON, into this file");
  command.run([words] { return ci_coverage(*words); });
}

}  // namespace

CertifyOptions certify_options(const CiWords& words) {
  CertifyOptions options;
  options.subjects = {words.hunt.trial.subject};
  if (!words.hunt.dialect.empty()) options.dialects = {words.hunt.dialect};
  options.corpus = words.hunt.corpus;
  options.report = words.report;
  options.profile = words.hunt.profile;
  options.readings = words.hunt.readings;
  options.known_failures = words.hunt.known_failures;
  options.alarm_map = words.hunt.trial.alarm_map;
  options.limits = words.hunt.trial.limits;
  options.jobs = words.hunt.jobs;
  options.seed = words.hunt.seed;
  options.fresh = 0;  // the hunt is what draws programs here
  options.argv = arguments();
  return options;
}

void add_ci(Command& program) {
  Command command = program.add_command("ci", "What a pipeline runs, on a change and in the night");
  command.require_command();
  add_change(command);
  add_batch(command);
  add_prune(command);
  add_coverage(command);
}

}  // namespace gonogo::cli
