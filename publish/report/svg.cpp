// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/report/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "publish/report/escape.hpp"

namespace gonogo::oracle::report::svg {
namespace {

void append_number(std::string& out, double value) {
  const auto hundredths = std::llround(std::clamp(value, -1e9, 1e9) * 100);
  if (hundredths < 0) out += '-';
  const long long magnitude = std::llabs(hundredths);
  out += std::to_string(magnitude / 100);
  const long long rest = magnitude % 100;
  if (rest == 0) return;
  out += '.';
  out += static_cast<char>('0' + rest / 10);
  if (rest % 10 != 0) out += static_cast<char>('0' + rest % 10);
}

void append_point(std::string& out, char command, SheetPoint point) {
  out += command;
  append_number(out, point.x);
  out += ' ';
  append_number(out, point.y);
}

}  // namespace

std::string number(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

void append_line(std::string& out, SheetPoint from, SheetPoint to) {
  append_point(out, 'M', from);
  append_point(out, 'L', to);
}

void append_text(std::string& out, SheetPoint at, std::string_view css_class,
                 std::string_view content, std::string_view attributes) {
  out += fmt::format("<text x=\"{}\" y=\"{}\" class=\"{}\" {}>{}</text>\n", number(at.x),
                     number(at.y), css_class, attributes, markup_text(content));
}

namespace {

double distance_to_segment(SheetPoint point, SheetPoint from, SheetPoint to) {
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const double length = dx * dx + dy * dy;
  const double along = (point.x - from.x) * dx + (point.y - from.y) * dy;
  const double share = length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0.0;
  return std::hypot(from.x + share * dx - point.x, from.y + share * dy - point.y);
}

// Whether the points between two of them lie on their chord, as far as anybody sees.
bool is_flat(const std::vector<SheetPoint>& points, std::size_t from, std::size_t to) {
  constexpr double kVisible = 0.05;
  for (std::size_t i = from + 1; i < to; ++i) {
    if (distance_to_segment(points[i], points[from], points[to]) > kVisible) return false;
  }
  return true;
}

}  // namespace

void append_subpath(std::string& out, const View& view, const std::vector<Point3>& points) {
  constexpr std::size_t kMostLeftOut = 64;
  std::vector<SheetPoint> places;
  places.reserve(points.size());
  for (const Point3& point : points) places.push_back(view.place(point));
  append_point(out, 'M', places.front());
  std::size_t kept = 0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const bool end = i + 1 == places.size();
    if (!end && i - kept < kMostLeftOut && is_flat(places, kept, i + 1)) continue;
    append_point(out, 'L', places[i]);
    kept = i;
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
