// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/manual/page_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "publish/manual/example_run.hpp"
#include "publish/report/escape.hpp"

namespace gonogo::oracle::manual {
namespace {

using reference::Reading;

// Text inside a table or a line of Markdown.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '|' || c == '<' || c == '*' || c == '_' || c == '[' || c == ']') out += '\\';
    out += c;
  }
  return out;
}

std::string anchor(std::string_view id) {
  std::string out;
  for (const char c : id) out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

std::string clause_link(reference::ClauseId clause) {
  if (clause == reference::kNoClause) return {};
  const std::string_view id = reference::clause_name(clause);
  return fmt::format("[{}](#{})", id, anchor(id));
}

std::string capitalised(std::string_view text) {
  std::string out(text);
  if (!out.empty()) out[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(out[0])));
  return out;
}

// Puts a drawing beside the page and a reference to it into the text; nothing where nothing moves.
void append_figure(PageDraft& page, std::string_view key, const report::Figure& figure) {
  std::string svg = report::svg_figure(figure);
  if (svg.empty()) return;
  std::string name;
  for (const char c : key) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-';
    name += plain ? c : '-';
  }
  const std::string file = fmt::format("{}/{}.svg", page.dialect, name);
  page.text += fmt::format("![{}]({})\n\n", figure.title, file);
  page.drawings.push_back({file, std::move(svg)});
}

// The program in the playground, as playground/page/playground.js reads it.
std::string playground_link(std::string_view dialect, std::string_view program,
                            std::string_view profile) {
  std::string link =
      fmt::format("[try it](../../build/playground/page/index.html#dialect={}&program={}", dialect,
                  report::address_text(program));
  if (!profile.empty()) link += "&profile=" + report::address_text(profile);
  return link + ")";
}

void append_program(PageDraft& page, std::string_view program, std::string_view profile) {
  page.text += fmt::format("```\n{}```\n\n", program);
  if (!profile.empty()) {
    page.text += fmt::format("with the profile\n\n```toml\n{}```\n\n", profile);
  }
  page.text += playground_link(page.dialect, program, profile) + "\n\n";
}

void append_motions(PageDraft& page, const ExampleRun& trial) {
  const std::vector<std::size_t> numbers = report::motion_numbers(trial.path);
  constexpr std::size_t kMost = 40;
  page.text += "| | line | what happens | clause |\n|---|---|---|---|\n";
  for (std::size_t i = 0; i < trial.steps.size() && i < kMost; ++i) {
    const ExampleStep& step = trial.steps[i];
    page.text += fmt::format(
        "| {} | {} | {} | {} |\n", numbers[i] > 0 ? fmt::format("**{}**", numbers[i]) : "",
        step.block > 0 ? std::to_string(step.block) : "", step.text, clause_link(step.clause));
  }
  if (trial.steps.size() > kMost) {
    page.text += fmt::format("| | | and {} more | |\n", trial.steps.size() - kMost);
  }
  page.text += '\n';
}

// What a trial comes to, in a few words.
std::string summary(const ExampleRun& trial) {
  const auto moving = std::ranges::count_if(trial.steps, &ExampleStep::moves);
  const std::string motions =
      moving == 0 ? "nothing moves" : fmt::format("{} motion{}", moving, moving > 1 ? "s" : "");
  if (trial.steps.empty()) return motions;
  const ExampleStep& last = trial.steps.back();
  if (last.block > 0 && trial.alarm) {
    return fmt::format("{}, then {} in line {}", motions, last.text, last.block);
  }
  return fmt::format("{}, {}", motions, last.text);
}

// Where a trial first departs from another.
std::string departure(const ExampleRun& base, const ExampleRun& other) {
  for (std::size_t i = 0; i < std::max(base.steps.size(), other.steps.size()); ++i) {
    const ExampleStep* before = i < base.steps.size() ? &base.steps[i] : nullptr;
    const ExampleStep* after = i < other.steps.size() ? &other.steps[i] : nullptr;
    if (before != nullptr && after != nullptr && before->text == after->text &&
        before->block == after->block) {
      continue;
    }
    std::string text;
    if (after != nullptr && after->block > 0) text = fmt::format("line {}: ", after->block);
    text += after != nullptr ? after->text : "no more motion";
    if (before != nullptr) text += ", instead of " + before->text;
    return text;
  }
  return "the same motions";
}

