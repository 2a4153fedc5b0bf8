// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/witness.hpp"

#include <ctime>
#include <utility>

namespace gonogo::hunt {
namespace {

using oracle::RunEnd;
using reference::Record;

// An answer that is longer is compared so far.
constexpr std::size_t kComparedRecords = 5'000;

// What a run put out, as far as it is compared.
struct Answer {
  std::vector<Record> records;
  bool is_cut = false;  // there was more, or the run was interrupted
  RunEnd end;
};

std::string text_of(const Record& record) {
  std::string text;
  append_json(record, text);
  return text;
}

bool is_same_end(const RunEnd& a, const RunEnd& b) {
  return a.kind == b.kind && a.feature == b.feature && a.alarm.native == b.alarm.native &&
         a.alarm.alarm_class == b.alarm.alarm_class && a.alarm.block == b.alarm.block &&
         a.alarm.word == b.alarm.word;
}

bool is_broken_off(const RunEnd& end) {
  return end.kind == RunEnd::Kind::stopped || end.kind == RunEnd::Kind::timeout;
}

// Whether the control answers the program otherwise, as far as the answer goes.
bool differs(const Answer& answer, oracle::Subject& control, std::string_view program) {
  std::size_t place = 0;
  bool is_other = false;
  const RunEnd end = control.run("witness", program, [&](const Record& record) {
    const bool is_past = place == answer.records.size();
    is_other = is_past ? !answer.is_cut : text_of(record) != text_of(answer.records[place]);
    ++place;
    return !is_other && !is_past;
  });
  if (is_other) return true;
  if (place < answer.records.size()) return true;
  return !answer.is_cut && !is_same_end(answer.end, end);
}

class WitnessedSubject : public oracle::Subject {
 public:
  WitnessedSubject(std::unique_ptr<oracle::Subject> subject, SubjectMaker control,
                   std::shared_ptr<Witness> witness)
      : subject_(std::move(subject)),
        make_control_(std::move(control)),
        witness_(std::move(witness)) {}

  const oracle::SubjectInfo& info() const override { return subject_->info(); }
  void configure(const reference::Profile& profile) override {
    subject_->configure(profile);
    profile_ = profile;
  }
  void announce(std::string_view id, std::string_view program) override {
    subject_->announce(id, program);
  }
  RunEnd run(std::string_view id, std::string_view program,
             const oracle::RecordSink& sink) override {
    if (witness_->is_triggered) return subject_->run(id, program, sink);
    const std::uint64_t before = reached();
    Answer answer;
    answer.end = subject_->run(id, program, [&](const Record& record) {
      answer.is_cut = answer.is_cut || answer.records.size() == kComparedRecords;
      if (!answer.is_cut) answer.records.push_back(record);
      return sink(record);
    });
    if (witness_->reached_count && reached() == before) return std::move(answer.end);
    const double begin = processor_seconds();
    witness_->is_reached = true;
    answer.is_cut = answer.is_cut || is_broken_off(answer.end);
    witness_->is_triggered = differs(answer, control(), program);
    witness_->seconds += processor_seconds() - begin;
    return std::move(answer.end);
  }
  void renew() override { subject_->renew(); }
  void set_run_limit(std::chrono::milliseconds limit) override { subject_->set_run_limit(limit); }
  bool keeps_state() const override { return subject_->keeps_state(); }

 private:
  std::uint64_t reached() const { return witness_->reached_count ? witness_->reached_count() : 0; }
  oracle::Subject& control() {
    if (!control_) control_ = make_control_();
    if (profile_) control_->configure(*profile_);
    return *control_;
  }

  std::unique_ptr<oracle::Subject> subject_;
  SubjectMaker make_control_;
  std::unique_ptr<oracle::Subject> control_;  // made when a program first reaches the fault
  std::shared_ptr<Witness> witness_;
  std::optional<reference::Profile> profile_;
};

}  // namespace

SubjectMaker witnessed(SubjectMaker make, SubjectMaker control, std::shared_ptr<Witness> witness) {
  return [make = std::move(make), control = std::move(control), witness = std::move(witness)] {
    return std::make_unique<WitnessedSubject>(make(), control, witness);
  };
}

double processor_seconds() {
  return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

}  // namespace gonogo::hunt
