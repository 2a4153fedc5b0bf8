// SPDX-License-Identifier: GPL-3.0-or-later
//
// Speed of the grammar: blocks and bytes a second, on one thread.
#include <benchmark/benchmark.h>

#include <string>
#include <string_view>

#include "grammar/line_source.hpp"
#include "grammar/parser.hpp"

namespace gonogo::grammar {
namespace {

void parse_line(benchmark::State& state, std::string_view line) {
  Block block;
  for (auto _ : state) {
    auto error = parse_block(Dialect::gsk988ta, line, block);
    benchmark::DoNotOptimize(error);
    benchmark::DoNotOptimize(block.words.data());
  }
  state.SetItemsProcessed(state.iterations());
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(line.size()));
}
BENCHMARK_CAPTURE(parse_line, straight_cut, "N10 G01 X12.345 Z-6.789 F200");
BENCHMARK_CAPTURE(parse_line, short_block, "X96 R-20;");
BENCHMARK_CAPTURE(parse_line, pocket, "N110 G110 X50 Z50 Y20 R-5 I16 L3 Q5 P1 D4 F800");
BENCHMARK_CAPTURE(parse_line, long_comment, "G1 X1 (finishing pass of the outer contour)");
BENCHMARK_CAPTURE(parse_line, bad_line, "N10 G01 X12.345 Z F200");

void read_program(benchmark::State& state, Dialect dialect, const std::string& line) {
  std::string program;
  for (int i = 0; i < 10000; ++i) program += line;
  Block block;
  for (auto _ : state) {
    MemorySource bytes(program);
    LineSource lines(bytes);
    for (Line next; lines.next(next);) {
      auto error = parse_block(dialect, next.text, block);
      benchmark::DoNotOptimize(error);
    }
  }
  state.SetItemsProcessed(state.iterations() * 10000);
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(program.size()));
}
constexpr char kPlain[] = "N10 G01 X12.345 Z-6.789 F200\n";
BENCHMARK_CAPTURE(read_program, gsk988ta, Dialect::gsk988ta, kPlain);
BENCHMARK_CAPTURE(read_program, hnc21t, Dialect::hnc21t, kPlain);
BENCHMARK_CAPTURE(read_program, rs274, Dialect::rs274, kPlain);
BENCHMARK_CAPTURE(read_program, sinumerik, Dialect::sinumerik, kPlain);
// What the filter for plain blocks leaves to the grammars.
BENCHMARK_CAPTURE(read_program, gsk988ta_comment, Dialect::gsk988ta,
                  "N10 G01 X12.345 Z-6.789 F200 (finish)\n");
BENCHMARK_CAPTURE(read_program, sinumerik_names, Dialect::sinumerik,
                  "N10 G2 X12.345 Y-6.789 CR=20.5\n");
BENCHMARK_CAPTURE(read_program, sinumerik_expressions, Dialect::sinumerik,
                  "N10 X=R1+2*R2 Y=IC(SIN(30)*R3)\n");

}  // namespace
}  // namespace gonogo::grammar

BENCHMARK_MAIN();
