// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo faults: each planted fault of the built-in expanders is run through the corpus; one that
// no case finds is a hole in the corpus. With --matrix: what it costs each method to find it.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "cli/commands.hpp"
#include "cli/named_files.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/program_file.hpp"
#include "cli/subjects.hpp"
#include "expanders/registry.hpp"
#include "fuzz/hunt/kill_matrix.hpp"

namespace gonogo::cli {
namespace {

struct FaultsOptions {
  std::string corpus;
  bool list = false;
  bool matrix = false;
  bool only_field_defects = false;
  bool fail_fast = false;
  std::string methods = "corpus,hunt";
  std::string format = "text";
  std::string only;
  std::string judge = "right";
  long seed = 1;
  long most_seconds = 60;
};

void append_list(std::string& out) {
  for (std::string_view name : expanders::names()) {
    for (const expanders::FaultDescription& fault : expanders::faults(name)) {
      out += fmt::format("{}+{}  [{}]\n    {}\n    models: {}\n", name, fault.name, fault.clause,
                         fault.what, fault.models);
      if (!fault.report.empty()) out += fmt::format("    report: {}\n", fault.report);
    }
  }
}

// What the corpus says of one subject, with a clause its cases of that clause alone; with
// fail_fast, up to the first case that finds it.
struct Kills {
  std::size_t cases = 0;
  std::string first;  // id of the first case that finds it
  std::set<std::string> verdicts;
};

Kills run(const oracle::Corpus& corpus, const std::string& spec, bool fail_fast,
          const std::string& clause = "") {
  oracle::CampaignOptions campaign;
  if (!clause.empty()) campaign.clauses = {clause};
  campaign.jobs = 2;
  campaign.fail_fast = fail_fast;
  Kills kills;
  auto note = [&](const std::string& id, oracle::VerdictKind kind) {
    // A fault may be planted where no text says anything.
    const bool departs =
        decision(kind) == oracle::Decision::no_go || kind == oracle::VerdictKind::advice;
    if (!departs) return;
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
    if (tally.add(id, readings)) note(id, oracle::VerdictKind::fail_reading);
  }
  return kills;
}

// The cases of the clause that the fault breaks find it soonest.
Kills first_kill(const oracle::Corpus& corpus, const std::string& spec, std::string_view clause) {
  const Kills kills = run(corpus, spec, true, std::string(clause));
  return kills.cases != 0 ? kills : run(corpus, spec, true);
}

// "corpus,hunt"
std::vector<hunt::Method> methods_of(const std::string& text) {
  std::vector<hunt::Method> methods;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    const std::optional<hunt::Method> method = hunt::method_named(word);
    if (!method) {
      throw UsageError(fmt::format(
          "There is no method \"{}\". Write some of: corpus,properties,operations,hunt,fuzz.",
          word));
    }
    if (std::ranges::find(methods, *method) == methods.end()) methods.push_back(*method);
    begin = end + 1;
  }
  return methods;
}

// The expander's name with that fault, as a target. `sound` and what it captures are of the
// expander.
hunt::MatrixTarget target_of(std::string_view expander, const expanders::FaultDescription& fault,
                             hunt::MatrixTarget sound) {
  hunt::MatrixTarget target = std::move(sound);
  target.name = fmt::format("{}+{}", expander, fault.name);
  target.clause = fault.clause;
  target.what = fault.what;
  target.report = fault.report;
  target.make = subject_maker("builtin:" + target.name, {});
  target.reached_count = [expander, name = fault.name] {
    return expanders::count(expander, name).value().reached;
  };
  return target;
}

// The expanders without a fault and with each of theirs; those that the options ask for.
std::vector<hunt::MatrixTarget> targets_of(const FaultsOptions& options) {
  std::vector<hunt::MatrixTarget> targets;
  for (std::string_view name : expanders::names()) {
    const oracle::SubjectMaker sound = subject_maker(fmt::format("builtin:{}", name), {});
    const std::vector<std::string> dialects = declared_dialects(sound);
    std::vector<oracle::SubjectMaker> peers;
    for (std::string_view other : expanders::names()) {
      if (other != name) peers.push_back(subject_maker(fmt::format("builtin:{}", other), {}));
    }
    const hunt::MatrixTarget clean = {std::string(name), "", dialects, sound, sound, peers};
    const bool is_whole = options.only.empty() || options.only == name;
    if (is_whole && !options.only_field_defects) targets.push_back(clean);
    for (const expanders::FaultDescription& fault : expanders::faults(name)) {
      if (options.only_field_defects && fault.report.empty()) continue;
      hunt::MatrixTarget target = target_of(name, fault, clean);
      if (target.name.find(options.only) != std::string::npos) targets.push_back(std::move(target));
    }
  }
  if (targets.empty()) {
    throw UsageError(
        fmt::format("No such fault's name holds \"{}\"; --list names them.", options.only));
  }
  return targets;
}

int matrix(const FaultsOptions& options) {
  hunt::MatrixOptions bench;
  bench.methods = methods_of(options.methods);
  bench.seed = static_cast<std::uint64_t>(options.seed);
  bench.most_seconds = static_cast<double>(options.most_seconds);
  bench.blind = options.judge == "always-go";
  std::optional<oracle::Corpus> corpus;
  if (std::ranges::find(bench.methods, hunt::Method::corpus) != bench.methods.end()) {
    bench.corpus = &corpus.emplace(corpus_folder(options.corpus));
  }
  const bool is_markdown = options.format == "markdown";
  std::vector<hunt::MatrixRow> rows;
  Output output(is_markdown ? 2 : 1);
  for (const hunt::MatrixTarget& target : targets_of(options)) {
    rows.push_back(hunt::matrix_row(target, bench));
    output.text() += hunt::row_text(rows.back());
    output.flush();
  }
  const std::vector<std::string> wrong = hunt::complaints(rows, bench.methods);
  for (const hunt::Method method : bench.methods) {
    output.text() += fmt::format("{}: {}\n", name(method), summary_text(rows, method));
  }
  for (const std::string& sentence : wrong) output.text() += sentence + "\n";
  output.flush();
  if (is_markdown) {
    Output document;
    document.text() = options.only_field_defects ? hunt::field_defects_markdown(rows, bench.methods)
                                                 : hunt::matrix_markdown(rows, bench.methods);
    document.flush();
  }
  return wrong.empty() ? kGo : kNoGo;
}

int faults(const FaultsOptions& options) {
  if (options.matrix) return matrix(options);
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
    const Kills clean = run(corpus, fmt::format("builtin:{}", name), false);
    output.text() += fmt::format("{:<34} {:>6} cases find it  {}\n", name, clean.cases,
                                 clean.cases == 0 ? "(fault-free)" : "FALSE ALARM " + clean.first);
    survivors += clean.cases == 0 ? 0 : 1;
    for (const expanders::FaultDescription& fault : expanders::faults(name)) {
      const std::string spec = fmt::format("{}+{}", name, fault.name);
      const std::string subject = "builtin:" + spec;
      const Kills kills = options.fail_fast ? first_kill(corpus, subject, fault.clause)
                                            : run(corpus, subject, false);
      std::string verdicts;
      for (const std::string& verdict : kills.verdicts) verdicts += " " + verdict;
      output.text() += kills.cases == 0 ? fmt::format("{:<34} SURVIVES: {}\n", spec, fault.what)
                       : options.fail_fast
                           ? fmt::format("{:<34} found by {}{}\n", spec, kills.first, verdicts)
                           : fmt::format("{:<34} {:>6} cases, first {}{}\n", spec, kills.cases,
                                         kills.first, verdicts);
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
  command.flag("--fail-fast", options->fail_fast,
               "of each fault, stop at the first case that finds it");
  command.flag("--matrix", options->matrix, "what it costs each method to find each fault");
  command.option("--method", options->methods,
                 "with --matrix, of corpus,properties,operations,hunt,fuzz (corpus,hunt)");
  command.choice("--format", options->format, {"text", "markdown"},
                 "with --matrix; markdown: docs/kill-matrix.md");
  command.option("--only", options->only, "with --matrix, faults whose name holds this");
  command.flag("--only-field-defects", options->only_field_defects,
               "with --matrix, faults that were reported of real programs");
  command.number("--seed", options->seed, 0, std::numeric_limits<long>::max(),
                 "with --matrix, of the programs");
  constexpr long kMostSeconds = 3600;
  command.number("--most-seconds", options->most_seconds, 1, kMostSeconds,
                 "with --matrix, of processor time for a fault (60)");
  command.choice("--judge", options->judge, {"right", "always-go"},
                 "with --matrix; always-go: does the bench notice a judge that says GO to all?");
  command.needs({"--method", "--format", "--only", "--only-field-defects", "--seed",
                 "--most-seconds", "--judge"},
                "--matrix");
  command.run([options] { return faults(*options); });
}

}  // namespace gonogo::cli
