// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/manual/examples.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <stdexcept>

#include "publish/example_texts.hpp"

namespace gonogo::oracle::manual {
namespace {

// Which files a dialect has, and on whose page their drawings stand.
struct Share {
  std::string_view dialect;
  std::string_view file;
  std::string_view page;
};
constexpr auto kShares = std::to_array<Share>({
    {"gsk988ta", "gsk988ta", "gsk988ta"},
    {"hnc21t", "hnc21t", "hnc21t"},
    {"rs274", "rs274", "rs274"},
    {"sinumerik840d", "sinumerik", "sinumerik840d"},
    {"sinumerik802s", "sinumerik", "sinumerik840d"},
    {"sinumerik802s", "sinumerik802s", "sinumerik802s"},
});

std::string text_of(const toml::table& entry, std::string_view key) {
  return entry[key].value_or(std::string());
}

// Calls `take` with each entry of an array of tables.
template <typename Take>
void for_each_entry(const toml::table& file, std::string_view key, Take take) {
  const toml::array* entries = file[key].as_array();
  if (entries == nullptr) return;
  for (const toml::node& entry : *entries) take(*entry.as_table());
}

Examples read(std::string_view text, std::string_view page) {
  const toml::table file = toml::parse(text);
  Examples all{page, {}, {}, {}};
  for_each_entry(file, "example", [&](const toml::table& entry) {
    all.examples.push_back({text_of(entry, "section"), text_of(entry, "key"),
                            text_of(entry, "title"), text_of(entry, "program"),
                            text_of(entry, "profile")});
  });
  for_each_entry(file, "reading", [&](const toml::table& entry) {
    ReadingExample& example = all.readings.emplace_back(ReadingExample{
        text_of(entry, "name"), text_of(entry, "program"), text_of(entry, "profile"), {}});
    if (const toml::array* values = entry["values"].as_array()) {
      for (const toml::node& value : *values) {
        example.values.push_back(value.value_or(std::string()));
      }
    }
  });
  for_each_entry(file, "alarm", [&](const toml::table& entry) {
    all.alarms.push_back({text_of(entry, "clause"), text_of(entry, "class"),
                          text_of(entry, "program"), text_of(entry, "profile")});
  });
  return all;
}

}  // namespace

std::vector<Examples> examples_of(std::string_view dialect) {
  std::vector<Examples> all;
  for (const Share& share : kShares) {
    if (share.dialect != dialect) continue;
    const auto text = std::ranges::find(kExampleTexts, share.file, &ExampleText::name);
    if (text == kExampleTexts.end()) throw std::logic_error("an example file is missing");
    all.push_back(read(text->text, share.page));
  }
  return all;
}

}  // namespace gonogo::oracle::manual
