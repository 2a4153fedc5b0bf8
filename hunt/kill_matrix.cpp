// SPDX-License-Identifier: GPL-3.0-or-later
#include "hunt/kill_matrix.hpp"

#include <algorithm>
#include <ctime>

#include "hunt/operation_hunt.hpp"
#include "hunt/property_hunt.hpp"
#include "oracle/campaign/campaign.hpp"
#include "oracle/campaign/reading_tally.hpp"
#include "program/text.hpp"

namespace gonogo::hunt {
namespace {

using program::count_blocks;

// Seconds of processor time: others may use the machine meanwhile.
class Stopwatch {
 public:
  double seconds() const {
    return static_cast<double>(std::clock() - begin_) / static_cast<double>(CLOCKS_PER_SEC);
  }

 private:
  std::clock_t begin_ = std::clock();
};

// The first case in the corpus's order that is NO-GO; else what the readings together say.
Kill run_corpus(const MatrixTarget& target, const MatrixOptions& options) {
  oracle::CampaignOptions campaign;
  campaign.dialects = target.dialects;
  campaign.fail_fast = !target.clause.empty();
  const Stopwatch watch;
  Kill kill;
  oracle::ReadingTally tally;
  auto take = [&](const oracle::CaseResult& result) {
    if (kill.killed) return;
    ++kill.executions;
    const bool no_go = decision(result.verdict.kind) == oracle::Decision::no_go ||
                       result.verdict.kind == oracle::VerdictKind::advice;  // as under strict
    const bool contradicts = result.readings && !tally.add(*result.readings);
    kill.killed = (no_go || contradicts) && !options.blind;
    if (!kill.killed) return;
    kill.how = result.id;
    kill.seconds = watch.seconds();
  };
  run_campaign(*options.corpus, campaign, target.make, take, nullptr);
  if (!kill.killed) kill.seconds = watch.seconds();
  return kill;
}

std::size_t blocks_of(const Exhibit& exhibit) {
  std::size_t blocks = count_blocks(exhibit.program.text);
  for (const generate::GeneratedProgram& program : exhibit.before)
    blocks += count_blocks(program.text);
  return blocks;
}

// The dialects of the expander in turn, until there is a finding.
Kill run_hunts(const MatrixTarget& target, const MatrixOptions& options, bool guided) {
  TrialOptions trial;
  trial.blind = options.blind;
  trial.strict = true;  // a fault may be planted where no text says anything
  std::vector<std::unique_ptr<Hunt>> hunts;
  for (const std::string& dialect : target.dialects) {
    HuntOptions hunt;
    hunt.dialect = dialect;
    hunt.seed = options.seed;
    hunt.guided = guided;
    hunt.everywhere = true;  // `control` tells what the domain would
    hunts.push_back(std::make_unique<Hunt>(target.make, trial, std::move(hunt)));
  }
  // What the expander without the fault shows too is not of the fault.
  TrialOptions of_control;
  of_control.strict = true;
  Trial control(target.control, of_control);
  const StillShows is_of_the_fault = [&](const Exhibit& exhibit) {
    const std::optional<oracle::Verdict> verdict = control.run_alone(exhibit);
    return target.clause.empty() || (verdict && decision(verdict->kind) == oracle::Decision::go);
  };
  const Stopwatch watch;
  Kill kill;
  const std::size_t most = target.clause.empty() ? options.clean_programs * hunts.size() : SIZE_MAX;
  const bool is_timed = !target.clause.empty();
  while (kill.executions < most && !(is_timed && watch.seconds() > options.most_seconds)) {
    Hunt& hunt = *hunts[kill.executions++ % hunts.size()];
    std::optional<Finding> finding = hunt.step();
    if (!finding || decision(finding->verdict.kind) != oracle::Decision::no_go) continue;
    if (!is_of_the_fault(finding->exhibit)) continue;
    kill.killed = true;
    kill.seconds = watch.seconds();
    hunt.reduce(*finding, {}, is_of_the_fault);
    kill.blocks = blocks_of(finding->exhibit);
    kill.how = finding->signature.text();
    return kill;
  }
  kill.seconds = watch.seconds();
  return kill;
}

// The dialects of the expander in turn, until its answers contradict each other.
Kill run_properties(const MatrixTarget& target, const MatrixOptions& options) {
  std::vector<std::unique_ptr<PropertyHunt>> hunts;
  PropertyOptions hunt;
  hunt.seed = options.seed;
  for (const std::string& dialect : target.dialects) {
    hunt.dialect = dialect;
    hunt.blind = options.blind;
    hunts.push_back(std::make_unique<PropertyHunt>(target.make, hunt));
  }
  hunt.blind = false;
  PropertyHunt control(target.control, hunt);
  const bool has_fault = !target.clause.empty();
  const std::size_t most = has_fault ? SIZE_MAX : options.clean_programs * hunts.size();
  const Stopwatch watch;
  Kill kill;
  while (kill.executions < most && !(has_fault && watch.seconds() > options.most_seconds)) {
    PropertyHunt& one = *hunts[kill.executions++ % hunts.size()];
    std::optional<PropertyFinding> finding = one.step();
    if (!finding) continue;
    // What the expander without the fault shows too is not of the fault.
    const StillShows is_of_the_fault = [&](const Exhibit& exhibit) {
      return !has_fault || !control.differs(exhibit.program, *finding->relation, finding->variant);
    };
    if (!is_of_the_fault({{}, finding->program})) continue;
    kill.killed = true;
    kill.seconds = watch.seconds();
    one.reduce(*finding, {}, is_of_the_fault);
    kill.blocks = count_blocks(finding->program.text);
    kill.how = finding->signature();
    return kill;
  }
  kill.seconds = watch.seconds();
  return kill;
}

// Lists of operations until the target departs from its peers or from itself, or is unsafe.
Kill run_operations(const MatrixTarget& target, const MatrixOptions& options) {
  std::vector<OperationHunt::Named> subjects;
  for (const SubjectMaker& peer : target.peers) subjects.push_back({"a peer", peer});
  subjects.push_back({target.name, target.make});
  OperationOptions operations;
  operations.seed = options.seed;
  OperationHunt hunt(std::move(subjects), std::move(operations));
  const bool has_fault = !target.clause.empty();
  const std::size_t most = has_fault ? SIZE_MAX : options.clean_programs;
  const Stopwatch watch;
  Kill kill;
  while (kill.executions < most && !(has_fault && watch.seconds() > options.most_seconds)) {
    ++kill.executions;
    for (const OperationFinding& finding : hunt.step()) {
      if (finding.second.subject != target.name || options.blind) continue;
      kill.killed = true;
      kill.seconds = watch.seconds();
      kill.blocks = count_blocks(finding.second.text);
      kill.how = finding.signature();
      return kill;
    }
  }
  kill.seconds = watch.seconds();
  return kill;
}

}  // namespace

std::string_view name(Method method) {
  switch (method) {
    case Method::corpus:
      return "corpus";
    case Method::properties:
      return "properties";
    case Method::operations:
      return "operations";
    case Method::hunt:
      return "hunt";
    case Method::fuzz:
      return "fuzz";
  }
  return "";
}

std::optional<Method> method_named(std::string_view text) {
  for (const Method method : kMethods) {
    if (name(method) == text) return method;
  }
  return std::nullopt;
}

MatrixRow matrix_row(const MatrixTarget& target, const MatrixOptions& options) {
  MatrixRow row{target.name, target.clause, {}};
  for (const Method method : options.methods) {
    if (method == Method::corpus) {
      row.kills[method] = run_corpus(target, options);
    } else if (method == Method::properties) {
      row.kills[method] = run_properties(target, options);
    } else if (method == Method::operations) {
      row.kills[method] = run_operations(target, options);
    } else {
      row.kills[method] = run_hunts(target, options, method == Method::hunt);
    }
  }
  return row;
}

}  // namespace gonogo::hunt
