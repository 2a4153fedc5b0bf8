// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/campaign/known_failures.hpp"

#include <fmt/format.h>
#include <fnmatch.h>
#include <toml++/toml.h>

#include "reference/outcome.hpp"

namespace gonogo::oracle {
namespace {

bool matches(const std::string& glob, const std::string& text) {
  return ::fnmatch(glob.c_str(), text.c_str(), 0) == 0;
}

// Thrown inside this file only.
[[noreturn]] void fail(const toml::node& at, std::string message) {
  throw FileFault{fmt::format("line {}: {}", at.source().begin.line, message)};
}

std::string text_of(const toml::table& table, std::string_view key, bool needed) {
  const toml::node* node = table.get(key);
  if (node == nullptr) {
    if (needed) fail(table, fmt::format("The entry lacks `{}`.", key));
    return {};
  }
  if (auto text = node->value_exact<std::string>()) return *text;
  fail(*node, fmt::format("The value of `{}` must be a text in quotes.", key));
}

KnownFailure entry_of(const toml::table& table) {
  for (const auto& [key, value] : table) {
    const std::string_view name = key.str();
    if (name != "cases" && name != "verdict" && name != "deviation" && name != "reason") {
      fail(value,
           fmt::format("There is no key `{}`. Write cases, verdict, deviation or reason.", name));
    }
  }
  KnownFailure entry;
  entry.cases = text_of(table, "cases", true);
  entry.deviation = text_of(table, "deviation", false);
  entry.reason = text_of(table, "reason", true);
  const std::string verdict = text_of(table, "verdict", true);
  const std::optional<VerdictKind> kind = verdict_kind(verdict);
  if (!kind || decision(*kind) != Decision::no_go) {
    fail(table, fmt::format("\"{}\" is no verdict of a failure.", verdict));
  }
  entry.verdict = *kind;
  return entry;
}

template <typename Result, typename Read>
std::variant<Result, FileFault> read_toml(std::string_view text, Read read) {
  try {
    return read(toml::parse(text));
  } catch (const FileFault& fault) {
    return fault;
  } catch (const toml::parse_error& error) {
    return FileFault{fmt::format("line {}: {}", error.source().begin.line, error.description())};
  }
}

}  // namespace

std::variant<std::vector<KnownFailure>, FileFault> known_failures_from_toml(std::string_view text) {
  return read_toml<std::vector<KnownFailure>>(text, [](const toml::table& document) {
    std::vector<KnownFailure> entries;
    for (const auto& [key, value] : document) {
      const toml::array* list = value.as_array();
      if (key.str() != "failure" || list == nullptr) {
        fail(value, "The file holds [[failure]] entries only.");
      }
      for (const toml::node& node : *list) {
        if (node.as_table() == nullptr) fail(node, "The file holds [[failure]] entries only.");
        entries.push_back(entry_of(*node.as_table()));
      }
    }
    return entries;
  });
}

std::variant<std::vector<AlarmMap::Entry>, FileFault> alarm_map_from_toml(std::string_view text) {
  return read_toml<std::vector<AlarmMap::Entry>>(text, [](const toml::table& document) {
    std::vector<AlarmMap::Entry> entries;
    for (const auto& [key, value] : document) {
      const toml::table* table = value.as_table();
      if (key.str() != "alarms" || table == nullptr) fail(value, "The file holds [alarms] only.");
      for (const auto& [native, node] : *table) {
        const std::string alarm_class = text_of(*table, native.str(), true);
        if (!reference::alarm_class(alarm_class)) {
          fail(node, fmt::format("\"{}\" is no alarm class.", alarm_class));
        }
        entries.push_back({std::string(native.str()), alarm_class});
      }
    }
    return entries;
  });
}

void KnownFailures::note_case(const std::string& id) {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (matches(entries_[i].cases, id)) has_case_[i] = true;
  }
}

void KnownFailures::apply(CaseResult& result) const {
  Verdict& verdict = result.verdict;
  const Decision answer = decision(verdict.kind);
  for (const KnownFailure& entry : entries_) {
    if (!matches(entry.cases, result.id)) continue;
    if (answer == Decision::undecided || verdict.kind == VerdictKind::skip) return;
    if (answer == Decision::go) {
      verdict.kind = VerdictKind::xpass;
      verdict.message = fmt::format("Known to fail with {} ({}), but it passes.",
                                    name(entry.verdict), entry.reason);
      return;
    }
    const bool same_deviation =
        entry.deviation.empty() || entry.deviation == verdict.deviation_exact;
    if (verdict.kind != entry.verdict || !same_deviation) continue;
    verdict.message =
        fmt::format("Known: {} ({}: {})", entry.reason, name(verdict.kind), verdict.message);
    verdict.kind = VerdictKind::xfail;
    return;
  }
}

std::vector<std::string> KnownFailures::of_no_case() const {
  std::vector<std::string> globs;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (!has_case_[i]) globs.push_back(entries_[i].cases);
  }
  return globs;
}

std::optional<std::string_view> AlarmMap::class_of(const std::string& native) const {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (!matches(entries_[i].native, native)) continue;
    used_[i] = true;
    return entries_[i].alarm_class;
  }
  return std::nullopt;
}

std::vector<std::string> AlarmMap::unused() const {
  std::vector<std::string> natives;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (!used_[i]) natives.push_back(entries_[i].native);
  }
  return natives;
}

}  // namespace gonogo::oracle
