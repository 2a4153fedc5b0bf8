// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <sstream>
#include <utility>

#include "cli/exit_code.hpp"
#include "cli/output.hpp"
#include "cli/wrong_words.hpp"
#include "reference/nearest_word.hpp"

namespace gonogo::cli {
namespace {

// A variable that is not set in a script must not look like an option that was left out.
const CLI::Validator& not_empty() {
  static const CLI::Validator kNotEmpty(
      [](const std::string& word) {
        return std::string(word.empty() ? "is empty; leave it out, or write a value" : "");
      },
      "");
  return kNotEmpty;
}

// A whole number from low to high. The parser would read one with zeros in front as octal.
CLI::Validator whole_number(long low, long high) {
  return {[low, high](std::string& word) -> std::string {
            long value = 0;
            const char* const end = word.data() + word.size();
            const auto [last, error] = std::from_chars(word.data(), end, value);
            if (error == std::errc() && last == end && value >= low && value <= high) {
              word = std::to_string(value);
              return {};
            }
            return fmt::format("{} is no whole number from {} to {}.", word, low, high);
          },
          fmt::format("INT in [{} - {}]", low, high)};
}

// The type says the words, which a completion needs: {a,b}.
CLI::Validator one_of(const std::vector<std::string>& words) {
  return {[words](const std::string& word) -> std::string {
            if (std::ranges::find(words, word) != words.end()) return {};
            return fmt::format("{} is none of its words. {}Write {}.", word,
                               reference::did_you_mean(reference::nearest_word(word, words)),
                               fmt::join(words, ", "));
          },
          fmt::format("{{{}}}", fmt::join(words, ","))};
}

}  // namespace

Command Command::add_command(const std::string& name, const std::string& text) {
  return {*app_->add_subcommand(name, text), *exit_code_};
}

Command Command::add_hidden_command(const std::string& name, const std::string& text) {
  CLI::App* command = app_->add_subcommand(name, text);
  command->group("");
  return {*command, *exit_code_};
}

void Command::group(const CommandGroup& group) {
  for (const auto& [name, examples] : group.commands) {
    CLI::App* command = app_->get_subcommand(name);
    command->group(group.name);
    std::string text = "Examples:";
    for (const std::string& example : examples) text += "\n  gonogo " + example;
    command->footer(text);
  }
}

void Command::require_command() {
  app_->require_subcommand(1);
}

void Command::needed(const std::string& name, std::string& value, const std::string& text) {
  app_->add_option(name, value, text)->required()->check(not_empty());
}

void Command::arguments(const std::string& name, std::vector<std::string>& values,
                        const std::string& text) {
  app_->add_option(name, values, text)->required()->check(not_empty());
}

void Command::option(const std::string& name, std::string& value, const std::string& text) {
  app_->add_option(name, value, text)->check(not_empty());
}

void Command::repeated_option(const std::string& name, std::vector<std::string>& values,
                              const std::string& text) {
  app_->add_option(name, values, text + "; may be repeated")
      ->allow_extra_args(false)
      ->check(not_empty());
}

void Command::choice(const std::string& name, std::string& value,
                     const std::vector<std::string>& of, const std::string& text) {
  app_->add_option(name, value, text)->check(one_of(of));
}

void Command::number(const std::string& name, long& value, long low, long high,
                     const std::string& text) {
  app_->add_option(name, value, text)->transform(whole_number(low, high));
}

void Command::flag(const std::string& name, bool& value, const std::string& text) {
  app_->add_flag(name, value, text);
}

void Command::needs(const std::vector<std::string>& options, const std::string& other) {
  for (const std::string& name : options) app_->get_option(name)->needs(app_->get_option(other));
}

void Command::run(std::function<int()> action) {
  app_->callback([action = std::move(action), exit_code = exit_code_] { *exit_code = action(); });
}

namespace {

// The parser names the words of a choice in the type of its option: TEXT:{a,b}.
std::vector<std::string> choices_of(const std::string& type) {
  std::vector<std::string> choices;
  const std::size_t open = type.find('{');
  if (open == std::string::npos) return choices;
  const std::string words = type.substr(open + 1, type.rfind('}') - open - 1);
  for (std::size_t from = 0; from <= words.size();) {
    const std::size_t end = std::min(words.find(',', from), words.size());
    choices.push_back(words.substr(from, end - from));
    from = end + 1;
  }
  return choices;
}

OptionText text_of(const CLI::Option& option) {
  OptionText text;
  text.argument = option.get_positional();
  text.name = text.argument || option.get_lnames().empty() ? option.get_single_name()
                                                           : "--" + option.get_lnames().front();
  text.text = option.get_description();
  text.takes_value = option.get_items_expected_max() > 0;
  text.choices = choices_of(option.get_type_name());
  text.needed = option.get_required();
  text.repeated = option.get_items_expected_max() > 1;
  return text;
}

CommandText text_of(const CLI::App& app) {
  CommandText text{app.get_name(), app.get_description(), {}, {}};
  for (const CLI::Option* option : app.get_options()) text.options.push_back(text_of(*option));
  const auto is_shown = [](const CLI::App* command) { return !command->get_group().empty(); };
  for (const CLI::App* command : app.get_subcommands(is_shown)) {
    text.commands.push_back(text_of(*command));
  }
  return text;
}

}  // namespace

CommandText CommandLine::description() const {
  return text_of(*app_);
}

CommandLine::CommandLine(const std::string& name, const std::string& text,
                         const std::string& version)
    : app_(std::make_unique<CLI::App>(text, name)), program_(*app_, exit_code_) {
  app_->set_version_flag("--version", version);
  app_->require_subcommand(1);
}

CommandLine::~CommandLine() = default;

int CommandLine::parse(int argc, char** argv) {
  if (const std::string problem = unknown_command(*app_, argc > 1 ? argv[1] : "");
      !problem.empty()) {
    complain("gonogo: {}", problem);
    return kWrongUse;
  }
  try {
    app_->parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) {
      complain("gonogo: {}", problem_of(*app_, error));
      return kWrongUse;
    }
    std::ostringstream shown;  // --help and --version
    app_->exit(error, shown, shown);
    Output output;
    output.text() = shown.str();
    output.tell();
    return kGo;
  }
  return exit_code_;
}

}  // namespace gonogo::cli
