// SPDX-License-Identifier: GPL-3.0-or-later
#include "subjects/library_host.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>

#include "oracle/records/json_document.hpp"
#include "oracle/records/text.hpp"
#include "subjects/interface_handle.hpp"
#include "subjects/interface_record.hpp"
#include "subjects/line_buffer.hpp"
#include "subjects/start_reply.hpp"

namespace gonogo::oracle {
namespace {

using simdjson::dom::element;
using simdjson::dom::object;

constexpr std::size_t kLongestLine = std::size_t{1} << 30;
constexpr std::size_t kPart = std::size_t{1} << 16;  // bytes of records in a part of a reply

std::string_view text_member(const object& source, std::string_view key) {
  std::string_view text;
  if (source[key].get(text) != simdjson::SUCCESS) return {};
  return text;
}

// The description in one line, with the host's window in place of the library's own.
std::string with_window(std::string_view description) {
  JsonDocument document;
  auto parsed = document.parse(description);
  std::string reply = "{";
  for (auto field : std::get<object>(parsed)) {
    if (field.key == "max_in_flight") continue;
    append_json_string(field.key, reply);
    reply += ':' + simdjson::to_string(field.value) + ',';
  }
  return reply + fmt::format("\"max_in_flight\":{}}}", kHostWindow);
}

// An exception has left the library, and nothing in this process is certain any more: the runner
// sees a crash, as with every other way to end it.
[[noreturn]] void die(const RunEnd& end) {
  std::fprintf(stderr, "%s\n", end.message.c_str());
  std::abort();
}

}  // namespace

class LibraryHost::Impl {
 public:
  Impl(const gonogo_subject_v1& subject, int input, int output);
  void serve();
  const std::string& start_reply() const { return start_reply_; }

 private:
  bool answer(std::string_view line);
  void start(const object& message);
  void configure(const object& message);
  void reset();
  void run(const object& message);
  bool take(const gonogo_record_v1& record, std::string& fault);
  void close_reply(const RunEnd& end);
  void refuse(std::string_view message);
  void write();

