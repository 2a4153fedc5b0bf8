// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/recipes/cover_recipe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "fuzz/generate/cover/cases.hpp"
#include "corpus/io/toml_file.hpp"

namespace gonogo::recipes {

using cover::CoverCases;
using cover::Making;
using oracle::Case;
using oracle::CorpusError;

namespace {

std::int64_t number(const toml::table& cover, const std::string& path, std::string_view key) {
  const std::optional<std::int64_t> value = cover[key].value<std::int64_t>();
  if (!value || *value < 1) {
    throw CorpusError(fmt::format("{}: the key {} must be a number from 1 on.", path, key));
  }
  return *value;
}

Making making_of(const toml::table& cover, const std::string& path) {
  constexpr std::array<std::string_view, 7> kKeys = {
      "model", "version", "strength", "fault_strength", "seed", "signs", "left_out"};
  for (const auto& [key, value] : cover) {
    if (std::ranges::find(kKeys, key.str()) == kKeys.end()) {
      throw CorpusError(fmt::format("{}: there is no key {} in a cover.", path, key.str()));
    }
  }
  Making making;
  const std::string name = cover["model"].value_or<std::string>("");
  making.model = cover::find_model(name);
  if (making.model == nullptr) throw CorpusError(fmt::format("{}: no model {}.", path, name));
  if (number(cover, path, "version") != making.model->version) {
    throw CorpusError(fmt::format(
        "{}: the model {} is at version {}. Retire the cases of the version before, and "
        "name the new one.",
        path, name, making.model->version));
  }
  making.strength.valid = static_cast<unsigned>(number(cover, path, "strength"));
  making.strength.faulty = static_cast<unsigned>(number(cover, path, "fault_strength"));
  making.seed = static_cast<std::uint64_t>(number(cover, path, "seed"));
  making.signs = static_cast<std::size_t>(cover["signs"].value_or<std::int64_t>(0));
  if (const toml::array* left_out = cover["left_out"].as_array()) {
    for (const toml::node& id : *left_out) making.left_out.insert(id.value_or<std::string>(""));
  }
  return making;
}

}  // namespace

bool is_cover_recipe(const std::string& path) {
  return oracle::read_toml_file(path).contains("cover");
}

std::vector<Case> cover_recipe_cases(const std::string& path) {
  const toml::table document = oracle::read_toml_file(path);
  const toml::table* cover = document["cover"].as_table();
  if (cover == nullptr || document.size() != 1) {
    throw CorpusError(fmt::format("{}: a recipe of a covering array has one table, cover.", path));
  }
  try {
    const Making making = making_of(*cover, path);
    CoverCases made = cover::cover_cases(making);
    if (!made.disagreements.empty()) {
      throw CorpusError(fmt::format("{}: {} cases; the first: {}", path, made.disagreements.size(),
                                    made.disagreements.front()));
    }
    if (making.left_out.empty() && !made.count.complete()) {
      throw CorpusError(fmt::format("{}: {} tuples are not covered.", path,
                                    made.count.allowed - made.count.covered));
    }
    return std::move(made.cases);
  } catch (const cover::ModelError& error) {
    throw CorpusError(fmt::format("{}: {}", path, error.what()));
  }
}

}  // namespace gonogo::recipes
