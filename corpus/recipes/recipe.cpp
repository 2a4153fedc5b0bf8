// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/recipes/recipe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "corpus/io/toml_file.hpp"
#include "fuzz/program/features.hpp"
#include "oracle/records/text.hpp"

namespace gonogo::recipes {

using oracle::Case;
using oracle::CorpusError;
using oracle::Expectation;
using Json = nlohmann::ordered_json;

namespace {

// A TOML file as JSON, which has no dates and no comments to care for.
Json document_of(const std::string& path) {
  std::ostringstream text;
  text << toml::json_formatter(oracle::read_toml_file(path));
  return Json::parse(text.str());
}

void need_keys(const Json& table, std::string_view what, std::initializer_list<const char*> known) {
  for (const auto& [key, value] : table.items()) {
    if (std::ranges::find(known, key) == known.end()) {
      throw CorpusError(fmt::format("{} has a key \"{}\" that recipes do not have.", what, key));
    }
  }
}

std::vector<std::string> texts(const Json& table, const char* key) {
  return table.value(key, std::vector<std::string>{});
}

reference::Profile profile_of(const Json& group, const std::string& dialect) {
  Json keys = group.value("profile", Json::object());
  keys["dialect"] = dialect;
  auto result = reference::profile_from_json(keys.dump());
  if (auto* error = std::get_if<reference::ProfileError>(&result)) {
    throw CorpusError(error->message);
  }
  return std::get<reference::Profile>(std::move(result));
}

// With the words that the first line of each program has behind its own.
std::string program_of(const Json& entry, std::string_view opening) {
  std::string program;
  if (entry.contains("base64")) {
    auto bytes = oracle::decode_base64(entry.at("base64").get<std::string>());
    if (!bytes) throw CorpusError("The program is not base64.");
    program = *std::move(bytes);
  } else {
    program = entry.at("program").get<std::string>();
  }
  if (opening.empty()) return program;
  return program.insert(std::min(program.find_first_of("\r\n"), program.size()),
                        " " + std::string(opening));
}

// Where its program needs others than its group states, the case is of a group beside it.
void take_features(Case& test) {
  std::vector<std::string> features =
      program::features_of_case({test.profile, test.program}, test.features);
  const auto lacks = [](const auto& list, const std::string& one) {
    return std::ranges::find(list, one) == list.end();
  };
  std::string beside;
  for (const std::string& one : features) {
    if (lacks(test.features, one)) beside += "-with-" + one;
  }
  for (const std::string& one : test.features) {
    if (lacks(features, one)) beside += "-without-" + one;
  }
  if (beside.empty()) return;
  test.group += beside;
  test.features = std::move(features);
}

RecipeCase case_of(const Json& entry, const Case& common, const std::string& opening) {
  RecipeCase recipe;
  recipe.test = common;
  Case& test = recipe.test;
  test.id = entry.at("id").get<std::string>();
  need_keys(entry, test.id,
            {"id", "comment", "program", "base64", "tway", "sign", "provenance", "readings",
             "alarm", "outside", "opening"});
  test.comment = entry.at("comment").get<std::string>();
  test.program = program_of(entry, entry.value("opening", opening));
  test.tags_tway = texts(entry, "tway");
  test.tags_sign = texts(entry, "sign");
  test.provenance = entry.value("provenance", "hand");
  const Json readings = entry.value("readings", Json::object());
  for (const auto& [name, values] : readings.items()) {
    recipe.readings.push_back({name, values.get<std::vector<std::string>>()});
  }
  take_features(test);
  recipe.alarms = texts(entry, "alarm");
  recipe.outside = entry.value("outside", false);
  return recipe;
}

// Every choice of the stated readings.
std::vector<std::vector<std::pair<std::string, std::string>>> choices_of(
    const std::vector<StatedReading>& readings) {
  std::vector<std::vector<std::pair<std::string, std::string>>> choices = {{}};
  for (const StatedReading& reading : readings) {
    decltype(choices) longer;
    for (const auto& choice : choices) {
      for (const std::string& value : reading.values) {
        longer.push_back(choice);
        longer.back().emplace_back(reading.name, value);
      }
    }
    choices = std::move(longer);
  }
  return choices;
}

Expectation expectation_under(const reference::Profile& profile, const std::string& program,
                              std::vector<std::pair<std::string, std::string>> choice) {
  reference::Profile chosen = profile;
  for (const auto& [name, value] : choice) {
    if (auto error = reference::set_reading(chosen, name, value)) throw CorpusError(error->message);
  }
  Expectation expectation = oracle::expectation_of(chosen, program);
  expectation.when = std::move(choice);
  return expectation;
}

std::string joined(const std::set<std::string>& texts) {
  std::string out;
  for (const std::string& text : texts) out += (out.empty() ? "" : ", ") + text;
  return out.empty() ? "none" : out;
}

// What the recipe says of the ending against what the reference says.
void check_ending(const RecipeCase& recipe, const Expectation& got) {
  std::set<std::string> alarms;
  for (const oracle::ExpectedAlarm& alarm : got.alarms) {
    alarms.insert(fmt::format("{}@{}", name(alarm.alarm), alarm.block));
  }
  const std::set<std::string> wanted(recipe.alarms.begin(), recipe.alarms.end());
  if (alarms != wanted) {
    throw CorpusError(fmt::format("{}: the recipe wants the alarms {}, the reference gives {}.",
                                  recipe.test.id, joined(wanted), joined(alarms)));
  }
  if (got.not_covered != recipe.outside) {
    throw CorpusError(fmt::format("{}: the recipe says outside = {}, the reference {}.",
                                  recipe.test.id, recipe.outside, got.not_covered));
  }
}

// No stated reading without an effect.
void check_effects(const RecipeCase& recipe, const std::vector<Expectation>& expectations) {
  for (const StatedReading& reading : recipe.readings) {
    bool matters = false;
    for (const Expectation& a : expectations) {
      for (const Expectation& b : expectations) {
        auto rest = [&](Expectation e) {
          std::erase_if(e.when, [&](const auto& entry) { return entry.first == reading.name; });
          return e.when;
        };
        if (rest(a) != rest(b)) continue;
        Expectation bare_a = a, bare_b = b;
        bare_a.when.clear();
        bare_b.when.clear();
        matters = matters || expectation_json(bare_a) != expectation_json(bare_b);
      }
    }
    if (!matters) {
      throw CorpusError(
          fmt::format("{}: the reading {} makes no difference.", recipe.test.id, reading.name));
    }
  }
}

}  // namespace

std::vector<RecipeCase> read_recipe(const std::string& path) {
  const Json document = document_of(path);
  try {
    need_keys(document, "The file", {"dialect", "cycle", "opening", "group"});
    const std::string opening = document.value("opening", "");
    std::vector<RecipeCase> cases;
    for (const Json& group : document.at("group")) {
      need_keys(group, "A group", {"gid", "features", "clauses", "profile", "case"});
      Case common;
      common.dialect = document.at("dialect").get<std::string>();
      common.cycle = document.at("cycle").get<std::string>();
      common.group = group.at("gid").get<std::string>();
      common.features = texts(group, "features");
      common.clauses = texts(group, "clauses");
      common.profile = profile_of(group, common.dialect);
      for (const Json& entry : group.at("case")) cases.push_back(case_of(entry, common, opening));
    }
    return cases;
  } catch (const Json::exception& error) {
    throw CorpusError(fmt::format("{}: {}", path, error.what()));
  } catch (const CorpusError& error) {
    throw CorpusError(fmt::format("{}: {}", path, error.what()));
  }
}

Case prepare(const RecipeCase& recipe) {
  Case test = recipe.test;
  check_ending(recipe, oracle::expectation_of(test.profile, test.program));
  for (auto& choice : choices_of(recipe.readings)) {
    test.expect.push_back(expectation_under(test.profile, test.program, std::move(choice)));
  }
  check_effects(recipe, test.expect);
  return test;
}

}  // namespace gonogo::recipes
