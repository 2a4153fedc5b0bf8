// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>

#include "oracle/records/output_file.hpp"
#include "publish/evidence/certificate_files.hpp"
#include "publish/evidence/statement.hpp"
#include "publish/report/json_value.hpp"
#include "reference/profile.hpp"

namespace gonogo::oracle::evidence {
namespace {

namespace fs = std::filesystem;

// A file of the run and its place in the certificate.
struct Source {
  const char* name;         // in the folder
  const char* option;       // of certify and report
  const std::string& path;  // empty: none
  const char* sha_key;      // of the header; null: none
};

// The file that was given is the one that the run had.
void check_source(const Source& source, const Json& header) {
  const std::string told =
      source.sha_key == nullptr ? std::string() : report::text_of(header, source.sha_key);
  if (source.path.empty()) {
    if (told.empty()) return;
    throw ResultsError(fmt::format(
        "The run had a file that the certificate needs: name it with {}.", source.option));
  }
  if (!header.contains("known_failures") || source.sha_key == nullptr) return;
  const std::string given = file_sha256(source.path);
  if (given != told) {
    throw ResultsError(
        fmt::format("{} is not the file that the run had: its SHA-256 is {}, not {}.", source.path,
                    given, told.empty() ? "(none)" : told));
  }
}

// The profile that was given is the one of the results.
void check_profile(const std::string& path, const Json& header) {
  const Json profile = header.value("profile", Json::object());
  if (path.empty()) {
    if (profile.empty()) return;
    throw ResultsError(
        "The run had a profile that the certificate needs: name its file with --profile.");
  }
  const std::string text = file_text(path);
  std::string unnamed = unnamed_dialect(header);
  if (unnamed.empty()) unnamed = reference::kUnnamedDialect;
  auto read = path.ends_with(".json") ? reference::profile_from_json(text, unnamed)
                                      : reference::profile_from_toml(text, unnamed);
  if (const auto* error = std::get_if<reference::ProfileError>(&read)) {
    throw ResultsError(fmt::format("{}: {}", path, error->message));
  }
  const Json given = Json::parse(reference::profile_json(std::get<reference::Profile>(read)));
  if (given != profile) {
    throw ResultsError(fmt::format("{} is not the profile that the run had.", path));
  }
}

// An earlier certificate is replaced; a folder with other things is left alone.
void check_folder(const fs::path& folder, const CertificateSources& sources) {
  if (!fs::exists(folder)) return;
  for (const std::string& path :
       {sources.results, sources.known_failures, sources.alarm_map, sources.profile}) {
    if (path.empty() || !fs::equivalent(fs::absolute(path).parent_path(), folder)) continue;
    throw ResultsError(
        fmt::format("{} lies in the folder of the certificate: name another folder.", path));
  }
  const std::set<std::string> own = {kResultsFile,   kWaiversFile, kAlarmMapFile,
                                     kProfileFile,   kProfileJson, kStatementJson,
                                     kStatementText, kSums,        kTraces};
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (own.contains(name)) continue;
    throw ResultsError(
        fmt::format("{} holds {}, which is no part of a certificate: name a folder of its own.",
                    folder.string(), name));
  }
  for (const std::string& name : own) fs::remove_all(folder / name);
}

std::string sum_line(const fs::path& folder, const std::string& name) {
  return fmt::format("{}  {}\n", file_sha256((folder / name).string()), name);
}

// The traces of the cases of the run, in the order of their ids. Returns their lines of SHA256SUMS.
std::string copy_traces(const CertificateSources& sources, const fs::path& folder,
                        TraceFiles& traces) {
  if (sources.traces.empty()) return {};
  fs::create_directories(folder / kTraces);
  std::string sums;
  auto copy = [&](const std::string& name) {
    const fs::path from = fs::path(sources.traces) / name;
    if (!fs::exists(from)) return false;
    const std::string target = fmt::format("{}/{}", kTraces, name);
    fs::copy_file(from, folder / target);
    sums += sum_line(folder, target);
    return true;
  };
  ResultsReader reader(sources.results);
  for (CaseHead head; reader.next(head);) {
    if (copy(head.id + ".jsonl")) ++traces.files;
  }
  copy("subject.json");
  if (traces.files > 0) traces.sha256 = sha256_of_text(sums);
  return sums;
}

void write(const CertificateSources& sources, const fs::path& folder) {
  const Json header = ResultsReader(sources.results).header();
  const std::array<Source, 2> from_run = {
      {{kWaiversFile, "--known-failures", sources.known_failures, "known_failures"},
       {kAlarmMapFile, "--alarm-map", sources.alarm_map, "alarm_map"}}};
  for (const Source& source : from_run) check_source(source, header);
  check_profile(sources.profile, header);
  std::vector<std::string> files = {kResultsFile};
  if (!sources.known_failures.empty()) files.push_back(kWaiversFile);
  if (!sources.alarm_map.empty()) files.push_back(kAlarmMapFile);
  const char* profile = sources.profile.ends_with(".json") ? kProfileJson : kProfileFile;
  if (!sources.profile.empty()) files.push_back(profile);
  std::vector<std::string> reasons;
  if (!sources.known_failures.empty()) reasons = waiver_reasons(sources.known_failures);
  // What cannot be certified is reported before anything is written.
  make_statement(sources.results, reasons, files, {});
  check_folder(folder, sources);
  fs::create_directories(folder);
  TraceFiles traces;
  const std::string trace_sums = copy_traces(sources, folder, traces);
  const Statement statement = make_statement(sources.results, reasons, files, traces);
  fs::copy_file(sources.results, folder / kResultsFile);
  for (const Source& source : from_run) {
    if (!source.path.empty()) fs::copy_file(source.path, folder / source.name);
  }
  if (!sources.profile.empty()) fs::copy_file(sources.profile, folder / profile);
  write_file(folder / kStatementJson, statement.json);
  write_file(folder / kStatementText, statement.markdown);
  files.insert(files.end(), {kStatementText, kStatementJson});
  std::ranges::sort(files);
  std::string sums;
  for (const std::string& name : files) sums += sum_line(folder, name);
  write_file(folder / kSums, sums + trace_sums);
}

}  // namespace

std::optional<std::string> write_certificate(const CertificateSources& sources,
                                             const std::string& folder) {
  try {
    write(sources, folder);
    return std::nullopt;
  } catch (const ResultsError& error) {
    return error.what();
  }
}

}  // namespace gonogo::oracle::evidence
