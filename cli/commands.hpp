// SPDX-License-Identifier: GPL-3.0-or-later
//
// The commands of the program, one file each in cli/commands. Each adds itself to the command line.
#pragma once

#include <string>
#include <vector>

#include "cli/command_line.hpp"

namespace gonogo::cli {

// The words of the command line after the program's name, kept for the results.
std::vector<std::string>& arguments();
// Each command with its place in the help and two examples.
std::vector<CommandGroup> command_groups();

void add_expand(Command& program);
void add_explain(Command& program);
void add_judge(Command& program);
void add_certify(Command& program);
void add_spec(Command& program);
void add_report(Command& program);
void add_selftest(Command& program);
void add_faults(Command& program);
void add_corpus(Command& program);
// Adds new, build, merge and publish to it.
void add_corpus_making(Command& corpus);
// Hidden: the subjects of the self-test, good and bad.
void add_misbehave(Command& program);
void add_merge(Command& program);
void add_compare(Command& program);
void add_site(Command& program);
void add_verify(Command& program);
void add_export(Command& program);
void add_host(Command& program);
void add_hunt(Command& program);
void add_fuzz(Command& program);
void add_ci(Command& program);
void add_reduce(Command& program);
void add_identify(Command& program);
void add_generate(Command& program);
void add_signs(Command& program);
// These two describe every command that was added, themselves among them.
void add_completion(CommandLine& line);
void add_man(CommandLine& line);

}  // namespace gonogo::cli
