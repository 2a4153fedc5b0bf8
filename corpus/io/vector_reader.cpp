// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "corpus/io/corpus.hpp"
#include "corpus/io/files.hpp"
#include "corpus/io/json_place.hpp"
#include "oracle/records/json_document.hpp"
#include "oracle/records/text.hpp"
#include "oracle/records/trace_reader.hpp"

namespace gonogo::oracle {
namespace {

// Traces and exported programs are files of that name in a folder, and nowhere else.
bool names_a_file(std::string_view id) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
           c == '-' || c == '_';
  };
  return !id.empty() && id.size() <= 200 && id.front() != '.' &&
         id.find("..") == std::string_view::npos && std::ranges::all_of(id, is_plain);
}

using reference::Record;

reference::ClauseId clause_id(const JsonPlace& place) {
  const std::string name = place.text();
  const auto known = reference::clauses();
  const auto found = std::ranges::find(known, name, &reference::Clause::id);
  if (found == known.end()) place.fail(fmt::format("There is no clause {}.", name));
  return static_cast<reference::ClauseId>(found - known.begin());
}

bool flag_at(const JsonPlace& place, std::string_view key) {
  const auto value = place.find(key);
  return value && value->flag();
}

class FileReader {
 public:
  explicit FileReader(Detail detail) : detail_(detail) {}
  std::vector<Case> read(const JsonPlace& file);

 private:
  void read_group(const JsonPlace& group, const Case& head);
  void read_case(const JsonPlace& place, const Case& head);
  reference::Profile profile_of(const JsonPlace& place, const std::string& dialect) const;
  std::string program_of(const JsonPlace& place) const;
  Expectation expectation_of(const JsonPlace& place, const Case& test);
  Record record_of(const JsonPlace& place);
  OpenPart open_part_of(const JsonPlace& place, const Expectation& expectation) const;
  ExpectedAlarm alarm_of(const JsonPlace& place) const;

  Detail detail_;
  std::vector<Case> cases_;
  std::set<std::string> ids_;
  std::set<std::string> groups_;
  TraceReader records_;
};

std::vector<Case> FileReader::read(const JsonPlace& file) {
  file.need_object({"format", "corpus", "dialect", "cycle", "groups"});
  if (const std::int64_t format = file.member("format").integer(); format != 1 && format != 2) {
    file.member("format").fail(
        fmt::format("This program reads vector files of format 1 and 2, not {}.", format));
  }
  file.member("corpus").text();
  Case head;
  head.dialect = file.member("dialect").text();
  head.cycle = file.member("cycle").text();
  if (!names_a_file(head.cycle)) {
    file.member("cycle").fail("A cycle is letters, digits, points, - and _, as g94.");
  }
  for (const JsonPlace& group : file.member("groups").items()) read_group(group, head);
  std::ranges::sort(cases_, {}, &Case::id);
  return std::move(cases_);
}

void FileReader::read_group(const JsonPlace& group, const Case& head) {
  group.need_object({"gid", "features", "clauses", "profile", "cases"});
  Case common = head;
  common.group = group.member("gid").text();
  if (!groups_.insert(common.group).second) {
    group.member("gid").fail(fmt::format("The group {} stands twice.", common.group));
  }
  common.features = group.member("features").texts();
  common.clauses = group.member("clauses").texts();
  for (const JsonPlace& clause : group.member("clauses").items()) clause_id(clause);
  common.profile = profile_of(group.member("profile"), head.dialect);
  for (const JsonPlace& place : group.member("cases").items()) read_case(place, common);
}

void FileReader::read_case(const JsonPlace& place, const Case& head) {
  place.need_object({"id", "comment", "program", "expect", "tags", "provenance"});
  Case test = head;
  test.id = place.member("id").text();
  if (!names_a_file(test.id)) {
    place.member("id").fail("An id is letters, digits, points, - and _: files are named after it.");
  }
  if (!ids_.insert(test.id).second) {
    place.member("id").fail(fmt::format("The id {} stands twice.", test.id));
  }
  test.comment = place.member("comment").text();
  test.program = program_of(place.member("program"));
  const JsonPlace expect = place.member("expect");
  for (const JsonPlace& item : expect.items()) test.expect.push_back(expectation_of(item, test));
  if (test.expect.empty()) expect.fail("A case needs at least one expectation.");
  const JsonPlace tags = place.member("tags");
  tags.need_object({"tway", "sign"});
  test.tags_tway = tags.member("tway").texts();
  test.tags_sign = tags.member("sign").texts();
  test.provenance = place.member("provenance").text();
  cases_.push_back(std::move(test));
}

reference::Profile FileReader::profile_of(const JsonPlace& place,
                                          const std::string& dialect) const {
  if (const auto own = place.find("dialect")) own->fail("The dialect is that of the file.");
  std::string keys = place.json();
  const bool empty = keys.find_first_not_of("{} ") == std::string::npos;
  keys.insert(1, fmt::format("\"dialect\":\"{}\"{}", dialect, empty ? "" : ","));
  reference::ProfileResult result = reference::profile_from_json(keys);
  if (auto* error = std::get_if<reference::ProfileError>(&result)) place.fail(error->message);
  return std::get<reference::Profile>(std::move(result));
}

