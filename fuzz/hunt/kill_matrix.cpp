// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/kill_matrix.hpp"

#include <algorithm>
#include <array>
#include <functional>

#include "campaign/campaign.hpp"
#include "campaign/reading_tally.hpp"
#include "fuzz/hunt/operation_hunt.hpp"
#include "fuzz/hunt/property_hunt.hpp"
#include "fuzz/hunt/witness.hpp"
#include "fuzz/program/text.hpp"

namespace gonogo::hunt {
namespace {

using program::count_blocks;

// One method and one target: its subjects, what becomes of its fault, and the time that passes.
class Watch {
 public:
  explicit Watch(const MatrixTarget& target) : make_(target.make) {
    if (target.clause.empty()) return;
    witness_ = std::make_shared<Witness>();
    witness_->reached_count = target.reached_count;
    make_ = witnessed(target.make, target.control, witness_);
  }
  const SubjectMaker& make() const { return make_; }
  void start() { begin_ = processor_seconds(); }
  // The method's alone.
  double seconds() const {
    return processor_seconds() - begin_ - (witness_ ? witness_->seconds : 0);
  }
  // After each program: whether it was the first to reach the fault, or to trigger it.
  void note(Kill& kill) const {
    if (!witness_) return;
    if (witness_->is_reached && kill.reached == 0) kill.reached = kill.executions;
    if (witness_->is_triggered && kill.triggered == 0) kill.triggered = kill.executions;
  }

