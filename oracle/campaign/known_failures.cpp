// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/campaign/known_failures.hpp"

#include <fmt/format.h>
#include <fnmatch.h>
#include <toml++/toml.h>

#include <algorithm>
#include <set>

#include "reference/outcome.hpp"

namespace gonogo::oracle {
namespace {

// Most globs differ in what stands before their first wildcard.
bool matches(const std::string& glob, const std::string& text) {
  const std::size_t literal = glob.find_first_of("*?[\\");
  if (literal == std::string::npos) return glob == text;
  if (text.compare(0, literal, glob, 0, literal) != 0) return false;
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

void refuse_other_keys(const toml::table& table, const std::set<std::string_view>& keys) {
  for (const auto& [key, value] : table) {
    if (keys.contains(key.str())) continue;
    fail(value, fmt::format("There is no key `{}`. Write {}.", key.str(), fmt::join(keys, ", ")));
  }
}

// The globs of `cases`: a text, or a list of texts.
std::vector<std::string> globs_of(const toml::table& table) {
  const toml::array* list = table["cases"].as_array();
  if (list == nullptr) return {text_of(table, "cases", true)};
  std::vector<std::string> globs;
  for (const toml::node& node : *list) {
    auto text = node.value_exact<std::string>();
    if (!text) fail(node, "The list `cases` holds texts in quotes only.");
    globs.push_back(*std::move(text));
  }
  if (globs.empty()) fail(*list, "The list `cases` is empty.");
  return globs;
}

// What a failure says besides its reason, once for each of its globs.
void add_failures(const toml::table& table, const std::string& reason,
                  std::vector<KnownFailure>& entries) {
  KnownFailure entry;
  entry.deviation = text_of(table, "deviation", false);
  entry.got = text_of(table, "got", false);
  entry.reason = reason;
  const std::string verdict = text_of(table, "verdict", true);
  const std::optional<VerdictKind> kind = verdict_kind(verdict);
  if (!kind || decision(*kind) != Decision::no_go) {
    fail(table, fmt::format("\"{}\" is no verdict of a failure.", verdict));
  }
  entry.verdict = *kind;
  for (std::string& glob : globs_of(table)) {
    if (glob.find_first_not_of("*?") == std::string::npos) {
      fail(table, fmt::format("`cases = \"{}\"` covers everything. Name the cases.", glob));
    }
    entry.cases = std::move(glob);
    entries.push_back(entry);
  }
}

// The tables of a list of tables, each given to `take`.
template <typename Take>
void each_table(const toml::node& node, std::string_view sentence, Take take) {
  const toml::array* list = node.as_array();
  if (list == nullptr) fail(node, std::string(sentence));
  for (const toml::node& item : *list) {
    if (item.as_table() == nullptr) fail(item, std::string(sentence));
    take(*item.as_table());
  }
}

void add_lone_failure(const toml::table& table, std::vector<KnownFailure>& entries) {
  refuse_other_keys(table, {"cases", "verdict", "deviation", "got", "reason", "program"});
  text_of(table, "program", false);
  add_failures(table, text_of(table, "reason", true), entries);
}

void add_cause(const toml::table& cause, std::vector<KnownFailure>& entries) {
  refuse_other_keys(cause, {"reason", "program", "failure"});
  text_of(cause, "program", false);
  const std::string reason = text_of(cause, "reason", true);
  const toml::node* failures = cause.get("failure");
  if (failures == nullptr) fail(cause, "The cause has no [[cause.failure]].");
  each_table(*failures, "The failures of a cause are [[cause.failure]].",
             [&](const toml::table& failure) {
               refuse_other_keys(failure, {"cases", "verdict", "deviation", "got"});
               add_failures(failure, reason, entries);
             });
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

bool is_as_known(const Verdict& verdict, const KnownFailure& entry) {
  return verdict.kind == entry.verdict &&
         (entry.deviation.empty() || entry.deviation == verdict.deviation_exact) &&
         (entry.got.empty() || entry.got == verdict.got);
}

}  // namespace

std::variant<std::vector<KnownFailure>, FileFault> known_failures_from_toml(std::string_view text) {
  return read_toml<std::vector<KnownFailure>>(text, [](const toml::table& document) {
    constexpr std::string_view kSentence = "The file holds [[cause]] and [[failure]] entries only.";
    std::vector<KnownFailure> entries;
    for (const auto& [key, value] : document) {
      const bool is_cause = key.str() == "cause";
      if (!is_cause && key.str() != "failure") fail(value, std::string(kSentence));
      each_table(value, kSentence, [&](const toml::table& table) {
        is_cause ? add_cause(table, entries) : add_lone_failure(table, entries);
      });
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
    if (matches(entries_[i].cases, id)) ++cases_[i];
  }
}

void KnownFailures::apply(CaseResult& result) const {
  Verdict& verdict = result.verdict;
  const Decision answer = decision(verdict.kind);
  for (const KnownFailure& entry : entries_) {
    if (!matches(entry.cases, result.id)) continue;
    if (answer == Decision::undecided || answer == Decision::neither) return;
    if (answer == Decision::go) {
      verdict.kind = VerdictKind::xpass;
      verdict.message = fmt::format("Known to fail with {} ({}), but it passes.",
                                    name(entry.verdict), entry.reason);
      result.readings.reset();  // whatever reading explains it
      return;
    }
    if (!is_as_known(verdict, entry)) continue;
    verdict.message =
        fmt::format("Known: {} ({}: {})", entry.reason, name(verdict.kind), verdict.message);
    verdict.kind = VerdictKind::xfail;
    return;
  }
}

std::vector<std::string> KnownFailures::stale() const {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (cases_[i] == 0) {
      texts.push_back(fmt::format("known failure {}: no case has this id", entries_[i].cases));
    } else if (cases_[i] > kMostCasesOfAGlob) {
      texts.push_back(fmt::format("known failure {}: it covers {} cases, more than {}; list them",
                                  entries_[i].cases, cases_[i], kMostCasesOfAGlob));
    }
  }
  return texts;
}

const AlarmMap::Entry* AlarmMap::entry_for(const std::string& native) const {
  const auto found = std::ranges::find_if(
      entries_, [&](const Entry& entry) { return matches(entry.native, native); });
  return found == entries_.end() ? nullptr : &*found;
}

std::vector<std::string> AlarmMap::natives() const {
  std::vector<std::string> natives;
  for (const Entry& entry : entries_) natives.push_back(entry.native);
  return natives;
}

}  // namespace gonogo::oracle
