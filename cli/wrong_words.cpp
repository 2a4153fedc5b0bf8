// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/wrong_words.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string_view>
#include <vector>

#include "reference/nearest_word.hpp"

namespace gonogo::cli {
namespace {

// The command that the words name, down to the last of its commands.
const CLI::App& named_command(const CLI::App& app) {
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
  return *command;
}

// "gonogo ci batch"
std::string name_of(const CLI::App& command) {
  const CLI::App* const parent = command.get_parent();
  return (parent == nullptr ? "" : name_of(*parent) + " ") + command.get_name();
}

std::vector<std::string> shown_commands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (!command->get_group().empty()) names.push_back(command->get_name());
  }
  return names;
}

// " Did you mean --out?"; nothing where no word is near.
std::string near(const std::string& word, const std::vector<std::string>& known) {
  std::string text = reference::did_you_mean(reference::nearest_word(word, known));
  if (text.empty()) return text;
  text.pop_back();
  return " " + text;
}

// What of the words the command does not take. A word behind an unknown option is its value.
std::string unknown_words(const CLI::App& command, const std::vector<std::string>& words) {
  std::vector<std::string> known;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  }
  std::string text;
  bool is_value = false;
  for (const std::string& word : words) {
    const std::string option = word.substr(0, word.find('='));
    if (word.starts_with("-")) {
      text += fmt::format("There is no option {} of {}.{}\n", option, name_of(command),
                          near(option, known));
    } else if (!is_value) {
      text += fmt::format("The word {} is one too many for {}.\n", word, name_of(command));
    }
    is_value = word.starts_with("-") && option == word;
  }
  return text;
}

// A command of commands, of which none was named.
std::string missing_command(const CLI::App& command, const std::vector<std::string>& words) {
  if (words.empty()) {
    return fmt::format("Write one of its commands behind {}: {}.\n", name_of(command),
                       fmt::join(shown_commands(command), ", "));
  }
  const std::string unknown = unknown_command(command, words.front());
  return unknown.empty() ? unknown_words(command, words) : unknown;
}

// What the command needs and was not given, each with what it is.
std::string missing_words(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_required() || option->count() > 0) continue;
    text += fmt::format(
        "{} needs {}: {}.\n", name_of(command),
        option->get_positional() ? "the word " + option->get_name() : option->get_name() + " VALUE",
        option->get_description());
  }
  return text;
}

// Options that have no effect without another one.
std::string lonely_options(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0) continue;
    for (const CLI::Option* other : option->get_needs()) {
      if (other->count() > 0) continue;
      text +=
          fmt::format("{} needs {} beside it: write {} too, or leave {} out.\n", option->get_name(),
                      other->get_name(), other->get_name(), option->get_name());
    }
  }
  return text;
}

// An option with too many values or none, or a switch with one. The parser's sentence names it.
std::string wrong_number_of_values(const CLI::App& command, std::string_view said) {
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    const std::size_t at = said.find(name);
    if (at == std::string_view::npos) continue;
    const std::size_t behind = at + name.size();
    if (behind < said.size() && said[behind] != ':' && said[behind] != ' ') continue;
    if (option->get_items_expected_max() == 0) return name + " takes no value: write it alone.\n";
    if (option->count() > 1) return name + " is given more than once: write it once.\n";
    return fmt::format("{} needs a value behind it: {}.\n", name, option->get_description());
  }
  return {};
}

}  // namespace

std::string unknown_command(const CLI::App& app, const std::string& word) {
  if (word.empty() || word.front() == '-') return {};
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_name() == word) return {};
  }
  const std::vector<std::string> known = shown_commands(app);
  const std::string of = app.get_parent() == nullptr ? "" : " of " + name_of(app);
  return fmt::format("There is no command \"{}\"{}.{} There are {}.\n", word, of, near(word, known),
                     fmt::join(known, ", "));
}

std::string problem_of(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = named_command(app);
  const std::vector<std::string> further = app.remaining(true);
  std::string text;
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    text = unknown_words(command, further);
  } else if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) {
    text = command.get_require_subcommand_min() > 0
               ? missing_command(command, further)
               : unknown_words(command, further) + missing_words(command);
  } else if (dynamic_cast<const CLI::RequiresError*>(&error) != nullptr) {
    text = lonely_options(command);
  } else if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr ||
             dynamic_cast<const CLI::ConversionError*>(&error) != nullptr) {
    text = wrong_number_of_values(command, error.what());
  }
  if (text.empty()) text = fmt::format("{}\n", error.what());
  return fmt::format("{}`{} --help` says what it takes.\n", text, name_of(command));
}

}  // namespace gonogo::cli
