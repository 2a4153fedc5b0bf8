// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/capture_subject.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "capture/captured_samples.hpp"
#include "capture/captured_trace.hpp"
#include "capture/export_manifest.hpp"
#include "oracle/records/features.hpp"
#include "oracle/records/input_file.hpp"
#include "oracle/records/trace_reader.hpp"
#include "reference/dialect.hpp"
#include "subjects/start_reply.hpp"

namespace gonogo::oracle {
namespace {

namespace fs = std::filesystem;

std::string text_of_file(const fs::path& path) {
  std::ifstream file = open_regular(path);
  if (!file) throw SubjectUnusable(fmt::format("{} cannot be opened.", path.string()));
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// Everything of a dialect by name: what has no file is skipped, and that is no broken promise.
void declare_everything(SubjectInfo& info) {
  if (info.everything || info.dialects.empty()) {
    for (const reference::Dialect& dialect : reference::dialects()) {
      info.dialects[std::string(dialect.name)];
    }
  }
  info.everything = false;
  info.recorded = true;
  for (auto& [dialect, features] : info.dialects) {
    if (!features.empty()) continue;
    for (const Feature& feature : feature_vocabulary()) {
      if (feature.dialect == dialect) features.insert(std::string(feature.name));
    }
  }
}

// Whether the recorded traces name source lines: all of those that begin with a record do there. An
// `end` or an alarm needs no line.
bool traces_name_blocks(const fs::path& folder) {
  bool any = false;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".jsonl") continue;
    std::ifstream file = open_regular(entry.path());
    TraceReader reader;
    for (std::string line; std::getline(file, line);) {
      if (line.find("\"k\"") == std::string::npos) continue;
      const TraceLine read = reader.read(line);
      const auto* record = std::get_if<reference::Record>(&read);
      if (record == nullptr || record->kind == reference::RecordKind::end) break;
      if (record->block == 0) return false;
      any = true;
      break;
    }
  }
  return any;
}

SubjectInfo read_info(const fs::path& folder) {
  SubjectInfo info;
  const fs::path path = folder / "subject.json";
  if (fs::exists(path)) {
    JsonDocument document;
    const std::string text = text_of_file(path);
    auto parsed = document.parse(text);
    const auto* fault = std::get_if<JsonFault>(&parsed);
    std::variant<SubjectInfo, JsonFault> read =
        fault != nullptr ? *fault : read_start_reply(std::get<simdjson::dom::object>(parsed));
    if (auto* wrong = std::get_if<JsonFault>(&read)) {
      throw SubjectUnusable(fmt::format("{}: {}", path.string(), wrong->message));
    }
    info = std::get<SubjectInfo>(std::move(read));
  } else {
    info.name = "capture";
    if (traces_name_blocks(folder)) info.features.insert("blocks");
  }
  declare_everything(info);
  info.max_in_flight = 1;
  return info;
}

class CaptureSubject : public Subject {
 public:
  CaptureSubject(fs::path folder, const CaptureOptions& options) : folder_(std::move(folder)) {
    if (!fs::is_directory(folder_)) {
      throw SubjectUnusable(
          fmt::format("There is no folder {}. Name the folder of what came back: capture:DIR.",
                      folder_.string()));
    }
    info_ = read_info(folder_);
    const fs::path own = folder_ / "manifest.json";
    const std::string manifest = !options.manifest.empty() ? options.manifest
                                 : fs::exists(own)         ? own.string()
                                                           : std::string();
    if (!manifest.empty()) programs_ = read_export_manifest(manifest);
    if (options.feed_tolerance) sampled_.feed_tolerance = *options.feed_tolerance;
    if (options.blend) sampled_.blend = *options.blend;
    if (const auto fault = read_columns(options.columns, sampled_.columns)) {
      throw SubjectUnusable(fmt::format("--columns: {}", *fault));
    }
    if (options.fastest) sampled_.fastest = *options.fastest / 60;
  }

  const SubjectInfo& info() const override { return info_; }
  void configure(const reference::Profile& profile) override {
    start_ = profile.initial.at;
    resolution_ = profile.resolution();
  }
  void renew() override {}
  bool keeps_state() const override { return false; }
  RunEnd run(std::string_view id, std::string_view program, const RecordSink& sink) override;

 private:
  std::optional<fs::path> find(const std::string& id, std::string_view ending) const;

  fs::path folder_;
  SubjectInfo info_;
  std::map<std::string, ExportedProgram> programs_;
  SampledTolerances sampled_;
  reference::Position start_;
  Number resolution_ = 0;
};

std::optional<fs::path> CaptureSubject::find(const std::string& id, std::string_view ending) const {
  const auto exported = programs_.find(id);
  for (const std::string& stem :
       {id, exported != programs_.end() ? exported->second.stem : std::string()}) {
    if (stem.empty()) continue;
    fs::path path = folder_ / fmt::format("{}{}", stem, ending);
    if (fs::exists(path)) return path;
  }
  return std::nullopt;
}

RunEnd CaptureSubject::run(std::string_view id, std::string_view, const RecordSink& sink) {
  const std::string name(id);
  const auto exported = programs_.find(name);
  const std::uint64_t header = exported != programs_.end() ? exported->second.header_lines : 0;
  if (const auto path = find(name, ".jsonl")) {
    return read_captured_trace(path->string(), {header, start_, resolution_}, sink);
  }
  const auto path = find(name, ".csv");
  if (!path) {
    RunEnd end = RunEnd::of(
        RunEnd::Kind::skip,
        fmt::format("{} holds neither a .jsonl nor a .csv of the case.", folder_.string()));
    end.feature = "capture";
    return end;
  }
  SampledTolerances sampled = sampled_;
  sampled.header_lines = header;
  try {
    RunEnd end = check_samples(path->string(), sampled);
    leave_header(end.alarm, header);
    end.notes = fmt::format("{}{}", kSampledNote, path->filename().string());
    end.sampled = std::make_shared<const CapturedSamples>(path->string(), std::move(sampled));
    return end;
  } catch (const SampleFault& fault) {
    return RunEnd::of(RunEnd::Kind::protocol, fault.what());
  }
}

}  // namespace

std::unique_ptr<Subject> make_capture_subject(const std::string& folder,
                                              const CaptureOptions& options) {
  return std::make_unique<CaptureSubject>(folder, options);
}

}  // namespace gonogo::oracle
