// SPDX-License-Identifier: GPL-3.0-or-later
#include "harness.hpp"

#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "expanders/registry.hpp"

namespace gonogo::expanders::testing {
namespace {

std::string text_of(const gonogo_number& number) {
  if (number.form != GONOGO_NUMBER_TEXT) throw std::logic_error("a number that is no text");
  return {number.text.data, number.text.size};
}

std::string feed_of(const gonogo_record_v1& record) {
  return " f=" + text_of(record.f) + (record.feed_mode == GONOGO_FEED_PER_REVOLUTION ? "/rev" : "");
}

std::string to_of(const gonogo_record_v1& record) {
  std::string text;
  for (std::size_t axis = 0; axis < GONOGO_AXES; ++axis) {
    if (record.to[axis].form == GONOGO_NUMBER_ABSENT) continue;
    text += std::string(" ") + "xyzac"[axis] + "=" + text_of(record.to[axis]);
  }
  return text;
}

std::string dialect_of(std::string_view maker) {
  if (maker == "gsk") return "gsk988ta";
  if (maker == "sinumerik") return "sinumerik840d";
  if (maker == "sinumerik802s") return "sinumerik802s";
  return maker == "hnc" ? "hnc21t" : "rs274";
}

std::string describe(const gonogo_record_v1& record) {
  switch (record.kind) {
    case GONOGO_RAPID:
      return "rapid" + to_of(record);
    case GONOGO_FEED:
      return "feed" + to_of(record) + feed_of(record);
    case GONOGO_ARC:
      return "arc" + std::to_string(record.plane) + " c=" + text_of(record.centre[0]) + "," +
             text_of(record.centre[1]) + " rot=" + std::to_string(record.rot) + to_of(record) +
             feed_of(record);
    case GONOGO_ARC3:
      return "arc3 via=" + text_of(record.via[0]) + "," + text_of(record.via[1]) + "," +
             text_of(record.via[2]) + to_of(record) + feed_of(record);
    case GONOGO_THREAD:
      return "thread" + to_of(record) + " lead=" + text_of(record.lead) +
             " start=" + text_of(record.start);
    case GONOGO_DWELL:
      return "dwell " + text_of(record.seconds);
    case GONOGO_M:
      return "m " + std::to_string(record.m);
    case GONOGO_END:
      return "end" + to_of(record);
    default:
      throw std::logic_error("an unexpected kind of record");
  }
}

}  // namespace

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

std::string after_first(const Outcome& outcome) {
  return joined({outcome.records.begin() + 1, outcome.records.end() - 1});
}

std::string millimetres(long thousandths) {
  char text[32];
  std::snprintf(text, sizeof text, "%s%ld.%03ld", thousandths < 0 ? "-" : "",
                std::labs(thousandths) / 1000, std::labs(thousandths) % 1000);
  return text;
}

std::string Outcome::trace() const {
  std::string text;
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (records[i].starts_with("end")) continue;
    text += std::to_string(blocks[i]) + " " + records[i] + "\n";
  }
  if (alarms != 0) text += "alarm " + alarm + " in " + std::to_string(alarm_block) + "\n";
  return text;
}

std::string Outcome::motions() const {
  std::vector<std::string> kept = records;
  if (!kept.empty() && kept.back().starts_with("end")) kept.pop_back();
  return joined(kept);
}

std::string Outcome::all() const {
  std::string text = "answer " + std::to_string(answer) + "\n";
  for (std::size_t i = 0; i < records.size(); ++i) {
    text += std::to_string(blocks[i]) + " " + records[i] + "\n";
  }
  if (alarms != 0) text += "alarm " + alarm + " in " + std::to_string(alarm_block) + "\n";
  return text;
}

int Session::take_record(void* context, const gonogo_record_v1* record) {
  auto& session = *static_cast<Session*>(context);
  session.outcome_.records.push_back(describe(*record));
  session.outcome_.blocks.push_back(record->block);
  return session.outcome_.records.size() >= session.most_ ? 1 : 0;
}

void Session::take_alarm(void* context, const gonogo_alarm_v1* alarm) {
  Outcome& outcome = static_cast<Session*>(context)->outcome_;
  ++outcome.alarms;
  outcome.alarm.assign(alarm->klass.data, alarm->klass.size);
  outcome.native.assign(alarm->native.data, alarm->native.size);
  outcome.alarm_block = alarm->block;
  outcome.alarm_word = alarm->word;
}

void Session::take_note(void* context, int, gonogo_text message) {
  static_cast<Session*>(context)->outcome_.note.assign(message.data, message.size);
}

Session::Session(std::string_view profile, std::string_view fault, std::string_view maker)
    : subject_(find(maker == "sinumerik802s" ? "sinumerik" : maker, fault)) {
  if (subject_ == nullptr) throw std::logic_error("no such subject");
  sink_.struct_size = sizeof sink_;
  sink_.context = this;
  sink_.record = &take_record;
  sink_.alarm = &take_alarm;
  sink_.note = &take_note;
  const std::string configuration =
      R"({"dialect":")" + dialect_of(maker) + R"(","profile":)" + std::string(profile) + "}";
  outcome_.create =
      subject_->create({configuration.data(), configuration.size()}, &sink_, &handle_);
}

Session::~Session() {
  if (handle_ != nullptr) subject_->destroy(handle_);
}

Outcome Session::run(std::string_view program, std::size_t most) {
  if (handle_ == nullptr) return outcome_;
  outcome_ = Outcome{};
  most_ = most;
  outcome_.answer = subject_->run(handle_, {program.data(), program.size()});
  return outcome_;
}

Outcome run(std::string_view program, std::string_view profile, std::string_view fault) {
  return Session(profile, fault).run(program);
}

Outcome run_with_reading(const std::string& reading, const std::string& value,
                         std::string_view program) {
  return run(program, R"({"x_diameter":false,"readings":{")" + reading + R"(":")" + value + "\"}}");
}

Outcome run_hnc(std::string_view program, std::string_view profile, std::string_view fault) {
  return Session(profile, fault, "hnc").run(program);
}

Outcome run_ngc(std::string_view program, std::string_view profile, std::string_view fault) {
  nlohmann::json keys = nlohmann::json::parse(profile);
  auto& end = keys["readings"]["ngc.program-end"];
  if (end.is_null()) end = "free";
  return Session(keys.dump(), fault, "ngc").run(program);
}

Outcome run_sinumerik(std::string_view program, std::string_view profile, std::string_view fault) {
  return Session(profile, fault, "sinumerik").run(program);
}

Outcome run_sinumerik802s(std::string_view program, std::string_view profile,
                          std::string_view fault) {
  return Session(profile, fault, "sinumerik802s").run(program);
}

}  // namespace gonogo::expanders::testing
