// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads results.jsonl line by line, and says of a file that is not whole what is wrong and where.
#pragma once

#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>

#include "corpus/io/sha256.hpp"
#include "oracle/records/case_head.hpp"

namespace gonogo::oracle {

// What is wrong with a results file: a sentence with the file and the number of the line.
class ResultsError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class ResultsReader {
 public:
  using Json = nlohmann::ordered_json;
  enum class Order {
    by_id,   // a results file: sorted, no id twice
    as_run,  // the journal of a run: in any order, and a last line that was cut off is dropped
  };

  // Opens the file and reads the header; throws ResultsError.
  explicit ResultsReader(std::string path, Order order = Order::by_id);

  const std::string& path() const { return path_; }
  const Json& header() const { return header_; }
  // The next case line: what lists show of it. False after the last. Throws ResultsError for a line
  // that is cut off, is no JSON, is neither case nor footer, names no verdict, comes twice or out
  // of order, and for a footer whose hash or number of cases differs from the lines.
  bool next(CaseHead& head);
  // The same: the whole line.
  bool next(Json& line);
  // The line that was read last, as it stands in the file without its line end, and as JSON.
  const std::string& text() const { return text_; }
  Json json() const { return parsed(); }
  // After the last case line; nothing: the file is incomplete.
  const std::optional<Json>& footer() const { return footer_; }
  // For the case lines read so far, as in the footer: without what differs from run to run.
  std::string sha256() const;
  std::uint64_t cases() const { return cases_; }
  // For the line read last, from 1.
  std::uint64_t line_number() const { return line_number_; }
  // Bytes up to and with the last whole line.
  std::uint64_t whole_bytes() const { return whole_bytes_; }

 private:
  bool read_line();
  Json parsed() const;
  void read_head(CaseHead& head) const;
  void check_case(const CaseHead& head);
  void take_footer(Json line);
  std::string sha256_of_values() const;
  [[noreturn]] void fail(const std::string& sentence) const;

  std::string path_;
  Order order_;
  std::ifstream in_;
  std::string text_;
  std::uint64_t line_number_ = 0;
  std::uint64_t whole_bytes_ = 0;
  Json header_;
  std::optional<Json> footer_;
  Sha256 hash_;         // of the lines as they stand there
  std::string sha256_;  // what the footer says, once it is found to be true
  CaseHead head_;
  std::string last_id_;
  std::uint64_t cases_ = 0;
};

// A case line as the hash of the footer takes it: without `us`, `attempts` and `notes`, with a line
// end.
std::string hashed_text(const nlohmann::ordered_json& line);

}  // namespace gonogo::oracle
