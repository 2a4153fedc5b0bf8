// SPDX-License-Identifier: GPL-3.0-or-later
//
// parse_file DIALECT FILE: reads a program line by line, as the reference does, and parses every
// block; nothing else. For tests/bench/table, which measures the process. Exit 1 at the first line
// that is no block.
#include <fcntl.h>

#include <cstdio>
#include <string_view>

#include "grammar/file_source.hpp"
#include "grammar/parser.hpp"

namespace {

using gonogo::grammar::Dialect;

const Dialect* find_dialect(std::string_view name) {
  static constexpr std::string_view kNames[] = {"gsk988ta", "hnc21t", "rs274", "sinumerik"};
  for (const Dialect& dialect : gonogo::grammar::kDialects) {
    if (kNames[static_cast<int>(dialect)] == name) return &dialect;
  }
  return nullptr;
}

}  // namespace

int main(int argc, char** argv) {
  const Dialect* const dialect = argc == 3 ? find_dialect(argv[1]) : nullptr;
  const int file = dialect != nullptr ? ::open(argv[2], O_RDONLY) : -1;
  if (file < 0) {
    std::fprintf(stderr, "usage: %s gsk988ta|hnc21t|rs274|sinumerik FILE\n", argv[0]);
    return 2;
  }
  gonogo::grammar::FileSource bytes(file);
  gonogo::grammar::LineSource lines(bytes);
  gonogo::grammar::Block block;
  std::size_t words = 0;
  for (gonogo::grammar::Line line; lines.next(line);) {
    if (gonogo::grammar::parse_block(*dialect, line.text, block)) {
      std::fprintf(stderr, "line %llu is no block\n", static_cast<unsigned long long>(line.number));
      return 1;
    }
    words += block.words.size() + block.named.size();
  }
  std::printf("%zu words\n", words);
  return 0;
}