 private:
  SubjectMaker make_;
  std::shared_ptr<Witness> witness_;  // null: there is no fault
  double begin_ = processor_seconds();
};

// The first case in the corpus's order that is NO-GO; else what the readings together say.
Kill run_corpus(const MatrixTarget& target, const MatrixOptions& options) {
  oracle::CampaignOptions campaign;
  campaign.dialects = target.dialects;
  campaign.fail_fast = !target.clause.empty();
  Watch watch(target);
  Kill kill;
  oracle::ReadingTally tally;
  auto take = [&](const oracle::CaseResult& result) {
    if (kill.killed) return;
    ++kill.executions;
    watch.note(kill);
    const bool no_go = decision(result.verdict.kind) == oracle::Decision::no_go ||
                       result.verdict.kind == oracle::VerdictKind::advice;  // as under strict
    const bool contradicts = result.readings && tally.add(result.id, *result.readings);
    kill.killed = (no_go || contradicts) && !options.blind;
    if (!kill.killed) return;
    kill.how = result.id;
    kill.seconds = watch.seconds();
  };
  run_campaign(*options.corpus, campaign, watch.make(), take, nullptr);
  if (!kill.killed) kill.seconds = watch.seconds();
  return kill;
}

std::size_t blocks_of(const Reproducer& reproducer) {
  std::size_t blocks = count_blocks(reproducer.program.text);
  for (const generate::GeneratedProgram& program : reproducer.before)
    blocks += count_blocks(program.text);
  return blocks;
}

// Reduces a finding and says what it is.
using Describe = std::function<void(Kill& kill)>;

// Programs until one is a finding of the fault. `try_one` gets the number of the program, from 0;
// null: it is none. Without a fault there are `most_clean` of them.
template <typename Try>
Kill until_killed(const MatrixTarget& target, const MatrixOptions& options, Watch& watch,
                  std::size_t most_clean, const Try& try_one) {
  const bool has_fault = !target.clause.empty();
  const std::size_t most = has_fault ? SIZE_MAX : most_clean;
  watch.start();
  Kill kill;
  while (kill.executions < most && !(has_fault && watch.seconds() > options.most_seconds)) {
    const Describe describe = try_one(kill.executions++);
    watch.note(kill);
    if (!describe) continue;
    kill.killed = true;
    kill.seconds = watch.seconds();
    describe(kill);
    return kill;
  }
  kill.seconds = watch.seconds();
  return kill;
}

// The dialects of the expander in turn, until there is a finding.
Kill run_hunts(const MatrixTarget& target, const MatrixOptions& options, bool guided) {
  TrialOptions trial;
  trial.grants.strict = true;  // a fault may be planted where no text says anything
  // What the expander without the fault shows too is not of the fault.
  Trial control(target.control, trial);
  const StillShows is_of_the_fault = [&](const Reproducer& reproducer) {
    const std::optional<oracle::Verdict> verdict = control.run_alone(reproducer);
    return target.clause.empty() || (verdict && decision(verdict->kind) == oracle::Decision::go);
  };
  trial.blind = options.blind;
  Watch watch(target);
  std::vector<std::unique_ptr<Hunt>> hunts;
  for (const std::string& dialect : target.dialects) {
    HuntOptions hunt;
    hunt.dialect = dialect;
    hunt.seed = options.seed;
    hunt.guided = guided;
    // `control` says what the domain would; without a fault there is none.
    hunt.everywhere = !target.clause.empty();
    hunts.push_back(std::make_unique<Hunt>(watch.make(), trial, std::move(hunt)));
  }
  const auto try_one = [&](std::size_t number) -> Describe {
    Hunt* const hunt = hunts[number % hunts.size()].get();
    std::optional<Finding> finding = hunt->step();
    if (!finding || decision(finding->verdict.kind) != oracle::Decision::no_go) return nullptr;
    if (!is_of_the_fault(finding->reproducer)) return nullptr;
    return [hunt, &is_of_the_fault, finding = *std::move(finding)](Kill& kill) mutable {
      hunt->reduce(finding, {}, is_of_the_fault);
      kill.blocks = blocks_of(finding.reproducer);
      kill.how = finding.signature.text();
    };
  };
  return until_killed(target, options, watch, options.clean_programs * hunts.size(), try_one);
}

// The dialects of the expander in turn, until its answers contradict each other.
Kill run_properties(const MatrixTarget& target, const MatrixOptions& options) {
  Watch watch(target);
  std::vector<std::unique_ptr<PropertyHunt>> hunts;
  PropertyOptions hunt;
  hunt.seed = options.seed;
  for (const std::string& dialect : target.dialects) {
    hunt.dialect = dialect;
    hunt.blind = options.blind;
    hunts.push_back(std::make_unique<PropertyHunt>(watch.make(), hunt));
  }
  hunt.blind = false;
  PropertyHunt control(target.control, hunt);
  const auto try_one = [&](std::size_t number) -> Describe {
    PropertyHunt* const one = hunts[number % hunts.size()].get();
    std::optional<PropertyFinding> finding = one->step();
    if (!finding) return nullptr;
    // What the expander without the fault shows too is not of the fault.
    const StillShows is_of_the_fault = [&, relation = finding->relation,
                                        variant = finding->variant](const Reproducer& reproducer) {
      return target.clause.empty() || !control.differs(reproducer.program, *relation, variant);
    };
    if (!is_of_the_fault({{}, finding->program})) return nullptr;
    return [one, is_of_the_fault, finding = *std::move(finding)](Kill& kill) mutable {
      one->reduce(finding, {}, is_of_the_fault);
      kill.blocks = count_blocks(finding.program.text);
      kill.how = finding.signature();
    };
  };
  return until_killed(target, options, watch, options.clean_programs * hunts.size(), try_one);
}

// Lists of operations until the target departs from its peers or from itself, or is unsafe.
Kill run_operations(const MatrixTarget& target, const MatrixOptions& options) {
  Watch watch(target);
  std::vector<OperationHunt::Named> subjects;
  for (const SubjectMaker& peer : target.peers) subjects.push_back({"a peer", peer});
  subjects.push_back({target.name, watch.make()});
  OperationOptions operations;
  operations.seed = options.seed;
  OperationHunt hunt(std::move(subjects), std::move(operations));
  const auto try_one = [&](std::size_t) -> Describe {
    for (const OperationFinding& finding : hunt.step()) {
      if (finding.second.subject != target.name || options.blind) continue;
      return [finding](Kill& kill) {
        kill.blocks = count_blocks(finding.second.text);
        kill.how = finding.signature();
      };
    }
    return nullptr;
  };
  return until_killed(target, options, watch, options.clean_programs, try_one);
}

}  // namespace

std::string_view name(Method method) {
  constexpr auto kNames =
      std::to_array<std::string_view>({"corpus", "properties", "operations", "hunt", "fuzz"});
  return kNames[static_cast<std::size_t>(method)];
}

std::optional<Method> method_named(std::string_view text) {
  const auto* const found =
      std::ranges::find(kMethods, text, [](Method method) { return name(method); });
  return found == std::end(kMethods) ? std::nullopt : std::optional(*found);
}

MatrixRow matrix_row(const MatrixTarget& target, const MatrixOptions& options) {
  MatrixRow row{target.name, target.clause, {}, target.what, target.report};
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
