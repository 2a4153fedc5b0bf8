// SPDX-License-Identifier: GPL-3.0-or-later
//
// The commands of the program, one file each in cli/commands. Each adds itself to the command line
// and returns nothing; when it is chosen its callback puts the exit code into `exit_code`.
#pragma once

#include <CLI/CLI.hpp>

namespace gonogo::cli {

void add_expand(CLI::App& app, int& exit_code);
void add_explain(CLI::App& app, int& exit_code);
void add_judge(CLI::App& app, int& exit_code);
void add_certify(CLI::App& app, int& exit_code);
void add_spec(CLI::App& app, int& exit_code);
void add_report(CLI::App& app, int& exit_code);
void add_selftest(CLI::App& app, int& exit_code);
void add_faults(CLI::App& app, int& exit_code);
void add_corpus(CLI::App& app, int& exit_code);
// Hidden: the subjects of the self-test, good and bad.
void add_misbehave(CLI::App& app, int& exit_code);
void add_merge(CLI::App& app, int& exit_code);
void add_compare(CLI::App& app, int& exit_code);
void add_verify(CLI::App& app, int& exit_code);
void add_export(CLI::App& app, int& exit_code);
void add_host(CLI::App& app, int& exit_code);

}  // namespace gonogo::cli
