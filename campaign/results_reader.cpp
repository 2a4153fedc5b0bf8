// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign/results_reader.hpp"

#include <fmt/format.h>

#include "campaign/encoding.hpp"
#include "campaign/results.hpp"
#include "campaign/results_shape.hpp"
#include "oracle/records/input_file.hpp"
#include "oracle/records/verdict.hpp"

namespace gonogo::oracle {

using Json = ResultsReader::Json;

namespace {

// The text member; nothing when it is missing, empty or no text.
std::optional<std::string> text_of(const Json& object, const char* key) {
  auto found = object.find(key);
  if (found == object.end() || !found->is_string()) return std::nullopt;
  auto text = found->get<std::string>();
  if (text.empty()) return std::nullopt;
  return text;
}

}  // namespace

std::string hashed_text(const Json& line) {
  std::string text = "{";
  for (const auto& [key, value] : line.items()) {
    if (key == "us" || key == "attempts" || key == "notes") continue;
    if (text.size() > 1) text += ',';
    text += dump(Json(key));
    text += ':';
    text += dump(value);
  }
  return text + "}\n";
}

ResultsReader::ResultsReader(std::string path, Order order)
    : path_(std::move(path)), order_(order), in_(open_regular(path_)) {
  if (!in_) throw ResultsError(fmt::format("{} cannot be opened.", path_));
  if (!read_line()) {
    throw ResultsError(fmt::format("{} is empty: a results file begins with its header.", path_));
  }
  header_ = parsed();
  auto format = header_.find("format");
  if (format == header_.end()) fail("is not the header of a results file");
  if (!format->is_number_integer() || !reads_results_format(format->get<std::int64_t>())) {
    fail(fmt::format("names the format {}; this program reads 1 to {}", dump(*format),
                     kResultsFormat));
  }
  if (const auto fault = header_fault(header_)) fail(*fault);
}

void ResultsReader::fail(const std::string& sentence) const {
  throw ResultsError(fmt::format("{}: line {} {}.", path_, line_number_, sentence));
}

// False at the end of the file.
bool ResultsReader::read_line() {
  if (!std::getline(in_, text_)) {
    if (in_.bad()) throw ResultsError(fmt::format("{} cannot be read.", path_));
    return false;
  }
  ++line_number_;
  if (!in_.eof()) {
    whole_bytes_ += text_.size() + 1;
    return true;
  }
  // Without a line end: the writer was stopped in the middle.
  if (order_ == Order::as_run && line_number_ > 1) return false;
  fail("is cut off: it has no line end");
}

Json ResultsReader::parsed() const {
  try {
    Json value = Json::parse(text_);
    if (!value.is_object()) fail("is no JSON object");
    return value;
  } catch (const Json::parse_error& error) {
    fail(fmt::format("is no JSON: it cannot be read from byte {} on", error.byte));
  } catch (const Json::out_of_range&) {
    fail("holds a number that is too large");
  }
}

void ResultsReader::read_head(CaseHead& head) const {
  if (read_case_head(text_, head)) return;
  // What is no JSON is reported in the words of the larger parser, which takes a key that stands
  // twice.
  if (!read_case_head(dump(parsed()), head)) fail("nests deeper than a line of results");
}

void ResultsReader::check_case(const CaseHead& head) {
  if (head.id.empty() || head.verdict.empty()) fail("is neither a case nor the footer");
  if (!verdict_kind(head.verdict)) {
    fail(fmt::format("has the verdict \"{}\", which this program does not know", head.verdict));
  }
  if (head.dialect.empty()) fail(fmt::format("names no dialect for the case {}", head.id));
  if (order_ == Order::by_id && cases_ > 0) {
    if (head.id == last_id_) fail(fmt::format("holds the case {} a second time", head.id));
    if (head.id < last_id_) {
      fail(fmt::format("holds the case {} after {}: the lines are not sorted by id", head.id,
                       last_id_));
    }
  }
  last_id_ = head.id;
}

// The hash is that of the lines as this program writes them. A file that was written anew with
// other blanks holds the same values.
std::string ResultsReader::sha256_of_values() const {
  std::ifstream in = open_regular(path_);
  std::string line;
  std::getline(in, line);
  Sha256 hash;
  for (std::uint64_t i = 0; i < cases_ && std::getline(in, line); ++i) {
    hash.update(hashed_text(Json::parse(line)));
  }
  return hash.hex();
}

void ResultsReader::take_footer(Json line) {
  const auto told = text_of(line, "sha256");
  if (told != sha256()) {
    const std::string hash = sha256_of_values();
    if (told != hash) {
      fail(fmt::format("says that the case lines have the SHA-256 {}, but they have {}",
                       told.value_or("(none)"), hash));
    }
  }
  sha256_ = *told;
  auto cases = line.find("cases");
  if (cases != line.end() && *cases != cases_) {
    fail(fmt::format("says that the file has {} cases, but it has {}", dump(*cases), cases_));
  }
  if (const auto fault = footer_fault(line)) fail(*fault);
  footer_ = std::move(line);
  if (read_line()) fail("follows the footer, which is the last line");
}

bool ResultsReader::next(CaseHead& head) {
  if (footer_ || !read_line()) return false;
  read_head(head);
  if (head.id.empty()) {
    Json line = parsed();
    if (!line.contains("id") && line.contains("totals")) {
      take_footer(std::move(line));
      return false;
    }
  }
  check_case(head);
  hash_case_line(text_, hash_);
  ++cases_;
  return true;
}

bool ResultsReader::next(Json& line) {
  if (!next(head_)) return false;
  line = parsed();
  return true;
}

std::string ResultsReader::sha256() const {
  if (!sha256_.empty()) return sha256_;
  Sha256 so_far = hash_;
  return so_far.hex();
}

}  // namespace gonogo::oracle
