// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/generate/cover/cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <set>
#include <sstream>

#include "fuzz/generate/cover/minimise.hpp"
#include "fuzz/generate/cover/sign_cases.hpp"
#include "corpus/io/sha256.hpp"
#include "fuzz/program/features.hpp"

namespace gonogo::cover {

using oracle::Case;
using oracle::Expectation;

namespace {

std::vector<std::string> words_of(std::string_view text) {
  std::istringstream in{std::string(text)};
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

std::string in_one_line(const std::set<std::string>& texts) {
  std::string out;
  for (const std::string& text : texts) out += (out.empty() ? "" : ", ") + text;
  return out.empty() ? "none" : out;
}

// "class@line" of each alarm that the row must raise.
std::set<std::string> wanted_alarms(const Parameters& parameters, const Row& row,
                                    std::size_t line) {
  std::set<std::string> wanted;
  for (std::size_t p = 0; p < row.size(); ++p) {
    for (const std::string& alarm : parameters.list[p].classes[row[p]].alarms) {
      wanted.insert(fmt::format("{}@{}", alarm, line));
    }
  }
  return wanted;
}

std::set<std::string> alarms_of(const Expectation& expectation) {
  std::set<std::string> alarms;
  for (const oracle::ExpectedAlarm& alarm : expectation.alarms) {
    alarms.insert(fmt::format("{}@{}", name(alarm.alarm), alarm.block));
  }
  if (expectation.not_covered) alarms.insert("not-covered");
  return alarms;
}

// Tags of all classes; the comment names those that are not the first of their parameter.
void describe(const Parameters& parameters, const Row& row, Case& test) {
  for (std::size_t p = 0; p < row.size(); ++p) {
    const Parameter& parameter = parameters.list[p];
    const std::string tag = fmt::format("{}={}", parameter.name, parameter.classes[row[p]].name);
    test.tags_tway.push_back(tag);
    if (row[p] != 0) test.comment += (test.comment.empty() ? "" : ", ") + tag;
  }
  if (test.comment.empty()) test.comment = "the first class of every parameter";
}

bool raises(const std::vector<Expectation>& some, const std::set<std::string>& wanted) {
  return std::ranges::any_of(
      some, [&](const Expectation& expectation) { return alarms_of(expectation) == wanted; });
}

// What the case is there for: its tuples, and the clauses that its records and alarms name.
std::set<std::string> purposes_of(const Making& making, const Parameters& parameters,
                                  const Row& row, const Case& test) {
  std::set<std::string> purposes;
  for (std::string& tuple : tuples_of(parameters, making.strength, row)) {
    purposes.insert(std::move(tuple));
  }
  for (const Expectation& expectation : test.expect) {
    for (const reference::Record& record : expectation.records) {
      purposes.insert(std::string(reference::clause_name(record.clause)));
    }
  }
  return purposes;
}

}  // namespace

std::string Making::stem() const {
  return fmt::format("{}.v{}-t{}f{}-s{}", model->name, model->version, strength.valid,
                     strength.faulty, seed);
}

std::string Making::provenance() const {
  return fmt::format("model {} version {}, strength {}, of faults {}, seed {}", model->name,
                     model->version, strength.valid, strength.faulty, seed);
}

std::string group_name(const std::string& stem, const Case& test) {
  oracle::Sha256 hash;
  hash.update(reference::profile_json(test.profile));
  for (const std::string& feature : test.features) hash.update(" " + feature);
  return fmt::format("{}.{}", stem, hash.hex().substr(0, 8));
}

std::vector<std::string> clause_list(std::string_view text) {
  std::vector<std::string> clauses;
  for (const std::string& word : words_of(text)) {
    const std::size_t range = word.find("..");
    if (range == std::string::npos) {
      clauses.push_back(word);
      continue;
    }
    // "GSK-G94-01..12": the two digits before the dots to those behind.
    const std::string stem = word.substr(0, range - 2);
    const int last = std::stoi(word.substr(range + 2));
    for (int n = std::stoi(word.substr(range - 2, 2)); n <= last; ++n) {
      clauses.push_back(fmt::format("{}{:02}", stem, n));
    }
  }
  return clauses;
}

namespace {

// The profile under some answers to readings that it leaves open, and what is expected then.
struct Answered {
  reference::Profile profile;
  std::vector<std::pair<std::string, std::string>> when;
  Expectation expectation;
};

// One of each alternative of the first open reading that makes a difference; none: no reading does.
std::vector<Answered> answers_to_one(const Answered& before, std::string_view program) {
  const std::string said = expectation_json(before.expectation);
  for (const reference::Reading& reading : reference::readings()) {
    if (reading.by_properties || !reading.belongs_to(before.profile.dialect) ||
        !before.profile.readings.is(reading.key, "any")) {
      continue;
    }
    std::vector<Answered> answers;
    bool differs = false;
    for (const std::string_view value : reading.alternatives) {
      Answered& next = answers.emplace_back(before);
      next.profile.readings.set(reading.key, value);
      next.expectation = oracle::expectation_of(next.profile, program);
      differs = differs || expectation_json(next.expectation) != said;
      next.when.emplace_back(reading.name, value);
    }
    if (differs) return answers;
  }
  return {};
}

}  // namespace

std::vector<Expectation> expectations_of(const reference::Profile& profile,
                                         std::string_view program) {
  const Answered shown = {profile, {}, oracle::expectation_of(profile, program)};
  std::vector<Answered> open = {shown};
  std::vector<Expectation> expectations;
  while (!open.empty()) {
    Answered one = std::move(open.back());
    open.pop_back();
    std::vector<Answered> answers = answers_to_one(one, program);
    if (answers.empty()) {
      one.expectation.when = std::move(one.when);
      expectations.push_back(std::move(one.expectation));
    }
    // The first is stated first.
    std::ranges::move(answers.rbegin(), answers.rend(), std::back_inserter(open));
    if (open.size() + expectations.size() > oracle::kMostStated) return {shown.expectation};
  }
  return expectations;
}

std::optional<DrawnCase> case_of(const Making& making, const Parameters& parameters, const Row& row,
                                 std::string& why) {
  const Model& model = *making.model;
  const Pick pick(parameters, row);
  Drawing drawing(pick, model.dialect);
  model.draw(pick, drawing);

  Case test;
  test.dialect = model.dialect;
  test.cycle = model.cycle;
  test.program = drawing.program();
  test.profile = drawing.profile;
  test.clauses = clause_list(model.clauses);
  test.features = words_of(model.features);
  test.features.insert(test.features.end(), drawing.features.begin(), drawing.features.end());
  test.features = program::features_of_case({test.profile, test.program}, test.features);
  test.provenance = making.provenance();
  test.group = group_name(making.stem(), test);
  describe(parameters, row, test);
  test.expect = expectations_of(test.profile, test.program);

  const std::set<std::string> wanted = wanted_alarms(parameters, row, drawing.test_line);
  // Where a reading is open a row runs under the alternatives that are shown first, and a fault is
  // one under some of them.
  const std::set<std::string> got = alarms_of(test.expect.front());
  const bool is_meant = got == wanted || (!wanted.empty() && raises(test.expect, wanted));
  if (!is_meant) {
    why = fmt::format("the model wants the alarms {}, the reference gives {}.\n{} {}\n{}",
                      in_one_line(wanted), in_one_line(got), test.comment,
                      reference::profile_json(test.profile), test.program);
    return std::nullopt;
  }
  return DrawnCase{std::move(test), drawing.test_line, drawing.decimals()};
}

std::optional<Making> making_of(const Case& test) {
  const std::size_t number = test.id.rfind('.');
  const std::string stem = test.id.substr(0, number);
  const std::size_t place = stem.rfind('.');
  if (number == std::string::npos || place == std::string::npos) return std::nullopt;
  Making making;
  making.model = find_model(stem.substr(0, place));
  unsigned version = 0;
  unsigned long seed = 0;
  const int fields = std::sscanf(stem.c_str() + place, ".v%9u-t%2uf%2u-s%10lu", &version,
                                 &making.strength.valid, &making.strength.faulty, &seed);
  making.seed = seed;
  if (making.model == nullptr || fields != 4 || making.stem() != stem) return std::nullopt;
  return making;
}

Row row_of(const Parameters& parameters, const Case& test) {
  Row row(parameters.list.size(), kOpen);
  for (const std::string& tag : test.tags_tway) {
    const std::size_t place = tag.find('=');
    const std::size_t p = parameters.find(tag.substr(0, place));
    row[p] = static_cast<std::uint8_t>(parameters.find_class(p, tag.substr(place + 1)));
  }
  if (std::ranges::find(row, kOpen) != row.end()) {
    throw ModelError(fmt::format("The tags of {} do not name a class of each parameter.", test.id));
  }
  return row;
}

TupleCount count_cases(const Parameters& parameters, Strength strength,
                       const std::vector<Case>& cases) {
  std::vector<Row> rows;
  for (const Case& test : cases) {
    if (!test.tags_tway.empty()) rows.push_back(row_of(parameters, test));
  }
  return count_tuples(parameters, strength, rows);
}

namespace {

bool is_unsaid(const Parameters& parameters, const Row& row) {
  for (std::size_t p = 0; p < row.size(); ++p) {
    if (parameters.list[p].classes[row[p]].is_unsaid) return true;
  }
  return false;
}

}  // namespace

CoverCases cover_cases(const Making& making) {
  const Parameters parameters = parse_parameters(making.model->parameters);
  const CoveringArray array = covering_array(parameters, making.strength, making.seed);
  CoverCases made;
  std::vector<DrawnCase> all;
  std::vector<std::set<std::string>> purposes;
  for (std::size_t i = 0; i < array.rows.size(); ++i) {
    std::string why;
    const std::string id = fmt::format("{}.{:06}", making.stem(), i + 1);
    if (making.left_out.contains(id) || is_unsaid(parameters, array.rows[i])) continue;
    std::optional<DrawnCase> drawn = case_of(making, parameters, array.rows[i], why);
    if (!drawn) {
      made.disagreements.push_back(fmt::format("{}: {}", id, why));
      continue;
    }
    drawn->test.id = id;
    purposes.push_back(purposes_of(making, parameters, array.rows[i], drawn->test));
    all.push_back(*std::move(drawn));
  }
  std::vector<DrawnCase> kept;
  for (const std::size_t i : smallest_cover(purposes)) kept.push_back(std::move(all[i]));
  std::vector<Case> signs = sign_cases(making, kept);
  for (DrawnCase& drawn : kept) made.cases.push_back(std::move(drawn.test));
  made.count = count_cases(parameters, making.strength, made.cases);
  made.signs = signs.size();
  std::ranges::move(signs, std::back_inserter(made.cases));
  return made;
}

}  // namespace gonogo::cover
