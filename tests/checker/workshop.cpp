// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/checker/workshop.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "checker/corpus.hpp"
#include "checker/results.hpp"
#include "checker/sha256.hpp"
#include "checker/vectors.hpp"
#include "checker/verdicts.hpp"
#include "tests/has.hpp"

namespace gonogo::checker {
namespace {

namespace fs = std::filesystem;

constexpr const char* kManifest =
    R"({"format":1,"version":"2026.1.0","license":"CC0-1.0",
"files":["vectors/rs274/tiny.json"],"retired":["tiny.old.000001"]})";

// A line, three quarters of a circle of radius 10 about the origin, and a missing feed.
constexpr const char* kVectors =
    R"({"format":1,"corpus":"2026.1.0","dialect":"rs274","cycle":"tiny",
"groups":[{"gid":"tiny","features":["basic"],"clauses":["NGC-G0-01"],"profile":{},"cases":[
{"id":"tiny.line.000001","comment":"a line","program":"G0 X1\nG1 Y2 F100\nM3\n","expect":[{"basis":"text","records":[
{"k":"rapid","b":1,"to":{"x":"1"}},
{"k":"feed","b":2,"to":{"y":"2"},"f":"100"},
{"k":"m","b":3,"m":3},
{"k":"end","to":{"x":"1","y":"2","z":"0","a":"0","c":"0"}}]}],
"tags":{"tway":[],"sign":[]},"provenance":"hand"},
{"id":"tiny.arc.000001","comment":"an arc","program":"G0 X10\nG2 Y10 X0 I-10 F50\n","expect":[{"basis":"text","records":[
{"k":"rapid","b":1,"to":{"x":"10"}},
{"k":"arc","b":2,"plane":"G17","c":{"x":"0","y":"0"},"rot":-1,"to":{"x":"0","y":"10"},"f":"50"},
{"k":"end","to":{"x":"0","y":"10","z":"0","a":"0","c":"0"}}]}],
"tags":{"tway":[],"sign":[]},"provenance":"hand"},
{"id":"tiny.alarm.000001","comment":"no feed","program":"G0 X1\nG1 Y2\nX3\n","expect":[{"basis":"text","records":[
{"k":"rapid","b":1,"to":{"x":"1"}}],
"alarm":{"any_of":[{"class":"feed-missing","b":2}]}}],
"tags":{"tway":[],"sign":[]},"provenance":"hand"}]}]})";