// First the default, or where that is `any` the value that `expand` shows.
std::vector<std::string> values_of(const Reading& reading, const ReadingExample& example) {
  std::vector<std::string> values = {
      std::string(reading.fallback == "any" ? reading.alternatives.front() : reading.fallback)};
  for (const std::string_view value : reading.alternatives) {
    if (value != values.front()) values.emplace_back(value);
  }
  values.insert(values.end(), example.values.begin(), example.values.end());
  return values;
}

// The line below a reading's text: clause, default, the other values, what `any` means.
std::string choices(const Reading& reading) {
  std::string text =
      fmt::format("Clause {}. Default `{}`", clause_link(reading.clause), reading.fallback);
  if (reading.is_length) return text + "; a length in mm may be given instead.";
  std::string others;
  for (const std::string_view value : reading.alternatives) {
    if (value != reading.fallback)
      others += fmt::format("{}`{}`", others.empty() ? "" : ", ", value);
  }
  text += fmt::format("; else {}. ", others);
  return text + (reading.by_properties
                     ? "With `any` every path that keeps the limits is admissible."
                     : "With `any` each of them is admissible, one for a whole program.");
}

// Lines as code inside a table.
std::string code_lines(std::string_view text) {
  std::string out;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    out += fmt::format("{}`{}`", out.empty() ? "" : "<br>", text.substr(from, end - from));
    from = end + 1;
  }
  return out;
}

}  // namespace

void append_clauses(PageDraft& page, std::span<const reference::Clause* const> clauses) {
  page.text += "| clause | level | basis | what it says | carried by |\n|---|---|---|---|---|\n";
  for (const reference::Clause* clause : clauses) {
    std::string text = escaped(clause->text);
    if (!clause->derivation.empty()) text += "<br>Derived: " + escaped(clause->derivation);
    const std::string answer = reference::other_answer(*clause);
    if (!answer.empty()) text += "<br>Advice: " + answer;
    page.text +=
        fmt::format("| <a id=\"{}\"></a>{} | {} | {} | {} | [{}](../../{}) |\n", anchor(clause->id),
                    clause->id, reference::name(clause->level), reference::name(clause->basis()),
                    text, clause->carrier.substr(clause->carrier.rfind('/') + 1), clause->carrier);
  }
  page.text += '\n';
}

void append_example(PageDraft& page, const Example& example) {
  const ExampleRun trial =
      try_program(example_profile(page.dialect, example.profile), example.program);
  page.text += fmt::format("### {}\n\n", example.title);
  append_program(page, example.program, example.profile);
  report::Figure figure;
  figure.title = example.title;
  figure.lathe = page.lathe;
  figure.path = &trial.path;
  figure.limits = trial.limits;
  append_figure(page, example.key, figure);
  if (!trial.limits.empty()) {
    page.text +=
        "The manual leaves part of this path open. The green lines are what it fixes; the path is "
        "one that keeps them.\n\n";
  }
  append_motions(page, trial);
}

void append_reading(PageDraft& page, const Reading& reading, const ReadingExample& example) {
  page.text += fmt::format("<a id=\"{0}\"></a>\n#### {0}\n\n{1}. {2}\n\n", reading.name,
                           escaped(capitalised(reading.text)), choices(reading));
  append_program(page, example.program, example.profile);
  const std::vector<std::string> values = values_of(reading, example);
  std::vector<ExampleRun> trials;
  for (const std::string& value : values) {
    reference::Profile profile = example_profile(page.dialect, example.profile);
    choose(profile, reading.name, value);
    trials.push_back(try_program(profile, example.program));
  }
  reference::Profile open = example_profile(page.dialect, example.profile);
  if (reading.by_properties) choose(open, reading.name, "any");
  const std::vector<report::Limit> limits = try_program(open, example.program).limits;
  page.text += "| value | what happens |\n|---|---|\n";
  for (std::size_t i = 0; i < values.size(); ++i) {
    page.text += fmt::format(
        "| `{}`{} | {} |\n", values[i], values[i] == reading.fallback ? " (default)" : "",
        i == 0 ? summary(trials[i])
               : departure(trials.front(), trials[i]) + "; " + summary(trials[i]));
  }
  page.text += '\n';
  report::Figure figure;
  figure.lathe = page.lathe;
  figure.path = &trials.front().path;
  figure.limits = limits;
  figure.path_name = fmt::format("{} = {}", reading.name, values.front());
  figure.title = figure.path_name;
  if (values.size() == 1) append_figure(page, reading.name, figure);
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (draw_the_same(trials.front().path, trials[i].path)) continue;
    figure.other = &trials[i].path;
    figure.other_name = values[i];
    figure.title = fmt::format("{} and {}", figure.path_name, values[i]);
    append_figure(page, fmt::format("{}.{}", reading.name, values[i]), figure);
  }
}

