// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/judge_session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

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

// The open readings that a program can touch. Those of other dialects are open by default, too.
std::vector<ReadingKey> open_in(const reference::Profile& profile) {
  static const auto kOpenable = [] {
    std::map<std::string_view, std::vector<ReadingKey>> by_dialect;
    for (const Reading& reading : reference::readings()) {
      for (const std::string_view dialect : {reading.dialect, reading.also}) {
        by_dialect.try_emplace(dialect, openable_in(dialect));
      }
    }
    return by_dialect;
  }();
  std::vector<ReadingKey> open;
  const auto own = kOpenable.find(profile.dialect);
  if (own == kOpenable.end()) return open;
  std::ranges::copy_if(own->second, std::back_inserter(open),
                       [&](ReadingKey key) { return profile.readings.is(key, "any"); });
  return open;
}

}  // namespace

std::vector<ReadingKey> touched_by(const reference::Profile& profile, const ProgramText& program) {
  ProgramInput input(program);
  reference::Expander expander(profile, input.lines, reference::OpenPaths::judged);
  try {
    std::size_t items = 0;
    std::uint64_t block = 0;
    while (const reference::Item* item = expander.next()) {
      const auto* record = std::get_if<Record>(item);
      if (record != nullptr && std::exchange(block, record->block) != record->block) items = 0;
      if (++items > kMostItems) break;
    }
  } catch (const exact::Undecided&) {
    // The judge comes to the same place and says so.
  }
  return expander.readings().touched();
}

Assignments assignments_of(const reference::Profile& profile, const ProgramText& program) {
  Assignments result;
  result.choices.push_back(profile.readings);
  if (open_in(profile).empty()) return result;
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
    : profile_(profile), program_(program), terms_(terms), choices_{profile.readings} {
  only_judge_.emplace(profile, program_, terms);
  std::vector<ReadingKey> open = open_in(profile);
  if (!open.empty()) unsettled_ = Unsettled{std::move(open), {}};
}

bool JudgeSession::record(const Record& record) {
  return unsettled_ ? record_unsettled(record) : tell_judges(record);
}

bool JudgeSession::tell_judges(const Record& record) {
  bool undecided = false;
  for (std::size_t i = 0; i < choices_.size(); ++i) {
    undecided = judge_of(i).record(record) || undecided;
  }
  return undecided;
}

bool JudgeSession::record_unsettled(const Record& record) {
  ProgramJudge& judge = *only_judge_;
  const bool undecided = judge.record(record);
  if (undecided && judge.is_in_step()) {
    unsettled_->taken.add_own(judge.progress(), &record);
  } else {
    unsettled_->taken.add(record);
  }
  if (!touches_open() && unsettled_->taken.parts() < kMostParts) return undecided;
  settle();
  bool all_decided = true;
  for (std::size_t i = 0; i < choices_.size(); ++i) {
    all_decided = all_decided && judge_of(i).is_decided();
  }
  return !all_decided;
}

bool JudgeSession::line(std::string_view line) {
  if (choices_.size() != 1) return false;
  ProgramJudge& judge = judge_of(0);
  if (!unsettled_) return judge.line(line);
  // Else it has to be kept as a record.
  if (!judge.is_in_step() || !judge.line(line) || judge.is_decided()) return false;
  unsettled_->taken.add_own(judge.progress(), nullptr);
  if (touches_open()) settle();
  return true;
}

bool JudgeSession::touches_open() const {
  const reference::ReadingsInUse& readings = only_judge_->readings();
  return std::ranges::any_of(unsettled_->open,
                             [&](ReadingKey key) { return readings.touched(key); });
}

void JudgeSession::settle() {
  const RecordLog taken = std::move(unsettled_->taken);
  unsettled_.reset();
  Assignments assignments = assignments_of(profile_, program_);
  too_many_ = assignments.too_many;
  open_ = std::move(assignments.open);
  if (open_.empty()) return;  // the one judge goes on
  only_judge_.reset();
  choices_.clear();
  if (too_many_) return;  // `finish` says so, whatever comes
  choices_ = std::move(assignments.choices);
  for (const ReadingChoice& choice : choices_) {
    reference::Profile assigned = profile_;
    assigned.readings = choice;
    assigned_judges_.push_back(
        std::make_unique<AssignedJudge>(std::move(assigned), program_, terms_));
  }
  taken.replay(profile_, program_, [this](const Record& record) { tell_judges(record); });
}

ProgramJudge& JudgeSession::judge_of(std::size_t assignment) {
  return only_judge_ ? *only_judge_ : assigned_judges_[assignment]->judge;
}

SampledVerdict JudgeSession::finish_under(std::size_t assignment, const RunEnd& end) {
  if (end.sampled == nullptr) {
    SampledVerdict said{judge_of(assignment).finish(end), 0};
    said.progress = judge_of(assignment).progress();
    return said;
  }
  reference::Profile assigned = profile_;
  assigned.readings = choices_[assignment];
  return end.sampled->judge(assigned, program_, terms_, end);
}

// R9.
bool outranks(const SampledVerdict& one, const SampledVerdict& other) {
  const auto rank = [](const SampledVerdict& said) {
    switch (decision(said.verdict.kind)) {
      case Decision::go:
        return 3;
      case Decision::undecided:
        return 2;
      case Decision::neither:
        return 1;
      case Decision::no_go:
        return 0;
    }
    return 0;
  };
  if (rank(one) != rank(other)) return rank(one) > rank(other);
  if (rank(one) == 3) return one.verdict.kind < other.verdict.kind;
  const bool departs = rank(one) <= 1;
  return departs && one.progress > other.progress;
}

SessionVerdict JudgeSession::finish(const RunEnd& end) {
  SessionVerdict result;
  if (unsettled_) {
    const bool may_be_whole = end.kind == RunEnd::Kind::ok || end.kind == RunEnd::Kind::alarm;
    if (may_be_whole && end.sampled == nullptr) {
      const SampledVerdict said = finish_under(0, end);
      // GO: then the reference is at its end, and whether a reading was asked for is known.
      const bool is_go = decision(said.verdict.kind) == Decision::go;
      if (is_go && !touches_open()) return {said.verdict, choices_, {}};
    }
    settle();
  }
  result.open = open_;
  if (too_many_) {
    result.verdict =
        gap_verdict(GapReason::cap_assignments,
                    fmt::format("The program touches open readings with more than {} assignments.",
                                kMaximumAssignments));
    return result;
  }
  std::optional<SampledVerdict> best;
  for (std::size_t i = 0; i < choices_.size(); ++i) {
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
