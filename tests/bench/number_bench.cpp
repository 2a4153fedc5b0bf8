// SPDX-License-Identifier: GPL-3.0-or-later
//
// The exact number: the small path, rationals, roots and enclosures.
#include <benchmark/benchmark.h>

#include <string>

#include "reference/exact/number.hpp"

namespace {

using gonogo::exact::Number;

// The two operands of a benchmark by its argument.
std::array<Number, 2> operands(std::int64_t form) {
  switch (form) {
    case 0:
      return {Number::millionths(12'345'000), Number::millionths(2'500'000)};
    case 1:
      return {Number(11) / Number(3), Number(5) / Number(7)};
    case 2:
      return {Number::root(1, 2, 3), Number::root(3, -1, 3)};
    default:
      return {gonogo::exact::cos_sin_degrees(20)[0], gonogo::exact::cos_sin_degrees(31)[0]};
  }
}

template <typename Operation>
void run(benchmark::State& state, Operation operation) {
  auto [a, b] = operands(state.range(0));
  for (auto _ : state) {
    benchmark::DoNotOptimize(a);
    benchmark::DoNotOptimize(b);
    auto result = operation(a, b);
    benchmark::DoNotOptimize(result);
  }
}

void add(benchmark::State& state) {
  run(state, [](const Number& a, const Number& b) { return a + b; });
}
void subtract(benchmark::State& state) {
  run(state, [](const Number& a, const Number& b) { return a - b; });
}
void multiply(benchmark::State& state) {
  run(state, [](const Number& a, const Number& b) { return a * b; });
}
void divide(benchmark::State& state) {
  run(state, [](const Number& a, const Number& b) { return a / b; });
}
void compare(benchmark::State& state) {
  run(state, [](const Number& a, const Number& b) { return Number::compare(a, b); });
}
void copy(benchmark::State& state) {
  run(state, [](const Number& a, const Number&) { return a; });
}
BENCHMARK(add)->DenseRange(0, 3);
BENCHMARK(subtract)->DenseRange(0, 3);
BENCHMARK(multiply)->DenseRange(0, 3);
BENCHMARK(divide)->DenseRange(0, 3);
BENCHMARK(compare)->DenseRange(0, 3);
BENCHMARK(copy)->DenseRange(0, 1);

void write_json(benchmark::State& state) {
  const Number value = operands(state.range(0))[0];
  std::string out;
  for (auto _ : state) {
    out.clear();
    value.append_json(out);
    benchmark::DoNotOptimize(out.data());
  }
}
BENCHMARK(write_json)->DenseRange(0, 3);

void parse(benchmark::State& state, const char* text) {
  std::string_view view = text;
  for (auto _ : state) {
    benchmark::DoNotOptimize(view);
    auto value = Number::parse(view);
    benchmark::DoNotOptimize(value);
  }
}
BENCHMARK_CAPTURE(parse, short_decimal, "-12.345");
BENCHMARK_CAPTURE(parse, whole, "150");
BENCHMARK_CAPTURE(parse, long_decimal, "0.1234567890123456789");
BENCHMARK_CAPTURE(parse, fraction, "11/3");
BENCHMARK_CAPTURE(parse, hex, "0x1.999999999999ap-4");

void root_of_a_square_sum(benchmark::State& state) {
  const Number x = Number::millionths(12'345'678);
  const Number y = Number::millionths(7'654'321);
  for (auto _ : state) {
    auto value = gonogo::exact::sqrt(x * x + y * y);
    benchmark::DoNotOptimize(value);
  }
}
BENCHMARK(root_of_a_square_sum);

void sine_and_cosine(benchmark::State& state) {
  const Number angle = Number::millionths(12'345'678);
  for (auto _ : state) {
    auto value = gonogo::exact::cos_sin_degrees(angle);
    benchmark::DoNotOptimize(value);
  }
}
BENCHMARK(sine_and_cosine);

}  // namespace

BENCHMARK_MAIN();
