// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/report/html.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "oracle/report/assets.hpp"
#include "oracle/report/case_detail.hpp"
#include "oracle/report/escape.hpp"
#include "oracle/report/json_value.hpp"
#include "oracle/report/summary.hpp"

namespace gonogo::oracle::report {
namespace {

// What drawings and records of all failures together may take of the page.
constexpr std::size_t kMostPathBytes = std::size_t{64} << 20;

std::optional<Json> parse_object(const std::string& line) {
  Json value = Json::parse(line, nullptr, false);
  if (!value.is_object()) return std::nullopt;
  return value;
}

// The data of the page, written as it comes: a block of rows for the list, a block a failure.
class PageWriter {
 public:
  PageWriter(std::ostream& out, std::string subject) : out_(out), subject_(std::move(subject)) {}

  void add(const Json& line) {
    append_row(line);
    if (rows_.size() > kRowBytes) flush_rows();
    if (decision_of(text_of(line, "verdict")) == Decision::go) return;
    const bool with_paths = path_bytes_ < kMostPathBytes;
    const std::string detail = script_json(dump(case_detail(line, subject_, with_paths)));
    path_bytes_ += detail.size();
    out_ << "<script type=\"application/json\" id=\"d" << index_ - 1 << "\">" << detail
         << "</script>\n";
  }
  void flush_rows() {
    if (rows_.empty()) return;
    out_ << "<script type=\"application/json\" class=\"rows\">[" << rows_ << "]</script>\n";
    rows_.clear();
  }

 private:
  static constexpr std::size_t kRowBytes = std::size_t{1} << 20;

  void append_row(const Json& line) {
    Json row = Json::array({text_of(line, "id"), text_of(line, "dialect"), text_of(line, "cycle"),
                            text_of(line, "verdict"), text_of(line, "clause"),
                            text_of(line, "message"), line.value("clauses", Json::array())});
    if (!rows_.empty()) rows_ += ',';
    rows_ += script_json(dump(row));
    ++index_;
  }

  std::ostream& out_;
  std::string subject_;
  std::string rows_;
  std::size_t index_ = 0;
  std::size_t path_bytes_ = 0;
};

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
  replace(parts.before, "{{style}}", kReportCss.text);
  replace(parts.after, "{{script}}", kReportJs.text);
  return parts;
}

std::optional<ReportError> write_page(std::istream& in, const Json& header, std::ostream& out) {
  const Skeleton page = skeleton();
  out << page.before;
  PageWriter writer(out, subject_name(header));
  Summary summary;
  std::optional<Json> footer;
  std::uint64_t bad_lines = 0;
  std::string line;
  while (std::getline(in, line)) {
    if (line.empty()) continue;
    std::optional<Json> value = parse_object(line);
    if (value && value->contains("totals")) {
      footer = std::move(value);
    } else if (value && !text_of(*value, "id").empty() && !text_of(*value, "verdict").empty()) {
      summary.add(*value);
      writer.add(*value);
    } else {
      ++bad_lines;
    }
  }
  writer.flush_rows();
  const Json whole = summary.finish(header, footer ? &*footer : nullptr, bad_lines);
  out << "<script type=\"application/json\" id=\"summary\">" << script_json(dump(whole))
      << "</script>\n"
      << page.after;
  out.flush();
  if (!out) return ReportError{"The report cannot be written; is the disk full?"};
  return std::nullopt;
}

}  // namespace

std::optional<ReportError> write_html_report(const std::string& results,
                                             const std::string& directory) {
  std::ifstream in(results, std::ios::binary);
  if (!in) return ReportError{fmt::format("{} cannot be opened.", results)};
  std::string first;
  std::getline(in, first);
  const std::optional<Json> header = parse_object(first);
  if (!header || count_of(*header, "format") != 1) {
    return ReportError{
        fmt::format("{} does not begin with the header of a results file of format 1.", results)};
  }
  std::error_code failure;
  std::filesystem::create_directories(directory, failure);
  const std::filesystem::path target = std::filesystem::path(directory) / "index.html";
  std::filesystem::path part = target;
  part += ".part";
  std::ofstream out(part, std::ios::binary | std::ios::trunc);
  if (!out) return ReportError{fmt::format("{} cannot be written.", part.string())};
  if (auto error = write_page(in, *header, out)) return error;
  out.close();
  std::filesystem::rename(part, target, failure);
  if (failure) return ReportError{fmt::format("{} cannot be written.", target.string())};
  return std::nullopt;
}

}  // namespace gonogo::oracle::report
