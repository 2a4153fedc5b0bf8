// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/targets/file_scratch.hpp"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "campaign/results.hpp"
#include "corpus/io/corpus.hpp"
#include "corpus/io/folder_writer.hpp"

namespace gonogo::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCorpusVersion = "2026.1.0";

oracle::Case case_of(const char* id, const char* program) {
  oracle::Case test;
  test.id = id;
  test.program = program;
  test.provenance = "hand";
  test.dialect = "rs274";
  test.cycle = "lines";
  test.group = "lines";
  test.features = {"basic"};
  test.profile = std::get<reference::Profile>(reference::default_profile("rs274"));
  test.expect = {oracle::expectation_of(test.profile, test.program)};
  return test;
}

// With another value of the first key of that name, where there is one.
std::string with_text(std::string_view line, std::string_view key, std::string_view value) {
  const std::string begin = "\"" + std::string(key) + "\":\"";
  const std::size_t at = line.find(begin);
  const std::size_t from = at + begin.size();
  if (at == std::string_view::npos || from > line.size()) return std::string(line);
  const std::size_t to = std::min(line.find('"', from), line.size());
  return std::string(line.substr(0, from)) + std::string(value) + std::string(line.substr(to));
}

// Takes a line that is none as it stands, as a mutated one may be.
void hash_line(std::string_view line, oracle::Sha256& hash) {
  if (nlohmann::ordered_json::accept(line)) {
    oracle::hash_case_line(line, hash);
  } else {
    hash.update(line);
  }
}

}  // namespace

Scratch::Scratch() {
  oracle::CorpusFolder corpus;
  corpus.version = kCorpusVersion;
  corpus.files["vectors/rs274/lines.json"] = {
      case_of("lines.000001", "G0 X1\nG1 Y2 F100\nM2\n"),
      case_of("lines.000002", "G0 X2\nG3 X4 I1 F100\nM2\n")};
  oracle::write_corpus(path("corpus"), corpus);
  oracle::write_corpus(path("manifest"), corpus);
  corpus_sha256_ = oracle::Corpus(path("corpus")).sha256();
  for (const char* folder : {"certificate", "errata"}) fs::create_directory(path(folder));
  put("certificate/statement.json", "{}");
  put("certificate/STATEMENT.md", "");
  put("certificate/SHA256SUMS", "");
}

const Scratch& scratch() {
  static const Scratch kScratch;
  return kScratch;
}

std::string mended_results(std::string_view file) {
  const std::size_t header_end = std::min(file.find('\n'), file.size());
  std::string header = with_text(file.substr(0, header_end), "gonogo", kMendedVersion);
  header = with_text(header, "version", kCorpusVersion);
  header = with_text(header, "sha256", scratch().corpus_sha256());
  std::string_view rest = file.substr(header_end);
  if (!rest.empty()) rest.remove_prefix(1);
  std::string text = header + "\n";
  oracle::Sha256 hash;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (rest.empty()) {
      text += with_text(line, "sha256", hash.hex());
    } else {
      text += line;
      hash_line(line, hash);
    }
    text += '\n';
  }
  return text;
}

}  // namespace gonogo::fuzz
