// SPDX-License-Identifier: GPL-3.0-or-later
//
// A subject that is one process for many programs. It is started again when it fails.
#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <system_error>
#include <utility>

#include "oracle/records/text.hpp"
#include "subjects/configuration.hpp"
#include "subjects/pipe_session.hpp"

namespace gonogo::oracle {
namespace {

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
    Told what = told(info_, profile, limits_.stated);
    silent_ = std::move(what.silent);
    std::string configuration = configuration_members(what.profile);
    if (configuration == configuration_) return;
    forget_ahead();
    configuration_ = std::move(configuration);
    configured_ = false;
  }

  void announce(std::string_view id, std::string_view program) override {
    if (!silent_ && takes(program)) ahead_.push_back({std::string(id), std::string(program)});
  }

  RunEnd run(std::string_view id, std::string_view program, const RecordSink& sink) override {
    if (configuration_.empty()) {
      return RunEnd::of(RunEnd::Kind::error, "The subject has not been configured.");
    }
    if (silent_) return *silent_;
    if (is_given_up()) {
      RunEnd end =
          RunEnd::of(RunEnd::Kind::crash,
                     fmt::format("The subject was given up after {} restarts in a row without "
                                 "an answer.",
                                 limits_.restarts));
      end.given_up = true;
      return end;
    }
    if (!takes(program)) {
      RunEnd end = RunEnd::of(RunEnd::Kind::skip, "The program is not UTF-8.");
      end.feature = "bytes";
      return end;
    }
    if (ahead_.empty() || ahead_.front().id != id || ahead_.front().program != program) {
      forget_ahead();
      announce(id, program);
    }
    RunEnd end = attempt(sink);
    const std::size_t others = session_ ? session_->open_runs() : 0;
    const bool has_culprit = is_breakdown(end) && end.kind != RunEnd::Kind::protocol;
    if (has_culprit && others > 0 && !session_->delivered()) {
      suspects_ = others + 1;
      breakdown_ = std::move(end);
      session_.reset();
      end = attempt(sink);
    }
    look_for_culprit(end);
    ahead_.pop_front();
    // What stands on stderr by now may be of a run that was sent ahead.
    if (session_) end.notes += session_->take_notes();
    count(end);
    if (session_ && !session_->usable()) session_.reset();
    return end;
  }

  void renew() override {
    close();
    ahead_.clear();
    clear_suspects();
    failures_ = 0;
    given_up_ = false;
  }

  std::optional<RunEnd> finish() override {
    if (!session_ || session_->open_runs() > 0) return std::nullopt;
    const Ending ending = session_->stop();
    const std::string notes = session_->take_notes();
    session_.reset();
    if (!ending.broke_down()) return std::nullopt;
    RunEnd end = RunEnd::of(RunEnd::Kind::crash,
                            fmt::format("The subject {} when it was told to stop.", ending.text()));
    end.notes = notes;
    return end;
  }

  void set_run_limit(std::chrono::milliseconds limit) override {
    limits_.run = limit;
    if (session_) session_->set_run_limit(limit);
  }

 private:
  struct Announced {
    std::string id;
    std::string program;
  };

  bool takes(std::string_view program) const {
    return info_.features.contains("bytes") || is_utf8(program);
  }

  // A subject that still has programs to run is not asked to go: it would run them first.
  void close() {
    if (session_ && session_->open_runs() == 0) session_->stop();
    session_.reset();
  }

  // What comes is not what was announced.
  void forget_ahead() {
    if (session_ && session_->open_runs() > 0) close();
    ahead_.clear();
    clear_suspects();
  }

  std::optional<RunEnd> open(SubjectInfo* info) {
    configured_ = false;
    try {
      session_ = std::make_unique<PipeSession>(command_, limits_);
    } catch (const std::system_error& error) {
      return RunEnd::of(RunEnd::Kind::crash,
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

  // The first of those announced. After a failure the others are sent again to the next process.
  RunEnd attempt(const RecordSink& sink) {
    if (!session_ || !session_->usable()) {
      if (auto failed = open(nullptr)) return *std::move(failed);
    }
    if (!configured_) {
      refusal_ = session_->configure(configuration_);
      configured_ = session_->usable();
    }
    if (refusal_) return *refusal_;
    send_ahead();
    return session_->receive_run(sink);
  }

  static bool is_breakdown(const RunEnd& end) {
    return end.kind == RunEnd::Kind::crash || end.kind == RunEnd::Kind::timeout ||
           end.kind == RunEnd::Kind::out_of_memory || end.kind == RunEnd::Kind::protocol;
  }

  void clear_suspects() {
    suspects_ = 0;
    breakdown_.reset();
  }

  // Where a subject breaks down with many programs under way, each is run again, one after another:
  // that which it breaks down with alone is to blame. Where it is none of them, it is not
  // forgotten.
  void look_for_culprit(RunEnd& end) {
    if (suspects_ == 0) return;
    if (is_breakdown(end)) return clear_suspects();
    if (--suspects_ > 0) return;
    end = *std::move(breakdown_);
    end.message += " That was with others under way; alone none of them does that.";
    breakdown_.reset();
  }

  // So many programs in a row without an answer may be the programs' doing: one that does nothing
  // tells.
  bool is_given_up() {
    if (failures_ <= limits_.restarts || given_up_) return given_up_;
    std::deque<Announced> announced = std::exchange(ahead_, {Announced{"probe", "M30\n"}});
    given_up_ = is_breakdown(attempt([](const reference::Record&) { return true; }));
    ahead_ = std::move(announced);
    if (session_ && !session_->usable()) session_.reset();
    if (!given_up_) failures_ = 0;
    return given_up_;
  }

  // Half a window at a time, so that not every reply costs a message of its own.
  void send_ahead() {
    const int most = suspects_ > 0 ? 1 : info_.max_in_flight;
    const auto window = static_cast<std::size_t>(std::max(1, most));
    if (2 * session_->open_runs() > window) return;
    for (std::size_t i = session_->open_runs(); i < std::min(window, ahead_.size()); ++i) {
      session_->send_run(ahead_[i].id, ahead_[i].program);
    }
  }

  // A subject that answers may go on for ever; one that only fails may not.
  void count(const RunEnd& end) {
    if (is_breakdown(end)) {
      ++failures_;
    } else if (end.kind != RunEnd::Kind::stopped) {
      failures_ = 0;
    }
  }

  const std::string command_;
  Limits limits_;
  SubjectInfo info_;
  std::deque<Announced> ahead_;  // the next runs; those that were sent stand first
  std::unique_ptr<PipeSession> session_;
  std::string configuration_;
  std::optional<RunEnd> silent_;   // of a machine that it does not take
  bool configured_ = false;        // this session knows the configuration
  std::optional<RunEnd> refusal_;  // and this is what it said against it
  int failures_ = 0;               // in a row
  bool given_up_ = false;
  std::size_t suspects_ = 0;         // of the runs to come, which were under way at a breakdown
  std::optional<RunEnd> breakdown_;  // that one
};

}  // namespace

std::unique_ptr<Subject> make_pipe_subject(const std::string& command, const Limits& limits) {
  return std::make_unique<PipeSubject>(command, limits);
}

}  // namespace gonogo::oracle
