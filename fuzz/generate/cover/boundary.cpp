// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/generate/cover/boundary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "fuzz/generate/cover/length.hpp"
#include "grammar/line_source.hpp"
#include "reference/exact/number.hpp"
#include "reference/expander.hpp"

namespace gonogo::cover {
namespace {

using reference::AlarmReport;
using reference::Record;

constexpr std::size_t kMostItems = 300;

// What comes of a program, as far as predicates show in it.
struct Outcome {
  bool usable = false;
  std::vector<std::string> steps;  // kind and clause of each record
  std::set<std::string> alarms;    // "class clause"
  std::set<std::string> clauses;   // of the alarms
  friend bool operator==(const Outcome&, const Outcome&) = default;
};

Outcome outcome_of(const reference::Profile& profile, const std::string& program) {
  grammar::MemorySource bytes(program);
  grammar::LineSource lines(bytes);
  reference::Expander expander(profile, lines, reference::OpenPaths::shown);
  Outcome outcome;
  try {
    while (const reference::Item* item = expander.next()) {
      if (outcome.steps.size() > kMostItems) return {};
      if (auto* record = std::get_if<Record>(item)) {
        outcome.steps.push_back(
            fmt::format("{} {}", name(record->kind), reference::clause_name(record->clause)));
      } else if (auto* report = std::get_if<AlarmReport>(item)) {
        for (const reference::Alarm& alarm : report->alarms) {
          const std::string_view clause = reference::clause_name(alarm.clause);
          outcome.alarms.insert(fmt::format("{} {}", name(alarm.alarm), clause));
          outcome.clauses.emplace(clause);
        }
      } else if (std::holds_alternative<reference::NotCovered>(*item)) {
        return {};
      }
    }
  } catch (const exact::Undecided&) {
    return {};
  }
  outcome.usable = outcome.clauses.size() <= 1;
  return outcome;
}

// The program as a function of the word's value in least increments.
class Variation {
 public:
  Variation(const reference::Profile& profile, const std::string& program, const VariedWord& word,
            int decimals)
      : profile_(profile), program_(program), word_(word), decimals_(decimals) {}

  std::string program(std::int64_t value) const {
    std::string text = program_;
    text.replace(word_.begin, word_.length, Length{0, value}.text(decimals_));
    return text;
  }
  const Outcome& at(std::int64_t value) {
    auto [place, is_new] = known_.try_emplace(value);
    if (is_new) place->second = outcome_of(profile_, program(value));
    return place->second;
  }
  // The least increments of the number as it stands; nothing where it has more decimals.
  std::optional<std::int64_t> present() const {
    const std::string text = program_.substr(word_.begin, word_.length);
    const std::size_t point = std::min(text.find('.'), text.size());
    std::string digits = text.substr(0, point);
    std::string fraction = text.substr(std::min(point + 1, text.size()));
    const auto places = static_cast<std::size_t>(decimals_);
    if (fraction.size() > places || digits.size() + places > 12) return std::nullopt;
    fraction.resize(places, '0');
    return std::stoll(digits + fraction);
  }

