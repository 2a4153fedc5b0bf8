// SPDX-License-Identifier: GPL-3.0-or-later
//
// The judge held to the definition: on what the corpus expects, and on traces with one thing
// changed. GONOGO_TRIALS says how many.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "deciding.hpp"
#include "oracle/corpus/corpus.hpp"
#include "tests/trials.hpp"

namespace gonogo::relation {
namespace {

using oracle::Decision;
using oracle::VerdictKind;
using reference::Axis;
using reference::Record;
using reference::RecordKind;

// A case under one assignment of its readings, with the trace that the corpus expects.
struct Specimen {
  std::string id;
  std::string program;
  reference::Profile profile;
  Trace right;
};

constexpr std::size_t kMostRecords = 40;
// A curve takes the definition a hundred times as long as a line: one case in so many.
constexpr std::size_t kRoundCases = 24;

bool is_round(const Record& record) {
  return record.kind == RecordKind::arc || record.kind == RecordKind::arc3;
}

std::vector<Specimen> specimens() {
  std::vector<Specimen> all;
  std::size_t round = 0;
  oracle::Corpus(std::string(GONOGO_SOURCE_DIR) + "/corpus")
      .for_each([&](const oracle::Case& test) {
        for (const oracle::Expectation& expected : test.expect) {
          if (expected.not_covered || expected.records.size() > kMostRecords) continue;
          if (std::ranges::any_of(expected.records, is_round) && round++ % kRoundCases != 0)
            continue;
          Specimen specimen{test.id, test.program, test.profile, {expected.records, {}}};
          for (const auto& [name, value] : expected.when) {
            set_reading(specimen.profile, name, value);
            specimen.id += " " + name + "=" + value;
          }
          if (!expected.alarms.empty()) {
            specimen.right.end.kind = oracle::RunEnd::Kind::alarm;
            specimen.right.end.alarm.block = expected.alarms.front().block;
            specimen.right.end.alarm.alarm_class = name(expected.alarms.front().alarm);
          }
          all.push_back(std::move(specimen));
        }
        return true;
      });
  return all;
}

using Records = std::vector<Record>;
using Wanted = bool (*)(const Record&);

bool is_any(const Record& record) {
  return record.kind != RecordKind::end;
}
bool moves(const Record& record) {
  return is_motion(record.kind) && !record.axes.empty();
}
bool is_arc(const Record& record) {
  return record.kind == RecordKind::arc;
}
bool is_m(const Record& record) {
  return record.kind == RecordKind::m;
}

// The place of any record that is wanted; nothing where there is none.
std::optional<std::size_t> any(const Records& records, Wanted wanted, Trials& chance) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (wanted(records[i])) places.push_back(i);
  }
  if (places.empty()) return std::nullopt;
  return chance.one_of(places);
}

bool drop(Records& records, const Number&, Trials& chance) {
  const auto at = any(records, is_any, chance);
  if (at) records.erase(records.begin() + static_cast<std::ptrdiff_t>(*at));
  return at.has_value();
}

bool swap(Records& records, const Number&, Trials& chance) {
  const auto at = any(records, is_any, chance);
  if (!at || *at + 1 >= records.size() || !is_any(records[*at + 1])) return false;
  std::swap(records[*at], records[*at + 1]);
  return true;
}

bool shift(Records& records, const Number& tau, Trials& chance) {
  const auto at = any(records, moves, chance);
  if (!at) return false;
  Record& record = records[*at];
  for (std::size_t tries = 0; tries < 20; ++tries) {
    const Axis axis = chance.one_of(reference::kAllAxes);
    if (!record.axes.has(axis)) continue;
    record.to[axis] += chance.once_in(2) ? tau * 2 : tau * -2;
    return true;
  }
  return false;
}

