// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo completion: the script with which bash completes the words of a command line.
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "expanders/registry.hpp"
#include "reference/dialect.hpp"
#include "reference/reading.hpp"

namespace gonogo::cli {
namespace {

// Words of options that several commands have, beyond those of their own choices.
std::string dialects() {
  std::string words;
  for (const reference::Dialect& dialect : reference::dialects()) {
    words += fmt::format("{} ", dialect.name);
  }
  return words;
}

std::string readings() {
  std::string words;
  for (const reference::Reading& reading : reference::readings()) {
    for (const std::string_view value : reading.alternatives) {
      words += fmt::format("{}={} ", reading.name, value);
    }
    if (!reading.is_length) words += fmt::format("{}=any ", reading.name);
  }
  return words;
}

std::string subjects() {
  std::string words = "pipe: oneshot: lib: capture: ";
  for (const std::string_view name : expanders::names()) {
    words += fmt::format("builtin:{} ", name);
    for (const expanders::FaultDescription& fault : expanders::faults(name)) {
      words += fmt::format("builtin:{}+{} ", name, fault.name);
    }
  }
  return words;
}

// What stands for them in the script.
std::string words_of(const OptionText& option) {
  if (option.name == "--dialect") return "$_gonogo_dialects";
  if (option.name == "--reading") return "$_gonogo_readings";
  if (option.name == "--subject") return "$_gonogo_subjects";
  return fmt::format("'{}'", fmt::join(option.choices, " "));
}

// A branch of `case "$command$option"`, and of `case "$command"`, for a command and those in it.
void append_branches(const CommandText& command, const std::string& path, std::string& values,
                     std::string& words) {
  std::string names;
  for (const CommandText& inner : command.commands) names += inner.name + " ";
  for (const OptionText& option : command.options) {
    if (option.argument) continue;
    names += option.name + " ";
    if (!option.takes_value) continue;
    values += fmt::format("    '{} {}') words={} ;;\n", path, option.name, words_of(option));
  }
  words += fmt::format("    '{}') words='{}' ;;\n", path, names);
  for (const CommandText& inner : command.commands) {
    append_branches(inner, path + "/" + inner.name, values, words);
  }
}

// Follows the commands of the line to the one that the word belongs to.
void append_commands(const CommandText& command, const std::string& path, std::string& out) {
  for (const CommandText& inner : command.commands) {
    out += fmt::format("      '{0} {1}') command={0}/{1} ;;\n", path, inner.name);
    append_commands(inner, path + "/" + inner.name, out);
  }
}

std::string script(const CommandText& program) {
  std::string values;
  std::string words;
  std::string commands;
  append_branches(program, "", values, words);
  append_commands(program, "", commands);
  return fmt::format(R"bash(# bash completion of gonogo, written by `gonogo completion`.
_gonogo_dialects='{}'
_gonogo_readings='{}'
_gonogo_subjects='{}'
_gonogo() {{
  local line=${{COMP_LINE:0:COMP_POINT}} command='' before='' word='' words='' given i
  # bash breaks words at ':' and '=', which belong to ours: split the line at blanks.
  local -a parts
  read -ra parts <<<"$line"
  [[ $line == *[[:blank:]] ]] && parts+=('')
  word=${{parts[-1]}}
  before=${{parts[-2]-}}
  for ((i = 1; i < ${{#parts[@]}} - 1; ++i)); do
    case "$command ${{parts[i]}}" in
{}    esac
  done
  case "$command $before" in
{}    *) given=no ;;
  esac
  if [[ ${{given-}} == no ]]; then
    case "$command" in
{}    esac
    [[ $word == -* || $command == '' || $command == /corpus ]] || words=''
  fi
  COMPREPLY=()
  if [[ $word == @(pipe|oneshot|lib|capture):* ]]; then
    mapfile -t COMPREPLY < <(compgen -f -- "${{word#*:}}")
    compopt -o filenames 2>/dev/null
    return 0
  fi
  if [[ ! $words ]]; then
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
    compopt -o filenames 2>/dev/null
    return 0
  fi
  local found
  for found in $words; do
    [[ $found == "$word"* ]] && COMPREPLY+=("$found")
  done
  # What stands before the last ':' or '=' is on the line already.
  local typed=${{word%"${{word##*[:=]}}"}}
  [[ $typed ]] && COMPREPLY=("${{COMPREPLY[@]#"$typed"}}")
  [[ ${{#COMPREPLY[@]}} -eq 1 && ${{COMPREPLY[0]}} == *: ]] && compopt -o nospace 2>/dev/null
  return 0
}}
complete -F _gonogo gonogo
)bash",
                     dialects(), readings(), subjects(), commands, values, words);
}

}  // namespace

void add_completion(CommandLine& line) {
  Command command =
      line.program().add_command("completion", "Write the script that completes words in bash");
  command.run([&line] {
    Output output;
    output.text() = script(line.description());
    output.flush();
    return kGo;
  });
}

}  // namespace gonogo::cli
