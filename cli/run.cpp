// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "campaign/results_lock.hpp"
#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "cli/program_file.hpp"
#include "cli/run.hpp"
#include "cli/version.hpp"
#include "corpus/io/corpus.hpp"
#include "subjects/make_subject.hpp"

namespace gonogo::cli {

std::vector<std::string>& arguments() {
  static std::vector<std::string> words;
  return words;
}

namespace {

int run_command(int argc, char** argv) {
  CommandLine line("gonogo", "GoNoGo, the master gauge for CNC canned cycles.",
                   std::string("gonogo ") + kVersion);
  Command& program = line.program();
  arguments().assign(argv + 1, argv + argc);
  for (void (*const add)(Command&) :
       {add_expand,   add_explain, add_judge,    add_certify,   add_spec,  add_report,
        add_selftest, add_faults,  add_corpus,   add_misbehave, add_merge, add_compare,
        add_site,     add_verify,  add_export,   add_host,      add_hunt,  add_fuzz,
        add_ci,       add_reduce,  add_identify, add_generate,  add_signs}) {
    add(program);
  }
  add_completion(line);
  add_man(line);
  for (const CommandGroup& group : command_groups()) program.group(group);
  return line.parse(argc, argv);
}

// A file that another path would not fail for, as a full disk does.
bool is_of_the_place(const std::error_code& code) {
  constexpr std::errc kOfThePlace[] = {std::errc::no_such_file_or_directory,
                                       std::errc::not_a_directory,
                                       std::errc::is_a_directory,
                                       std::errc::permission_denied,
                                       std::errc::file_exists,
                                       std::errc::filename_too_long,
                                       std::errc::operation_not_permitted,
                                       std::errc::read_only_file_system,
                                       std::errc::too_many_symbolic_link_levels};
  return std::ranges::any_of(kOfThePlace, [&](std::errc one) { return code == one; });
}

}  // namespace

int run(int argc, char** argv) {
  try {
    return run_command(argc, argv);
  } catch (const UsageError& error) {
    complain("gonogo: {}\n", error.what());
    return kWrongUse;
  } catch (const oracle::SubjectUnusable& error) {
    complain("gonogo: {}\n", error.what());
    return kWrongUse;
  } catch (const oracle::CorpusError& error) {
    complain("gonogo: {}\n", error.what());
    return kWrongUse;
  } catch (const oracle::ResultsRefused& error) {
    complain("gonogo: {}\n", error.what());
    return kWrongUse;
  } catch (const OutputError& error) {
    if (!error.quiet()) complain("gonogo: {}\n", error.what());
    return kUndecided;
  } catch (const std::filesystem::filesystem_error& error) {
    complain("gonogo: {} cannot be made, read or written: {}.\n", error.path1().string(),
             error.code().message());
    return is_of_the_place(error.code()) ? kWrongUse : kUndecided;
  } catch (const std::system_error& error) {
    complain("gonogo: {}.\n", error.what());
    return is_of_the_place(error.code()) ? kWrongUse : kUndecided;
  } catch (const std::exception& error) {
    complain("gonogo: an error of the gauge itself: {}. Please report it.\n", error.what());
    return kUndecided;
  }
}

}  // namespace gonogo::cli
