// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/evidence/verify_sums.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "oracle/evidence/certificate_files.hpp"
#include "oracle/evidence/statement.hpp"

namespace gonogo::oracle::evidence {
namespace {

namespace fs = std::filesystem;
using Result = Check::Result;

// Of many faults of one kind, the first are named.
constexpr std::size_t kNamedFaults = 10;

// SHA256SUMS: name -> sum.
std::map<std::string, std::string> read_sums(const fs::path& folder, Findings& findings) {
  std::map<std::string, std::string> sums;
  std::istringstream lines(file_text((folder / kSums).string()));
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    constexpr std::size_t kHex = 64;
    const bool is_entry = line.size() > kHex + 2 && line.substr(kHex, 2) == "  ";
    const std::string name = is_entry ? line.substr(kHex + 2) : std::string();
    if (!is_entry || name.find('/') != std::string::npos) {
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
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name == kSums || sums.contains(name)) continue;
    faults.push_back(fmt::format("{} does not stand in {}.", name, kSums));
  }
  for (const char* name : {kResultsFile, kStatementJson, kStatementText}) {
    if (!sums.contains(name)) faults.push_back(fmt::format("{} has no sum.", name));
  }
  findings.add_list(faults, fmt::format("The sums of {} files hold.", sums.size()));
}

}  // namespace gonogo::oracle::evidence
