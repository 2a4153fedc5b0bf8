// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command line of the program and of its commands. The parser's own header is large: only
// command_line.cpp and wrong_words.cpp include it.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cli/exit_code.hpp"

namespace CLI {
class App;
}

namespace gonogo::cli {

// What a command takes, for the manual page and the completion of words.
struct OptionText {
  std::string name;                  // "--dialect"; of an argument its name
  std::string text;                  // the line of the help
  std::vector<std::string> choices;  // the words that it takes; empty: any
  bool argument = false;             // a word without a name
  bool takes_value = true;
  bool needed = false;
  bool repeated = false;
};
struct CommandText {
  std::string name;
  std::string text;
  std::vector<OptionText> options;
  std::vector<CommandText> commands;  // without hidden ones
};

// What the help of a command shows beside its words.
struct CommandGuide {
  std::string name;
  std::vector<std::string> examples;  // without the name of the program
};
// Commands that the help of the program lists together.
struct CommandGroup {
  std::string name;
  std::vector<CommandGuide> commands;
};

// A command and its words. The variables given must outlive the parse; a command keeps them in what
// it gives to `run`. Every text is the line of the help.
class Command {
 public:
  Command(CLI::App& app, int& exit_code) : app_(&app), exit_code_(&exit_code) {}

  Command add_command(const std::string& name, const std::string& text);
  // One that the help does not name.
  Command add_hidden_command(const std::string& name, const std::string& text);
  // All commands have to be there.
  void group(const CommandGroup& group);
  // One of its own commands has to be given.
  void require_command();

  // An option that is needed; of a name without hyphens a word without a name. `arguments`: one
  // such word or more.
  void needed(const std::string& name, std::string& value, const std::string& text);
  void arguments(const std::string& name, std::vector<std::string>& values,
                 const std::string& text);
  // --name VALUE
  void option(const std::string& name, std::string& value, const std::string& text);
  void repeated_option(const std::string& name, std::vector<std::string>& values,
                       const std::string& text);
  // One of a few words.
  void choice(const std::string& name, std::string& value, const std::vector<std::string>& of,
              const std::string& text);
  // A whole number in [low, high].
  void number(const std::string& name, long& value, long low, long high, const std::string& text);
  void flag(const std::string& name, bool& value, const std::string& text);

  // An option that has no effect without another one is refused without it.
  void needs(const std::vector<std::string>& options, const std::string& other);

  // What the command does when it is chosen; gives the exit code.
  void run(std::function<int()> action);

 private:
  CLI::App* app_;
  int* exit_code_;
};

// The whole program.
class CommandLine {
 public:
  CommandLine(const std::string& name, const std::string& text, const std::string& version);
  ~CommandLine();

  Command& program() { return program_; }
  // All that was added until now.
  CommandText description() const;
  // Runs the command that the words choose: its exit code. Says what is wrong with the words, and
  // returns kWrongUse, where they choose none.
  int parse(int argc, char** argv);

 private:
  std::unique_ptr<CLI::App> app_;
  int exit_code_ = kGo;
  Command program_;
};

}  // namespace gonogo::cli