std::string FileReader::program_of(const JsonPlace& place) const {
  if (place.is_text()) return place.text();
  place.need_object({"base64"});
  const JsonPlace encoded = place.member("base64");
  auto bytes = decode_base64(encoded.text());
  if (!bytes) encoded.fail("This is not base64.");
  return *std::move(bytes);
}

Expectation FileReader::expectation_of(const JsonPlace& place, const Case& test) {
  place.need_object({"when", "basis", "records", "open", "alarm", "not_covered", "others"});
  Expectation expectation;
  if (detail_ == Detail::to_run) {
    expectation.not_covered = flag_at(place, "not_covered");
    return expectation;
  }
  if (const auto when = place.find("when")) {
    reference::Profile profile = test.profile;
    for (const auto& [reading, value] : when->members()) {
      if (auto error = reference::set_reading(profile, reading, value.text())) {
        value.fail(error->message);
      }
      expectation.when.emplace_back(reading, value.text());
    }
  }
  if (const auto basis = place.find("basis")) {
    expectation.basis = reference::basis(basis->text());
    if (!expectation.basis) basis->fail(fmt::format("There is no basis {}.", basis->text()));
  }
  for (const JsonPlace& record : place.member("records").items()) {
    expectation.records.push_back(record_of(record));
  }
  if (const auto open = place.find("open")) {
    for (const JsonPlace& item : open->items()) {
      expectation.open.push_back(open_part_of(item, expectation));
    }
  }
  if (const auto alarm = place.find("alarm")) {
    alarm->need_object({"any_of"});
    for (const JsonPlace& item : alarm->member("any_of").items()) {
      expectation.alarms.push_back(alarm_of(item));
    }
    if (expectation.alarms.empty()) alarm->fail("At least one alarm must be admissible.");
  }
  expectation.not_covered = flag_at(place, "not_covered");
  expectation.has_others = flag_at(place, "others");
  const bool ends =
      !expectation.records.empty() && expectation.records.back().kind == reference::RecordKind::end;
  const int endings =
      (ends ? 1 : 0) + (expectation.alarms.empty() ? 0 : 1) + (expectation.not_covered ? 1 : 0);
  if (endings != 1) {
    place.fail("An expectation ends with one of: an end record, an alarm, not_covered.");
  }
  return expectation;
}

Record FileReader::record_of(const JsonPlace& place) {
  TraceLine line = records_.read(place.json());
  if (auto* fault = std::get_if<TraceFault>(&line)) place.fail(fault->message);
  auto* record = std::get_if<Record>(&line);
  if (record == nullptr) place.fail("An alarm is no record; it stands under \"alarm\".");
  if (record->block == 0 && record->kind != reference::RecordKind::end) {
    place.fail("A record of the corpus carries b, its source line.");
  }
  if (const auto clause = place.find("clause")) record->clause = clause_id(*clause);
  return std::move(*record);
}

OpenPart FileReader::open_part_of(const JsonPlace& place, const Expectation& expectation) const {
  place.need_object({"from", "to", "clause", "path", "conditions"});
  const std::int64_t from = place.member("from").integer();
  const std::int64_t to = place.member("to").integer();
  const std::size_t before = expectation.open.empty() ? 0 : expectation.open.back().to;
  if (from < static_cast<std::int64_t>(before) || to < from ||
      to > static_cast<std::int64_t>(expectation.records.size())) {
    place.fail("Open parts follow each other and lie within the records.");
  }
  return {static_cast<std::size_t>(from), static_cast<std::size_t>(to),
          clause_id(place.member("clause")), place.member("path").text(),
          place.member("conditions").json()};
}

ExpectedAlarm FileReader::alarm_of(const JsonPlace& place) const {
  place.need_object({"class", "b", "word"});
  ExpectedAlarm alarm;
  const JsonPlace alarm_class = place.member("class");
  const auto known = reference::alarm_class(alarm_class.text());
  if (!known) alarm_class.fail(fmt::format("There is no alarm class {}.", alarm_class.text()));
  alarm.alarm = *known;
  const std::int64_t block = place.member("b").integer();
  if (block < 1) place.member("b").fail("Source lines count from 1.");
  alarm.block = static_cast<std::uint64_t>(block);
  if (const auto named = place.find("word")) {
    const std::string word = named->text();
    if (word.empty() || word.size() > 7) {
      named->fail("A word is named by its address: X, CR, R101.");
    }
    alarm.word = reference::WordName(word);
  }
  return alarm;
}

}  // namespace

std::vector<Case> read_vector_file(const std::string& path, Detail detail) {
  const std::string text = file_text(path);
  JsonDocument document;
  auto parsed = document.parse(text);
  if (auto* fault = std::get_if<JsonFault>(&parsed)) {
    throw CorpusError(fmt::format("{}: {}", path, fault->message));
  }
  return FileReader(detail).read(JsonPlace(path, std::get<simdjson::dom::object>(parsed)));
}

}  // namespace gonogo::oracle
