// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/judge_session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace gonogo::oracle {

using reference::Reading;
using reference::ReadingChoice;
using reference::ReadingKey;

namespace {

bool is_open(const ReadingChoice& choice, const Reading& reading) {
  return !reading.by_properties && choice.is(reading.key, "any");
}

// The readings of a dialect that may be open.
std::vector<ReadingKey> openable_in(std::string_view dialect) {
  std::vector<ReadingKey> keys;
  for (const Reading& reading : reference::readings()) {
    if (!reading.by_properties && reading.belongs_to(dialect)) keys.push_back(reading.key);
  }
  return keys;
}

// Whether a program can touch an open reading. Those of other dialects are open by default, too.
bool can_be_open(const reference::Profile& profile) {
  static const auto kOpenable = [] {
    std::map<std::string_view, std::vector<ReadingKey>> by_dialect;
    for (const Reading& reading : reference::readings()) {
      for (const std::string_view dialect : {reading.dialect, reading.also}) {
        by_dialect.try_emplace(dialect, openable_in(dialect));
      }
    }
    return by_dialect;
  }();
  const auto own = kOpenable.find(profile.dialect);
  return own != kOpenable.end() && std::ranges::any_of(own->second, [&](ReadingKey key) {
           return profile.readings.is(key, "any");
         });
}

}  // namespace

std::vector<ReadingKey> touched_by(const reference::Profile& profile, const ProgramText& program) {
  ProgramInput input(program);
  reference::Expander expander(profile, input.lines, reference::OpenPaths::judged);
  try {
    while (expander.next() != nullptr) {
    }
  } catch (const exact::Undecided&) {
    // The judge comes to the same place and says so.
  }
  return expander.readings().touched();
}

Assignments assignments_of(const reference::Profile& profile, const ProgramText& program) {
  Assignments result;
  result.choices.push_back(profile.readings);
  if (!can_be_open(profile)) return result;
  // Each assignment is run until it touches an open reading; that one is then split.
  std::set<ReadingKey> open;
  for (std::size_t i = 0; i < result.choices.size();) {
    reference::Profile assigned = profile;
    assigned.readings = result.choices[i];
    const std::vector<ReadingKey> touched = touched_by(assigned, program);
    auto split = std::ranges::find_if(touched, [&](ReadingKey key) {
      return is_open(assigned.readings, reference::reading(key));
    });
    if (split == touched.end()) {
      ++i;
      continue;
    }
    open.insert(*split);
    const Reading& reading = reference::reading(*split);
    for (std::string_view alternative : reading.alternatives) {
      ReadingChoice choice = assigned.readings;
      choice.set(*split, alternative);
      if (alternative == reading.alternatives.front()) {
        result.choices[i] = choice;
      } else {
        result.choices.push_back(choice);
      }
    }
    if (result.choices.size() > kMaximumAssignments) {
      result.too_many = true;
      break;
    }
  }
  result.open.assign(open.begin(), open.end());
  return result;
}

JudgeSession::JudgeSession(const reference::Profile& profile, const ProgramText& program,
                           const JudgeTerms& terms)
    : profile_(profile), program_(program), terms_(terms) {
  Assignments assignments = assignments_of(profile, program);
  too_many_ = assignments.too_many;
  open_ = std::move(assignments.open);
  choices_ = std::move(assignments.choices);
  for (const ReadingChoice& choice : choices_) {
    reference::Profile assigned = profile;
    assigned.readings = choice;
    judges_.push_back(std::make_unique<ProgramJudge>(std::move(assigned), program, terms));
  }
}

bool JudgeSession::record(const Record& record) {
  bool undecided = false;
  for (const auto& judge : judges_) undecided = judge->record(record) || undecided;
  return undecided;
}

SampledVerdict JudgeSession::finish_under(std::size_t assignment, const RunEnd& end) {
  if (end.sampled == nullptr) {
    SampledVerdict said{judges_[assignment]->finish(end), 0};
    said.progress = judges_[assignment]->progress();
    return said;
  }
  reference::Profile assigned = profile_;
  assigned.readings = choices_[assignment];
  return end.sampled->judge(assigned, program_, terms_, end);
}

bool outranks(const SampledVerdict& one, const SampledVerdict& other) {
  const auto rank = [](const SampledVerdict& said) {
    const Decision its = decision(said.verdict.kind);
    return its == Decision::go ? 2 : its == Decision::undecided ? 1 : 0;
  };
  if (rank(one) != rank(other)) return rank(one) > rank(other);
  if (rank(one) == 2) return one.verdict.kind < other.verdict.kind;
  return rank(one) == 0 && one.progress > other.progress;
}

SessionVerdict JudgeSession::finish(const RunEnd& end) {
  SessionVerdict result;
  result.open = open_;
  if (too_many_) {
    result.verdict.kind = VerdictKind::oracle_gap;
    result.verdict.message = fmt::format(
        "The program touches open readings with more than {} assignments.", kMaximumAssignments);
    return result;
  }
  std::optional<SampledVerdict> best;
  for (std::size_t i = 0; i < judges_.size(); ++i) {
    SampledVerdict said = finish_under(i, end);
    if (decision(said.verdict.kind) == Decision::go) result.explaining.push_back(choices_[i]);
    if (!best || outranks(said, *best)) best = std::move(said);
  }
  result.verdict = std::move(best->verdict);
  return result;
}

void RecordsInMemory::each(const std::function<bool(const Record&)>& take) const {
  for (const Record& record : records_) {
    if (!take(record)) return;
  }
}

SessionVerdict judge_outcome(const reference::Profile& profile, const ProgramText& program,
                             const JudgeTerms& terms, const RecordSeries& records,
                             const RunEnd& end) {
  JudgeSession session(profile, program, terms);
  records.each([&](const Record& record) { return session.record(record); });
  return session.finish(end);
}

SessionVerdict judge_outcome(const reference::Profile& profile, const ProgramText& program,
                             const JudgeTerms& terms, std::span<const Record> records,
                             const RunEnd& end) {
  return judge_outcome(profile, program, terms, RecordsInMemory(records), end);
}

}  // namespace gonogo::oracle
