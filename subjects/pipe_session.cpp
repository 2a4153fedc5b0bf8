// SPDX-License-Identifier: GPL-3.0-or-later
#include "subjects/pipe_session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <thread>
#include <utility>

#include "oracle/records/record_json.hpp"
#include "oracle/records/text.hpp"
#include "subjects/start_reply.hpp"

namespace gonogo::oracle {
namespace {

using simdjson::dom::object;

constexpr std::chrono::milliseconds kFarewell{500};
constexpr std::string_view kStart =
    R"({"cmd":"start","protocol":[1],"runner":"gonogo )" GONOGO_VERSION R"("})";

void append_run_message(std::int64_t seq, std::string_view id, std::string_view program,
                        std::string& line) {
  line += fmt::format(R"({{"cmd":"run","seq":{},"id":)", seq);
  append_json_string(readable(id), line);
  line += ",\"program\":";
  if (is_utf8(program)) {
    append_json_string(program, line);
  } else {
    line += "{\"base64\":\"" + base64(program) + "\"}";
  }
  line += "}\n";
}

}  // namespace

PipeSession::PipeSession(const std::string& command, const Limits& limits)
    : limits_(limits), process_(command, limits), lines_(limits.line_bytes) {}

RunEnd PipeSession::fail(RunEnd::Kind kind, std::string message) {
  usable_ = false;
  process_.kill();
  return RunEnd::of(kind, std::move(message));
}

// The subject closed its output or is gone. A process that closes its output is about to end, and
// how it ends says more than that it was killed here.
RunEnd PipeSession::fail_at_end() {
  process_.arm(kFarewell);
  const std::size_t half = lines_.rest().size();
  LineBuffer rest(0);
  process_.pump_to_end(rest, drop);
  const Ending ending = process_.kill();
  const std::string what =
      ending.by_itself ? "The subject " + ending.text() : "The subject closed its output";
  return fail(RunEnd::Kind::crash,
              fmt::format("{} while {}{}.", what, doing_,
                          half > 0 ? fmt::format(", after {} bytes of a line", half) : ""));
}

// A line before it was asked for, or behind the reply.
std::optional<RunEnd> PipeSession::unasked(bool look) {
  if (look && lines_.empty()) {
    process_.arm(std::chrono::milliseconds(0));
    const Process::Event event = process_.pump(lines_);
    if (event == Process::Event::closed || event == Process::Event::exited) return fail_at_end();
  }
  if (lines_.empty()) return std::nullopt;
  return fail(RunEnd::Kind::protocol,
              "The subject wrote what was not asked for: " + excerpt(lines_.rest()));
}

void PipeSession::arm(std::chrono::milliseconds time) {
  time_ = time;
  process_.arm(time);
}

std::optional<RunEnd> PipeSession::ask(std::string line, std::chrono::milliseconds time) {
  if (auto failed = unasked(true)) return failed;
  arm(time);
  process_.send(std::move(line) + '\n');
  return std::nullopt;
}

// Waits for output, and a little longer where the subject has enough to do meanwhile.
Process::Event PipeSession::look() {
  waited_ = true;
  const auto wait = std::min<Process::Clock::duration>(pace_.wait(open_.size()), time_ / 8);
  if (wait > Process::Clock::duration::zero()) std::this_thread::sleep_for(wait);
  const Process::Event event = process_.pump(lines_);
  if (event != Process::Event::output) return event;
  const auto now = Process::Clock::now();
  pace_.note(lines_.whole_lines(), open_.size() + 1, now - std::exchange(looked_, now));
  return event;
}

PipeSession::Parsed PipeSession::read_line() {
  while (true) {
    auto line = lines_.next();
    if (lines_.too_long()) {
      return fail(RunEnd::Kind::protocol, fmt::format("A line has more than {} bytes, while {}.",
                                                      limits_.line_bytes, doing_));
    }
    if (line) {
      read_ += line->size() + 1;
      auto parsed = document_.parse_padded(*line);
      if (auto* fault = std::get_if<JsonFault>(&parsed)) {
        return fail(RunEnd::Kind::protocol, fault->message);
      }
      return std::get<object>(parsed);
    }
    switch (look()) {
      case Process::Event::output:
        break;
      case Process::Event::closed:
      case Process::Event::exited:
        return fail_at_end();
      case Process::Event::deadline:
        return fail(RunEnd::Kind::timeout, fmt::format("The subject gave no answer within {} ms "
                                                       "while {}.",
                                                       time_.count(), doing_));
      case Process::Event::excess:
        return fail(RunEnd::Kind::out_of_memory,
                    fmt::format("The subject {} while {}.", process_.excess(), doing_));
    }
  }
}

std::variant<SubjectInfo, RunEnd> PipeSession::start() {
  doing_ = "starting";
  if (auto failed = ask(std::string(kStart), limits_.start)) return *std::move(failed);
  auto reply = read_line();
  if (auto* end = std::get_if<RunEnd>(&reply)) return std::move(*end);
  auto info = read_start_reply(std::get<object>(reply));
  if (auto* fault = std::get_if<JsonFault>(&info)) {
    return fail(RunEnd::Kind::protocol, fault->message);
  }
  if (auto extra = unasked(false)) return *std::move(extra);
  return std::get<SubjectInfo>(std::move(info));
}

std::optional<RunEnd> PipeSession::configure(const std::string& members) {
  doing_ = "being configured";
  if (auto failed = ask("{\"cmd\":\"configure\"," + members + "}", limits_.start)) return failed;
  auto reply = read_line();
  if (auto* end = std::get_if<RunEnd>(&reply)) return std::move(*end);
  bool ok = false;
  if (std::get<object>(reply)["ok"].get(ok) != simdjson::SUCCESS) {
    return fail(RunEnd::Kind::protocol, "The reply to \"configure\" needs \"ok\":true or false.");
  }
  std::string_view message;
  if (!ok && std::get<object>(reply)["message"].get(message) != simdjson::SUCCESS) {
    message = "The subject does not say which key it refuses.";
  }
  if (auto extra = unasked(false)) return extra;
  if (ok) return std::nullopt;
  return RunEnd::of(RunEnd::Kind::refused, excerpt(message, 1000));
}

void PipeSession::send_run(std::string_view id, std::string_view program) {
  if (open_.empty()) {  // the subject has nothing to say
    doing_ = fmt::format("running {}", excerpt(id));
    unasked_for_ = unasked(true);
  }
  open_.push_back({++seq_, std::string(id)});
  // A subject could look answers up by the name of a case.
  append_run_message(seq_, limits_.show_ids ? std::string(id) : std::to_string(seq_), program,
                     outgoing_);
}

RunEnd PipeSession::receive_run(const RecordSink& sink) {
  delivered_ = false;
  const OpenRun run = std::move(open_.front());
  open_.pop_front();
  doing_ = fmt::format("running {}", excerpt(run.id));
  if (unasked_for_) return *std::exchange(unasked_for_, std::nullopt);
  const auto begin = Process::Clock::now();
  in_sink_ = Process::Clock::duration::zero();
  arm(limits_.run);
  waited_ = false;
  if (!outgoing_.empty()) process_.send(std::exchange(outgoing_, {}));
  RunEnd end = receive(run.seq, sink);
  const auto spent = share_of(Process::Clock::now() - begin - in_sink_);
  end.microseconds = std::chrono::duration_cast<std::chrono::microseconds>(spent).count();
  return end;
}

Process::Clock::duration PipeSession::share_of(Process::Clock::duration spent) {
  if (waited_) {
    sharers_ = open_.empty() ? 0 : lines_.whole_lines();
    share_ = spent / static_cast<Process::Clock::rep>(sharers_ + 1);
    return share_;
  }
  if (sharers_ == 0) return spent;
  --sharers_;
  return spent + share_;
}

namespace {

RunEnd end_of(PipeReply& reply) {
  RunEnd end;
  end.kind = reply.outcome;
  end.alarm = std::move(reply.alarm);
  end.feature = std::move(reply.feature);
  end.message = std::move(reply.message);
  end.notes = std::move(reply.notes);
  return end;
}

}  // namespace

RunEnd PipeSession::receive(std::int64_t seq, const RecordSink& sink) {
  // The sink has seen enough, but the run may end as a skip (J-RUN-05).
  std::optional<RunEnd> stopped;
  while (true) {
    auto parsed = read_line();
    if (auto* end = std::get_if<RunEnd>(&parsed)) return std::move(stopped).value_or(*end);
    auto read = read_pipe_reply(std::get<object>(parsed), seq);
    if (auto* fault = std::get_if<TraceFault>(&read)) {
      const RunEnd end = fail(RunEnd::Kind::protocol, std::move(fault->message));
      return std::move(stopped).value_or(end);
    }
    auto& reply = std::get<PipeReply>(read);
    if (!stopped) {
      stopped = deliver(reply, sink);
      if (!usable_) return *std::move(stopped);
      read_ = 0;
    }
    if (reply.more) {
      if (stopped && read_ > limits_.further_bytes) {
        return fail(RunEnd::Kind::stopped, std::move(stopped->message));
      }
      continue;
    }
    if (open_.empty()) {
      if (auto extra = unasked(false)) return *std::move(extra);
    }
    if (stopped && reply.outcome != RunEnd::Kind::skip) return *std::move(stopped);
    return end_of(reply);
  }
}

// The time that the oracle takes for the records is not the subject's.
std::optional<RunEnd> PipeSession::deliver(const PipeReply& reply, const RecordSink& sink) {
  if (!reply.records || reply.records->size() == 0) return std::nullopt;
  delivered_ = true;
  const auto begin = Process::Clock::now();
  const auto take = [&](const simdjson::dom::element& item) -> std::optional<RunEnd> {
    object source;
    if (item.get(source) != simdjson::SUCCESS) {
      return fail(RunEnd::Kind::protocol, "A record must be an object.");
    }
    auto line = read_trace_line(source);
    if (auto* fault = std::get_if<TraceFault>(&line)) {
      return fail(RunEnd::Kind::protocol, std::move(fault->message));
    }
    auto* record = std::get_if<reference::Record>(&line);
    if (record == nullptr) {
      return fail(RunEnd::Kind::protocol,
                  "An alarm stands in the key \"alarm\" of the reply, not among the records.");
    }
    if (!sink(*record)) return RunEnd::of(RunEnd::Kind::stopped, "The run was stopped.");
    return std::nullopt;
  };
  std::optional<RunEnd> end;
  try {
    for (auto item : *reply.records) {
      end = take(item);
      if (end) break;
    }
  } catch (...) {  // the sink's own affair; the rest of the reply will not be read
    fail(RunEnd::Kind::stopped, {});
    throw;
  }
  const auto spent = Process::Clock::now() - begin;
  in_sink_ += spent;
  process_.extend(spent);
  return end;
}

Ending PipeSession::stop() {
  if (!usable_) return {};
  process_.send("{\"cmd\":\"stop\"}\n");
  process_.end_input();
  process_.arm(kFarewell);
  LineBuffer ignored(0);
  process_.pump_to_end(ignored, drop);
  usable_ = false;
  return process_.kill();
}

}  // namespace gonogo::oracle
