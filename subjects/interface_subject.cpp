// SPDX-License-Identifier: GPL-3.0-or-later
//
// A subject behind the C interface, in this process.
#include <chrono>
#include <utility>

#include "subjects/configuration.hpp"
#include "subjects/interface_handle.hpp"
#include "subjects/interface_record.hpp"
#include "subjects/make_subject.hpp"
#include "subjects/start_reply.hpp"

namespace gonogo::oracle {
namespace {

using Clock = std::chrono::steady_clock;

class InterfaceSubject : public Subject {
 public:
  InterfaceSubject(const gonogo_subject_v1& subject, StatedMachine stated)
      : handle_(subject),
        info_(read_description(handle_.description())),
        stated_(std::move(stated)) {}

  const SubjectInfo& info() const override { return info_; }

  void configure(const reference::Profile& profile) override {
    Told what = told(info_, profile, stated_);
    silent_ = std::move(what.silent);
    handle_.configure("{" + configuration_members(what.profile) + "}");
  }

  RunEnd run(std::string_view, std::string_view program, const RecordSink& sink) override {
    if (silent_) return *silent_;
    const auto begin = Clock::now();
    RunEnd end = handle_.run(program, [&sink](const gonogo_record_v1& source, std::string& fault) {
      auto converted = convert_record(source);
      if (auto* wrong = std::get_if<TraceFault>(&converted)) {
        fault = std::move(wrong->message);
        return false;
      }
      return sink(std::get<reference::Record>(converted));
    });
    end.microseconds =
        std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - begin).count();
    return end;
  }

  void renew() override { handle_.close(); }

 private:
  InterfaceHandle handle_;
  SubjectInfo info_;
  const StatedMachine stated_;
  std::optional<RunEnd> silent_;  // of a machine that it does not take
};

}  // namespace

std::unique_ptr<Subject> make_interface_subject(const gonogo_subject_v1& subject,
                                                const StatedMachine& stated) {
  return std::make_unique<InterfaceSubject>(subject, stated);
}

}  // namespace gonogo::oracle
