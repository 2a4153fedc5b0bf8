// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/io/corpus.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "corpus/io/embedded.hpp"
#include "corpus/io/files.hpp"
#include "corpus/io/json_place.hpp"
#include "corpus/io/sha256.hpp"
#include "oracle/records/input_file.hpp"
#include "oracle/records/json_document.hpp"

namespace gonogo::oracle {
namespace fs = std::filesystem;

namespace {

std::string embedded_file_text(const std::string& path) {
  for (const EmbeddedFile& file : embedded_corpus()) {
    if (path == fmt::format("{}/{}", kEmbeddedFolder, file.name)) return embedded_text(file);
  }
  throw CorpusError(fmt::format("This program carries no {}.", path));
}

}  // namespace

std::string file_text(const std::string& path) {
  if (path.starts_with(kEmbeddedFolder)) return embedded_file_text(path);
  std::ifstream file = open_regular(path);
  std::error_code error;
  std::string text(file ? fs::file_size(path, error) : 0, '\0');
  if (!file || error || !file.read(text.data(), static_cast<std::streamsize>(text.size()))) {
    throw CorpusError(fmt::format("{} cannot be read: {}.", path, std::strerror(errno)));
  }
  return text;
}

namespace {

// The vector files below a folder as names relative to it, in their order.
std::vector<std::string> vector_files(const std::string& folder) {
  std::vector<std::string> files;
  if (folder == kEmbeddedFolder) {
    for (const EmbeddedFile& file : embedded_corpus()) {
      if (file.name.starts_with("vectors/")) files.emplace_back(file.name);
    }
    std::ranges::sort(files);
    return files;
  }
  std::error_code error;
  for (const fs::directory_entry& entry :
       fs::recursive_directory_iterator(fs::path(folder) / "vectors", error)) {
    if (!entry.is_regular_file() || entry.path().extension() != ".json") continue;
    files.push_back(fs::relative(entry.path(), folder).generic_string());
  }
  if (error) {
    throw CorpusError(
        fmt::format("{} is no corpus: {}/vectors cannot be listed: {}. Name a folder that has "
                    "vectors/ and manifest.json.",
                    folder, folder, error.message()));
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace

bool expects_alarm(const Case& test) {
  return std::ranges::any_of(test.expect,
                             [](const Expectation& one) { return !one.alarms.empty(); });
}

Corpus::Corpus(std::string folder) : folder_(std::move(folder)), files_(vector_files(folder_)) {
  const std::string path = folder_ + "/manifest.json";
  const std::string text = file_text(path);
  JsonDocument document;
  auto parsed = document.parse(text);
  if (auto* fault = std::get_if<JsonFault>(&parsed)) {
    throw CorpusError(fmt::format("{}: {}", path, fault->message));
  }
  const JsonPlace manifest(path, std::get<simdjson::dom::object>(parsed));
  manifest.need_object({"format", "version", "license", "files", "retired"});
  if (const std::int64_t format = manifest.member("format").integer(); format != 1) {
    manifest.member("format").fail(
        fmt::format("This program reads manifests of format 1, not {}.", format));
  }
  version_ = manifest.member("version").text();
  for (const std::string& id : manifest.member("retired").texts()) retired_.insert(id);
  std::vector<std::string> listed = manifest.member("files").texts();
  std::ranges::sort(listed);
  if (listed != files_) {
    manifest.member("files").fail(
        "The list is not that of the *.json files below vectors/. List each of them once.");
  }
  Sha256 hash;
  for (const std::string& file : files_) {
    const std::string bytes = file_text(folder_ + "/" + file);
    hash.update(fmt::format("{}\n{}\n", file, bytes.size()));
    hash.update(bytes);
    file_bytes_.push_back(bytes.size());
  }
  sha256_ = hash.hex();
}

void Corpus::for_each(const std::function<void(const Case&)>& visit) const {
  CaseReader reader(*this);
  while (const std::optional<Case> test = reader.next()) visit(*test);
}

}  // namespace gonogo::oracle
