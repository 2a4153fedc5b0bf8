// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo host LIBRARY: runs a shared library as a subject of the pipe protocol. `certify` starts it
// for lib:LIBRARY; by hand it shows what a library answers.
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <system_error>

#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "oracle/records/text.hpp"
#include "subjects/library_file.hpp"
#include "subjects/library_host.hpp"
#include "subjects/make_subject.hpp"

namespace gonogo::cli {
namespace {

struct HostOptions {
  std::string library;
  bool check = false;
};

int moved_away(int descriptor) {
  const int moved = fcntl(descriptor, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  if (moved < 0) throw std::system_error(errno, std::generic_category(), "fcntl");
  return moved;
}

// The protocol's descriptors. Those of the library are others: what it prints goes to standard
// error, line by line, and it has nothing to read.
struct Channel {
  int input = moved_away(STDIN_FILENO);
  int output = moved_away(STDOUT_FILENO);

  Channel() {
    const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
    if (nothing < 0 || dup2(nothing, STDIN_FILENO) < 0 || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) {
      throw std::system_error(errno, std::generic_category(), "dup2");
    }
    close(nothing);
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
  }
};

void say(const Channel& channel, const std::string& line) {
  Output output(channel.output);
  output.text() = people_text(line + "\n", false);
  output.flush();
}

// What stands in the table is the library's, and the sentence says whose.
oracle::LibraryHost made_host(const std::string& library, const Channel& channel) {
  const gonogo_subject_v1& subject = oracle::load_library(library);
  try {
    return {subject, channel.input, channel.output};
  } catch (const oracle::SubjectUnusable& error) {
    throw oracle::SubjectUnusable(oracle::library_path(library) + ": " + error.what());
  }
}

// What can be done with a library that fits. One that declares no dialect is asked for one.
std::string fits(const HostOptions& options, const std::string& reply) {
  const std::string subject = oracle::shell_quoted("lib:" + options.library);
  const bool declares = reply.find("\"dialects\"") != std::string::npos;
  std::string text = fmt::format("The library fits. Next: gonogo certify --subject {}", subject);
  if (!declares) {
    text +=
        " --dialect rs274\nIt declares no dialect: name the one that it reads (gonogo spec "
        "--features).";
  }
  return text;
}

int host(const HostOptions& options) {
  const Channel channel;
  try {
    oracle::LibraryHost host = made_host(options.library, channel);
    if (options.check) {
      say(channel, host.start_reply() + "\n" + fits(options, host.start_reply()));
    } else {
      host.serve();
    }
    return kGo;
  } catch (const oracle::SubjectUnusable& error) {
    // The sentence is all that comes where the protocol would: the runner passes it on.
    say(channel, oracle::visible(error.what()));
    return kWrongUse;
  }
}

}  // namespace

void add_host(Command& program) {
  auto options = std::make_shared<HostOptions>();
  Command command = program.add_command("host", "Run a shared library behind the pipe protocol");
  command.needed("library", options->library, "shared library with gonogo_get_subject");
  command.flag("--check", options->check, "only load it and print what it says of itself");
  command.run([options] { return host(*options); });
}

}  // namespace gonogo::cli
