// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/io/recheck.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gonogo::oracle {
namespace {

std::string text_of(const reference::Record& record) {
  std::string text;
  append_json(record, text);
  return text;
}

// What the first record that differs is on both sides; past the last one: "nothing".
std::string difference(const Expectation& expected, const Expectation& now) {
  const std::size_t most = std::max(expected.records.size(), now.records.size());
  const auto at = [](const Expectation& side, std::size_t i) {
    return i < side.records.size() ? text_of(side.records[i]) : std::string("nothing");
  };
  for (std::size_t i = 0; i < most; ++i) {
    if (at(expected, i) == at(now, i)) continue;
    return fmt::format("record {} is {}, and the vector has {}", i, at(now, i), at(expected, i));
  }
  return fmt::format("its records are the same, the rest is not: {}", expectation_json(now));
}

}  // namespace

std::optional<std::string> recheck(const Case& test) {
  for (const Expectation& expected : test.expect) {
    reference::Profile profile = test.profile;
    for (const auto& [reading, value] : expected.when) {
      if (auto error = reference::set_reading(profile, reading, value)) return error->message;
    }
    Expectation now = expectation_of(profile, test.program);
    now.when = expected.when;
    if (expected.open.empty()) now.open.clear();  // format 1 has none
    if (expectation_json(now) != expectation_json(expected)) {
      return "The reference says otherwise: " + difference(expected, now) + ".";
    }
  }
  return std::nullopt;
}

std::size_t recheck_file(const std::string& path) {
  const std::vector<Case> cases = read_vector_file(path);
  for (const Case& test : cases) {
    if (auto fault = recheck(test)) {
      throw CorpusError(fmt::format("{}: {}: {}", path, test.id, *fault));
    }
  }
  return cases.size();
}

}  // namespace gonogo::oracle
