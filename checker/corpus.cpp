// SPDX-License-Identifier: GPL-3.0-or-later
#include "checker/corpus.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "checker/sha256.hpp"

namespace gonogo::checker {
namespace fs = std::filesystem;
namespace {

Expectation read_expectation(const Json& value) {
  Expectation expectation;
  const Json* basis = value.find("basis");
  expectation.is_silent = basis != nullptr && basis->text == "silent";
  if (const Json* when = value.find("when")) {
    for (const auto& [key, choice] : when->members) expectation.when[key] = choice.text;
  }
  bool has_end = false;
  for (const Json& item : value.member("records", Json::Kind::list).items) {
    Record record = read_record(item);
    if (has_end) throw Fault("A record follows the end.");
    has_end = record.kind == RecordKind::end;
    if (has_end) {
      expectation.end = record.to;
    } else {
      expectation.records.push_back(std::move(record));
    }
  }
  int endings = has_end ? 1 : 0;
  if (const Json* alarm = value.find("alarm")) {
    ++endings;
    expectation.ending = Expectation::Ending::alarm;
    for (const Json& choice : alarm->member("any_of", Json::Kind::list).items) {
      expectation.any_of.push_back({choice.text_of("class"), choice.integer_of("b")});
    }
    if (expectation.any_of.empty()) throw Fault("An alarm has no class.");
  }
  if (value.find("not_covered") != nullptr) {
    ++endings;
    expectation.ending = Expectation::Ending::not_covered;
  }
  expectation.has_others = value.find("others") != nullptr;
  if (endings != 1) throw Fault("An expectation has none or several of end, alarm, not_covered.");
  return expectation;
}

std::vector<std::string> vector_files(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::recursive_directory_iterator(folder + "/vectors", error)) {
    if (!entry.is_regular_file() || entry.path().extension() != ".json") continue;
    names.push_back(fs::relative(entry.path(), folder).generic_string());
  }
  if (error) throw Fault(folder + "/vectors cannot be listed: " + error.message() + ".");
  std::ranges::sort(names);
  return names;
}

}  // namespace

std::string file_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text;
  if (file) text.assign(std::istreambuf_iterator<char>(file), {});
  if (!file || file.bad()) throw Fault(path + " cannot be read.");
  return text;
}

std::string program_bytes(const Json& program) {
  if (program.is(Json::Kind::text)) return program.text;
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::string& text = program.text_of("base64");
  std::string bytes;
  unsigned long held = 0;
  int bits = 0;
  for (const char c : text.substr(0, text.find('='))) {
    const std::size_t digit = kDigits.find(c);
    if (digit == std::string_view::npos) throw Fault("A program's base64 has a foreign character.");
    held = ((held << 6) | digit) & 0xFFFFFF;
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>((held >> bits) & 0xFF);
  }
  return bytes;
}

Corpus::Corpus(std::string folder) : folder_(std::move(folder)) {
  std::vector<std::string> listed;
  read_manifest(listed);
  std::ranges::sort(listed);
  const std::vector<std::string> names = vector_files(folder_);
  if (listed != names) {
    faults_.push_back("manifest.json does not list the files below vectors/, each of them once.");
  }
  Sha256 hash;
  for (const std::string& name : names) {
    files_.push_back({name, file_text(folder_ + "/" + name)});
    const std::string& text = files_.back().text;
    hash.update(name + "\n" + std::to_string(text.size()) + "\n");
    hash.update(text);
    try {
      index(files_.size() - 1);
    } catch (const Fault& fault) {
      throw Fault(name + ": " + fault.what());
    }
  }
  sha256_ = hash.hex();
}

void Corpus::read_manifest(std::vector<std::string>& listed) {
  const std::string path = folder_ + "/manifest.json";
  const std::string text = file_text(path);
  try {
    const Json manifest = parse_json(text);
    if (manifest.integer_of("format") != 1) throw Fault("The format is not 1.");
    version_ = manifest.text_of("version");
    listed = manifest.texts_of("files");
    retired_ = manifest.texts_of("retired");
  } catch (const Fault& fault) {
    throw Fault(path + ": " + fault.what());
  }
}

void Corpus::index(std::size_t file) {
  const Json root = parse_json(files_[file].text);
  for (const Json& group : root.member("groups", Json::Kind::list).items) {
    groups_.push_back({{root.text_of("dialect"), root.text_of("cycle"), group.texts_of("clauses")},
                       group.texts_of("features"),
                       group.member("profile", Json::Kind::object)});
    for (const Json& one : group.member("cases", Json::Kind::list).items) {
      const std::string& id = one.text_of("id");
      const Place place{file, groups_.size() - 1, one.begin, one.end};
      if (!cases_.emplace(id, place).second) faults_.push_back("The id " + id + " is there twice.");
    }
  }
}

void Corpus::for_each(
    const std::function<void(const std::string& id, const Topic& topic)>& visit) const {
  for (const auto& [id, place] : cases_) visit(id, groups_[place.group].topic);
}

Vector Corpus::read(const std::string& id) const {
  const Place& place = cases_.at(id);
  const Group& group = groups_[place.group];
  const std::string& text = files_[place.file].text;
  const Json one = parse_json(std::string_view(text).substr(place.begin, place.end - place.begin));
  Vector vector{id, group.topic.dialect, group.features, group.profile, {}, {}};
  vector.cycle = group.topic.cycle;
  vector.clauses = group.topic.clauses;
  const Json* program = one.find("program");
  if (program == nullptr) throw Fault("The program is missing.");
  vector.program = program_bytes(*program);
  for (const Json& item : one.member("expect", Json::Kind::list).items) {
    vector.expect.push_back(read_expectation(item));
  }
  return vector;
}

}  // namespace gonogo::checker
