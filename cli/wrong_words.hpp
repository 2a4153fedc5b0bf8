// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is wrong with the words of a command line, in words of the gauge and not in those of the
// parser, with what to write.
#pragma once

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace gonogo::cli {

// Empty: the word is a command of this one, an option, or none.
std::string unknown_command(const CLI::App& app, const std::string& word);

// The mistake for which the parser threw the error. REQUIRES: the error is none of --help.
std::string problem_of(const CLI::App& app, const CLI::ParseError& error);

}  // namespace gonogo::cli
