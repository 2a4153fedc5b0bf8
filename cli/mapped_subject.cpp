// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mapped_subject.hpp"

#include <memory>
#include <utility>

namespace gonogo::cli {
namespace {

class MappedSubject : public oracle::Subject {
 public:
  MappedSubject(std::unique_ptr<oracle::Subject> inner,
                std::shared_ptr<const oracle::AlarmMap> alarms)
      : inner_(std::move(inner)), alarms_(std::move(alarms)) {}

  const oracle::SubjectInfo& info() const override { return inner_->info(); }
  void configure(const reference::Profile& profile) override { inner_->configure(profile); }
  oracle::RunEnd run(std::string_view id, std::string_view program,
                     const oracle::RecordSink& sink) override {
    oracle::RunEnd end = inner_->run(id, program, sink);
    alarms_->name_class(end);
    return end;
  }
  void renew() override { inner_->renew(); }

 private:
  std::unique_ptr<oracle::Subject> inner_;
  std::shared_ptr<const oracle::AlarmMap> alarms_;
};

}  // namespace

std::unique_ptr<oracle::Subject> with_alarm_map(std::unique_ptr<oracle::Subject> subject,
                                                std::shared_ptr<const oracle::AlarmMap> alarms) {
  if (!alarms) return subject;
  return std::make_unique<MappedSubject>(std::move(subject), std::move(alarms));
}

}  // namespace gonogo::cli
