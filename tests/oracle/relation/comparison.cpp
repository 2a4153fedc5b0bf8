// SPDX-License-Identifier: GPL-3.0-or-later
#include "comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>

namespace gonogo::relation {

using oracle::VerdictKind;

namespace {

constexpr long kPrinted = 3;
constexpr std::size_t kMostPrinted = 40;

// Whether the two differ about the limit alone: where the judge is narrower, with the limit of arcs
// as tau; where it is wider, with twice tau.
bool is_at_limit(const Task& task, const Trace& trace, const Answer& answer,
                 const oracle::Verdict& verdict) {
  Tolerances tolerances = tolerances_of(task.tolerances, task.profile);
  const bool passes = decision(answer.kind) == oracle::Decision::go;
  tolerances.tolerance = passes ? tolerances.tolerance * 8 / 17 : tolerances.tolerance * 2;
  const Answer other = decide(task.profile, task.program, tolerances, trace.outcome());
  return passes ? decision(other.kind) != oracle::Decision::go
                : decision(other.kind) == decision(verdict.kind);
}

// The definition: a shift along the path is none, a centre is where the points of its arc are, and
// of a circle no wider than the limit it shows nowhere how it is gone round. The judge holds the
// end of each motion and the centre and turns of each arc, also then.
bool is_of_numbers(std::string_view change, const Answer& answer) {
  constexpr std::array<std::string_view, 4> kChanges = {"shift", "shift-centre", "turn", "reverse"};
  return decision(answer.kind) == oracle::Decision::go &&
         (change.starts_with("shift-end") || std::ranges::count(kChanges, change) > 0);
}

}  // namespace

void Comparison::compare(const Task& task, std::string_view change,
                         std::span<const reference::Record> records, const oracle::RunEnd& end) {
  const Trace trace{{records.begin(), records.end()}, end};
  const auto begin = std::chrono::steady_clock::now();
  const Answer answer = decide(task.profile, task.program,
                               tolerances_of(task.tolerances, task.profile), trace.outcome());
  const auto decided = std::chrono::steady_clock::now();
  const oracle::Verdict verdict =
      judge_outcome(task.profile, task.program, task.tolerances, trace.records, trace.end).verdict;
  ++traces_;
  ++said_[fmt::format("{} {} / {}", word(answer.kind), name(answer.gap), word(verdict.kind))];
  using namespace std::chrono_literals;
  if (decided - begin > 20s) {
    fmt::print("slow: {} {} {}s\n", task.id, change,
               std::chrono::duration_cast<std::chrono::seconds>(decided - begin).count());
  }
  if (decision(answer.kind) == decision(verdict.kind) || answer.gap != GapReason::none) return;
  if (decision(verdict.kind) == oracle::Decision::undecided) {
    ++undecided_[fmt::format("{}: definition {}", name(verdict.gap), word(answer.kind))];
    return;
  }
  if (is_of_numbers(change, answer)) {
    ++of_numbers_;
    return;
  }
  const std::string kind = fmt::format("{}: definition {} {}, judge {}", change, name(answer.kind),
                                       name(answer.rule), name(verdict.kind));
  if (is_at_limit(task, trace, answer, verdict)) {
    const bool is_narrower = decision(answer.kind) == oracle::Decision::go;
    long& count = is_narrower ? narrower_ : wider_;
    if (++count <= kPrinted) {
      print_difference(task, fmt::format("about the limit, {}", kind), answer, verdict, trace);
    }
    return;
  }
  if (++differences_[kind] <= kPrinted) print_difference(task, kind, answer, verdict, trace);
}

void Comparison::print_difference(const Task& task, std::string_view kind, const Answer& answer,
                                  const oracle::Verdict& verdict, const Trace& trace) const {
  fmt::print(
      "{}\n  {} blocks {} m {}\n  {}\n  want {}\n  got {} (record {})\n  judge: {}\n{}\n{}\n{}\n",
      kind, task.id, task.tolerances.compare_blocks, task.tolerances.compare_m, answer.message,
      answer.want, answer.got, answer.record ? static_cast<long>(*answer.record) : -1L,
      verdict.message, profile_json(task.profile), task.program,
      trace.records.size() > kMostPrinted ? "" : relation::text_of(trace));
  std::fflush(stdout);
}

void Comparison::print() const {
  for (const auto& [said, count] : said_) fmt::print("{:7} {}\n", count, said);
  for (const auto& [reason, count] : undecided_) {
    fmt::print("{:7} undecided by the judge, {}\n", count, reason);
  }
  fmt::print(
      "{} traces, judge narrower {}, wider {}, ends, centres and turns {}, {} other differences\n",
      traces_, narrower_, wider_, of_numbers_, differences());
  for (const auto& [kind, count] : differences_) fmt::print("{:7} {}\n", count, kind);
  std::fflush(stdout);
}

long Comparison::differences() const {
  long sum = 0;
  for (const auto& [kind, count] : differences_) sum += count;
  return sum;
}

oracle::Tolerances tolerances_for(const reference::Profile& profile, bool blocks, bool m) {
  oracle::SubjectInfo subject;
  if (blocks) subject.features.insert("blocks");
  if (m) subject.features.insert("m");
  return make_tolerances(subject, profile);
}

}  // namespace gonogo::relation
