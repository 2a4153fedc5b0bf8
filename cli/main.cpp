// SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>

#include "cli/run.hpp"

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  return gonogo::cli::run(argc, argv);
}
