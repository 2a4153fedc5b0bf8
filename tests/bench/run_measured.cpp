// SPDX-License-Identifier: GPL-3.0-or-later
//
// run_measured OUTPUT COMMAND [ARGUMENT...]: runs a command with its output going to a file and
// prints one line: seconds of CPU with all its children, seconds on the clock, peak memory in KiB,
// exit code. A program of its own because the peak of a process counts from its fork: that of a
// script would show in every figure.
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: %s OUTPUT COMMAND [ARGUMENT...]\n", argv[0]);
    return 2;
  }
  const auto begin = std::chrono::steady_clock::now();
  const pid_t child = ::fork();
  if (child < 0) {
    std::perror("fork");
    return 2;
  }
  if (child == 0) {
    const int out = ::open(argv[1], O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int nothing = ::open("/dev/null", O_RDWR);
    if (out < 0 || nothing < 0) ::_exit(126);
    ::dup2(nothing, STDIN_FILENO);
    ::dup2(out, STDOUT_FILENO);
    ::dup2(nothing, STDERR_FILENO);
    ::execvp(argv[2], argv + 2);
    ::_exit(127);
  }
  int status = 0;
  rusage used{};
  ::wait4(child, &status, 0, &used);
  const std::chrono::duration<double> clock = std::chrono::steady_clock::now() - begin;
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
  };
  std::printf("%.6f %.6f %ld %d\n", seconds(used.ru_utime) + seconds(used.ru_stime), clock.count(),
              used.ru_maxrss, WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status));
  return 0;
}