bool relabel(Records& records, const Number&, Trials& chance) {
  const auto at = any(records, moves, chance);
  if (!at) return false;
  Record& record = records[*at];
  switch (chance.below(3)) {
    case 0:
      ++record.block;
      return true;
    case 1:
      if (record.kind == RecordKind::rapid) {
        record.kind = RecordKind::feed;
        record.feed = 100;
      } else if (record.kind == RecordKind::feed) {
        record.kind = RecordKind::rapid;
      } else {
        return false;
      }
      return true;
    default:
      if (record.kind == RecordKind::rapid) return false;
      (record.kind == RecordKind::thread ? record.lead : record.feed) += Number::millionths(20'000);
      return true;
  }
}

bool reverse(Records& records, const Number&, Trials& chance) {
  const auto at = any(records, is_arc, chance);
  if (at) records[*at].rot = -records[*at].rot;
  return at.has_value();
}

bool turn_more(Records& records, const Number&, Trials& chance) {
  const auto at = any(records, is_arc, chance);
  if (at) records[*at].rot += records[*at].rot < 0 ? -1 : 1;
  return at.has_value();
}

bool move_m(Records& records, const Number&, Trials& chance) {
  const auto at = any(records, is_m, chance);
  if (!at || records.size() < 2) return false;
  const Record record = records[*at];
  records.erase(records.begin() + static_cast<std::ptrdiff_t>(*at));
  const std::size_t low = *at < 3 ? 0 : *at - 3;
  const std::size_t high = std::min(records.size(), *at + 4);
  records.insert(records.begin() + static_cast<std::ptrdiff_t>(low + chance.below(high - low)),
                 record);
  return true;
}

struct Operator {
  std::string_view name;
  bool (*apply)(Records& records, const Number& tau, Trials& chance);
};
constexpr std::array kOperators = {Operator{"drop", drop},       Operator{"swap", swap},
                                   Operator{"shift", shift},     Operator{"relabel", relabel},
                                   Operator{"reverse", reverse}, Operator{"turn", turn_more},
                                   Operator{"move M", move_m}};

Answer decided(const Specimen& specimen, const oracle::JudgeTerms& terms, const Trace& trace) {
  return decide(specimen.profile, specimen.program, terms_of(terms, specimen.profile),
                trace.outcome());
}

// The differences that are known, each with the side that is right by docs/relation.md.
bool is_known(std::string_view op, const Answer& answer, const oracle::Verdict& verdict,
              const oracle::JudgeTerms& terms) {
  const bool passes = decision(answer.kind) == Decision::go;
  // The definition: where two motions meet, a stretch of tau has no label, and where they have one label
  // is no event. The judge holds the ends of each motion, also where the path is within tau of both; a
  // shift is one of 2 tau.
  if (passes) {
    return op == "shift" && (verdict.kind == VerdictKind::fail_geometry ||
                             verdict.kind == VerdictKind::fail_order);
  }
  // The definition: an M function is at its place among the events of its block.
  return answer.rule == Rule::event && terms.compare_m;
}

// What the two say of many traces.
class Comparison {
 public:
  void compare(const Specimen& specimen, std::string_view op, const oracle::JudgeTerms& terms,
               const Trace& trace) {
    const Answer answer = decided(specimen, terms, trace);
    const oracle::Verdict verdict =
        judge_outcome(specimen.profile, specimen.program, terms, trace.records, trace.end).verdict;
    ++traces_;
    const bool is_same = decision(answer.kind) == decision(verdict.kind);
    ++said_[fmt::format("{} / {}", text_of(answer), word(verdict.kind))];
    if (is_same || answer.gap != GapReason::none) return;
    if (is_known(op, answer, verdict, terms)) {
      ++known_;
      return;
    }
    const std::string kind = fmt::format("{}: definition {} {}, judge {}", op, name(answer.kind),
                                         name(answer.rule), name(verdict.kind));
    if (++differences_[kind] <= kPrinted) {
      fmt::print("{}\n  {} blocks {} m {}\n  {}\n  want {}\n  got {}\n  judge: {}\n{}\n{}\n", kind,
                 specimen.id, terms.compare_blocks, terms.compare_m, answer.message, answer.want,
                 answer.got, verdict.message, specimen.program,
                 trace.records.size() > kMostPrinted ? "" : relation::text_of(trace));
    }
  }
  void print() const {
    for (const auto& [said, count] : said_) fmt::print("{:7} {}\n", count, said);
    fmt::print("{} traces, {} known differences, {} others\n", traces_, known_, differences());
    for (const auto& [kind, count] : differences_) fmt::print("{:7} {}\n", count, kind);
  }
  long differences() const {
    long sum = 0;
    for (const auto& [kind, count] : differences_) sum += count;
    return sum;
  }

 private:
  static constexpr long kPrinted = 2;
  static constexpr std::size_t kMostPrinted = 12;
  static std::string_view word(VerdictKind kind) {
    switch (decision(kind)) {
      case Decision::go:
        return "GO";
      case Decision::no_go:
        return "NO-GO";
      case Decision::undecided:
        return "undecided";
      default:
        return "advice";
    }
  }
  static std::string text_of(const Answer& answer) {
    return fmt::format("{} {}", word(answer.kind), name(answer.gap));
  }

  long traces_ = 0;
  long known_ = 0;
  std::map<std::string, long> said_;
  std::map<std::string, long> differences_;
};

oracle::JudgeTerms terms_for(const Specimen& specimen, bool blocks, bool m) {
  oracle::SubjectInfo subject;
  if (blocks) subject.features.insert("blocks");
  if (m) subject.features.insert("m");
  return make_terms(subject, specimen.profile, std::nullopt, std::nullopt);
}

TEST(DefinitionSweep, WhatTheCorpusExpectsIsRight) {
  Comparison comparison;
  const std::vector<Specimen> all = specimens();
  Trials trials(400);
  const std::size_t step =
      std::max<std::size_t>(1, all.size() / static_cast<std::size_t>(trials.count));
  for (std::size_t i = 0; i < all.size(); i += step) {
    comparison.compare(all[i], "right", terms_for(all[i], true, true), all[i].right);
  }
  comparison.print();
  EXPECT_EQ(comparison.differences(), 0);
}

TEST(DefinitionSweep, TheJudgeSaysTheSameOfChangedTraces) {
  Comparison comparison;
  const std::vector<Specimen> all = specimens();
  Trials trials(400);
  for (long done = 0; done < trials.count;) {
    const Specimen& specimen = trials.one_of(all);
    const Operator& op = trials.one_of(kOperators);
    const oracle::JudgeTerms terms = terms_for(specimen, !trials.once_in(4), !trials.once_in(8));
    Trace trace = specimen.right;
    if (!op.apply(trace.records, terms.tolerance, trials)) continue;
    comparison.compare(specimen, op.name, terms, trace);
    ++done;
  }
  comparison.print();
  EXPECT_EQ(comparison.differences(), 0);
}

}  // namespace
}  // namespace gonogo::relation
