// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/judge_session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include "oracle/judge/verdict_ranking.hpp"

namespace gonogo::oracle {

using reference::Profile;
using reference::ReadingChoice;
using reference::ReadingKey;

namespace {

// The first traverses of a block that carry the clause. `block` 0: not known.
std::vector<Record> traverses_of(const Profile& profile, const ProgramText& program,
                                 reference::ClauseId clause, std::uint64_t block) {
  std::vector<Record> traverses;
  ProgramInput input(program);
  reference::Expander expander(profile, input.lines, reference::OpenPaths::judged);
  try {
    for (std::size_t items = 0; items < kMostItems && traverses.size() < kMostLengths; ++items) {
      const reference::Item* item = expander.next();
      if (item == nullptr) break;
      const auto* record = std::get_if<Record>(item);
      if (record == nullptr || record->block < block) continue;
      if (block != 0 && record->block > block) break;
      if (record->clause == clause && record->kind == reference::RecordKind::rapid) {
        traverses.push_back(*record);
      }
    }
  } catch (const exact::Undecided&) {
    // As far as it is known.
  }
  return traverses;
}

// The open readings that an assignment has otherwise than `expand` shows them.
std::string not_as_shown(const ReadingChoice& choice, std::span<const ReadingKey> keys) {
  std::string text;
  for (const ReadingKey key : keys) {
    const reference::Reading& reading = reference::reading(key);
    if (choice.is(key, reading.alternatives.front())) continue;
    text += fmt::format("{}{}={}", text.empty() ? "" : ", ", reading.name, choice.get(key));
  }
  return text;
}

// How far the subject stands from the end of the traverse, along its axes.
std::vector<Number> lengths_between(const Record& traverse, const Position& subject) {
  std::vector<Number> lengths;
  for (const reference::Axis axis : reference::kLinearAxes) {
    if (!traverse.axes.has(axis)) continue;
    const Number length = exact::abs(subject[axis] - traverse.to[axis]);
    if (length.is_rational() && length.sign() != 0) lengths.push_back(length);
  }
  return lengths;
}

}  // namespace

struct JudgeSession::Fork {
  Fork(const Profile& its, const ProgramText& program, const Tolerances& tolerances,
       AssignmentSet its_set, Forking forking)
      : set(std::move(its_set)),
        profile(std::make_shared<const Profile>(with_readings(its, set.taken()))),
        judge(*profile, program, tolerances, &set, forking) {}
  std::string told_under() const { return not_as_shown(set.taken(), set.settled()); }
  AssignmentSet set;
  const std::shared_ptr<const Profile> profile;
  ProgramJudge judge;
};

JudgeSession::JudgeSession(const Profile& profile, const ProgramText& program,
                           const Tolerances& tolerances, Forking forking)
    : profile_(profile),
      program_(program),
      tolerances_(tolerances),
      forking_(forking),
      stands_(profile.initial.at) {
  AssignmentSet all(profile);
  if (all.leaves_open()) taken_.emplace();
  Fork& first = add_fork(std::move(all));
  if (!taken_) first.judge.watched().stop_watching();
}

JudgeSession::~JudgeSession() = default;

// J-READ-01.
JudgeSession::Fork& JudgeSession::add_fork(AssignmentSet set) {
  Fork& fork = *alive_.emplace_back(
      std::make_shared<Fork>(profile_, program_, tolerances_, std::move(set), forking_));
  if (taken_) {
    taken_->replay(program_, [&](const Record& record) { return fork.judge.record(record); });
  }
  return fork;
}

void JudgeSession::part(Fork& fork) {
  for (const auto& [key, value] : fork.judge.watched().take_parted()) {
    open_.insert(key);
    add_fork(fork.set.with(key, value));
    fork.set.leave_out(key, value);
  }
}

// New ones come behind those that they part from.
void JudgeSession::settle_forks() {
  for (std::size_t i = 0; i < alive_.size();) {
    if (i == kMaximumAssignments) {
      too_many_ = true;
      alive_.clear();
      return;
    }
    part(*alive_[i]);
    if (alive_[i]->judge.is_decided()) {
      bury(alive_[i]);
      alive_.erase(alive_.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      ++i;
    }
  }
}

std::uint64_t JudgeSession::departed_block(const ProgramJudge& judge) const {
  // O words go back.
  return profile_.dialect == "rs274" ? 0 : judge.departed_block();
}

void JudgeSession::bury(const std::shared_ptr<Fork>& fork) {
  ProgramJudge& judge = fork->judge;
  most_others_ = std::max(most_others_, judge.watched().others());
  const bool keeps = departures_.size() < kMaximumAssignments;
  const bool is_best = consider({keeps ? judge.decided() : judge.finish(RunEnd{}), judge.progress(),
                                 departed_block(judge), fork->told_under()},
                                keeps ? fork : nullptr);
  if (is_best) surplus_ = judge.surplus();
  try_lengths(*fork);
}

// J-READ-02: an open length is what the subject shows of it where it departs.
void JudgeSession::try_lengths(const Fork& fork) {
  for (const ReadingKey key : open_lengths(fork.set, fork.judge.readings())) {
    const auto traverses =
        traverses_of(*fork.profile, program_, reference::reading(key).clause, last_block_);
    for (const Position& shown : {stood_, stands_}) {
      for (const Record& traverse : traverses) {
        for (const Number& length : lengths_between(traverse, shown)) {
          try_length(fork, key, length);
        }
      }
    }
  }
}

void JudgeSession::try_length(const Fork& fork, ReadingKey key, const Number& length) {
  if (lengths_.size() == kMostLengths) return;
  const auto [text, is_new] = lengths_.insert(length.text());
  if (!is_new) return;
  open_.insert(key);
  add_fork(fork.set.with(key, *text));
}

// J-READ-01. Keeps what came farther; else the departure of the path that `expand` shows; else what
// took more records; else what came first.
bool JudgeSession::consider(SampledVerdict said, std::shared_ptr<Fork> unexplained) {
  if (decision(said.verdict.kind) == Decision::no_go) departures_.push_back({said, unexplained});
  const bool is_later = records_ > best_records_;
  if (best_ && !outranks(said, *best_)) {
    const bool is_kept = decision(said.verdict.kind) == Decision::no_go &&
                         best_->told_under.empty() && !said.told_under.empty();
    if (!is_later || is_kept || outranks(*best_, said)) return false;
  }
  best_ = std::move(said);
  best_unexplained_ = std::move(unexplained);
  best_records_ = records_;
  surplus_block_.reset();
  return true;
}

void JudgeSession::explain_best() {
  if (best_unexplained_) best_->verdict = best_unexplained_->judge.finish(RunEnd{});
  best_unexplained_.reset();
  if (surplus_block_ && best_->verdict.kind == VerdictKind::fail_geometry) {
    best_->verdict.block = *surplus_block_;
  }
}

void JudgeSession::log(const Record& record, bool undecided) {
  if (!taken_) return;
  const Fork& first = *alive_.front();
  if (undecided && first.judge.is_in_step()) {
    taken_->add_own(first.profile, first.judge.progress(), &record);
  } else {
    taken_->add(record);
  }
}

// The log has grown too long: from now on each assignment that will say something else later has a
// judge of its own.
void JudgeSession::stop_forking() {
  std::vector<std::shared_ptr<Fork>> before = std::exchange(alive_, {});
  for (std::shared_ptr<Fork>& fork : before) {
    std::vector<AssignmentSet> different;
    if (!add_different(profile_, program_, fork->set, different) ||
        alive_.size() + different.size() > kMaximumAssignments) {
      too_many_ = true;
      alive_.clear();
      return;
    }
    fork->set = different.front();
    alive_.push_back(std::move(fork));
    for (std::size_t i = 1; i < different.size(); ++i) add_fork(std::move(different[i]));
  }
  for (const auto& fork : alive_) {
    fork->judge.watched().stop_watching();
    for (const ReadingKey key : fork->set.settled()) open_.insert(key);
  }
  taken_.reset();
}

bool JudgeSession::record(const Record& record) {
  // A motion that departs may be one too many of an earlier block, which this record shows.
  if (surplus_ && surplus_->is_shown_by(record, tolerances_)) surplus_block_ = surplus_->block;
  surplus_.reset();
  if (alive_.empty()) return false;
  ++records_;
  last_block_ = record.block;
  stood_ = stands_;
  if (is_motion(record.kind)) {
    for (const reference::Axis axis : reference::kLinearAxes) {
      if (record.axes.has(axis)) stands_[axis] = record.to[axis];
    }
  }
  bool settled = true;
  for (std::size_t i = 0; i < alive_.size(); ++i) {
    ProgramJudge& judge = alive_[i]->judge;
    const bool undecided = judge.record(record);
    if (i == 0) log(record, undecided);
    settled = settled && undecided && !judge.watched().has_parted();
  }
  if (!settled) settle_forks();
  if (taken_ && taken_->parts() > kMostParts && !alive_.empty()) stop_forking();
  return !alive_.empty() || surplus_.has_value();
}

bool JudgeSession::line(std::string_view line) {
  if (alive_.size() != 1 || surplus_) return false;
  Fork& fork = *alive_.front();
  if (!taken_) return fork.judge.line(line);
  // Else it has to be kept as a record.
  if (!fork.judge.is_in_step() || !fork.judge.line(line) || fork.judge.is_decided()) return false;
  taken_->add_own(fork.profile, fork.judge.progress(), nullptr);
  if (fork.judge.watched().has_parted()) settle_forks();
  return true;
}

// The end may show that others part.
void JudgeSession::finish_forks(const RunEnd& end) {
  ++records_;
  for (std::size_t i = 0; i < alive_.size(); ++i) {
    if (i == kMaximumAssignments) {
      too_many_ = true;
      return;
    }
    Fork& fork = *alive_[i];
    SampledVerdict said{fork.judge.finish(end), 0};
    said.progress = fork.judge.progress();
    said.block = departed_block(fork.judge);
    part(fork);
    said.told_under = fork.told_under();
    most_others_ = std::max(most_others_, fork.judge.watched().others());
    if (decision(said.verdict.kind) == Decision::go) {
      for (const ReadingKey key : open_lengths(fork.set, fork.judge.readings())) {
        open_.insert(key);
        fork.set = fork.set.with(key, fork.set.values(key).front());
      }
      std::ranges::move(fork.set.choices(), std::back_inserter(explaining_));
    }
    consider(std::move(said));
  }
}

void JudgeSession::finish_sampled(const SampledOutcome& sampled, const RunEnd& end) {
  const Assignments assignments = assignments_of(profile_, program_);
  too_many_ = assignments.too_many;
  open_ = {assignments.open.begin(), assignments.open.end()};
  if (too_many_) return;
  best_.reset();
  for (const ReadingChoice& choice : assignments.choices) {
    SampledVerdict said =
        sampled.judge(with_readings(profile_, choice), program_, tolerances_, end);
    said.told_under = not_as_shown(choice, assignments.open);
    if (decision(said.verdict.kind) == Decision::go) explaining_.push_back(choice);
    consider(std::move(said));
  }
}

void JudgeSession::finish_together(const RunEnd& end) {
  if (forking_ == Forking::when_asked || !taken_ || most_others_ < 2) return;
  if (!best_ || decision(best_->verdict.kind) != Decision::no_go) return;
  JudgeSession each(profile_, program_, tolerances_, Forking::when_asked);
  taken_->replay(program_, [&](const Record& record) { return each.record(record); });
  const SessionVerdict said = each.finish(end);
  if (each.too_many_ || decision(said.verdict.kind) != Decision::go) return;
  best_->verdict = said.verdict;
  explaining_ = said.explaining;
  open_ = std::move(each.open_);
}

SessionVerdict JudgeSession::finish(const RunEnd& end) {
  // J-RUN-05: what came before a skip is not judged.
  if (end.kind == RunEnd::Kind::skip || end.kind == RunEnd::Kind::refused) {
    SessionVerdict skipped;
    skipped.verdict.kind = VerdictKind::skip;
    skipped.verdict.feature = end.feature;
    skipped.verdict.message = end.message;
    return skipped;
  }
  if (end.sampled != nullptr) {
    finish_sampled(*end.sampled, end);
  } else if (!too_many_) {
    finish_forks(end);
  }
  if (best_) explain_best();
  if (best_ && runs_on(best_->verdict)) {
    std::vector<SampledVerdict> departures;
    for (Departed& each : departures_) {
      if (each.unexplained) each.said.verdict = each.unexplained->judge.finish(RunEnd{});
      departures.push_back(std::move(each.said));
    }
    const SampledVerdict* shown = shown_way_to_run_on(*best_, departures);
    if (shown != nullptr) best_ = *shown;
  }
  if (end.sampled == nullptr && !too_many_) finish_together(end);
  SessionVerdict result;
  result.open.assign(open_.begin(), open_.end());
  if (too_many_) {
    result.verdict = gap_verdict(
        GapReason::cap_assignments,
        fmt::format("The program takes more than {} ways under the readings that are open.",
                    kMaximumAssignments));
    return result;
  }
  result.explaining = std::move(explaining_);
  name_readings(best_->told_under, best_->verdict);
  result.verdict = std::move(best_->verdict);
  return result;
}

SessionVerdict judge_outcome(const reference::Profile& profile, const ProgramText& program,
                             const Tolerances& tolerances, const RecordSeries& records,
                             const RunEnd& end) {
  JudgeSession session(profile, program, tolerances);
  records.each([&](const Record& record) { return session.record(record); });
  return session.finish(end);
}

SessionVerdict judge_outcome(const reference::Profile& profile, const ProgramText& program,
                             const Tolerances& tolerances, std::span<const Record> records,
                             const RunEnd& end) {
  return judge_outcome(profile, program, tolerances, RecordsInMemory(records), end);
}

}  // namespace gonogo::oracle
