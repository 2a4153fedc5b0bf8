// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <tuple>

#include "tests/oracle/relation/deciding.hpp"

namespace gonogo::mutations {

using oracle::Decision;
using oracle::Verdict;
using oracle::VerdictKind;

namespace {

constexpr std::size_t kPrinted = 40;

Verdict judge(const Specimen& specimen, const Trace& trace) {
  return judge_outcome(specimen.profile, specimen.program, specimen.tolerances, trace.records,
                       trace.end)
      .verdict;
}

// Where blocks tell nothing that the motions do not.
bool is_told_by_its_motions(const Specimen& specimen) {
  return specimen.items.empty() && specimen.renamings.empty();
}

Verdict judge_without_blocks(const Specimen& specimen, Trace trace) {
  oracle::Tolerances tolerances = specimen.tolerances;
  tolerances.compare_blocks = false;
  for (Record& record : trace.records) record.block = 0;
  trace.end.alarm.block = 0;
  return judge_outcome(specimen.profile, specimen.program, tolerances, trace.records, trace.end)
      .verdict;
}

std::string verdict_text(const Verdict& verdict) {
  return fmt::format("{}: {}", name(verdict.kind), verdict.message);
}

std::string rule_of_definition(const Specimen& specimen, const Trace& mutant) {
  const bool alarms = mutant.end.kind == oracle::RunEnd::Kind::alarm;
  const relation::Answer answer =
      relation::decide(specimen.profile, specimen.program,
                       relation::tolerances_of(specimen.tolerances, specimen.profile),
                       {mutant.records, alarms ? &mutant.end.alarm : nullptr});
  return fmt::format("{} {}", name(answer.rule), name(answer.kind));
}

// By reservoir: the smallest of a kind is the one to look at.
void note(std::vector<Survivor>& all, const Specimen& specimen, const Operator& op,
          const Statement& statement, const Verdict& verdict, const Trace& mutant,
          std::string rule) {
  Survivor survivor{specimen.id,
                    std::string(op.name),
                    std::move(rule),
                    statement.why,
                    verdict_text(verdict),
                    fmt::format("{}{}\n{}", specimen.program,
                                reference::profile_json(specimen.profile), trace_text(mutant)),
                    mutant.records.size()};
  all.push_back(std::move(survivor));
}

void print_some(std::string_view title, std::vector<Survivor> all) {
  if (all.empty()) return;
  std::ranges::sort(all, {},
                    [](const Survivor& one) { return std::tie(one.size, one.id, one.op); });
  std::map<std::pair<std::string, std::string>, long> kinds;
  for (const Survivor& one : all)
    ++kinds[{one.rule.empty() ? one.op : one.rule + ", " + one.op, one.why + " | " + one.verdict}];
  fmt::print("\n{}: {} of {} kinds\n", title, all.size(), kinds.size());
  std::size_t printed = 0;
  for (const auto& [kind, count] : kinds) {
    fmt::print("  {} x {}: {}\n", count, kind.first, kind.second);
  }
  std::map<std::string, long> seen;
  for (const Survivor& one : all) {
    if (++seen[one.op + one.why] > 1 || ++printed > kPrinted) continue;
    fmt::print("\n--- {} {}\n{}; {}\n{}", one.id, one.op, one.why, one.verdict, one.text);
  }
}

}  // namespace

std::string trace_text(const Trace& trace) {
  std::string text;
  for (const Record& record : trace.records) {
    append_json(record, text);
    text += "\n";
  }
  if (trace.end.kind == oracle::RunEnd::Kind::alarm) {
    text += fmt::format("{{\"k\":\"alarm\",\"b\":{},\"class\":\"{}\"}}\n", trace.end.alarm.block,
                        trace.end.alarm.alarm_class);
  }
  return text;
}

void Bench::run(Chance& chance, long wanted) {
  while (wrong() < wanted) {
    for (const auto& [group, cases] : cases_) {
      const RawCase& raw = chance.one_of(cases);
      std::unique_ptr<Specimen> specimen;
      try {
        specimen = make_specimen(raw, chance.one_of(raw.assignments), kMostRecords);
      } catch (const std::logic_error& error) {
        faults_.insert(error.what());
        continue;
      }
      if (specimen == nullptr) continue;
      if (decision(judge(*specimen, specimen->right).kind) != Decision::go) {
        ++unusable_;
        continue;
      }
      try_specimen(*specimen, chance);
    }
  }
}

void Bench::try_specimen(const Specimen& specimen, Chance& chance) {
  const long before = wrong();
  for (const Operator& op : operators_) try_operator(specimen, op, chance);
  by_group_[specimen.group] += wrong() - before;
}

void Bench::try_operator(const Specimen& specimen, const Operator& op, Chance& chance) {
  Edit edit(specimen, chance);
  if (!op.apply(edit)) return;
  Row& row = rows_[op.name];
  ++row.mutants;
  const Statement statement = state(specimen, edit.trace);
  if (statement.answer == Answer::unsure) {
    ++row.uncounted;
    return;
  }
  count(specimen, op, statement, edit.trace, judge(specimen, edit.trace));
  if (op.orders_events && is_told_by_its_motions(specimen)) {
    ++row.mutants;
    count(specimen, op, statement, edit.trace, judge_without_blocks(specimen, edit.trace));
  }
}

void Bench::count(const Specimen& specimen, const Operator& op, const Statement& statement,
                  const Trace& mutant, const Verdict& verdict) {
  Row& row = rows_[op.name];
  const Decision decided = decision(verdict.kind);
  if (statement.answer == Answer::same) {
    ++row.explained[statement.why];
    if (decided != Decision::go) note(harsh_, specimen, op, statement, verdict, mutant, "");
    return;
  }
  ++row.wrong;
  if (decided == Decision::no_go) {
    ++row.no_go;
    ++no_go_by_rule_[oracle::rule_text(name(rule_of(verdict)))];
  } else if (verdict.kind == VerdictKind::advice) {
    ++row.advice;
  } else {
    if (decided == Decision::undecided) ++row.gap;
    ++row.survivors;
    // The definition may take minutes for a level, and this is told before.
    fmt::print("survivor: {} {} {}\n", specimen.id, op.name, verdict_text(verdict));
    std::fflush(stdout);
    note(survivors_, specimen, op, statement, verdict, mutant,
         rule_of_definition(specimen, mutant));
  }
}

long Bench::wrong() const {
  long count = 0;
  for (const auto& [name, row] : rows_) count += row.wrong;
  return count;
}

std::vector<std::string> Bench::untried() const {
  std::vector<std::string> groups;
  for (const auto& [group, cases] : cases_) {
    if (!by_group_.contains(group)) groups.push_back(group);
  }
  return groups;
}

void Bench::print() const {
  fmt::print("{:28} {:>7} {:>7} {:>7} {:>7} {:>5} {:>9} {:>9} {:>9}\n", "operator", "mutants",
             "wrong", "NO-GO", "advice", "gap", "explained", "uncounted", "survivors");
  Row all;
  for (const Operator& op : operators_) {
    const auto found = rows_.find(op.name);
    const Row row = found == rows_.end() ? Row{} : found->second;
    long explained = 0;
    for (const auto& [kind, count] : row.explained) {
      explained += count;
      all.explained[kind] += count;
    }
    fmt::print("{:28} {:7} {:7} {:7} {:7} {:5} {:9} {:9} {:9}\n", op.name, row.mutants, row.wrong,
               row.no_go, row.advice, row.gap, explained, row.uncounted, row.survivors);
    all.mutants += row.mutants;
    all.wrong += row.wrong;
    all.no_go += row.no_go;
    all.advice += row.advice;
    all.gap += row.gap;
    all.uncounted += row.uncounted;
    all.survivors += row.survivors;
  }
  fmt::print("{:28} {:7} {:7} {:7} {:7} {:5} {:9} {:9} {:9}\n", "all", all.mutants, all.wrong,
             all.no_go, all.advice, all.gap, "", all.uncounted, all.survivors);
  fmt::print("explained, by kind:\n");
  for (const auto& [kind, count] : all.explained) fmt::print("  {:7} {}\n", count, kind);
  fmt::print("NO-GO, by rule:\n");
  for (const auto& [rule, count] : no_go_by_rule_) fmt::print("  {:7} {}\n", count, rule);
  fmt::print("traces that are not GO as they are: {}\n", unusable_);
  for (const std::string& fault : faults_) fmt::print("{}\n", fault);
  print_some("right by the bench, not GO by the judge", harsh_);
  print_some("SURVIVORS", survivors_);
}

}  // namespace gonogo::mutations
