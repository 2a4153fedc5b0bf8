// SPDX-License-Identifier: GPL-3.0-or-later
//
// A subject that is one process for many programs. It is started again when it fails.
#include <fmt/format.h>

#include <system_error>

#include "oracle/subjects/configuration.hpp"
#include "oracle/subjects/pipe_session.hpp"
#include "oracle/subjects/text.hpp"

namespace gonogo::oracle {
namespace {

RunEnd end_of(RunEnd::Kind kind, std::string message) {
  RunEnd end;
  end.kind = kind;
  end.message = std::move(message);
  return end;
}

class PipeSubject : public Subject {
 public:
  PipeSubject(const std::string& command, const Limits& limits)
      : command_(command), limits_(limits) {
    if (auto failed = open(&info_)) {
      throw SubjectUnusable(fmt::format(
          "The subject `{}` cannot be used. {}{}{} It must answer the line {{\"cmd\":\"start\","
          "\"protocol\":[1],...}} on stdin with one line on stdout; try the command by hand.",
          command, failed->message,
          failed->notes.empty() ? "" : " It wrote on stderr: ", excerpt(failed->notes, 2000)));
    }
  }
  PipeSubject(const PipeSubject&) = delete;
  PipeSubject& operator=(const PipeSubject&) = delete;
  ~PipeSubject() override { close(); }

  const SubjectInfo& info() const override { return info_; }

  void configure(const reference::Profile& profile) override {
    std::string configuration = configuration_members(profile);
    if (configuration == configuration_) return;
    configuration_ = std::move(configuration);
    configured_ = false;
  }

  RunEnd run(std::string_view id, std::string_view program, const RecordSink& sink) override {
    if (failures_ > limits_.restarts) {
      return end_of(RunEnd::Kind::crash,
                    fmt::format("The subject was given up after {} restarts in a row without an "
                                "answer.",
                                limits_.restarts));
    }
    if (configuration_.empty()) {
      return end_of(RunEnd::Kind::error, "The subject has not been configured.");
    }
    if (!info_.features.contains("bytes") && !is_utf8(program)) {
      RunEnd end = end_of(RunEnd::Kind::skip, "The program is not UTF-8.");
      end.feature = "bytes";
      return end;
    }
    RunEnd end = attempt(id, program, sink);
    if (session_ && end.notes.empty()) end.notes = session_->take_notes();
    count(end);
    if (session_ && !session_->usable()) session_.reset();
    return end;
  }

  void renew() override { close(); }

 private:
  void close() {
    if (session_) session_->stop();
    session_.reset();
  }

  std::optional<RunEnd> open(SubjectInfo* info) {
    configured_ = false;
    try {
      session_ = std::make_unique<PipeSession>(command_, limits_);
    } catch (const std::system_error& error) {
      return end_of(RunEnd::Kind::crash,
                    fmt::format("No process could be started: {}.", error.what()));
    }
    auto started = session_->start();
    if (auto* failed = std::get_if<RunEnd>(&started)) {
      failed->notes = session_->take_notes();
      return std::move(*failed);
    }
    if (info != nullptr) *info = std::get<SubjectInfo>(std::move(started));
    return std::nullopt;
  }

  RunEnd attempt(std::string_view id, std::string_view program, const RecordSink& sink) {
    if (!session_ || !session_->usable()) {
      if (auto failed = open(nullptr)) return *std::move(failed);
    }
    if (!configured_) {
      refusal_ = session_->configure(configuration_);
      configured_ = session_->usable();
    }
    if (refusal_) return *refusal_;
    return session_->run(id, program, sink);
  }

  // A subject that answers may go on for ever; one that only fails may not.
  void count(const RunEnd& end) {
    switch (end.kind) {
      case RunEnd::Kind::crash:
      case RunEnd::Kind::timeout:
      case RunEnd::Kind::out_of_memory:
      case RunEnd::Kind::protocol:
        ++failures_;
        break;
      case RunEnd::Kind::stopped:
        break;
      default:
        failures_ = 0;
    }
  }

  const std::string command_;
  const Limits limits_;
  SubjectInfo info_;
  std::unique_ptr<PipeSession> session_;
  std::string configuration_;
  bool configured_ = false;        // this session knows the configuration
  std::optional<RunEnd> refusal_;  // and this is what it said against it
  int failures_ = 0;               // in a row
};

}  // namespace

std::unique_ptr<Subject> make_pipe_subject(const std::string& command, const Limits& limits) {
  return std::make_unique<PipeSubject>(command, limits);
}

}  // namespace gonogo::oracle
