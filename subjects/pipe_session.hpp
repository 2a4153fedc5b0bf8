// SPDX-License-Identifier: GPL-3.0-or-later
//
// One life of a subject's process under the pipe protocol, from `start` to its end.
#pragma once

#include <deque>

#include "oracle/records/json_document.hpp"
#include "subjects/line_buffer.hpp"
#include "subjects/pipe_reply.hpp"
#include "subjects/process.hpp"
#include "subjects/reply_pace.hpp"

namespace gonogo::oracle {

class PipeSession {
 public:
  // Throws std::system_error when no process can be started.
  PipeSession(const std::string& command, const Limits& limits);

  // Each returns what went wrong, if anything did. After a failure other than `refused` the
  // session is of no further use.
  std::variant<SubjectInfo, RunEnd> start();
  std::optional<RunEnd> configure(const std::string& members);

  // Sends a program to be run, at the latest when a reply is waited for. Under one configuration
  // many may be open at the same time; the replies come in the same order.
  void send_run(std::string_view id, std::string_view program);
  std::size_t open_runs() const { return open_.size(); }
  // The reply to the first of the open runs. Its time begins with the call: when it was sent, or
  // when the reply to its predecessor had been read. Replies that came together share the time
  // equally. REQUIRES: open_runs() > 0
  RunEnd receive_run(const RecordSink& sink);
  // For the runs from now on.
  void set_run_limit(std::chrono::milliseconds limit) { limits_.run = limit; }

  // Asks the subject to go, and waits a little for it.
  Ending stop();

  bool usable() const { return usable_; }
  // Whether records of the last run came.
  bool delivered() const { return delivered_; }
  std::string take_notes() { return process_.take_notes(); }

 private:
  using Parsed = std::variant<simdjson::dom::object, RunEnd>;

  std::optional<RunEnd> ask(std::string line, std::chrono::milliseconds time);
  void arm(std::chrono::milliseconds time);
  RunEnd receive(std::int64_t seq, const RecordSink& sink);
  Parsed read_line();
  Process::Event look();
  Process::Clock::duration share_of(Process::Clock::duration spent);
  std::optional<RunEnd> deliver(const PipeReply& reply, const RecordSink& sink);
  std::optional<RunEnd> unasked(bool look);
  RunEnd fail(RunEnd::Kind kind, std::string message);
  RunEnd fail_at_end();

  struct OpenRun {
    std::int64_t seq;
    std::string id;
  };
  Limits limits_;
  Process process_;
  LineBuffer lines_;
  JsonDocument document_;
  std::string doing_ = "starting";  // for messages
  std::chrono::milliseconds time_{0};
  Process::Clock::duration in_sink_{0};
  ReplyPace pace_;
  Process::Clock::time_point looked_;  // when output came last
  bool waited_ = false;                // the present run, for its reply
  std::size_t sharers_ = 0;            // replies, not yet delivered, that came with the last one
  Process::Clock::duration share_{0};  // of each of them in the time until they came
  std::string outgoing_;               // runs to be sent
  std::int64_t seq_ = 0;
  std::deque<OpenRun> open_;           // sent, not yet answered
  std::optional<RunEnd> unasked_for_;  // what was wrong before the first of them was sent
  std::size_t read_ = 0;               // bytes of lines, since it was set to 0
  bool usable_ = true;
  bool delivered_ = false;
};

}  // namespace gonogo::oracle