const std::map<std::string, std::string> kTraces = {
    {"tiny.line.000001", R"({"k":"rapid","b":1,"to":{"x":"1"}}
{"k":"feed","b":2,"to":{"y":"2"},"f":"100"}
{"k":"m","b":3,"m":3}
{"k":"end","to":{"x":"1","y":"2"}}
)"},
    {"tiny.arc.000001", R"({"k":"rapid","b":1,"to":{"x":"10"}}
{"k":"arc","b":2,"plane":"G17","c":{"x":"0","y":"0"},"rot":-1,"to":{"x":"0","y":"10"},"f":"50"}
)"},
    {"tiny.alarm.000001", R"({"k":"rapid","b":1,"to":{"x":"1"}}
{"k":"alarm","b":2,"class":"feed-missing"}
)"}};

void replace_once(std::string& text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from;
  ASSERT_EQ(text.find(from, at + 1), std::string::npos) << from << " is there twice";
  text.replace(at, from.size(), to);
}

void write_file(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

template <typename Check>
Said said_by(Check check) {
  char* text = nullptr;
  std::size_t size = 0;
  std::FILE* out = ::open_memstream(&text, &size);
  Said said;
  try {
    said.exit_code = check(out);
  } catch (const Fault& fault) {
    said.exit_code = 2;
    std::fputs(fault.what(), out);
  }
  std::fclose(out);
  said.text.assign(text, size);
  std::free(text);
  return said;
}

// The records of a trace file as the list of a case line; alarms are not kept there.
std::string list_of(const std::string& records) {
  std::string list;
  std::size_t begin = 0;
  for (std::size_t end = records.find('\n'); end != std::string::npos;
       begin = end + 1, end = records.find('\n', begin)) {
    const std::string line = records.substr(begin, end - begin);
    if (line.find("\"alarm\"") != std::string::npos) continue;
    list += (list.empty() ? "" : ",") + line;
  }
  return "[" + list + "]";
}

}  // namespace

Workshop::Workshop() : manifest_(kManifest), vectors_(kVectors), traces_(kTraces) {
  std::string name = (fs::temp_directory_path() / "gonogo-check-XXXXXX").string();
  folder_ = ::mkdtemp(name.data());
  for (const auto& [id, records] : kTraces) set_verdict(id, "pass-exact");
}

Workshop::~Workshop() {
  fs::remove_all(folder_);
}

void Workshop::change_vectors(const std::string& from, const std::string& to) {
  replace_once(vectors_, from, to);
}

void Workshop::change_lines(const std::string& from, const std::string& to) {
  std::size_t changed = 0;
  for (auto& [id, line] : lines_) {
    if (line.find(from) == std::string::npos) continue;
    replace_once(line, from, to);
    ++changed;
  }
  ASSERT_EQ(changed, 1U) << from;
}

void Workshop::change_results(const std::string& from, const std::string& to) {
  results_changes_.emplace_back(from, to);
}

void Workshop::drop_line(const std::string& id) {
  lines_.erase(id);
  verdicts_.erase(id);
}

void Workshop::change_trace(const std::string& id, const std::string& from, const std::string& to) {
  replace_once(traces_.at(id), from, to);
}

void Workshop::set_verdict(const std::string& id, const std::string& verdict) {
  verdicts_[id] = verdict;
  std::string line = R"({"id":")" + id + R"(","dialect":"rs274","cycle":"tiny",)" +
                     R"("features":["basic"],"clauses":["NGC-G0-01"],)";
  line += R"("verdict":")" + verdict + R"(","us":17,"attempts":1)";
  if (decision_of(verdict) != Decision::go) {
    const std::size_t at = vectors_.find("\"program\":", vectors_.find(id));
    const std::size_t end = vectors_.find(",\"expect\"", at);
    line += "," + vectors_.substr(at, end - at) + R"(,"trace":)" + list_of(traces_.at(id));
  }
  lines_[id] = line + "}";
}

std::string Workshop::results_text() {
  const Corpus corpus((folder_ / "corpus").string());
  std::string text = R"({"format":2,"gonogo":"0.1.0","corpus":{"version":"2026.1.0","sha256":")" +
                     corpus.sha256() + R"("},"subject":{"name":"tiny","numeric":{"kind":"fixed",)" +
                     R"("resolution":"0.001"},"features":["blocks","m"]},"profile":{},)" +
                     R"("tolerance":null,"chord":null,"seed":0,"shard":"1/1","argv":["certify"]})" +
                     "\n";
  Sha256 hash;
  std::map<std::string, int> totals;
  bool no_go = false;
  std::size_t judged = 0;
  for (const auto& [id, line] : lines_) {
    text += line + "\n";
    std::string hashed = line;
    replace_once(hashed, R"(,"us":17,"attempts":1)", "");
    hash.update(hashed + "\n");
    const std::string& verdict = verdicts_[id];
    ++totals[verdict];
    no_go = no_go || decision_of(verdict) == Decision::no_go;
    if (is_judged(verdict)) ++judged;
  }
  std::string counts;
  for (const auto& [verdict, count] : totals) {
    counts += (counts.empty() ? "\"" : ",\"") + verdict + "\":" + std::to_string(count);
  }
  text += std::string(R"({"decision":")") + (no_go ? "NO-GO" : "GO") + R"(","totals":{)" + counts +
          R"(},"cases":)" + std::to_string(lines_.size()) + R"(,"judged":)" +
          std::to_string(judged) + R"(,"assignments":[],"sha256":")" + hash.hex() + "\"}\n";
  for (const auto& [from, to] : results_changes_) replace_once(text, from, to);
  return text;
}

void Workshop::write() {
  write_file(folder_ / "corpus/manifest.json", manifest_);
  write_file(folder_ / "corpus/vectors/rs274/tiny.json", vectors_);
  for (const auto& [id, records] : traces_) {
    write_file(folder_ / "traces" / (id + ".jsonl"), records);
  }
}

Said Workshop::check_vectors() {
  write();
  return said_by(
      [&](std::FILE* out) { return checker::check_vectors((folder_ / "corpus").string(), out); });
}

Said Workshop::check_verdicts() {
  write();
  write_file(folder_ / "results.jsonl", results_text());
  return said_by([&](std::FILE* out) {
    return checker::check_verdicts({(folder_ / "results.jsonl").string(),
                                    (folder_ / "corpus").string(), (folder_ / "traces").string()},
                                   out);
  });
}

void expect_said(Workshop& shop, int exit_code, const std::string& sentence) {
  const Said said = shop.check_verdicts();
  EXPECT_EQ(said.exit_code, exit_code) << said.text;
  EXPECT_TRUE(has(said.text, sentence));
}

}  // namespace gonogo::checker
