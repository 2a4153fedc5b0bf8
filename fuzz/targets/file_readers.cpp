// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/targets/file_readers.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <variant>

#include "campaign/encoding.hpp"
#include "campaign/known_failures.hpp"
#include "campaign/results_reader.hpp"
#include "capture/sample_reader.hpp"
#include "corpus/io/corpus.hpp"
#include "corpus/io/errata.hpp"
#include "fuzz/targets/file_scratch.hpp"
#include "oracle/records/trace_reader.hpp"
#include "publish/evidence/compare.hpp"
#include "publish/evidence/verify.hpp"
#include "reference/profile.hpp"

namespace gonogo::fuzz {
namespace {

using namespace oracle;

// What was read, or the error that the reader declares.
template <typename Error, typename Read>
std::string answer_of(Read read) {
  try {
    return read();
  } catch (const Error& error) {
    return error.what();
  }
}

// What was read and written anew is the same when it is read again.
void need_same(const std::string& first, const std::string& again) {
  if (first != again)
    throw std::logic_error("what was read is written as " + first + ", and again as " + again);
}

std::string text_of(const TraceLine& line) {
  std::string text;
  if (const auto* record = std::get_if<reference::Record>(&line)) {
    reference::append_json(*record, text);
  } else if (const auto* alarm = std::get_if<SubjectAlarm>(&line)) {
    text = alarm->native + "/" + alarm->alarm_class + "/" + std::to_string(alarm->block);
  } else {
    text = std::get<TraceFault>(line).message;
  }
  return text;
}

std::string read_records(std::string_view file) {
  TraceReader reader;
  std::string answer;
  while (!file.empty()) {
    const std::size_t end = std::min(file.find('\n'), file.size());
    const TraceLine line = reader.read(file.substr(0, end));
    const std::string text = text_of(line);
    if (std::holds_alternative<reference::Record>(line))
      need_same(text, text_of(reader.read(text)));
    answer += text + "\n";
    file.remove_prefix(std::min(end + 1, file.size()));
  }
  return answer;
}

std::string results_in(std::string_view file, ResultsReader::Order order) {
  return answer_of<ResultsError>([&] {
    ResultsReader reader(scratch().put("results.jsonl", file), order);
    std::string answer = oracle::dump(reader.header());
    for (CaseHead head; reader.next(head);) answer += "\n" + head.id + " " + head.verdict;
    return answer + "\n" + reader.sha256() + (reader.footer() ? " whole" : " cut off");
  });
}

std::string read_results(std::string_view file) {
  return results_in(file, ResultsReader::Order::by_id);
}

std::string read_journal(std::string_view file) {
  return results_in(file, ResultsReader::Order::as_run);
}

std::string read_compared(std::string_view file) {
  return answer_of<ResultsError>([&] {
    const std::string path = scratch().put("results.jsonl", mended_results(file));
    return evidence::comparison_text(evidence::compare_runs({path, path}),
                                     evidence::CompareFormat::text);
  });
}

// Only the results are the input: all else of the folder follows from them, and fails where it is
// compared.
std::string read_certificate(std::string_view file) {
  scratch().put("certificate/results.jsonl", mended_results(file));
  std::string answer;
  for (const evidence::Check& check : evidence::verify_certificate(
           scratch().path("certificate"), scratch().path("corpus"), kMendedVersion)) {
    answer += std::to_string(static_cast<int>(check.result)) + " " + check.sentence + "\n";
  }
  return answer;
}

std::string read_vectors(std::string_view file) {
  return answer_of<CorpusError>([&]() -> std::string {
    const std::vector<Case> cases = read_vector_file(scratch().put("vectors.json", file));
    if (cases.empty()) return "no cases";
    const std::string text = vector_file_text(kUnreleased, cases);
    need_same(text,
              vector_file_text(kUnreleased, read_vector_file(scratch().put("vectors.json", text))));
    return text;
  });
}

std::string read_manifest(std::string_view file) {
  return answer_of<CorpusError>([&] {
    scratch().put("manifest/manifest.json", file);
    const Corpus corpus(scratch().path("manifest"));
    return corpus.version() + " " + corpus.sha256() + " " + std::to_string(corpus.retired().size());
  });
}

std::string read_errata_file(std::string_view file) {
  return answer_of<CorpusError>([&] {
    scratch().put("errata/errata.toml", file);
    std::string answer;
    for (const Erratum& erratum : read_errata(scratch().path("errata"))) {
      answer +=
          erratum.id + " " + erratum.version + " " + erratum.what + " " + erratum.since + "\n";
    }
    return answer;
  });
}

std::string text_of(const reference::ProfileResult& read) {
  if (const auto* error = std::get_if<reference::ProfileError>(&read))
    return error->key + ": " + error->message;
  const auto& profile = std::get<reference::Profile>(read);
  const std::string text = reference::profile_json(profile);
  const auto again = reference::profile_from_json(text, profile.dialect);
  const auto* same = std::get_if<reference::Profile>(&again);
  if (same == nullptr) throw std::logic_error(std::get<reference::ProfileError>(again).message);
  need_same(text, reference::profile_json(*same));
  return profile.dialect + " " + text;
}

std::string read_profile_toml(std::string_view file) {
  return text_of(reference::profile_from_toml(file));
}

std::string read_profile_json(std::string_view file) {
  return text_of(reference::profile_from_json(file));
}

std::string read_known_failures(std::string_view file) {
  const auto read = known_causes_from_toml(file);
  if (const auto* fault = std::get_if<FileFault>(&read)) return fault->message;
  const std::string text = known_causes_text(std::get<std::vector<KnownCause>>(read));
  const auto again = known_causes_from_toml(text);
  if (const auto* fault = std::get_if<FileFault>(&again))
    throw std::logic_error(fault->message + "\n" + text);
  need_same(text, known_causes_text(std::get<std::vector<KnownCause>>(again)));
  return text;
}

std::string read_alarm_map(std::string_view file) {
  const auto read = alarm_map_from_toml(file);
  if (const auto* fault = std::get_if<FileFault>(&read)) return fault->message;
  std::string answer;
  for (const AlarmMap::Entry& entry : std::get<std::vector<AlarmMap::Entry>>(read)) {
    answer += entry.native + " " + entry.alarm_class + "\n";
  }
  return answer;
}

std::string read_samples(std::string_view file) {
  return answer_of<SampleFault>([&] {
    SampleReader reader(scratch().put("samples.csv", file));
    std::string answer;
    for (Sample sample; reader.next(sample);) {
      answer += sample.time.text() + " " + std::to_string(sample.block);
      for (const reference::Axis axis : reference::kAllAxes) answer += " " + sample.at[axis].text();
      answer += "\n";
    }
    return reader.alarm() ? answer + reader.alarm()->native + reader.alarm()->alarm_class : answer;
  });
}

// 'a' is the first.
constexpr std::array<FileReader, 13> kReaders = {{{"records", read_records},
                                                  {"results", read_results},
                                                  {"a journal", read_journal},
                                                  {"a certificate", read_certificate},
                                                  {"results compared", read_compared},
                                                  {"vectors", read_vectors},
                                                  {"a manifest", read_manifest},
                                                  {"errata", read_errata_file},
                                                  {"a profile in TOML", read_profile_toml},
                                                  {"a profile in JSON", read_profile_json},
                                                  {"known failures", read_known_failures},
                                                  {"an alarm map", read_alarm_map},
                                                  {"samples", read_samples}}};

}  // namespace

const FileReader& file_reader(std::uint8_t choice) {
  return kReaders[static_cast<std::uint8_t>(choice - 'a') % kReaders.size()];
}

}  // namespace gonogo::fuzz
