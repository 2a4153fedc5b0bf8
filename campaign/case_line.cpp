// SPDX-License-Identifier: GPL-3.0-or-later
//
// A case as a line of results.jsonl, written by hand: there are millions of them.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "campaign/encoding.hpp"
#include "campaign/results.hpp"
#include "campaign/results_reader.hpp"

namespace gonogo::oracle {

using Json = nlohmann::ordered_json;

namespace {

bool is_plain(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0x20 && byte < 0x7F && c != '"' && c != '\\';
}

// The same bytes as the JSON library writes, so that a line read and written again is the same.
class LineText {
 public:
  void text(std::string_view key, std::string_view value) {
    begin(key);
    append(value);
  }
  void texts(std::string_view key, const std::vector<std::string>& values) {
    list(key, values, &LineText::append);
  }
  template <typename Integer>
  void number(std::string_view key, Integer value) {
    begin(key);
    fmt::format_to(std::back_inserter(line_), "{}", value);
  }
  // A value that is JSON already, with or without blanks.
  void json(std::string_view key, std::string_view value) {
    begin(key);
    append_json(value);
  }
  void jsons(std::string_view key, const std::vector<std::string>& values) {
    list(key, values, &LineText::append_json);
  }
  void open(std::string_view key) {
    begin(key);
    line_ += '{';
    first_ = true;
  }
  void close() {
    line_ += '}';
    first_ = false;
  }
  std::string finish() {
    line_ += '}';
    return std::move(line_);
  }

 private:
  void begin(std::string_view key) {
    if (!first_) line_ += ',';
    first_ = false;
    line_ += '"';
    line_ += key;
    line_ += "\":";
  }
  void list(std::string_view key, const std::vector<std::string>& values,
            void (LineText::*append_one)(std::string_view)) {
    begin(key);
    line_ += '[';
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i > 0) line_ += ',';
      (this->*append_one)(values[i]);
    }
    line_ += ']';
  }
  void append(std::string_view value) {
    if (!std::ranges::all_of(value, is_plain)) {
      line_ += dump(Json(value));
      return;
    }
    line_ += '"';
    line_ += value;
    line_ += '"';
  }
  void append_json(std::string_view value) {
    const bool is_compact = std::ranges::none_of(value, [](char c) {
      return c == ' ' || c == '\n' || c == '\t' || c == '\\' || static_cast<signed char>(c) <= 0;
    });
    if (is_compact) {
      line_ += value;
    } else {
      line_ += dump(Json::parse(value));
    }
  }

  std::string line_ = "{";
  bool first_ = true;
};

// The basis of the expectation that the case departs from. An advice departs from no text, even
// where its clause has one.
void append_basis(const Verdict& verdict, LineText& line) {
  if (verdict.kind == VerdictKind::advice) {
    line.text("basis", name(reference::Basis::silent));
  } else if (verdict.clause != reference::kNoClause && decision(verdict.kind) == Decision::no_go) {
    line.text("basis", name(reference::clause(verdict.clause).basis()));
  }
}

void append_departure(const Verdict& verdict, LineText& line) {
  if (verdict.departure) line.text("departure", name(*verdict.departure));
  const RelationRule rule = rule_of(verdict);
  if (rule != RelationRule::none) line.text("rule", name(rule));
  if (verdict.gap != GapReason::none) line.text("gap", name(verdict.gap));
  if (verdict.clause != reference::kNoClause) {
    line.text("clause", reference::clause_name(verdict.clause));
  }
  append_basis(verdict, line);
  if (!verdict.reading.empty()) line.text("reading", verdict.reading);
  if (!verdict.told_under.empty()) line.text("told_under", verdict.told_under);
  if (verdict.block != 0) line.number("b", verdict.block);
  if (verdict.record) line.number("record", *verdict.record);
  if (!verdict.word.empty()) line.text("word", verdict.word.text());
  if (!verdict.want.empty()) line.text("want", verdict.want);
  if (!verdict.got.empty()) line.text("got", verdict.got);
  if (!verdict.deviation_exact.empty()) {
    line.open("deviation");
    line.text("exact", verdict.deviation_exact);
    line.text("mm", verdict.deviation_mm);
    line.close();
  }
  if (!verdict.witness.empty()) line.json("witness", verdict.witness);
  if (!verdict.feature.empty()) line.text("feature", verdict.feature);
  if (!verdict.message.empty()) line.text("message", verdict.message);
  if (!verdict.known.empty()) line.text("known", verdict.known);
}

void append_sampled(const SampledFigures& figures, LineText& line) {
  line.open("sampled");
  line.number("samples", figures.samples);
  line.text("tolerance", figures.tolerance);
  line.text("noise", figures.noise);
  line.text("following", figures.following);
  if (!figures.go_from.empty()) line.text("go_from", figures.go_from);
  if (!figures.worst.empty()) line.text("worst", figures.worst);
  if (!figures.worst_at.empty()) line.json("at", figures.worst_at);
  if (figures.worst_block != 0) line.number("b", figures.worst_block);
  line.text("longest", figures.longest);
  line.text("unseen", figures.unseen);
  line.close();
}

