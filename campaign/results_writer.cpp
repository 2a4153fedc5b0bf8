// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign/results_writer.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "campaign/known_failures.hpp"
#include "campaign/results_reader.hpp"
#include "corpus/io/sha256.hpp"
#include "oracle/records/input_file.hpp"
#include "oracle/records/output_file.hpp"

namespace gonogo::oracle {

using Json = nlohmann::ordered_json;

namespace {

std::string folder_of(const std::string& path) {
  const std::filesystem::path parent = std::filesystem::path(path).parent_path();
  return parent.empty() ? "." : parent.string();
}

// The key in which two headers differ; empty: none. Neither the command line nor the order of the
// cases makes it another run.
std::string difference(const Json& a, const Json& b) {
  for (const auto& [key, value] : b.items()) {
    if (key != "argv" && key != "seed" && (!a.contains(key) || a[key] != value)) return key;
  }
  for (const auto& [key, value] : a.items()) {
    if (!b.contains(key)) return key;
  }
  return {};
}

// A file in the place of results or journal is of a run, or absent: it is replaced. A link may
// lead anywhere.
void check_own(const std::string& path) {
  constexpr std::string_view kBegin = "{\"format\":";
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::symlink_status(path, ignored);
  if (!std::filesystem::exists(status)) return;
  std::string begin(kBegin.size(), '\0');
  std::ifstream file = std::filesystem::is_symlink(status) ? std::ifstream() : open_regular(path);
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(file.gcount()));
  if (file.is_open() && kBegin.starts_with(begin)) return;
  throw ResultsRefused(
      fmt::format("{} is not of a run, and would be replaced by one. Take it away, or name another "
                  "folder with --report.",
                  path));
}

// The views beside results are of these: a run that cannot write its own leaves none of another.
// A folder without the list of a report's programs is no report, and its files are somebody else's.
void remove_views_of(const std::filesystem::path& results) {
  const std::filesystem::path folder = results.has_parent_path() ? results.parent_path() : ".";
  try {
    if (results.filename() != kReportedResults) return;
    if (std::filesystem::exists(folder / kListOfPrograms)) remove_views(folder);
  } catch (const std::filesystem::filesystem_error& error) {
    throw ResultsUnwritable(error.what());
  }
}

// A journal that ends within its header says nothing.
bool has_header(const std::string& path) {
  std::ifstream file = open_regular(path);
  std::string line;
  return std::getline(file, line) && !file.eof();
}

}  // namespace

void remove_views(const std::filesystem::path& folder) {
  for (const char* name :
       {"index.html", "junit.xml", "results.sarif", "summary.md", "badge.json", "causes.json"}) {
    // A device or a folder of that name is somebody else's.
    if (std::filesystem::is_regular_file(folder / name)) std::filesystem::remove(folder / name);
  }
}

// The file that replaces the results when it is complete.
class ResultsWriter::Sorted {
 public:
  explicit Sorted(const std::string& path) : path_(path), sorted_(path + ".sorted") {
    file_ = open_stream(create_anew(sorted_), "w");
    if (file_ == nullptr) fail_to_write(sorted_);
  }
  Sorted(const Sorted&) = delete;
  Sorted& operator=(const Sorted&) = delete;
  // An incomplete file frees its space on the disk.
  ~Sorted() {
    if (!is_whole_) ::unlink(sorted_.c_str());
  }

  void put(const std::string& line) {
    if (!write_line(file_.get(), line)) fail_to_write(sorted_);
    hash_.update_line(line);
  }
  // The hash of all that was put.
  std::string finish() {
    if (std::fflush(file_.get()) != 0 || ::fsync(::fileno(file_.get())) != 0)
      fail_to_write(sorted_);
    if (std::fclose(file_.release()) != 0) fail_to_write(sorted_);
    remove_views_of(path_);
    if (std::rename(sorted_.c_str(), path_.c_str()) != 0) fail_to_write(path_);
    is_whole_ = true;
    return hash_.hex();
  }

 private:
  std::string path_;
  std::string sorted_;
  FileHandle file_;
  Sha256 hash_;
  bool is_whole_ = false;
};

ResultsWriter::ResultsWriter(std::string path, const ResultsHeader& header, Start start)
    : ResultsWriter(std::move(path), header_line(header), start) {}

