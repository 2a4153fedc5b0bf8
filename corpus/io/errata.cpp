// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/io/errata.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <array>
#include <filesystem>
#include <regex>

#include "corpus/io/corpus.hpp"
#include "corpus/io/toml_file.hpp"

namespace gonogo::oracle {
namespace {

std::string needed(const toml::table& entry, const std::string& path, std::string_view key) {
  const auto value = entry[key].value<std::string>();
  if (!value || value->empty()) {
    throw CorpusError(fmt::format("{}: an erratum needs the text {}.", path, key));
  }
  return *value;
}

Erratum erratum_of(const toml::table& entry, const std::string& path) {
  for (const auto& [key, value] : entry) {
    const std::string_view name = key.str();
    if (name != "id" && name != "version" && name != "what" && name != "since") {
      throw CorpusError(fmt::format("{}: an erratum has no key {}.", path, name));
    }
  }
  Erratum erratum{needed(entry, path, "id"), needed(entry, path, "version"),
                  needed(entry, path, "what"), needed(entry, path, "since")};
  for (const std::string& version : {erratum.version, erratum.since}) {
    if (!is_version(version)) {
      throw CorpusError(
          fmt::format("{}: {} is no version of a corpus. Write it as 2026.8.0.", path, version));
    }
  }
  if (!is_before(erratum.version, erratum.since)) {
    throw CorpusError(fmt::format("{}: {} was wrong in {}, which is not before {}.", path,
                                  erratum.id, erratum.version, erratum.since));
  }
  return erratum;
}

std::array<int, 3> numbers_of(const std::string& version) {
  std::array<int, 3> numbers{};
  std::sscanf(version.c_str(), "%9d.%9d.%9d", &numbers[0], &numbers[1], &numbers[2]);
  return numbers;
}

}  // namespace

bool is_version(const std::string& text) {
  static const std::regex kForm("[0-9]{4}\\.[0-9]{1,6}\\.[0-9]{1,6}");
  return std::regex_match(text, kForm);
}

bool is_covered(const std::string& pattern, const std::string& id) {
  return fnmatch(pattern.c_str(), id.c_str(), 0) == 0;
}

bool is_before(const std::string& version, const std::string& other) {
  return numbers_of(version) < numbers_of(other);
}

std::vector<Erratum> read_errata(const std::string& folder) {
  const std::string path = folder + "/errata.toml";
  std::vector<Erratum> errata;
  if (!std::filesystem::exists(path)) return errata;
  const toml::table document = read_toml_file(path);
  for (const auto& [key, value] : document) {
    const toml::array* entries = value.as_array();
    if (key.str() != "erratum" || entries == nullptr) {
      throw CorpusError(fmt::format("{}: write each erratum as [[erratum]].", path));
    }
    for (const toml::node& entry : *entries) {
      if (!entry.is_table()) throw CorpusError(path + ": an erratum is a table.");
      errata.push_back(erratum_of(*entry.as_table(), path));
    }
  }
  return errata;
}

}  // namespace gonogo::oracle
