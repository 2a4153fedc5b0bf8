// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whole-process throughput of `gonogo expand` with every record written out: how the rate and the
// peak memory grow from 1,000 blocks on.
//   gonogo_expand_bench GONOGO [BLOCKS...]
// Rates are of CPU time on one core, so that a loaded machine shows the same; the last column is
// the rate against that of the smallest program of the same kind. It measures and judges nothing.
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

namespace {

// A straight feed a block; no two alike, so that nothing can be joined or kept.
void write_feeds(std::ostream& out, long blocks) {
  out << "G18 G00 X100 Z5 F200\n";
  for (long i = 1; i < blocks; ++i) {
    out << "G01 X" << (i * 7) % 1999 << '.' << i % 1000 << " Z-" << (i * 13) % 997 << ".25\n";
  }
}

// A taper cycle a block: four records each.
void write_tapers(std::ostream& out, long blocks) {
  out << "G18 G00 X2100 Z5 F200\n";
  for (long i = 1; i < blocks; ++i) {
    out << (i == 1 ? "G94 " : "") << 'X' << (i * 7) % 1999 << " Z-" << 30 + (i * 13) % 997 << " R-"
        << i % 25 << ".5\n";
  }
}

struct Usage {
  double seconds = 0;  // of CPU
  long peak_kib = 0;
  bool worked = false;
};

// Runs `gonogo expand` with its records going to a file, as a user would have them.
Usage expand(const char* gonogo, const std::string& program, const std::string& records) {
  const pid_t child = ::fork();
  if (child == 0) {
    const int out = ::open(records.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::dup2(out, STDOUT_FILENO);
    ::execl(gonogo, gonogo, "expand", program.c_str(), "--dialect", "gsk988ta", nullptr);
    ::_exit(127);
  }
  int status = 0;
  rusage used{};
  ::wait4(child, &status, 0, &used);
  auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
  };
  return {seconds(used.ru_utime) + seconds(used.ru_stime), used.ru_maxrss,
          WIFEXITED(status) && WEXITSTATUS(status) == 0};
}

bool measure(const char* gonogo, const char* title, void (*write)(std::ostream&, long),
             const std::vector<long>& sizes, const std::string& folder) {
  double first_rate = 0;
  for (long blocks : sizes) {
    const std::string program = folder + "/program.nc";
    std::ofstream out(program);
    write(out, blocks);
    out.close();
    const Usage usage = expand(gonogo, program, folder + "/records.jsonl");
    if (!usage.worked) {
      std::fprintf(stderr, "%s expand failed on %ld blocks of %s\n", gonogo, blocks, title);
      return false;
    }
    const double rate = static_cast<double>(blocks) / usage.seconds;
    if (first_rate == 0) first_rate = rate;
    std::printf("%-8s %10ld blocks %9.0f blocks/s %7.1f MiB %6.2f\n", title, blocks, rate,
                static_cast<double>(usage.peak_kib) / 1024, rate / first_rate);
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: %s GONOGO [BLOCKS...]\n", argv[0]);
    return 2;
  }
  std::vector<long> sizes;
  for (int i = 2; i < argc; ++i) sizes.push_back(std::strtol(argv[i], nullptr, 10));
  if (sizes.empty()) sizes = {10'000, 100'000, 1'000'000};
  char folder[] = "/tmp/gonogo-expand-bench-XXXXXX";
  if (::mkdtemp(folder) == nullptr) {
    std::perror(folder);
    return 2;
  }
  const std::string place = folder;
  const bool worked = measure(argv[1], "G01", write_feeds, sizes, place) &&
                      measure(argv[1], "G94", write_tapers, sizes, place);
  for (const char* name : {"/program.nc", "/records.jsonl"}) std::remove((place + name).c_str());
  ::rmdir(folder);
  return worked ? 0 : 1;
}