 private:
  const reference::Profile& profile_;
  const std::string& program_;
  const VariedWord& word_;
  int decimals_;
  std::map<std::int64_t, Outcome> known_;
};

std::set<std::int64_t> tried_values(std::int64_t present) {
  const std::int64_t size = present < 0 ? -present : present;
  std::set<std::int64_t> values = {0};
  for (const std::int64_t value : {std::int64_t{1}, size / 2, size, size * 2, size * 10,
                                   std::int64_t{999'999'999}, std::int64_t{1'000'000'001}}) {
    values.insert({value, -value});
  }
  return values;
}

// The clause that one side breaks and the other does not, or where their records part.
std::string clause_between(const Outcome& below, const Outcome& above) {
  for (const auto& [one, other] : {std::pair{&below, &above}, {&above, &below}}) {
    for (const std::string& clause : one->clauses) {
      if (!other->clauses.contains(clause)) return clause;
    }
  }
  const auto parts = std::ranges::mismatch(below.steps, above.steps);
  const std::string& step = parts.in1 != below.steps.end()   ? *parts.in1
                            : parts.in2 != above.steps.end() ? *parts.in2
                                                             : below.steps.back();
  return step.substr(step.find(' ') + 1);
}

std::string summary(const Outcome& outcome) {
  std::set<std::string> parts(outcome.alarms);
  if (parts.empty()) parts.insert(outcome.steps.begin(), outcome.steps.end());
  std::string text;
  for (const std::string& part : parts) text += part + ", ";
  return text;
}

// How many zeros the value ends in: the predicate's own value is the rounder one of two.
int roundness(std::int64_t value) {
  if (value == 0) return 20;
  int zeros = 0;
  for (; value % 10 == 0; value /= 10) ++zeros;
  return zeros;
}

// The value that the predicate compares with, of two neighbours that differ.
std::int64_t value_on(Variation& variation, std::int64_t below, std::int64_t above) {
  if (variation.at(below - 1) != variation.at(below)) return below;
  if (variation.at(above + 1) != variation.at(above)) return above;
  return roundness(below) >= roundness(above) ? below : above;
}

std::optional<Triple> triple_between(Variation& variation, const VariedWord& word,
                                     std::int64_t below, std::int64_t above) {
  while (above - below > 1) {
    const std::int64_t middle = below + (above - below) / 2;
    (variation.at(middle) == variation.at(below) ? below : above) = middle;
  }
  const std::int64_t on = value_on(variation, below, above);
  Triple triple{word.address,
                clause_between(variation.at(below), variation.at(above)),
                summary(variation.at(below)) + " | " + summary(variation.at(above)),
                {}};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int64_t value = on + static_cast<std::int64_t>(i) - 1;
    if (!variation.at(value).usable) return std::nullopt;
    triple.programs[i] = variation.program(value);
  }
  return triple;
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return c >= 'A' && c <= 'Z';
}

}  // namespace

std::vector<VariedWord> varied_words(std::string_view program, std::size_t first,
                                     std::size_t last) {
  std::vector<VariedWord> words;
  std::size_t line = 1;
  for (std::size_t i = 0; i < program.size();) {
    if (program[i] == '\n') ++line;
    const bool begins = is_letter(program[i]) && (i == 0 || !is_letter(program[i - 1]));
    if (!begins || line < first || line > last) {
      ++i;
      continue;
    }
    // Letters; and before an '=', digits too.
    std::size_t end = i;
    while (end < program.size() && (is_letter(program[end]) || is_digit(program[end]))) ++end;
    if (end < program.size() && program[end] == '=') {
      ++end;
    } else {
      end = i + 1;
    }
    const std::string address(program.substr(i, end - i));
    std::size_t stop = end;
    if (stop < program.size() && program[stop] == '-') ++stop;
    while (stop < program.size() && (is_digit(program[stop]) || program[stop] == '.')) ++stop;
    const bool number = stop > end && is_digit(program[stop - 1]);
    if (number && std::string_view("GMNSTO").find(address) == std::string_view::npos) {
      words.push_back({address, line, end, stop - end});
    }
    i = std::max(stop, i + 1);
  }
  return words;
}

std::vector<Triple> boundary_triples(const reference::Profile& profile, const std::string& program,
                                     const VariedWord& word, int decimals) {
  Variation variation(profile, program, word, decimals);
  std::vector<Triple> triples;
  const std::optional<std::int64_t> present = variation.present();
  if (!present) return triples;
  const std::set<std::int64_t> values = tried_values(*present);
  for (auto above = std::next(values.begin()); above != values.end(); ++above) {
    const std::int64_t below = *std::prev(above);
    if (!variation.at(below).usable || !variation.at(*above).usable) continue;
    if (variation.at(below) == variation.at(*above)) continue;
    if (auto triple = triple_between(variation, word, below, *above)) {
      triples.push_back(*std::move(triple));
    }
  }
  return triples;
}

}  // namespace gonogo::cover