  InterfaceHandle handle_;
  std::string start_reply_;
  int input_;
  int output_;
  LineBuffer lines_;
  JsonDocument document_;
  std::string program_;  // of one in base64
  std::string reply_;    // what waits to be written
  std::string seq_;
  std::size_t records_ = 0;  // in reply_
  bool has_reader_ = true;   // somebody reads the output
};

LibraryHost::Impl::Impl(const gonogo_subject_v1& subject, int input, int output)
    : handle_(subject), input_(input), output_(output), lines_(kLongestLine) {
  const std::string description = handle_.description();
  read_description(description);
  start_reply_ = with_window(description);
}

void LibraryHost::Impl::serve() {
  while (has_reader_) {
    while (const auto line = lines_.next()) {
      if (!answer(*line) || !has_reader_) return;
    }
    if (lines_.too_long()) return refuse("The line is too long for a message.");
    const std::span<char> room = lines_.room();
    const ssize_t count = ::read(input_, room.data(), room.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return;
    lines_.commit(static_cast<std::size_t>(count));
  }
}

bool LibraryHost::Impl::answer(std::string_view line) {
  if (line.find_first_not_of(" \t\r") == std::string_view::npos) return true;
  auto parsed = document_.parse_padded(line);
  if (auto* fault = std::get_if<JsonFault>(&parsed)) {
    refuse(fault->message);
    return true;
  }
  const object& message = std::get<object>(parsed);
  const std::string_view command = text_member(message, "cmd");
  if (command == "stop") return false;
  if (command == "start") {
    start(message);
  } else if (command == "configure") {
    configure(message);
  } else if (command == "reset") {
    reset();
  } else if (command == "run") {
    run(message);
  } else {
    refuse(fmt::format("There is no command \"{}\".", excerpt(command, 60)));
  }
  return true;
}

void LibraryHost::Impl::start(const object& message) {
  simdjson::dom::array offered;
  if (message["protocol"].get(offered) == simdjson::SUCCESS) {
    for (auto version : offered) {
      std::int64_t number = 0;
      if (version.get(number) == simdjson::SUCCESS && number == 1) {
        reply_ = start_reply_;
        return write();
      }
    }
  }
  refuse("This host speaks version 1 of the protocol.");
}

void LibraryHost::Impl::configure(const object& message) {
  element dialect;
  element profile;
  if (message["dialect"].get(dialect) != simdjson::SUCCESS ||
      message["profile"].get(profile) != simdjson::SUCCESS) {
    return refuse("A configuration needs \"dialect\" and \"profile\".");
  }
  handle_.close();
  handle_.configure("{\"dialect\":" + simdjson::to_string(dialect) +
                    ",\"profile\":" + simdjson::to_string(profile) + "}");
  const auto failed = handle_.prepare();
  if (failed && failed->kind == RunEnd::Kind::refused) return refuse(failed->message);
  if (failed && failed->kind == RunEnd::Kind::crash) die(*failed);
  // Any other failure is the answer to each run: a refusal would be counted as a skip.
  reply_ = R"({"ok":true})";
  write();
}

void LibraryHost::Impl::reset() {
  const auto failed = handle_.prepare();
  if (failed && failed->kind == RunEnd::Kind::crash) die(*failed);
  if (failed) return refuse(failed->message);
  reply_ = R"({"ok":true})";
  write();
}

void LibraryHost::Impl::run(const object& message) {
  element seq;
  seq_ = message["seq"].get(seq) == simdjson::SUCCESS ? simdjson::to_string(seq) : "0";
  std::string_view program;
  if (message["program"].get(program) != simdjson::SUCCESS) {
    object packed;
    auto bytes = message["program"].get(packed) == simdjson::SUCCESS
                     ? decode_base64(text_member(packed, "base64"))
                     : std::nullopt;
    if (!bytes) {
      RunEnd end;
      end.kind = RunEnd::Kind::error;
      end.message = "A run needs \"program\", a text or {\"base64\":\"...\"}.";
      return close_reply(end);
    }
    program_ = *std::move(bytes);
    program = program_;
  }
  reply_.clear();
  records_ = 0;
  const RunEnd end = handle_.run(
      program,
      [this](const gonogo_record_v1& record, std::string& fault) { return take(record, fault); });
  close_reply(end);
}

bool LibraryHost::Impl::take(const gonogo_record_v1& record, std::string& fault) {
  if (auto wrong = form_fault(record)) {
    fault = std::move(wrong->message);
    return false;
  }
  if (records_ == 0) {
    reply_ = fmt::format("{{\"seq\":{},\"records\":[", seq_);
  } else {
    reply_ += ',';
  }
  ++records_;
  append_json(record, reply_);
  if (reply_.size() >= kPart) {
    reply_ += "],\"more\":true}";
    records_ = 0;
    write();
  }
  return has_reader_;
}

void LibraryHost::Impl::close_reply(const RunEnd& end) {
  if (end.kind == RunEnd::Kind::crash) die(end);
  reply_ += records_ > 0 ? "]," : fmt::format("{{\"seq\":{},", seq_);
  if (!end.notes.empty()) {
    reply_ += "\"notes\":";
    append_json_string(readable(end.notes), reply_);
    reply_ += ',';
  }
  if (end.kind == RunEnd::Kind::ok) {
    reply_ += "\"outcome\":\"ok\"}";
    return write();
  }
  if (end.kind == RunEnd::Kind::alarm) {
    reply_ += "\"outcome\":\"alarm\",\"alarm\":";
    append_json(end.alarm, reply_);
    reply_ += '}';
    return write();
  }
  if (end.kind == RunEnd::Kind::skip) {
    reply_ += "\"outcome\":\"skip\",\"feature\":";
    append_json_string(end.feature, reply_);
  } else {
    reply_ += "\"outcome\":\"error\"";
    if (end.kind == RunEnd::Kind::protocol) {
      reply_ += ",\"feature\":";
      append_json_string(kBrokenInterface, reply_);
    }
  }
  reply_ += ",\"message\":";
  append_json_string(end.message, reply_);
  reply_ += '}';
  write();
}

void LibraryHost::Impl::refuse(std::string_view message) {
  reply_ = "{\"ok\":false,\"message\":";
  append_json_string(readable(message), reply_);
  reply_ += '}';
  write();
}

void LibraryHost::Impl::write() {
  reply_ += '\n';
  std::string_view left = reply_;
  while (!left.empty() && has_reader_) {
    const ssize_t count = ::write(output_, left.data(), left.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      has_reader_ = false;  // the runner has gone
      break;
    }
    left.remove_prefix(static_cast<std::size_t>(count));
  }
  reply_.clear();
}

LibraryHost::LibraryHost(const gonogo_subject_v1& subject, int input, int output)
    : impl_(std::make_unique<Impl>(subject, input, output)) {}
LibraryHost::LibraryHost(LibraryHost&&) noexcept = default;
LibraryHost::~LibraryHost() = default;

void LibraryHost::serve() {
  impl_->serve();
}

const std::string& LibraryHost::start_reply() const {
  return impl_->start_reply();
}

}  // namespace gonogo::oracle
