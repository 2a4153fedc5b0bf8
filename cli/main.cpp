// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <system_error>

#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/exit_code.hpp"
#include "cli/output.hpp"
#include "cli/program_file.hpp"
#include "cli/version.hpp"
#include "oracle/subject.hpp"

namespace gonogo::cli {

std::vector<std::string>& arguments() {
  static std::vector<std::string> words;
  return words;
}

namespace {

int run(int argc, char** argv) {
  CLI::App app{"GoNoGo, the master gauge for CNC canned cycles.", "gonogo"};
  app.set_version_flag("--version", std::string("gonogo ") + kVersion);
  app.require_subcommand(1);
  arguments().assign(argv + 1, argv + argc);
  int exit_code = kGo;
  add_expand(app, exit_code);
  add_explain(app, exit_code);
  add_judge(app, exit_code);
  add_certify(app, exit_code);
  add_spec(app, exit_code);
  add_report(app, exit_code);
  add_selftest(app, exit_code);
  add_faults(app, exit_code);
  add_corpus(app, exit_code);
  add_misbehave(app, exit_code);
  add_merge(app, exit_code);
  add_compare(app, exit_code);
  add_verify(app, exit_code);
  add_export(app, exit_code);
  add_host(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kGo : kWrongUse;
  }
  return exit_code;
}

}  // namespace
}  // namespace gonogo::cli

int main(int argc, char** argv) {
  using namespace gonogo::cli;
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return run(argc, argv);
  } catch (const UsageError& error) {
    fmt::print(stderr, "gonogo: {}\n", error.what());
    return kWrongUse;
  } catch (const gonogo::oracle::SubjectUnusable& error) {
    fmt::print(stderr, "gonogo: {}\n", error.what());
    return kWrongUse;
  } catch (const OutputError& error) {
    if (!error.quiet()) fmt::print(stderr, "gonogo: {}\n", error.what());
    return kUndecided;
  } catch (const std::system_error& error) {
    fmt::print(stderr, "gonogo: {}.\n", error.what());
    return kWrongUse;
  } catch (const std::exception& error) {
    fmt::print(stderr, "gonogo: an error of the gauge itself: {}. Please report it.\n",
               error.what());
    return kUndecided;
  }
}
