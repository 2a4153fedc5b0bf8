// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/campaign/results.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <nlohmann/json.hpp>
#include <system_error>

#include "oracle/campaign/encoding.hpp"
#include "oracle/corpus/sha256.hpp"

namespace gonogo::oracle {

using Json = nlohmann::ordered_json;

namespace {

std::string dump(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

[[noreturn]] void fail(const std::string& path) {
  throw std::system_error(errno, std::generic_category(), path + " cannot be written");
}

Json numeric_json(const SubjectInfo& subject) {
  Json numeric = {{"kind", subject.numeric_kind}};
  if (subject.resolution) numeric["resolution"] = subject.resolution->text();
  if (subject.feed_resolution) numeric["feed_resolution"] = subject.feed_resolution->text();
  if (subject.chord) numeric["chord"] = subject.chord->text();
  return numeric;
}

Json text_or_null(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

}  // namespace

std::string header_line(const ResultsHeader& header) {
  Json line;
  line["format"] = 1;
  line["gonogo"] = header.version;
  line["corpus"] = {{"version", header.corpus_version}, {"sha256", header.corpus_sha256}};
  line["subject"] = {{"spec", header.subject_spec},
                     {"name", header.subject.name},
                     {"version", header.subject.version},
                     {"numeric", numeric_json(header.subject)},
                     {"features", header.subject.features}};
  line["profile"] = Json::parse(header.profile.empty() ? "{}" : header.profile);
  line["tolerance"] = text_or_null(header.tolerance);
  line["chord"] = text_or_null(header.chord);
  line["seed"] = header.seed;
  line["shard"] = header.shard;
  line["argv"] = header.argv;
  return dump(line);
}

std::string case_line(const CaseResult& result, bool with_timing) {
  const Verdict& verdict = result.verdict;
  Json line;
  line["id"] = result.id;
  line["dialect"] = result.dialect;
  line["cycle"] = result.cycle;
  line["clauses"] = result.clauses;
  line["verdict"] = name(verdict.kind);
  if (verdict.clause != reference::kNoClause) {
    line["clause"] = reference::clause_name(verdict.clause);
  }
  if (!verdict.reading.empty()) line["reading"] = verdict.reading;
  if (verdict.block != 0) line["b"] = verdict.block;
  if (verdict.record) line["record"] = *verdict.record;
  if (!verdict.word.empty()) line["word"] = verdict.word.text();
  if (!verdict.want.empty()) line["want"] = verdict.want;
  if (!verdict.got.empty()) line["got"] = verdict.got;
  if (!verdict.deviation_exact.empty()) {
    line["deviation"] = {{"exact", verdict.deviation_exact}, {"mm", verdict.deviation_mm}};
  }
  if (!verdict.witness.empty()) line["witness"] = Json::parse(verdict.witness);
  if (!verdict.feature.empty()) line["feature"] = verdict.feature;
  if (!verdict.message.empty()) line["message"] = verdict.message;
  if (with_timing) {
    line["us"] = result.microseconds;
    line["attempts"] = result.attempts;
  }
  if (!result.profile.empty() && result.profile != "{}")
    line["profile"] = Json::parse(result.profile);
  if (decision(verdict.kind) != Decision::go) {
    line["program"] = program_json(result.program);
    Json trace = Json::array();
    for (const std::string& record : result.trace) trace.push_back(Json::parse(record));
    line["trace"] = std::move(trace);
    if (!result.notes.empty()) line["notes"] = result.notes;
  }
  return dump(line);
}

ResultsWriter::ResultsWriter(std::string path, const ResultsHeader& header)
    : path_(std::move(path)), header_(header_line(header) + "\n") {
  part_ = std::fopen((path_ + ".part").c_str(), "w+e");
  if (part_ == nullptr) fail(path_ + ".part");
  if (std::fwrite(header_.data(), 1, header_.size(), part_) != header_.size()) fail(path_);
  end_ = static_cast<long long>(header_.size());
}

ResultsWriter::~ResultsWriter() {
  if (part_ != nullptr) std::fclose(part_);
}

void ResultsWriter::add(const CaseResult& result) {
  const std::string line = case_line(result, true) + "\n";
  if (std::fwrite(line.data(), 1, line.size(), part_) != line.size() || std::fflush(part_) != 0) {
    fail(path_ + ".part");
  }
  places_.push_back({result.id, end_, line.size()});
  end_ += static_cast<long long>(line.size());
  ++totals_[std::string(name(result.verdict.kind))];
}

void ResultsWriter::close(ResultsFooter& footer) {
  std::ranges::sort(places_, {}, &Place::id);
  const std::string sorted = path_ + ".sorted";
  std::FILE* out = std::fopen(sorted.c_str(), "we");
  if (out == nullptr) fail(sorted);
  Sha256 hash;
  auto put = [&](const std::string& text) {
    if (std::fwrite(text.data(), 1, text.size(), out) != text.size()) {
      const int reason = errno;
      std::fclose(out);
      errno = reason;
      fail(sorted);
    }
  };
  put(header_);
  for (const Place& place : places_) {
    std::string line(place.length, '\0');
    if (std::fseek(part_, static_cast<long>(place.offset), SEEK_SET) != 0 ||
        std::fread(line.data(), 1, line.size(), part_) != line.size()) {
      std::fclose(out);
      fail(path_ + ".part");
    }
    put(line);
    Json bare = Json::parse(line);
    bare.erase("us");
    bare.erase("attempts");
    hash.update(dump(bare) + "\n");
  }
  footer.totals = totals_;
  footer.sha256 = hash.hex();
  Json last;
  last["decision"] = footer.decision;
  last["totals"] = footer.totals;
  last["judged"] = footer.judged;
  last["assignments"] = footer.assignments;
  last["sha256"] = footer.sha256;
  put(dump(last) + "\n");
  const bool written = std::fflush(out) == 0 && ::fsync(::fileno(out)) == 0;
  if (std::fclose(out) != 0 || !written) fail(sorted);
  if (std::rename(sorted.c_str(), path_.c_str()) != 0) fail(path_);
  std::fclose(part_);
  part_ = nullptr;
  std::remove((path_ + ".part").c_str());
}

}  // namespace gonogo::oracle
