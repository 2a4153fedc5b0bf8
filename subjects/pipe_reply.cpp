// SPDX-License-Identifier: GPL-3.0-or-later
#include "subjects/pipe_reply.hpp"

#include <fmt/format.h>

#include "oracle/records/record_json.hpp"
#include "oracle/records/text.hpp"

namespace gonogo::oracle {
namespace {

using simdjson::dom::element;
using simdjson::dom::element_type;
using simdjson::dom::object;

// Thrown inside this file only.
struct ReplyFault {
  std::string message;
};

constexpr std::size_t kLongestMessage = 1000;
constexpr std::size_t kLongestNotes = 16384;

template <class Value>
Value value_of(std::string_view key, const element& source, std::string_view type) {
  Value value;
  if (source.get(value) != simdjson::SUCCESS) {
    throw ReplyFault{fmt::format("The key \"{}\" of a reply must be {}.", key, type)};
  }
  return value;
}

std::string reply_text(std::string_view key, const element& value) {
  return excerpt(value_of<std::string_view>(key, value, "a string"), kLongestMessage);
}

RunEnd::Kind outcome_of(std::string_view text) {
  if (text == "ok") return RunEnd::Kind::ok;
  if (text == "alarm") return RunEnd::Kind::alarm;
  if (text == "skip") return RunEnd::Kind::skip;
  if (text == "error") return RunEnd::Kind::error;
  throw ReplyFault{fmt::format("The outcome \"{}\" is unknown.", excerpt(text, 60))};
}

// What stands in a reply, before the keys are checked against each other.
struct Parts {
  PipeReply reply;
  std::optional<std::int64_t> seq;
  bool has_outcome = false;
  bool has_alarm = false;
};

void read_field(std::string_view key, const element& value, Parts& parts) {
  PipeReply& reply = parts.reply;
  if (key == "seq") {
    if (value.type() != element_type::INT64) {
      throw ReplyFault{"The key \"seq\" of a reply must be a JSON integer."};
    }
    parts.seq = value_of<std::int64_t>(key, value, "a JSON integer");
  } else if (key == "outcome") {
    parts.has_outcome = true;
    reply.outcome = outcome_of(value_of<std::string_view>(key, value, "a string"));
  } else if (key == "records") {
    reply.records = value_of<simdjson::dom::array>(key, value, "an array");
  } else if (key == "more") {
    reply.more = value_of<bool>(key, value, "true or false");
  } else if (key == "alarm") {
    parts.has_alarm = true;
    auto alarm = read_alarm(value_of<object>(key, value, "an object"));
    if (auto* fault = std::get_if<TraceFault>(&alarm)) throw ReplyFault{fault->message};
    reply.alarm = std::get<SubjectAlarm>(std::move(alarm));
  } else if (key == "feature") {
    reply.feature = reply_text(key, value);
  } else if (key == "message") {
    reply.message = reply_text(key, value);
  } else if (key == "notes") {
    reply.notes = visible(
        value_of<std::string_view>(key, value, "a string").substr(0, kLongestNotes), Lines::kept);
  } else if (key.substr(0, 2) != "x-") {
    throw ReplyFault{fmt::format("A reply has no key \"{}\"; a key of your own begins with x-.",
                                 excerpt(key, 60))};
  }
}

void check(const Parts& parts, std::int64_t seq) {
  if (!parts.seq) throw ReplyFault{"The reply has no \"seq\"."};
  if (*parts.seq != seq) {
    throw ReplyFault{fmt::format("The reply has \"seq\":{}; {} was asked.", *parts.seq, seq)};
  }
  const PipeReply& reply = parts.reply;
  if (parts.has_outcome == reply.more) {
    throw ReplyFault{reply.more ? "A part with \"more\":true has no outcome yet."
                                : "The reply has neither \"outcome\" nor \"more\":true."};
  }
  if (parts.has_alarm != (parts.has_outcome && reply.outcome == RunEnd::Kind::alarm)) {
    throw ReplyFault{parts.has_alarm ? "The reply has an \"alarm\" and another outcome."
                                     : "The outcome \"alarm\" needs the key \"alarm\"."};
  }
  if (!reply.more && reply.outcome == RunEnd::Kind::skip && reply.feature.empty()) {
    throw ReplyFault{"The outcome \"skip\" needs the key \"feature\"."};
  }
}

}  // namespace

std::variant<PipeReply, TraceFault> read_pipe_reply(const object& reply, std::int64_t seq) try {
  Parts parts;
  for (auto field : reply) read_field(field.key, field.value, parts);
  check(parts, seq);
  return std::move(parts.reply);
} catch (const ReplyFault& fault) {
  return TraceFault{fault.message};
}

}  // namespace gonogo::oracle
