// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign/trace_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "campaign/results.hpp"
#include "oracle/records/output_file.hpp"
#include "oracle/steps/step_text.hpp"

namespace gonogo::oracle {
namespace {

std::string subject_json(const SubjectInfo& subject) {
  nlohmann::ordered_json reply;
  reply["protocol"] = 1;
  reply["subject"] = {{"name", subject.name}, {"version", subject.version}};
  if (!subject.everything) reply["dialects"] = subject.dialects;
  reply["features"] = subject.features;
  reply["numeric"] = numeric_json(subject);
  return reply.dump() + "\n";
}

}  // namespace

TraceFile::TraceFile(const std::string& folder, std::string_view id, int number)
    : path_(fmt::format("{}/{}.jsonl", folder, id)),
      part_(number == 1 ? path_ + ".part" : fmt::format("{}.{}.part", path_, number)) {
  ::unlink(path_.c_str());
  file_ = open_stream(create_anew(part_), "w");
  if (file_ == nullptr) error_ = errno;
}

TraceFile::~TraceFile() {
  if (file_ != nullptr) ::unlink(part_.c_str());
}

void TraceFile::put(const std::string& line) {
  if (error_ == 0 && !write_line(file_.get(), line)) error_ = errno;
}

void TraceFile::record(const reference::Record& record) {
  if (error_ == 0) put(record_text(record));
}

void TraceFile::finish(const RunEnd& end) {
  const bool is_answer = end.kind == RunEnd::Kind::ok || end.kind == RunEnd::Kind::alarm ||
                         end.kind == RunEnd::Kind::stopped;
  if (end.kind == RunEnd::Kind::alarm) put(alarm_text(end.alarm));
  if (error_ == 0 && std::fflush(file_.get()) != 0) error_ = errno;
  if (error_ != 0) fail_to_write(part_, error_);
  has_outcome_ = is_answer && end.sampled == nullptr;
}

void TraceFile::keep() {
  if (!has_outcome_) return;
  if (std::rename(part_.c_str(), path_.c_str()) != 0) fail_to_write(path_, errno);
  file_.reset();
}

void begin_traces(const std::string& folder, const SubjectInfo& subject) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) fail_to_write(folder, error.value());
  const std::string path = folder + "/subject.json";
  const std::string text = subject_json(subject);
  try {
    write_file(path, text);
  } catch (const std::system_error& unwritten) {
    fail_to_write(path, unwritten.code().value());
  }
}

}  // namespace gonogo::oracle
