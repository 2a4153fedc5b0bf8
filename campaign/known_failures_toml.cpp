// SPDX-License-Identifier: GPL-3.0-or-later
//
// The TOML of known failures and alarm maps.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <set>
#include <utility>

#include "campaign/known_failures.hpp"
#include "oracle/records/record_fault.hpp"
#include "reference/outcome.hpp"
#include "reference/toml_text.hpp"

namespace gonogo::oracle {
namespace {

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

// A text, or a list of texts.
std::vector<std::string> texts_of(const toml::table& table, std::string_view key) {
  const toml::array* list = table[key].as_array();
  if (list == nullptr) return {text_of(table, key, true)};
  std::vector<std::string> texts;
  for (const toml::node& node : *list) {
    auto text = node.value_exact<std::string>();
    if (!text) fail(node, fmt::format("The list `{}` holds texts in quotes only.", key));
    texts.push_back(*std::move(text));
  }
  if (texts.empty()) fail(*list, fmt::format("The list `{}` is empty.", key));
  return texts;
}

// One that matches everything, which nobody has looked at.
bool is_of_wildcards(std::string_view glob) {
  return glob.find_first_not_of("*?") == std::string_view::npos;
}

// "k of n".
std::optional<Flaky> flaky_of(const toml::table& table) {
  const std::string text = text_of(table, "flaky", false);
  if (text.empty()) return std::nullopt;
  constexpr std::string_view kOf = " of ";
  Flaky flaky;
  const char* const end = text.data() + text.size();
  const auto failures = std::from_chars(text.data(), end, flaky.failures);
  const bool is_pair =
      failures.ec == std::errc() && std::string_view(failures.ptr, end).starts_with(kOf);
  const char* const runs_at = failures.ptr + kOf.size();
  const auto runs = is_pair ? std::from_chars(runs_at, end, flaky.runs) : failures;
  if (!is_pair || runs.ec != std::errc() || runs.ptr != end || flaky.failures < 1 ||
      flaky.runs <= flaky.failures || flaky.runs > kMostRunsOfAFlakyCase) {
    fail(table,
         fmt::format("`flaky = \"{}\"`: write \"1 of 5\", how many of how many runs may fail; "
                     "fewer than all, of at most {} runs.",
                     text, kMostRunsOfAFlakyCase));
  }
  return flaky;
}

// What a failure says besides its reason.
KnownCause::Failure failure_of(const toml::table& table) {
  KnownCause::Failure failure;
  failure.deviation = text_of(table, "deviation", false);
  failure.got = text_of(table, "got", false);
  failure.flaky = flaky_of(table);
  const std::string verdict = text_of(table, "verdict", true);
  const std::optional<VerdictKind> kind = verdict_kind(verdict);
  if (!kind || decision(*kind) != Decision::no_go) {
    fail(table, fmt::format("\"{}\" is no verdict of a failure.", verdict));
  }
  failure.verdict = *kind;
  failure.cases = texts_of(table, "cases");
  for (const std::string& glob : failure.cases) {
    if (is_of_wildcards(glob)) {
      fail(table, fmt::format("`cases = \"{}\"` covers everything. Name the cases.", glob));
    }
  }
  return failure;
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

KnownCause lone_failure_of(const toml::table& table) {
  refuse_other_keys(table, {"cases", "verdict", "deviation", "got", "flaky", "reason", "program"});
  return {text_of(table, "reason", true), text_of(table, "program", false), {failure_of(table)}};
}

KnownCause cause_of(const toml::table& table) {
  refuse_other_keys(table, {"reason", "program", "failure"});
  KnownCause cause{text_of(table, "reason", true), text_of(table, "program", false), {}};
  const toml::node* failures = table.get("failure");
  if (failures == nullptr) fail(table, "The cause has no [[cause.failure]].");
  each_table(*failures, "The failures of a cause are [[cause.failure]].",
             [&](const toml::table& failure) {
               refuse_other_keys(failure, {"cases", "verdict", "deviation", "got", "flaky"});
               cause.failures.push_back(failure_of(failure));
             });
  return cause;
}

template <typename Result, typename Read>
std::variant<Result, FileFault> read_toml(std::string_view text, Read read) {
  try {
    return read(reference::parse_toml(text));
  } catch (const FileFault& fault) {
    return fault;
  } catch (const toml::parse_error& error) {
    return FileFault{reference::toml_fault(text, error)};
  }
}

// A text as TOML: as it is where nothing of it has to be written otherwise.
std::string quoted(const std::string& text) {
  const auto is_plain = [](unsigned char c) { return c >= ' ' && c != 0x7F && c != '\''; };
  const bool has_quotes = text.find_first_of("\"\\") != std::string::npos;
  if (has_quotes && std::ranges::all_of(text, is_plain)) return "'" + text + "'";
  std::string basic = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      basic += '\\';
      basic += c;
    } else if (byte < ' ' || byte == 0x7F) {
      basic += fmt::format("\\u{:04X}", static_cast<unsigned>(byte));
    } else {
      basic += c;
    }
  }
  return basic + "\"";
}

std::string failure_text(const KnownCause::Failure& failure) {
  std::string text =
      fmt::format("[[cause.failure]]\nverdict = {}\n", quoted(std::string(name(failure.verdict))));
  if (!failure.deviation.empty())
    text += fmt::format("deviation = {}\n", quoted(failure.deviation));
  if (!failure.got.empty()) text += fmt::format("got = {}\n", quoted(failure.got));
  if (failure.flaky) {
    text += fmt::format("flaky = \"{} of {}\"\n", failure.flaky->failures, failure.flaky->runs);
  }
  constexpr std::size_t kWidth = 100;
  std::string line = "cases = [";
  for (std::size_t i = 0; i < failure.cases.size(); ++i) {
    const std::string next = quoted(failure.cases[i]) + (i + 1 < failure.cases.size() ? "," : "");
    if (failure.cases.size() > 1 && line.size() + 1 + next.size() > kWidth) {
      text += line + "\n";
      line = "   ";
    }
    line += (line.ends_with('[') ? "" : " ") + next;
  }
  return text + line + "]\n";
}

}  // namespace

