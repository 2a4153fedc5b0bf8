// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/report/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oracle/report/escape.hpp"

namespace gonogo::oracle::report::svg {

void append_number(std::string& out, double value) {
  const auto hundredths = static_cast<long long>(std::llround(std::clamp(value, -1e9, 1e9) * 100));
  if (hundredths < 0) out += '-';
  const long long magnitude = std::llabs(hundredths);
  out += std::to_string(magnitude / 100);
  const long long rest = magnitude % 100;
  if (rest == 0) return;
  out += '.';
  out += static_cast<char>('0' + rest / 10);
  if (rest % 10 != 0) out += static_cast<char>('0' + rest % 10);
}

std::string number(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

namespace {

void append_point(std::string& out, char command, SheetPoint point) {
  out += command;
  append_number(out, point.x);
  out += ' ';
  append_number(out, point.y);
}

}  // namespace

void append_line(std::string& out, SheetPoint from, SheetPoint to) {
  append_point(out, 'M', from);
  append_point(out, 'L', to);
}

void append_text(std::string& out, SheetPoint at, std::string_view css_class,
                 std::string_view content, std::string_view attributes) {
  out += fmt::format("<text x=\"{}\" y=\"{}\" class=\"{}\" {}>{}</text>\n", number(at.x),
                     number(at.y), css_class, attributes, markup_text(content));
}

void append_subpath(std::string& out, const View& view, const std::vector<Point3>& points) {
  constexpr double kQuarter = 0.25;
  SheetPoint last = view.place(points.front());
  append_point(out, 'M', last);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const SheetPoint next = view.place(points[i]);
    const bool end = i + 1 == points.size();
    if (!end && std::hypot(next.x - last.x, next.y - last.y) < kQuarter) continue;
    append_point(out, 'L', next);
    last = next;
  }
}

std::string ranges(const std::vector<std::size_t>& numbers) {
  std::string out;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    if (!out.empty()) out += ' ';
    out += std::to_string(numbers[i]);
    if (last > i) out += '-' + std::to_string(numbers[last]);
    i = last + 1;
  }
  return out;
}

double nice_step(double least) {
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least) return factor * power;
  }
  return 10 * power;
}

std::string step_label(double value, double step) {
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  std::string text = fmt::format("{:.{}f}", value, decimals);
  const bool zero = text.find_first_not_of("-0.") == std::string::npos;
  if (text.front() == '-') text = zero ? text.substr(1) : "\xE2\x88\x92" + text.substr(1);
  return text;
}

}  // namespace gonogo::oracle::report::svg
