// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/campaign/results_writer.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "oracle/campaign/known_failures.hpp"
#include "oracle/campaign/results_reader.hpp"
#include "oracle/corpus/sha256.hpp"

namespace gonogo::oracle {

using Json = nlohmann::ordered_json;

namespace {

[[noreturn]] void fail_to_write(const std::string& path) {
  throw ResultsUnwritable(fmt::format("{} cannot be written: {}", path, std::strerror(errno)));
}

std::string folder_of(const std::string& path) {
  const std::filesystem::path parent = std::filesystem::path(path).parent_path();
  return parent.empty() ? "." : parent.string();
}

// The key in which two headers differ, `argv` aside; empty: none.
std::string difference(const Json& a, const Json& b) {
  for (const auto& [key, value] : b.items()) {
    if (key != "argv" && (!a.contains(key) || a[key] != value)) return key;
  }
  for (const auto& [key, value] : a.items()) {
    if (!b.contains(key)) return key;
  }
  return {};
}

// A journal that ends within its header says nothing.
bool has_header(const std::string& path) {
  FileHandle file(std::fopen(path.c_str(), "re"));
  if (file == nullptr) return false;
  for (int c = std::fgetc(file.get()); c != EOF; c = std::fgetc(file.get())) {
    if (c == '\n') return true;
  }
  return false;
}

}  // namespace

// The file that takes the place of the results when it is whole.
class ResultsWriter::Sorted {
 public:
  explicit Sorted(const std::string& path)
      : path_(path), sorted_(path + ".sorted"), file_(std::fopen(sorted_.c_str(), "we")) {
    if (file_ == nullptr) fail_to_write(sorted_);
  }
  Sorted(const Sorted&) = delete;
  Sorted& operator=(const Sorted&) = delete;
  // What is not whole gives its room on the disk back.
  ~Sorted() {
    if (!is_whole_) ::unlink(sorted_.c_str());
  }

  void put(const std::string& line) {
    if (std::fwrite(line.data(), 1, line.size(), file_.get()) != line.size() ||
        std::fputc('\n', file_.get()) == EOF) {
      fail_to_write(sorted_);
    }
  }
  void finish() {
    if (std::fflush(file_.get()) != 0 || ::fsync(::fileno(file_.get())) != 0)
      fail_to_write(sorted_);
    if (std::fclose(file_.release()) != 0) fail_to_write(sorted_);
    if (std::rename(sorted_.c_str(), path_.c_str()) != 0) fail_to_write(path_);
    is_whole_ = true;
  }

 private:
  std::string path_;
  std::string sorted_;
  FileHandle file_;
  bool is_whole_ = false;
};

ResultsWriter::ResultsWriter(std::string path, const ResultsHeader& header, Start start)
    : path_(std::move(path)), header_(header_line(header)) {
  start == Start::resume&& has_header(journal_of(path_)) ? resume() : create();
}

ResultsWriter::ResultsWriter(std::string path, std::string header)
    : path_(std::move(path)), header_(std::move(header)) {
  create();
}

void ResultsWriter::create() {
  const std::string journal = journal_of(path_);
  journal_.reset(std::fopen(journal.c_str(), "w+e"));
  if (journal_ == nullptr) fail_to_write(journal);
  add_line(header_);
}

void ResultsWriter::resume() {
  const std::string journal = journal_of(path_);
  std::uint64_t whole = 0;
  try {
    ResultsReader reader(journal, ResultsReader::Order::as_run);
    const std::string key = difference(reader.header(), Json::parse(header_));
    if (!key.empty()) {
      throw ResumeError(fmt::format(
          "{} is of another run: its header differs in \"{}\". Run the command that it was begun "
          "with, or leave --resume out to begin anew.",
          journal, key));
    }
    for (CaseHead head; reader.next(head);) resumed_.insert(head.id);
    whole = reader.whole_bytes();
  } catch (const ResultsError& error) {
    throw ResumeError(fmt::format("{} Leave --resume out to begin the run anew.", error.what()));
  }
  journal_.reset(std::fopen(journal.c_str(), "r+e"));
  if (journal_ == nullptr ||
      ::ftruncate(::fileno(journal_.get()), static_cast<off_t>(whole)) != 0 ||
      std::fseek(journal_.get(), 0, SEEK_END) != 0) {
    fail_to_write(journal);
  }
}

// Line by line to the system, so that a killed run loses none.
void ResultsWriter::add_line(std::string_view line) {
  if (std::fwrite(line.data(), 1, line.size(), journal_.get()) != line.size() ||
      std::fputc('\n', journal_.get()) == EOF || std::fflush(journal_.get()) != 0) {
    fail_to_write(journal_of(path_));
  }
}

void ResultsWriter::each_journal_line(const std::function<void(std::string)>& take) {
  StoredLines lines(journal_.get(), journal_of(path_));
  std::string line;
  for (bool is_header = true; lines.next(line);) {
    if (!std::exchange(is_header, false)) take(std::move(line));
  }
}

RunAnswer ResultsWriter::close(const Ending& ending, ResultsFooter& footer, const Visit& visit) {
  LineSorter sorter(folder_of(path_));
  each_journal_line([&](std::string line) { sorter.add(std::move(line)); });
  Sorted out(path_);
  out.put(header_);
  Sha256 hash;
  Tally tally;
  const PassEvidence evidence = ending.is_shard ? PassEvidence::keep : PassEvidence::drop;
  std::set<std::string> mapped;
  std::string last;
  sorter.for_each([&](const std::string& id, const std::string& line) {
    if (id == last) throw std::runtime_error(fmt::format("The case {} is there twice.", id));
    last = id;
    CaseFacts facts = facts_of(line);
    const VerdictKind kind = tally.add(facts);
    if (!facts.mapped.empty()) mapped.insert(std::move(facts.mapped));
    const std::string written =
        facts.readings ? reconciled_line(line, kind, tally.conflict(), evidence) : line;
    out.put(written);
    hash_case_line(written, hash);
    if (visit) visit(written, kind);
  });
  footer.left_out = ending.left_out;
  footer.stale = ending.stale;
  footer.unused_alarms.reset();
  if (ending.alarms) {
    footer.unused_alarms.emplace();
    std::ranges::copy_if(*ending.alarms, std::back_inserter(*footer.unused_alarms),
                         [&](const std::string& entry) { return !mapped.contains(entry); });
    if (!ending.is_shard) {
      for (const std::string& entry : *footer.unused_alarms) {
        footer.stale.push_back(stale_alarm(entry));
      }
    }
  }
  const RunAnswer answer = tally.finish(footer.stale, conditions_of(Json::parse(header_)));
  footer.decision = answer.decision;
  footer.head = answer.head;
  footer.totals = answer.totals;
  footer.cases = answer.cases;
  footer.judged = answer.judged;
  footer.assignments = answer.assignments;
  footer.coordinates = answer.coordinates;
  footer.sha256 = hash.hex();
  if (ending.is_complete) out.put(footer_line(footer));
  out.finish();
  ::unlink(journal_of(path_).c_str());
  return answer;
}

void ResultsWriter::close_without_footer() {
  LineSorter sorter(folder_of(path_));
  each_journal_line([&](std::string line) { sorter.add(std::move(line)); });
  Sorted out(path_);
  out.put(header_);
  sorter.for_each([&](const std::string&, const std::string& line) { out.put(line); });
  out.finish();
  ::unlink(journal_of(path_).c_str());
}

}  // namespace gonogo::oracle