std::variant<std::vector<KnownCause>, FileFault> known_causes_from_toml(std::string_view text) {
  return read_toml<std::vector<KnownCause>>(text, [](const toml::table& document) {
    constexpr std::string_view kSentence = "The file holds [[cause]] and [[failure]] entries only.";
    std::vector<KnownCause> causes;
    for (const auto& [key, value] : document) {
      const bool is_cause = key.str() == "cause";
      if (!is_cause && key.str() != "failure") fail(value, std::string(kSentence));
      each_table(value, kSentence, [&](const toml::table& table) {
        causes.push_back(is_cause ? cause_of(table) : lone_failure_of(table));
      });
    }
    return causes;
  });
}

std::variant<std::vector<KnownFailure>, FileFault> known_failures_from_toml(std::string_view text) {
  auto read = known_causes_from_toml(text);
  if (auto* fault = std::get_if<FileFault>(&read)) return std::move(*fault);
  return entries_of(std::get<std::vector<KnownCause>>(read));
}

std::vector<KnownFailure> entries_of(const std::vector<KnownCause>& causes) {
  std::vector<KnownFailure> entries;
  for (const KnownCause& cause : causes) {
    for (const KnownCause::Failure& failure : cause.failures) {
      for (const std::string& glob : failure.cases) {
        entries.push_back(
            {glob, failure.verdict, failure.deviation, failure.got, cause.reason, failure.flaky});
      }
    }
  }
  return entries;
}

std::string known_causes_text(const std::vector<KnownCause>& causes) {
  std::string text;
  for (const KnownCause& cause : causes) {
    text +=
        fmt::format("{}[[cause]]\nreason = {}\n", text.empty() ? "" : "\n", quoted(cause.reason));
    if (!cause.program.empty()) text += fmt::format("program = {}\n", quoted(cause.program));
    for (const KnownCause::Failure& failure : cause.failures) text += failure_text(failure);
  }
  return text;
}

namespace {

// One class or a list, between blanks.
std::string classes_of(const toml::table& table, std::string_view native, const toml::node& node) {
  const std::vector<std::string> classes = texts_of(table, native);
  for (const std::string& one : classes) {
    if (!reference::alarm_class(one)) fail(node, fmt::format("\"{}\" is no alarm class.", one));
  }
  if (std::ssize(classes) > kMostClasses) {
    fail(node, fmt::format("A text stands for {} classes at most.", kMostClasses));
  }
  return fmt::format("{}", fmt::join(classes, " "));
}

}  // namespace

std::variant<std::vector<AlarmMap::Entry>, FileFault> alarm_map_from_toml(std::string_view text) {
  return read_toml<std::vector<AlarmMap::Entry>>(text, [](const toml::table& document) {
    // A table is in the order of its keys, and the first line of the file counts.
    std::map<std::pair<std::size_t, std::size_t>, AlarmMap::Entry> by_place;
    for (const auto& [key, value] : document) {
      const toml::table* table = value.as_table();
      if (key.str() != "alarms" || table == nullptr) fail(value, "The file holds [alarms] only.");
      for (const auto& [native, node] : *table) {
        if (is_of_wildcards(native.str())) {
          fail(node, fmt::format("\"{}\" is every alarm. Name the texts.", native.str()));
        }
        const auto place = native.source().begin;
        by_place[{place.line, place.column}] = {std::string(native.str()),
                                                classes_of(*table, native.str(), node)};
      }
    }
    std::vector<AlarmMap::Entry> entries;
    for (auto& [place, entry] : by_place) entries.push_back(std::move(entry));
    return entries;
  });
}

}  // namespace gonogo::oracle
