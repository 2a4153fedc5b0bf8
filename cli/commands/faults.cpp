// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo faults: the kill matrix. Each planted fault of the built-in expanders is run through the
// corpus; one that no case finds is a hole in the corpus.
#include <fmt/format.h>

#include <map>
#include <set>

#include "cli/commands.hpp"
#include "cli/corpus_folder.hpp"
#include "cli/exit_code.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/subjects.hpp"
#include "expanders/registry.hpp"

namespace gonogo::cli {
namespace {

struct FaultsOptions {
  std::string corpus;
  bool list = false;
};

void append_list(std::string& out) {
  for (std::string_view name : expanders::names()) {
    for (const expanders::FaultDescription& fault : expanders::faults(name)) {
      out += fmt::format("{}+{}  [{}]\n    {}\n    models: {}\n", name, fault.name, fault.clause,
                         fault.what, fault.models);
    }
  }
}

// What the corpus says of one subject.
struct Kills {
  std::size_t cases = 0;
  std::string first;  // id of the first case that finds it
  std::set<std::string> verdicts;
};

Kills run(const oracle::Corpus& corpus, const std::string& spec) {
  oracle::CampaignOptions campaign;
  campaign.jobs = 2;
  Kills kills;
  auto note = [&](const std::string& id, oracle::VerdictKind kind) {
    if (decision(kind) != oracle::Decision::no_go) return;
    ++kills.cases;
    if (kills.first.empty() || id < kills.first) kills.first = id;
    kills.verdicts.emplace(name(kind));
  };
  std::map<std::string, oracle::OpenReadings> open;
  auto take = [&](const oracle::CaseResult& result) {
    note(result.id, result.verdict.kind);
    if (result.readings) open.emplace(result.id, *result.readings);
  };
  const oracle::SubjectMaker maker = subject_maker(spec, campaign.limits);
  campaign.dialects = declared_dialects(maker);
  run_campaign(corpus, campaign, maker, take, nullptr);
  oracle::ReadingTally tally;
  for (const auto& [id, readings] : open) {
    if (!tally.add(readings)) note(id, oracle::VerdictKind::fail_reading);
  }
  return kills;
}

int faults(const FaultsOptions& options) {
  Output output;
  if (options.list) {
    append_list(output.text());
    output.flush();
    return kGo;
  }
  const oracle::Corpus corpus(corpus_folder(options.corpus));
  std::size_t survivors = 0;
  std::size_t all = 0;
  for (std::string_view name : expanders::names()) {
    const Kills clean = run(corpus, fmt::format("builtin:{}", name));
    output.text() += fmt::format("{:<34} {:>6} cases find it  {}\n", name, clean.cases,
                                 clean.cases == 0 ? "(fault-free)" : "FALSE ALARM " + clean.first);
    survivors += clean.cases == 0 ? 0 : 1;
    for (const expanders::FaultDescription& fault : expanders::faults(name)) {
      const std::string spec = fmt::format("{}+{}", name, fault.name);
      const Kills kills = run(corpus, "builtin:" + spec);
      std::string verdicts;
      for (const std::string& verdict : kills.verdicts) verdicts += " " + verdict;
      output.text() += kills.cases == 0 ? fmt::format("{:<34} SURVIVES: {}\n", spec, fault.what)
                                        : fmt::format("{:<34} {:>6} cases, first {}{}\n", spec,
                                                      kills.cases, kills.first, verdicts);
      output.flush();
      survivors += kills.cases == 0 ? 1 : 0;
      ++all;
    }
  }
  output.text() +=
      fmt::format("{} planted faults, {} left alive or falsely found\n", all, survivors);
  output.flush();
  return survivors == 0 ? kGo : kNoGo;
}

}  // namespace

void add_faults(Command& program) {
  auto options = std::make_shared<FaultsOptions>();
  Command command =
      program.add_command("faults", "Run every planted fault through the corpus: the kill matrix");
  command.option("--corpus", options->corpus, "folder of the corpus (the checked-in one)");
  command.flag("--list", options->list, "only name the faults and what they do");
  command.run([options] { return faults(*options); });
}

}  // namespace gonogo::cli