ResultsWriter::ResultsWriter(std::string path, std::string header, Start start)
    : path_(std::move(path)), header_(std::move(header)), lock_(path_), lines_(folder_of(path_)) {
  const std::string journal = journal_of(path_);
  check_own(path_);
  check_own(journal);
  if (start == Start::resume && has_header(journal)) {
    resume(journal);
  } else {
    journal_ = open_stream(create_anew(journal), "w");
    if (journal_ == nullptr) fail_to_write(journal);
    write(header_);
  }
}

void ResultsWriter::resume(const std::string& journal) {
  std::uint64_t whole = 0;
  try {
    ResultsReader reader(journal, ResultsReader::Order::as_run);
    const std::string key = difference(reader.header(), Json::parse(header_));
    if (!key.empty()) {
      throw ResultsRefused(fmt::format(
          "{} is of another run: its header differs in \"{}\". Run the command that it was begun "
          "with, or leave --resume out to begin anew.",
          journal, key));
    }
    for (CaseHead head; reader.next(head);) {
      if (!resumed_.insert(head.id)) {
        throw ResultsRefused(fmt::format(
            "{} holds the case {} twice. Leave --resume out to begin anew.", journal, head.id));
      }
      lines_.add(reader.text());
      count(head.dialect, verdict_kind(head.verdict).value_or(VerdictKind::oracle_error));
    }
    whole = reader.whole_bytes();
  } catch (const ResultsError& error) {
    throw ResultsRefused(fmt::format("{} Leave --resume out to begin the run anew.", error.what()));
  }
  journal_ = open_stream(::open(journal.c_str(), O_WRONLY | O_NOFOLLOW | O_CLOEXEC), "w");
  if (journal_ == nullptr ||
      ::ftruncate(::fileno(journal_.get()), static_cast<off_t>(whole)) != 0 ||
      std::fseek(journal_.get(), 0, SEEK_END) != 0) {
    fail_to_write(journal);
  }
}

// Line by line to the system, so that a killed run loses none.
void ResultsWriter::write(std::string_view line) {
  if (!write_line(journal_.get(), line) || std::fflush(journal_.get()) != 0) {
    fail_to_write(journal_of(path_));
  }
}

void ResultsWriter::count(const std::string& dialect, VerdictKind kind) {
  if (is_judged(kind)) ++standing_.judged[dialect];
  if (decision(kind) == Decision::no_go) ++standing_.no_go;
  if (kind == VerdictKind::xfail) ++standing_.known;
}

void ResultsWriter::add(const CaseResult& result) {
  add_line(case_line(result, true));
  count(result.dialect, result.verdict.kind);
}

void ResultsWriter::add_line(std::string_view line) {
  write(line);
  lines_.add(std::string(line));
}

ResultsFooter ResultsWriter::close(const Ending& ending, const Visit& visit) {
  Sorted out(path_);
  out.put(header_);
  Sha256 hash;
  Tally tally(declared_in(Json::parse(header_)));
  const PassEvidence evidence = ending.is_shard ? PassEvidence::keep : PassEvidence::drop;
  std::set<std::string> mapped;
  std::string last;
  const std::size_t added = lines_.size();
  std::size_t visited = 0;
  lines_.for_each([&](const std::string& id, const std::string& line) {
    if (id == last) throw std::runtime_error(fmt::format("The case {} is there twice.", id));
    last = id;
    ++visited;
    CaseFacts facts = facts_of(line);
    const VerdictKind kind = tally.add(facts);
    if (!facts.mapped.empty()) mapped.insert(std::move(facts.mapped));
    const std::string written =
        facts.readings ? reconciled_line(line, kind, tally.conflict(), evidence) : line;
    out.put(written);
    hash_case_line(written, hash);
    if (visit) visit(written, kind);
  });
  if (visited != added) {
    throw ResultsUnwritable(fmt::format("{} of {} cases were read back", visited, added));
  }
  ResultsFooter footer;
  footer.left_out = ending.left_out;
  footer.stale = ending.stale;
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
  footer.fresh = ending.fresh;
  RunConditions conditions = conditions_of(Json::parse(header_));
  conditions.fresh = footer.fresh;
  footer.answer = tally.finish(footer.stale, conditions);
  footer.sha256 = hash.hex();
  if (ending.is_complete) out.put(footer_line(footer));
  file_sha256_ = out.finish();
  ::unlink(journal_of(path_).c_str());
  return footer;
}

void ResultsWriter::close_without_footer() {
  Sorted out(path_);
  out.put(header_);
  lines_.for_each([&](const std::string&, const std::string& line) { out.put(line); });
  file_sha256_ = out.finish();
  ::unlink(journal_of(path_).c_str());
}

}  // namespace gonogo::oracle
