// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo spec: the clauses and readings of a dialect, and what lies outside; as text, or as a page
// with drawings.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "cli/program_file.hpp"
#include "oracle/records/features.hpp"
#include "oracle/records/output_file.hpp"
#include "publish/manual/examples.hpp"
#include "publish/manual/page.hpp"
#include "reference/dialect.hpp"
#include "reference/editions.hpp"
#include "reference/power_on.hpp"
#include "reference/reading.hpp"

namespace gonogo::cli {
namespace {

struct SpecOptions {
  std::string dialect;
  std::string about;
  bool features = false;
  bool alarms = false;
  std::string format = "text";
  std::string out;
};

// Whether a name is the word or has it among its parts, in letters of either case: GSK-G94-02 and
// gsk.g94.in-mode have g94. Without a word every name does.
bool concerns(std::string_view name, std::string_view word) {
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) ==
           std::tolower(static_cast<unsigned char>(b));
  };
  if (word.empty() || std::ranges::equal(name, word, same)) return true;
  while (!name.empty()) {
    const std::size_t end = std::min(name.find_first_of("-."), name.size());
    if (std::ranges::equal(name.substr(0, end), word, same)) return true;
    name.remove_prefix(std::min(end + 1, name.size()));
  }
  return false;
}

// G28 as the word G28, g28 or G028.
std::string plain_code(std::string_view word) {
  std::string code(1, static_cast<char>(std::toupper(static_cast<unsigned char>(word.front()))));
  word.remove_prefix(1);
  while (word.size() > 1 && word.front() == '0' && word[1] != '.') word.remove_prefix(1);
  return code.append(word);
}

bool is_code(std::string_view code, std::string_view about) {
  return !about.empty() && plain_code(code) == plain_code(about);
}

bool concerns(const reference::Code& code, std::string_view about) {
  return concerns(code.name, about) || concerns(code.feature, about) || is_code(code.text(), about);
}

// Whether a sentence names a code, and not only the beginning of a longer one.
bool names_code(std::string_view text, std::string_view code) {
  const auto goes_on = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
  for (std::size_t at = text.find(code); at != std::string_view::npos;
       at = text.find(code, at + 1)) {
    const std::size_t end = at + code.size();
    if ((at == 0 || !goes_on(text[at - 1])) && (end == text.size() || !goes_on(text[end]))) {
      return true;
    }
  }
  return false;
}

// Also a clause that a code asked for stands on, or that names it.
bool concerns(const reference::Dialect& dialect, const reference::Clause& clause,
              std::string_view about) {
  if (concerns(clause.id, about)) return true;
  return std::ranges::any_of(dialect.descriptor->codes, [&](const reference::Code& code) {
    if (code.is_m() || !is_code(code.text(), about)) return false;
    return reference::clause_name(code.clause) == clause.id || names_code(clause.text, code.text());
  });
}

void append_features(std::string& out) {
  for (const oracle::Feature& feature : oracle::feature_vocabulary()) {
    out += fmt::format("{:<12} {:<10} {}\n", feature.dialect, feature.name, feature.text);
  }
}

// The first example of an alarm class, as "dialect: program"; empty: there is none.
std::string example_of(std::string_view alarm) {
  for (const reference::Dialect& dialect : reference::dialects()) {
    for (const oracle::manual::Examples& part : oracle::manual::examples_of(dialect.name)) {
      for (const oracle::manual::AlarmExample& example : part.alarms) {
        if (example.alarm != alarm) continue;
        std::string text = fmt::format("{:8}{}, {}:\n", "", dialect.name, example.clause);
        for (std::size_t from = 0; from < example.program.size();) {
          const std::size_t end =
              std::min(example.program.find('\n', from), example.program.size());
          text += fmt::format("{:12}{}\n", "", example.program.substr(from, end - from));
          from = end + 1;
        }
        return text;
      }
    }
  }
  return {};
}

// Every class with what it means and a program that raises it.
void append_alarm_classes(std::string& out) {
#define GONOGO_ALARM(name, text, sentence) \
  out += fmt::format("{}\n    {}\n{}", text, sentence, example_of(text));
#include "reference/alarm_classes.def"
}

// Below the document and section where each stands: level, basis and text.
void append_clauses(const reference::Dialect& dialect, std::string_view about, std::string& out) {
  std::string_view source;
  for (const reference::Clause& clause : dialect.clauses) {
    if (!concerns(dialect, clause, about)) continue;
    if (clause.source != source) {
      source = clause.source;
      out += fmt::format("\n{}\n", source);
    }
    out += fmt::format("  {:<12} {:<8} {:<8} {}\n", clause.id, reference::name(clause.level),
                       reference::name(clause.basis()), clause.text);
    if (!clause.derivation.empty()) {
      out += fmt::format("{:34}derived: {}\n", "", clause.derivation);
    }
    const std::string answer = reference::other_answer(clause);
    if (!answer.empty()) out += fmt::format("{:34}advice: {}\n", "", answer);
    out += fmt::format("{:34}carried by {}\n", "", clause.carrier);
  }
}

// Has its heading only where something stands in it.
class Section {
 public:
  Section(std::string_view heading, std::string& out) : heading_(heading), out_(out) {}
  void add(std::string_view text) {
    if (!std::exchange(is_begun_, true)) out_ += fmt::format("\n{}\n", heading_);
    out_ += text;
  }

 private:
  std::string_view heading_;
  std::string& out_;
  bool is_begun_ = false;
};

