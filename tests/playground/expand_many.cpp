// SPDX-License-Identifier: GPL-3.0-or-later
//
// expand_many FOLDER: `gonogo expand` on one program after the other in one process, as main() calls it. A
// line of standard input names a program, its dialect and its profile, parted by blanks; of each comes a line
// with the exit code and the lengths of its records and messages, and both after it. FOLDER is for two files.
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "cli/run.hpp"

namespace {

// While it lives, what goes to a descriptor goes to a file.
class Redirection {
 public:
  Redirection(int descriptor, const std::string& path) : descriptor_(descriptor), before_(dup(descriptor)) {
    const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(file, descriptor_);
    close(file);
  }
  Redirection(const Redirection&) = delete;
  Redirection& operator=(const Redirection&) = delete;
  ~Redirection() {
    dup2(before_, descriptor_);
    close(before_);
  }

 private:
  int descriptor_;
  int before_;
};

std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

int expand(const std::string& line, const std::string& records, const std::string& messages) {
  std::istringstream words(line);
  std::string program, dialect, profile;
  words >> program >> dialect >> profile;
  std::vector<std::string> arguments = {"gonogo", "expand", program, "--dialect", dialect, "--profile", profile};
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  const Redirection to_records(1, records);
  const Redirection to_messages(2, messages);
  return gonogo::cli::run(static_cast<int>(pointers.size()), pointers.data());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::string folder = argv[1];
  for (std::string line; std::getline(std::cin, line);) {
    const int code = expand(line, folder + "/records", folder + "/messages");
    const std::string records = content_of(folder + "/records");
    const std::string messages = content_of(folder + "/messages");
    std::cout << code << ' ' << records.size() << ' ' << messages.size() << '\n' << records << messages;
  }
}
