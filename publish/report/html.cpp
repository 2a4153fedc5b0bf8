// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/report/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "campaign/encoding.hpp"
#include "oracle/records/input_file.hpp"
#include "oracle/records/output_file.hpp"
#include "oracle/records/text.hpp"
#include "publish/report/assets.hpp"
#include "publish/report/case_detail.hpp"
#include "publish/report/deflate.hpp"
#include "publish/report/escape.hpp"
#include "publish/report/json_value.hpp"
#include "publish/report/sheet_parts.hpp"
#include "publish/report/summary.hpp"

namespace gonogo::oracle::report {
namespace {

// What failures and passes may take of the page, packed. Beyond them a failure has no drawing, and
// a pass no program.
constexpr std::size_t kMostPathBytes = std::size_t{5} << 20;
constexpr std::size_t kMostPassBytes = std::size_t{3} << 20;
constexpr std::size_t kPassesOfAPack = 48;

constexpr std::size_t kRowBytes = std::size_t{1} << 20;

std::optional<Json> parse_object(const std::string& line) {
  Json value = Json::parse(line, nullptr, false);
  if (!value.is_object()) return std::nullopt;
  return value;
}

bool is_plain_in_json(char c) {
  return c >= 0x20 && c < 0x7F && c != '"' && c != '\\';
}

void append_text(std::string_view text, std::string& out) {
  if (!std::ranges::all_of(text, is_plain_in_json)) {
    out += dump(Json(text));
    return;
  }
  out += '"';
  out += text;
  out += '"';
}

std::string subject_name(const Json& header) {
  const Json subject = header.value("subject", Json::object());
  const std::string name = text_of(subject, "name");
  return name.empty() ? text_of(subject, "spec") : name + " " + text_of(subject, "version");
}

// The skeleton up to the mark {{data}} and after it, with style, script and hash filled in.
struct Skeleton {
  std::string before;
  std::string after;
};

void replace(std::string& text, std::string_view mark, std::string_view value) {
  if (const std::size_t at = text.find(mark); at != std::string::npos) {
    text.replace(at, mark.size(), value);
  }
}

Skeleton skeleton() {
  std::string page(kReportHtml.text);
  const std::size_t at = page.find("{{data}}");
  Skeleton parts{page.substr(0, at), page.substr(at + std::string_view("{{data}}").size())};
  replace(parts.before, "{{script-hash}}", "sha256-" + base64_of_hex(kReportJs.sha256));
  // The view in space has no sheet of its own to bring the styles of a drawing.
  const std::string_view open = "<style>";
  const std::string_view drawing = sheet_style();
  const std::size_t from = drawing.find(open) + open.size();
  const std::string styles(drawing.substr(from, drawing.find("</style>") - from));
  replace(parts.before, "{{style}}", std::string(kReportCss.text) + styles);
  replace(parts.after, "{{script}}", kReportJs.text);
  return parts;
}

}  // namespace

HtmlPage::HtmlPage(const std::string& directory, const Json& header)
    : target_(std::filesystem::path(directory) / "index.html"),
      part_(target_.string() + ".part"),
      subject_(subject_name(header)) {
  std::error_code ignored;  // what comes of it shows in the file
  std::filesystem::create_directories(directory, ignored);
  open_anew(part_, out_);
  Skeleton page = skeleton();
  out_ << page.before;
  after_ = std::move(page.after);
}

HtmlPage::~HtmlPage() {
  if (done_) return;
  out_.close();
  std::error_code ignored;
  std::filesystem::remove(part_, ignored);
}

void HtmlPage::add(const CaseHead& line, const Finding* finding) {
  if (!rows_.empty()) rows_ += ',';
  char between = '[';
  const std::string message =
      line.known.empty() ? line.message : fmt::format("Known: {} {}", line.known, line.message);
  for (const std::string* text :
       {&line.id, &line.dialect, &line.cycle, &line.verdict, &line.clause, &message}) {
    rows_ += std::exchange(between, ',');
    append_text(*text, rows_);
  }
  rows_ += ",[";
  for (std::size_t i = 0; i < line.clauses.size(); ++i) {
    if (i > 0) rows_ += ',';
    append_text(line.clauses[i], rows_);
  }
  rows_ += fmt::format("],{}]", finding == nullptr ? 0 : finding->number);
  ++index_;
  if (rows_.size() > kRowBytes) flush_rows();
}

void HtmlPage::add_detail(const Json& line, bool always) {
  const bool with_paths = always || path_bytes_ < kMostPathBytes;
  const std::string detail = packed(dump(case_detail(line, subject_, with_paths)));
  path_bytes_ += detail.size();
  out_ << "<script type=\"text/plain\" id=\"d" << index_ - 1 << "\">" << detail << "</script>\n";
}

bool HtmlPage::add_pass(const CorpusCase& test) {
  if (pass_bytes_ >= kMostPassBytes) return false;
  if (passes_.empty()) first_pass_ = index_ - 1;
  passes_[std::to_string(index_ - 1)] = pass_detail(test);
  if (passes_.size() >= kPassesOfAPack) flush_passes();
  return true;
}

void HtmlPage::flush_passes() {
  if (passes_.empty()) return;
  const std::string text = packed(dump(passes_));
  pass_bytes_ += text.size();
  out_ << "<script type=\"text/plain\" class=\"passes\" data-first=\"" << first_pass_
       << "\" data-last=\"" << index_ - 1 << "\">" << text << "</script>\n";
  passes_ = Json::object();
}

void HtmlPage::flush_rows() {
  if (rows_.empty()) return;
  out_ << "<script type=\"text/plain\" class=\"rows\">" << packed("[" + rows_ + "]")
       << "</script>\n";
  rows_.clear();
}

std::optional<std::string> HtmlPage::finish(const Json& summary) {
  if (!out_.is_open()) return fmt::format("{} cannot be written.", part_.string());
  flush_rows();
  flush_passes();
  Json told = summary;
  told["written"] = date_text(std::chrono::system_clock::now());
  out_ << "<script type=\"application/json\" id=\"summary\">" << script_json(dump(told))
       << "</script>\n"
       << after_;
  out_.close();
  if (!out_) return "The report cannot be written; is the disk full?";
  std::error_code failure;
  std::filesystem::rename(part_, target_, failure);
  if (failure) return fmt::format("{} cannot be written.", target_.string());
  done_ = true;
  return std::nullopt;
}

std::optional<std::string> write_html_report(const std::string& results,
                                             const std::string& directory) {
  std::ifstream in = open_regular(results);
  if (!in) return fmt::format("{} cannot be opened.", results);
  std::string line;
  std::getline(in, line);
  const std::optional<Json> header = parse_object(line);
  const auto format = header ? count_of(*header, "format") : std::nullopt;
  if (!format || !reads_results_format(static_cast<std::int64_t>(*format))) {
    return fmt::format("{} does not begin with the header of a results file of format 1 or {}.",
                       results, kResultsFormat);
  }
  HtmlPage page(directory, *header);
  Summary summary(*header);
  std::optional<Json> footer;
  std::uint64_t bad_lines = 0;
  CaseHead head;
  while (std::getline(in, line)) {
    if (line.empty()) continue;
    const bool is_object = read_case_head(line, head);
    if (is_object && !head.id.empty() && !head.verdict.empty()) {
      page.add(head, summary.add(head));
      const bool is_told = head.verdict == "skip" || decision_of(head.verdict) == Decision::go;
      if (!is_told) page.add_detail(Json::parse(line), summary.findings().is_smallest());
      continue;
    }
    std::optional<Json> value = parse_object(line);
    if (value && value->contains("totals")) {
      footer = std::move(value);
    } else {
      ++bad_lines;
    }
  }
  return page.finish(summary.finish(*header, footer ? &*footer : nullptr, bad_lines));
}

}  // namespace gonogo::oracle::report