void append_alarms(PageDraft& page, const std::vector<const AlarmExample*>& alarms) {
  if (alarms.empty()) return;
  page.text += "### Alarms\n\n| alarm | program | what is wrong | clause |\n|---|---|---|---|\n";
  for (const AlarmExample* example : alarms) {
    const ExampleRun trial =
        try_program(example_profile(page.dialect, example->profile), example->program);
    const std::string program = code_lines(example->program);
    std::string what = "no alarm";
    reference::ClauseId clause = reference::kNoClause;
    if (trial.alarm) {
      const reference::Alarm& alarm = trial.alarm->alarms.front();
      what = fmt::format("line {}: {}", trial.alarm->block, escaped(alarm.message));
      clause = alarm.clause;
    }
    if (!example->profile.empty()) what += "<br>With the profile " + code_lines(example->profile);
    page.text += fmt::format("| `{}` | {}<br>{} | {} | {} |\n", example->alarm, program,
                             playground_link(page.dialect, example->program, example->profile),
                             what, clause_link(clause));
  }
  page.text += '\n';
}

void append_codes(PageDraft& page, const reference::Dialect& dialect) {
  page.text +=
      "<a id=\"codes\"></a>\n## Codes and words\n\nThe codes that the gauge reads and the words "
      "that each takes. A modal word stays in force; any other one holds for its block. Beside "
      "them stand";
  for (const reference::CodeWord& word : dialect.descriptor->everywhere) {
    page.text +=
        fmt::format("{} {} ({})", &word == dialect.descriptor->everywhere.data() ? "" : ",",
                    escaped(word.address), word.title);
  }
  page.text += ".\n\n| code | what it is | feature | words | clause |\n|---|---|---|---|---|\n";
  for (const reference::Code& code : dialect.descriptor->codes) {
    if (code.treatment != reference::Treatment::read || code.is_m()) continue;
    page.text += fmt::format("| {} | {} | {} | {} | {} |\n", code.text(), code.title, code.feature,
                             escaped(reference::words_text(code)), clause_link(code.clause));
  }
  page.text += '\n';
}

void append_outside(PageDraft& page, const reference::Dialect& dialect) {
  page.text +=
      "<a id=\"outside\"></a>\n## Not covered\n\nCodes that the control has and the gauge does not "
      "read. A program is judged up to the first of them, and then counts as not covered.\n\n"
      "| code | what it is |\n|---|---|\n";
  for (const reference::OutsideCode& code : reference::outside_codes(*dialect.descriptor)) {
    page.text += fmt::format("| {} | {} |\n", code.code, escaped(code.title));
  }
  page.text += fmt::format("\nAlso: {}.\n\n## Ignored\n\nCodes without effect on the path:",
                           escaped(dialect.outside_constructs));
  for (const std::string& code : reference::codes_without_effect(*dialect.descriptor))
    page.text += fmt::format(" {}", code);
  page.text += ".\n";
  const std::vector<reference::PassedWords> rules = reference::passed_words(*dialect.descriptor);
  if (rules.empty()) return;
  page.text +=
      "\nWords beside codes that do not use them. Every other word is used, breaks a rule, or ends "
      "the program as not covered.\n\n| beside | words | rule | clause |\n|---|---|---|---|\n";
  for (const reference::PassedWords& rule : rules) {
    page.text += fmt::format("| {} | {} | {} | {} |\n", rule.codes, escaped(rule.words),
                             escaped(rule.why), clause_link(rule.clause));
  }
}

}  // namespace gonogo::oracle::manual
