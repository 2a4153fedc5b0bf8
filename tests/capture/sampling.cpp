// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/capture/sampling.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>

namespace gonogo::oracle {
namespace {

// The way at a time of a move that speeds up and slows down evenly; with its whole time.
struct Ramp {
  double length, speed, acceleration;
  double peak() const {
    if (acceleration == 0) return speed;
    return std::min(speed, std::sqrt(length * acceleration));
  }
  double ramp_time() const { return acceleration == 0 ? 0 : peak() / acceleration; }
  double whole() const { return length / peak() + ramp_time(); }
  double way(double time) const {
    const double t1 = ramp_time();
    if (t1 == 0) return speed * time;
    if (time < t1) return acceleration * time * time / 2;
    const double left = whole() - time;
    if (left < t1) return length - acceleration * left * left / 2;
    return peak() * (time - t1 / 2);
  }
};

}  // namespace

void SampledMachine::run(double seconds, const std::function<Point(double)>& place) {
  for (; next_ < now_ + seconds - 1e-12; next_ += interval_) {
    rows_.push_back({next_, place(next_ - now_)});
  }
  now_ += seconds;
  at_ = place(seconds);
}

SampledMachine& SampledMachine::line(Point to, double feed, double acceleration) {
  const Point from = at_;
  const double length = std::hypot(to.x - from.x, to.y - from.y, to.z - from.z);
  if (length == 0) return *this;
  const Ramp ramp{length, feed / 60, acceleration};
  run(ramp.whole(), [=](double time) {
    const double part = ramp.way(time) / length;
    return Point{from.x + part * (to.x - from.x), from.y + part * (to.y - from.y),
                 from.z + part * (to.z - from.z)};
  });
  at_ = to;
  return *this;
}

SampledMachine& SampledMachine::turn(Point centre, double degrees, double feed) {
  const Point from = at_;
  const double radius = std::hypot(from.x - centre.x, from.y - centre.y);
  const double start = std::atan2(from.y - centre.y, from.x - centre.x);
  const double sweep = degrees * std::numbers::pi / 180;
  const double seconds = radius * std::abs(sweep) / (feed / 60);
  run(seconds, [=](double time) {
    const double angle = start + sweep * time / seconds;
    return Point{centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle), from.z};
  });
  return *this;
}

SampledMachine& SampledMachine::stand(double seconds) {
  run(seconds, [at = at_](double) { return at; });
  return *this;
}

const std::vector<SampledMachine::Row>& SampledMachine::rows() {
  if (!closed_) rows_.push_back({next_, at_});
  closed_ = true;
  return rows_;
}

std::string csv_of(const std::vector<SampledMachine::Row>& rows) {
  std::string text = "t,x,y,z\n";
  for (const auto& [time, at] : rows) {
    text += fmt::format("{:.6f},{:.6f},{:.6f},{:.6f}\n", time, at.x, at.y, at.z);
  }
  return text;
}

std::string SampledMachine::csv() {
  return csv_of(rows());
}

Verdict judge_samples(const SampledCase& test, const std::string& csv) {
  const TemporaryFile file(csv);
  const auto profile =
      std::get<reference::Profile>(reference::default_profile(std::string(test.dialect)));
  Grants grants;
  if (!test.tolerance.empty()) grants.tolerance = Number::parse(test.tolerance);
  const Tolerances tolerances = make_tolerances({}, profile, grants);
  SampledTolerances sampled;
  sampled.header_lines = test.header_lines;
  sampled.feed_tolerance = *Number::parse(test.feed_tolerance);
  sampled.blend = *Number::parse(test.blend);
  if (const auto fault = read_columns(test.columns, sampled.columns)) throw SampleFault(*fault);
  RunEnd end = check_samples(file.path(), sampled);
  if (end.alarm.block > test.header_lines) end.alarm.block -= test.header_lines;
  end.sampled = std::make_shared<const CapturedSamples>(file.path(), sampled);
  return judge_outcome(profile, test.program, tolerances, std::span<const Record>(), end).verdict;
}

TemporaryFile::TemporaryFile(std::string_view text) {
  path_ = "/tmp/gonogo-samples-XXXXXX";
  const int descriptor = ::mkstemp(path_.data());
  if (descriptor >= 0) ::close(descriptor);
  std::ofstream(path_, std::ios::binary) << text;
}

TemporaryFile::~TemporaryFile() {
  std::remove(path_.c_str());
}

}  // namespace gonogo::oracle