void append_readings(std::string_view dialect, std::string_view about, std::string& out) {
  Section section("Readings (default first)", out);
  for (const reference::Reading& reading : reference::readings()) {
    if (!reading.belongs_to(dialect)) continue;
    const bool is_asked =
        concerns(reading.name, about) || concerns(reference::clause_name(reading.clause), about);
    if (!is_asked) continue;
    std::string choices(reading.fallback);
    for (std::string_view alternative : reading.alternatives) {
      if (alternative != reading.fallback) choices += fmt::format(" | {}", alternative);
    }
    if (reading.is_length) choices += " | a length in mm";
    if (reading.fallback != "any" && !reading.is_length) choices += " | any";
    section.add(fmt::format("  {} = {}\n{:8}{} ({})\n", reading.name, choices, "", reading.text,
                            reference::clause_name(reading.clause)));
  }
}

void append_codes(const reference::Dialect& dialect, std::string_view about, std::string& out) {
  Section section("Codes that are read, and their words (modal: they stay in force)", out);
  for (const reference::Code& code : dialect.descriptor->codes) {
    if (code.treatment != reference::Treatment::read || code.is_m()) continue;
    if (!concerns(code, about)) continue;
    std::string line = fmt::format("  {:<6} {} [{}]", code.text(), code.title, code.feature);
    if (code.clause != reference::kNoClause) {
      line += fmt::format(" ({})", reference::clause_name(code.clause));
    }
    line += '\n';
    const std::string words = reference::words_text(code);
    if (!words.empty()) line += fmt::format("{:9}{}\n", "", words);
    section.add(line);
  }
}

void append_outside(const reference::Dialect& dialect, std::string_view about, std::string& out) {
  std::string codes;
  for (const reference::OutsideCode& code : reference::outside_codes(*dialect.descriptor)) {
    if (!about.empty() && !is_code(code.code, about)) continue;
    codes += fmt::format("  {:<6} {}\n", code.code, code.title);
  }
  const std::string heading =
      "\nOutside: codes of the control that the gauge does not read (not-covered)\n";
  if (!about.empty()) {
    if (!codes.empty()) out += heading + codes;
    return;
  }
  out += fmt::format("{}{}  {}\n", heading, codes, dialect.outside_constructs);
  out += "\nIgnored: codes without effect on the path\n ";
  for (const std::string& code : reference::codes_without_effect(*dialect.descriptor)) {
    out += fmt::format(" {}", code);
  }
  out += '\n';
  const std::vector<reference::PassedWords> rules = reference::passed_words(*dialect.descriptor);
  if (rules.empty()) return;
  out += "\nIgnored: words beside codes that do not use them\n";
  for (const reference::PassedWords& rule : rules) {
    out += fmt::format("  {}: {}\n{:8}{} ({})\n", rule.codes, rule.words, "", rule.why,
                       reference::clause_name(rule.clause));
  }
}

// The page of each dialect chosen, with its drawings.
int write_pages(const SpecOptions& options) {
  if (options.out.empty()) {
    throw UsageError("A page comes with its drawings: name the folder for both with --out.");
  }
  for (const reference::Dialect& dialect : reference::dialects()) {
    if (!options.dialect.empty() && options.dialect != dialect.name) continue;
    for (const oracle::manual::PageFile& file : oracle::manual::page_of(dialect)) {
      const std::filesystem::path path = std::filesystem::path(options.out) / file.name;
      std::filesystem::create_directories(path.parent_path());
      oracle::write_file(path, file.text);
    }
  }
  return kGo;
}

bool concerns(const reference::Dialect& dialect, std::string_view about) {
  return std::ranges::any_of(dialect.clauses,
                             [&](const auto& one) { return concerns(dialect, one, about); }) ||
         std::ranges::any_of(dialect.descriptor->codes,
                             [&](const auto& one) { return concerns(one, about); }) ||
         std::ranges::any_of(reference::outside_codes(*dialect.descriptor),
                             [&](const auto& one) { return is_code(one.code, about); });
}

int spec(const SpecOptions& options) {
  Output output;
  if (options.alarms || options.features) {
    (options.alarms ? append_alarm_classes : append_features)(output.text());
    output.flush();
    return kGo;
  }
  if (!options.dialect.empty()) load_profile({options.dialect, "", {}});  // unknown: wrong use
  if (options.format == "markdown") return write_pages(options);
  if (!options.out.empty()) throw UsageError("--out goes with --format markdown.");
  bool has_any = false;
  for (const reference::Dialect& dialect : reference::dialects()) {
    if (!options.dialect.empty() && options.dialect != dialect.name) continue;
    if (!concerns(dialect, options.about)) continue;
    has_any = true;
    output.text() +=
        fmt::format("Dialect {}, at power-on {}.\nTexts: {}.\n", dialect.name,
                    reference::power_on_text(dialect.name), reference::editions_of(dialect.name));
    append_clauses(dialect, options.about, output.text());
    append_readings(dialect.name, options.about, output.text());
    append_codes(dialect, options.about, output.text());
    append_outside(dialect, options.about, output.text());
  }
  if (!has_any) {
    throw UsageError(fmt::format(
        "No clause is about {}. Write a code, as g94, or a clause: `gonogo spec` prints them all.",
        options.about));
  }
  output.flush();
  return kGo;
}

}  // namespace

void add_spec(Command& program) {
  auto options = std::make_shared<SpecOptions>();
  Command command = program.add_command("spec", "Print the clauses and readings of a dialect");
  command.option("--dialect", options->dialect, "one of: " + reference::dialect_names() + " (all)");
  command.option("--about", options->about, "only what concerns a code or clause, as g94");
  command.flag("--features", options->features,
               "the words by which a subject declares what it has");
  command.flag("--alarms", options->alarms,
               "the classes of alarms, each with its meaning and an example");
  command.choice("--format", options->format, {"text", "markdown"},
                 "text, or markdown: a page with drawings (text)");
  command.option("--out", options->out, "folder for pages and drawings");
  command.run([options] { return spec(*options); });
}

}  // namespace gonogo::cli