// Nearly always all are exact.
void append_coordinates(const RoundingCensus& census, LineText& line) {
  RoundingCensus exact;
  exact.take_exact(census.exact());
  if (census != exact) return line.json("coordinates", dump(census.json()));
  line.open("coordinates");
  line.number("exact", census.exact());
  line.close();
}

void append_readings(const OpenReadings& readings, LineText& line) {
  line.open("readings");
  line.texts("open", readings.open);
  line.texts("explaining", readings.explaining);
  line.text("verdict", name(readings.verdict));
  if (!readings.known.empty()) line.text("known", readings.known);
  line.close();
}

// Where a run of digits that begins at `at` ends.
std::size_t digits_end(std::string_view line, std::size_t at) {
  while (at < line.size() && line[at] >= '0' && line[at] <= '9') ++at;
  return at;
}

// Where the text that begins at `at` ends, behind its quote.
std::size_t text_end(std::string_view line, std::size_t at) {
  for (; at < line.size(); ++at) {
    if (line[at] == '\\') {
      ++at;
    } else if (line[at] == '"') {
      return at + 1;
    }
  }
  return line.size();
}

// Where `us`, `attempts` and `notes` stand in a case line as written here. No key of that name
// stands before them, and in a text the quotes would be escaped.
struct Timing {
  std::size_t begin;
  std::size_t end;
};

std::optional<Timing> timing_in(std::string_view line) {
  constexpr std::string_view kTime = ",\"us\":";
  constexpr std::string_view kAttempts = ",\"attempts\":";
  constexpr std::string_view kNotes = ",\"notes\":\"";
  const std::size_t begin = line.find(kTime);
  if (begin == std::string_view::npos) return std::nullopt;
  const std::size_t end = digits_end(line, begin + kTime.size());
  if (line.substr(end, kAttempts.size()) != kAttempts) return std::nullopt;
  const std::size_t behind = digits_end(line, end + kAttempts.size());
  if (line.substr(behind, kNotes.size()) != kNotes) return Timing{begin, behind};
  return Timing{begin, text_end(line, behind + kNotes.size())};
}

}  // namespace

std::string case_line(const CaseResult& result, bool with_timing) {
  const Verdict& verdict = result.verdict;
  LineText line;
  line.text("id", result.id);
  line.text("dialect", result.dialect);
  line.text("cycle", result.cycle);
  if (!result.features.empty()) line.texts("features", result.features);
  line.texts("clauses", result.clauses);
  line.text("verdict", name(verdict.kind));
  const bool says_nothing =
      verdict.kind == VerdictKind::oracle_gap || verdict.kind == VerdictKind::skip;
  if (result.expected_gap && says_nothing) line.json("expected", "true");
  const bool is_go = decision(verdict.kind) == Decision::go;
  if (is_go && verdict.property_motions > 0) {
    line.number("property_motions", verdict.property_motions);
  }
  if (verdict.coordinates && is_go) append_coordinates(*verdict.coordinates, line);
  append_departure(verdict, line);
  if (!result.mapped.empty()) line.text("mapped", result.mapped);
  if (verdict.sampled != nullptr) append_sampled(*verdict.sampled, line);
  if (with_timing) {
    line.number("us", result.microseconds);
    line.number("attempts", result.attempts);
    if (!result.notes.empty()) line.text("notes", result.notes);
  }
  if (result.readings) append_readings(*result.readings, line);
  if (!result.profile.empty() && result.profile != "{}") line.json("profile", result.profile);
  const bool may_fail = result.readings && !result.program.empty();
  if ((!is_go && verdict.kind != VerdictKind::skip) || may_fail) {
    line.json("program", dump(program_json(result.program)));
    line.jsons("trace", result.trace);
  }
  return line.finish();
}

std::string line_without_timing(std::string_view line) {
  const std::optional<Timing> timing = timing_in(line);
  if (timing) return std::string(line.substr(0, timing->begin)).append(line.substr(timing->end));
  std::string text = hashed_text(Json::parse(line));
  text.pop_back();
  return text;
}

void hash_case_line(std::string_view line, Sha256& hash) {
  if (const std::optional<Timing> timing = timing_in(line)) {
    hash.update(line.substr(0, timing->begin));
    hash.update_line(line.substr(timing->end));
  } else {
    hash.update(hashed_text(Json::parse(line)));
  }
}

std::string id_of_line(std::string_view line) {
  constexpr std::string_view kHead = "{\"id\":\"";
  if (line.starts_with(kHead)) {
    const std::size_t end = line.find_first_of("\"\\", kHead.size());
    if (end != std::string_view::npos && line[end] == '"') {
      return std::string(line.substr(kHead.size(), end - kHead.size()));
    }
  }
  return Json::parse(line).at("id").get<std::string>();
}

}  // namespace gonogo::oracle
