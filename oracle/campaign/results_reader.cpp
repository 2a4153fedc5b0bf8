// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/campaign/results_reader.hpp"

#include <fmt/format.h>

#include "oracle/verdict.hpp"

namespace gonogo::oracle {

using Json = ResultsReader::Json;

namespace {

std::string dump(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

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
    if (key == "us" || key == "attempts") continue;
    if (text.size() > 1) text += ',';
    text += dump(Json(key));
    text += ':';
    text += dump(value);
  }
  return text + "}\n";
}

ResultsReader::ResultsReader(std::string path, Order order)
    : path_(std::move(path)), order_(order), in_(path_, std::ios::binary) {
  if (!in_) throw ResultsError(fmt::format("{} cannot be opened.", path_));
  if (!read_line()) {
    throw ResultsError(fmt::format("{} is empty: a results file begins with its header.", path_));
  }
  header_ = parsed();
  auto format = header_.find("format");
  if (format == header_.end()) fail("is not the header of a results file");
  if (*format != 1) fail(fmt::format("names the format {}; this program reads 1", dump(*format)));
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
  }
}

void ResultsReader::check_case(const Json& line) {
  auto id = text_of(line, "id");
  const auto verdict = text_of(line, "verdict");
  if (!id || !verdict) fail("is neither a case nor the footer");
  if (!verdict_kind(*verdict)) {
    fail(fmt::format("has the verdict \"{}\", which this program does not know", *verdict));
  }
  if (!text_of(line, "dialect")) fail(fmt::format("names no dialect for the case {}", *id));
  if (order_ == Order::by_id && cases_ > 0) {
    if (*id == last_id_) fail(fmt::format("holds the case {} a second time", *id));
    if (*id < last_id_) {
      fail(
          fmt::format("holds the case {} after {}: the lines are not sorted by id", *id, last_id_));
    }
  }
  last_id_ = *std::move(id);
}

void ResultsReader::take_footer(Json line) {
  const std::string hash = sha256();
  if (const auto told = text_of(line, "sha256"); told != hash) {
    fail(fmt::format("says that the case lines have the SHA-256 {}, but they have {}",
                     told.value_or("(none)"), hash));
  }
  auto cases = line.find("cases");
  if (cases != line.end() && *cases != cases_) {
    fail(fmt::format("says that the file has {} cases, but it has {}", dump(*cases), cases_));
  }
  footer_ = std::move(line);
  if (read_line()) fail("follows the footer, which is the last line");
}

bool ResultsReader::next(Json& line, std::string* text) {
  if (footer_ || !read_line()) return false;
  line = parsed();
  if (!line.contains("id") && line.contains("totals")) {
    take_footer(std::move(line));
    return false;
  }
  check_case(line);
  hash_.update(hashed_text(line));
  ++cases_;
  if (text != nullptr) *text = text_;
  return true;
}

std::string ResultsReader::sha256() const {
  Sha256 so_far = hash_;
  return so_far.hex();
}

}  // namespace gonogo::oracle
