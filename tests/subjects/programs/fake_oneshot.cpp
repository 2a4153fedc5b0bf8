// SPDX-License-Identifier: GPL-3.0-or-later
//
// A subject that is one process a program, and misbehaves as its first argument says.
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace {

const std::string kRecord = R"({"k":"rapid","b":1,"to":{"x":"1","z":"11/3"}})";
const std::string kAlarm = R"({"k":"alarm","class":"syntax","b":2})";

int print(const std::string& line, int code) {
  std::cout << line << '\n' << std::flush;
  return code;
}

[[noreturn]] void sleep_for_ever() {
  while (true) pause();
}

std::string argument_after(const std::vector<std::string>& arguments, const std::string& name) {
  for (std::size_t i = 0; i + 1 < arguments.size(); ++i) {
    if (arguments[i] == name) return arguments[i + 1];
  }
  return {};
}

// The command line, the profile and its rights on stderr.
int show(const std::vector<std::string>& arguments) {
  const std::string path = argument_after(arguments, "--profile");
  struct stat status {};
  stat(path.c_str(), &status);
  std::ifstream file(path);
  std::cerr << "dialect=" << argument_after(arguments, "--dialect") << " mode=" << std::oct
            << (status.st_mode & 0777)
            << " profile=" << std::string(std::istreambuf_iterator<char>(file), {})
            << " path=" << path << "\n";
  return 0;
}

// More output than a pipe holds before the first byte of input is read.
int echo_size() {
  for (int i = 0; i < 5000; ++i) std::cout << kRecord << '\n';
  std::cout << std::flush;
  const std::string program(std::istreambuf_iterator<char>(std::cin), {});
  return print("{\"k\":\"m\",\"m\":" + std::to_string(program.size()) + "}", 0);
}

int describe(const std::string& mode) {
  if (mode == "described") {
    return print(R"({"protocol":1,"subject":{"name":"shot","version":"2"},"dialects":["rs274"]})",
                 0);
  }
  if (mode == "described-badly") return print(R"({"protocol":1})", 0);
  return 2;
}

int run(const std::string& mode, const std::vector<std::string>& arguments) {
  if (mode == "alarm") return print(kRecord + "\n" + kAlarm, 1);
  if (mode == "alarm-exit0") return print(kAlarm, 0);
  if (mode == "exit1") return print(kRecord, 1);
  if (mode == "after-alarm") return print(kAlarm + "\n" + kRecord, 1);
  if (mode == "exit2") return 2;
  if (mode == "exit3") {
    std::cerr << "no G116 here\n";
    return 3;
  }
  if (mode == "exit3-behind-records") return print(kRecord + "\n" + kRecord + "\n" + kRecord, 3);
  if (mode == "exit2-behind-records") return print(kRecord + "\n" + kRecord, 2);
  if (mode == "abort") std::abort();
  if (mode == "garbage") return print("G1 X1", 0);
  if (mode == "cut") {
    std::cout << kRecord.substr(0, 20) << std::flush;
    return 0;
  }
  if (mode == "no-newline") {
    std::cout << kRecord << std::flush;
    return 0;
  }
  if (mode == "hang") sleep_for_ever();
  if (mode == "flood") {
    while (true) print(kRecord, 0);
  }
  if (mode == "grandchild") {
    if (fork() == 0) sleep_for_ever();
    return print(kRecord, 0);
  }
  if (mode == "echo-size") return echo_size();
  if (mode == "show") return show(arguments);
  if (mode == "show-unsupported") {
    show(arguments);
    return 3;
  }
  if (mode == "reads") {
    return std::ifstream(argument_after(arguments, "--profile")) ? print(kRecord, 0) : 2;
  }
  return print(kRecord, 0);
}

}  // namespace

int main(int count, char** values) {
  const std::vector<std::string> arguments(values + 1, values + count);
  const std::string mode = arguments.empty() ? "good" : arguments[0];
  for (const std::string& argument : arguments) {
    if (argument == "--describe") return describe(mode);
  }
  return run(mode, arguments);
}
