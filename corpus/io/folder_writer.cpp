// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/io/folder_writer.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "corpus/io/recheck.hpp"
#include "oracle/records/output_file.hpp"
#include "oracle/records/text.hpp"

namespace gonogo::oracle {
namespace fs = std::filesystem;
namespace {

void write_in_folder(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  write_file(file, text);
}

template <typename Names>
std::string list_of(const Names& names) {
  std::string out;
  for (const std::string& name : names) {
    out += out.empty() ? "\n  " : ",\n  ";
    append_json_string(name, out);
  }
  return out.empty() ? "[]" : "[" + out + "\n ]";
}

}  // namespace

std::string manifest_text(const CorpusFolder& corpus) {
  std::vector<std::string> names;
  for (const auto& [name, cases] : corpus.files) names.push_back(name);
  return fmt::format(
      "{{\n \"format\": 1,\n \"version\": \"{}\",\n \"license\": \"{}\",\n \"files\": {},\n "
      "\"retired\": {}\n}}\n",
      corpus.version, corpus.license, list_of(names), list_of(corpus.retired));
}

void write_corpus(const std::string& folder, const CorpusFolder& corpus) {
  if (fs::exists(folder) && !fs::is_empty(folder)) {
    throw CorpusError(fmt::format("{} is not empty. Name a new folder.", folder));
  }
  for (const auto& [name, cases] : corpus.files) {
    const fs::path file = fs::path(folder) / name;
    write_in_folder(file, vector_file_text(corpus.version, cases));
    recheck_file(file.string());
  }
  write_in_folder(fs::path(folder) / "manifest.json", manifest_text(corpus));
}

}  // namespace gonogo::oracle
