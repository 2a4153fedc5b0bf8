// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/certificate_files.hpp"

#include <fmt/format.h>

#include <fstream>
#include <set>
#include <sstream>

#include "campaign/known_failures.hpp"
#include "campaign/results_reader.hpp"
#include "oracle/records/input_file.hpp"

namespace gonogo::oracle::evidence {

std::string file_text(const std::string& path) {
  std::ifstream in = open_regular(path);
  if (!in) throw ResultsError(fmt::format("{} cannot be read.", path));
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::string file_sha256(const std::string& path) {
  std::ifstream in = open_regular(path);
  if (!in) throw ResultsError(fmt::format("{} cannot be read.", path));
  Sha256 hash;
  std::string chunk(std::size_t{1} << 16, '\0');
  while (in.read(chunk.data(), static_cast<std::streamsize>(chunk.size())) || in.gcount() > 0) {
    hash.update(std::string_view(chunk).substr(0, static_cast<std::size_t>(in.gcount())));
  }
  return hash.hex();
}

std::string sha256_of_text(std::string_view text) {
  Sha256 hash;
  hash.update(text);
  return hash.hex();
}

std::vector<std::string> waiver_reasons(const std::string& path) {
  auto read = known_failures_from_toml(file_text(path));
  if (const auto* fault = std::get_if<FileFault>(&read)) {
    throw ResultsError(fmt::format("{}: {}", path, fault->message));
  }
  std::set<std::string> reasons;
  for (const KnownFailure& failure : std::get<std::vector<KnownFailure>>(read)) {
    reasons.insert(failure.reason);
  }
  return {reasons.begin(), reasons.end()};
}

}  // namespace gonogo::oracle::evidence
