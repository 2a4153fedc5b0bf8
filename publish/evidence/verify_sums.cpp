// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/verify_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "publish/evidence/certificate_files.hpp"
#include "publish/evidence/statement.hpp"

namespace gonogo::oracle::evidence {
namespace {

namespace fs = std::filesystem;
using Result = Check::Result;

// The first of many faults of one kind are named.
constexpr std::size_t kNamedFaults = 10;

constexpr std::string_view kTracesPrefix = "traces/";

bool is_trace(const std::string& name) {
  return name.starts_with(kTracesPrefix);
}

// SHA256SUMS: name -> sum.
std::map<std::string, std::string> read_sums(const fs::path& folder, Findings& findings) {
  std::map<std::string, std::string> sums;
  std::istringstream lines(file_text((folder / kSums).string()));
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    constexpr std::size_t kHex = 64;
    const bool is_entry = line.size() > kHex + 2 && line.substr(kHex, 2) == "  ";
    const std::string name = is_entry ? line.substr(kHex + 2) : std::string();
    const std::string own = is_trace(name) ? name.substr(kTracesPrefix.size()) : name;
    if (!is_entry || own.find('/') != std::string::npos) {
      findings.add(Result::fails,
                   fmt::format("{}: line {} is no sum of a file beside it.", kSums, number));
      continue;
    }
    sums[name] = line.substr(0, kHex);
  }
  return sums;
}

}  // namespace

void Findings::add_list(const std::vector<std::string>& faults, std::string ok) {
  for (std::size_t i = 0; i < std::min(kNamedFaults, faults.size()); ++i)
    add(Result::fails, faults[i]);
  if (faults.size() > kNamedFaults) {
    add(Result::fails, fmt::format("And {} more of this kind.", faults.size() - kNamedFaults));
  }
  if (faults.empty()) add(Result::holds, std::move(ok));
}

void check_sums(const fs::path& folder, Findings& findings) {
  const auto sums = read_sums(folder, findings);
  std::vector<std::string> faults;
  for (const auto& [name, sum] : sums) {
    if (!fs::exists(folder / name)) {
      faults.push_back(fmt::format("{} is missing.", name));
    } else if (const std::string own = file_sha256((folder / name).string()); own != sum) {
      faults.push_back(
          fmt::format("{} has been changed: its SHA-256 is {}, not {}.", name, own, sum));
    }
  }
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = fs::relative(entry.path(), folder).string();
    if (name == kSums || name == kTraces || sums.contains(name)) continue;
    faults.push_back(fmt::format("{} does not stand in {}.", name, kSums));
  }
  for (const char* name : {kResultsFile, kStatementJson, kStatementText}) {
    if (!sums.contains(name)) faults.push_back(fmt::format("{} has no sum.", name));
  }
  findings.add_list(faults, fmt::format("The sums of {} files hold.", sums.size()));
}

TraceFiles trace_files_of(const fs::path& folder) {
  std::istringstream lines(file_text((folder / kSums).string()));
  TraceFiles traces;
  std::string sums;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t name = line.find("  ");
    if (name == std::string::npos || !is_trace(line.substr(name + 2))) continue;
    sums += line + "\n";
    if (!line.ends_with("/subject.json")) ++traces.files;
  }
  if (traces.files > 0) traces.sha256 = sha256_of_text(sums);
  return traces;
}

}  // namespace gonogo::oracle::evidence
