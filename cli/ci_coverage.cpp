// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/ci_words.hpp"
#include "cli/exit_code.hpp"
#include "cli/named_files.hpp"
#include "cli/output.hpp"
#include "cli/program_file.hpp"
#include "corpus/io/corpus.hpp"
#include "fuzz/hunt/finding_files.hpp"
#include "fuzz/hunt/reach.hpp"
#include "oracle/records/output_file.hpp"

namespace gonogo::cli {
namespace {

void add_corpus_programs(const CiWords& words, hunt::Trial& trial, hunt::Reach& reach) {
  const oracle::Corpus corpus(corpus_folder(words.hunt.corpus));
  oracle::CaseReader reader(corpus, oracle::Detail::whole, {words.hunt.dialect});
  while (const auto test = reader.next()) {
    for (const std::string& clause : test->clauses) reach.add_about(clause);
    const generate::GeneratedProgram program{test->profile, test->program};
    reach.add(hunt::ProgramSource::corpus, program, trial.run(program), test->features);
  }
}

// The programs that showed something new, and those of the findings.
void add_campaign_programs(const CiWords& words, hunt::Trial& trial, hunt::Reach& reach) {
  if (words.hunt.campaign.empty()) return;
  for (const std::string& shard : shards_in(words.hunt.campaign)) {
    const hunt::CampaignState state = state_for(shard, words.hunt.dialect);
    for (const generate::GeneratedProgram& program : hunt::read_inputs(shard, state)) {
      reach.add(hunt::ProgramSource::campaign, program, trial.run(program));
    }
    for (const auto& [signature, finding] : state.findings) {
      const hunt::Reproducer reproducer =
          hunt::read_reproducer(shard + "/findings/" + finding.id, state.dialect);
      reach.add(hunt::ProgramSource::campaign, reproducer.program, trial.run_alone(reproducer));
    }
  }
}

}  // namespace

int ci_coverage(const CiWords& asked) {
  CiWords words = asked;
  words.hunt.dialect = load_profile({words.hunt.dialect, "", {}}).dialect;
  hunt::Trial trial(trial_subject(words.hunt.trial), trial_options(words.hunt.trial));
  hunt::Reach reach(words.hunt.dialect);
  add_corpus_programs(words, trial, reach);
  add_campaign_programs(words, trial, reach);
  if (!words.out.empty()) oracle::write_file(words.out, reach.json(words.hunt.trial.subject));
  Output output;
  output.text() = reach.text();
  output.tell();
  return reach.programs().judged == 0 ? kUndecided : kGo;
}

}  // namespace gonogo::cli
