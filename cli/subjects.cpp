// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/subjects.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <mutex>
#include <utility>
#include <variant>

#include "capture/capture_subject.hpp"
#include "cli/program_file.hpp"
#include "expanders/registry.hpp"
#include "reference/nearest_word.hpp"
#include "subjects/library_subject.hpp"

namespace gonogo::cli {
namespace {

oracle::SubjectMaker builtin_maker(const std::string& rest) {
  const std::size_t plus = rest.find('+');
  const std::string name = rest.substr(0, plus);
  const std::string fault = plus == std::string::npos ? std::string() : rest.substr(plus + 1);
  if (expanders::find(name, "") == nullptr) {
    const std::vector<std::string> names(expanders::names().begin(), expanders::names().end());
    throw UsageError(fmt::format("There is no built-in expander \"{}\". {}Write one of: {}.", name,
                                 reference::did_you_mean(reference::nearest_word(name, names)),
                                 fmt::join(names, ", ")));
  }
  if (plus != std::string::npos && fault.empty()) {
    throw UsageError(
        fmt::format("No fault stands behind the + of builtin:{}. `gonogo faults --list` names "
                    "them; builtin:{} has none.",
                    rest, name));
  }
  const gonogo_subject_v1* subject = expanders::find(name, fault);
  if (subject == nullptr) {
    std::vector<std::string> faults;
    for (const auto& one : expanders::faults(name)) faults.emplace_back(one.name);
    throw UsageError(
        fmt::format("The expander {} has no planted fault \"{}\". {}`gonogo faults "
                    "--list` names them.",
                    name, fault, reference::did_you_mean(reference::nearest_word(fault, faults))));
  }
  return [subject] { return oracle::make_interface_subject(*subject); };
}

// The shared libraries of the folder that the path is in.
std::vector<std::string> libraries_beside(const std::string& path) {
  namespace fs = std::filesystem;
  std::vector<std::string> found;
  const fs::path folder = fs::path(path).parent_path();
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, ignored)) {
    if (entry.path().extension() != ".so") continue;
    found.push_back((folder.empty() ? "." : folder) / entry.path().filename());
  }
  return found;
}

oracle::SubjectMaker library_maker(const std::string& path, const oracle::Limits& limits) {
  const bool is_there = std::filesystem::exists(path);
  const std::vector<std::string> others =
      is_there ? std::vector<std::string>() : libraries_beside(path);
  if (const std::string near = reference::nearest_word(path, others); !near.empty()) {
    throw UsageError(fmt::format("There is no library {}. Did you mean lib:{}?", path, near));
  }
  const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
  oracle::check_library(path, limits, program);
  return [=] { return oracle::make_library_subject(path, limits, program); };
}

template <typename Result>
Result checked(std::variant<Result, oracle::FileFault> read, const std::string& file) {
  if (auto* fault = std::get_if<oracle::FileFault>(&read)) {
    throw UsageError(fmt::format("{}: {}", file, fault->message));
  }
  return std::get<Result>(std::move(read));
}

class MappedSubject : public oracle::Subject {
 public:
  MappedSubject(std::unique_ptr<oracle::Subject> inner,
                std::shared_ptr<const oracle::AlarmMap> alarms)
      : inner_(std::move(inner)), alarms_(std::move(alarms)) {}

  const oracle::SubjectInfo& info() const override { return inner_->info(); }
  void configure(const reference::Profile& profile) override { inner_->configure(profile); }
  oracle::RunEnd run(std::string_view id, std::string_view program,
                     const oracle::RecordSink& sink) override {
    oracle::RunEnd end = inner_->run(id, program, sink);
    alarms_->name_class(end);
    return end;
  }
  void renew() override { inner_->renew(); }

 private:
  std::unique_ptr<oracle::Subject> inner_;
  std::shared_ptr<const oracle::AlarmMap> alarms_;
};

}  // namespace

oracle::SubjectMaker subject_maker(const std::string& text, const oracle::Limits& limits) {
  const auto spec = oracle::parse_subject_spec(text);
  if (spec && spec->kind == "builtin") return builtin_maker(spec->rest);
  if (spec && spec->kind == "pipe") {
    return [rest = spec->rest, limits] { return oracle::make_pipe_subject(rest, limits); };
  }
  if (spec && spec->kind == "oneshot") {
    return [rest = spec->rest, limits] { return oracle::make_oneshot_subject(rest, limits); };
  }
  if (spec && spec->kind == "capture") {
    return
        [rest = spec->rest, limits] { return oracle::make_capture_subject(rest, limits.capture); };
  }
  if (spec && spec->kind == "lib") return library_maker(spec->rest, limits);
  throw UsageError(
      fmt::format("\"{}\" names no subject. Write builtin:NAME, pipe:COMMAND, oneshot:COMMAND, "
                  "lib:PATH.so or capture:DIR.",
                  text));
}

oracle::SubjectMaker beginning_with(std::unique_ptr<oracle::Subject> first,
                                    oracle::SubjectMaker maker) {
  struct Kept {
    std::mutex mutex;
    std::unique_ptr<oracle::Subject> subject;
  };
  auto kept = std::make_shared<Kept>();
  kept->subject = std::move(first);
  return [kept, make = std::move(maker)] {
    {
      const std::lock_guard lock(kept->mutex);
      if (kept->subject) return std::move(kept->subject);
    }
    return make();
  };
}

std::vector<std::string> declared_dialects(const oracle::SubjectMaker& maker) {
  const std::unique_ptr<oracle::Subject> subject = maker();
  std::vector<std::string> names;
  for (const auto& [dialect, features] : subject->info().dialects) names.push_back(dialect);
  return names;
}

std::vector<oracle::KnownFailure> load_known_failures(const std::string& file) {
  return checked(oracle::known_failures_from_toml(read_file(file, "a file of known failures")),
                 file);
}

std::vector<oracle::KnownCause> load_known_causes(const std::string& file) {
  return checked(oracle::known_causes_from_toml(read_file(file, "a file of known failures")), file);
}

std::shared_ptr<const oracle::AlarmMap> load_alarm_map(const std::string& file) {
  if (file.empty()) return nullptr;
  return std::make_shared<const oracle::AlarmMap>(
      checked(oracle::alarm_map_from_toml(read_file(file, "an alarm map")), file));
}

std::unique_ptr<oracle::Subject> with_alarm_map(std::unique_ptr<oracle::Subject> subject,
                                                std::shared_ptr<const oracle::AlarmMap> alarms) {
  if (!alarms) return subject;
  return std::make_unique<MappedSubject>(std::move(subject), std::move(alarms));
}

}  // namespace gonogo::cli
