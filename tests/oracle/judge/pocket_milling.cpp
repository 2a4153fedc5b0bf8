// SPDX-License-Identifier: GPL-3.0-or-later
#include "pocket_milling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace gonogo::oracle {
namespace {

Number number(double value) {
  return Number::millionths(std::llround(value * 1e6));
}

}  // namespace

reference::Profile profile_802s(ReadingsOf readings) {
  auto profile = std::get<reference::Profile>(reference::default_profile("sinumerik802s"));
  profile.tools = {{"1", {10, 0}}, {"4", {5, 0}}, {"10", {5, 0}}};
  for (const auto& [name, value] : readings) {
    if (auto error = set_reading(profile, name, value)) throw std::invalid_argument(error->message);
  }
  return profile;
}

Verdict judge_records(std::string_view program, const std::vector<Record>& records,
                      const Judged& judged) {
  SubjectInfo subject;
  if (judged.blocks) subject.features.insert("blocks");
  const Tolerances tolerances = make_tolerances(subject, judged.profile);
  const std::vector<Record> sent = judged.blocks ? records : without_blocks(records);
  return judge_outcome(judged.profile, program, tolerances, sent, RunEnd{}).verdict;
}

std::vector<Record> shown(std::string_view program, const reference::Profile& profile) {
  ProgramInput input(program);
  reference::Expander expander(profile, input.lines, reference::OpenPaths::shown);
  std::vector<Record> records;
  while (const reference::Item* item = expander.next()) {
    const auto* record = std::get_if<Record>(item);
    if (record == nullptr) throw std::invalid_argument("an alarm");
    records.push_back(*record);
  }
  return records;
}

Verdict judge_shown(std::string_view program, const reference::Profile& profile) {
  return judge_records(program, shown(program, profile), {true, profile});
}

std::vector<Record> without_blocks(std::vector<Record> records) {
  for (Record& record : records) record.block = 0;
  return records;
}

std::string Job::program() const {
  return fmt::format(
      "G17 G90 F200 S300 M3 {} D1\nG0 X60 Y40 Z5\n{}{} R104={} R116=60 R117=40\n{} {} R122=120 "
      "R123=300\n{} {}\nLCYC75\nG0 X0 Y0\nM2\n",
      tool, frame, planes, depth, sizes, infeed, allowance, ways);
}

int Job::block() const {
  return 6 + static_cast<int>(std::ranges::count(frame, '\n'));
}

Miller::Miller(const Job& job, double centre_x, double centre_y, double degrees)
    : block_(static_cast<std::uint64_t>(job.block())),
      centre_x_(centre_x),
      centre_y_(centre_y),
      cosine_(std::cos(degrees * std::numbers::pi / 180)),
      sine_(std::sin(degrees * std::numbers::pi / 180)) {}

std::pair<Number, Number> Miller::base(double u, double v) const {
  return {number(centre_x_ + u * cosine_ - v * sine_), number(centre_y_ + u * sine_ + v * cosine_)};
}

Record& Miller::put(RecordKind kind) {
  Record record;
  record.kind = kind;
  record.block = block_;
  if (kind != RecordKind::rapid) record.feed = number(feed_in_plane_);
  records_.push_back(record);
  return records_.back();
}

Miller& Miller::approach() {
  Record& start = put(RecordKind::rapid);
  start.block = 2;
  start.axes = {Axis::x, Axis::y, Axis::z};
  start.to[Axis::x] = 60;
  start.to[Axis::y] = 40;
  start.to[Axis::z] = 5;
  return rapid_in_space(0, 0, 5).rapid_down(2);
}

Miller& Miller::rapid(double u, double v) {
  Record& record = put(RecordKind::rapid);
  record.axes = {Axis::x, Axis::y};
  std::tie(record.to[Axis::x], record.to[Axis::y]) = base(u, v);
  u_ = u;
  v_ = v;
  return *this;
}

Miller& Miller::rapid_in_space(double u, double v, double z) {
  rapid(u, v);
  records_.back().axes.add(Axis::z);
  records_.back().to[Axis::z] = number(z);
  return *this;
}

Miller& Miller::rapid_down(double z) {
  Record& record = put(RecordKind::rapid);
  record.axes = {Axis::z};
  record.to[Axis::z] = number(z);
  return *this;
}

Miller& Miller::plunge(double z) {
  Record& record = put(RecordKind::feed);
  record.axes = {Axis::z};
  record.to[Axis::z] = number(z);
  record.feed = number(feed_down_);
  return *this;
}

Miller& Miller::line(double u, double v) {
  if (u == u_ && v == v_) return *this;
  rapid(u, v);
  records_.back().kind = RecordKind::feed;
  records_.back().feed = number(feed_in_plane_);
  return *this;
}

Miller& Miller::ramp(double u, double v, double z) {
  line(u, v);
  records_.back().axes.add(Axis::z);
  records_.back().to[Axis::z] = number(z);
  records_.back().feed = number(feed_down_);
  return *this;
}

Miller& Miller::arc(double u, double v, double centre_u, double centre_v, int rot) {
  rapid(u, v);
  Record& record = records_.back();
  record.kind = RecordKind::arc;
  record.plane = reference::Plane::g17;
  record.feed = number(feed_in_plane_);
  record.rot = rot;
  std::tie(record.centre[0], record.centre[1]) = base(centre_u, centre_v);
  return *this;
}

Miller& Miller::end() {
  rapid_down(5);
  Record& after = put(RecordKind::rapid);
  after.block = block_ + 1;
  after.axes = {Axis::x, Axis::y};
  return *this;
}

Miller& Miller::feed_down(double feed) {
  feed_down_ = feed;
  return *this;
}

Miller& Miller::feed_in_plane(double feed) {
  feed_in_plane_ = feed;
  return *this;
}

Miller& Miller::round(double a, double b, double r, int sense) {
  const double s = sense;
  line(a, 0);
  line(a, s * (b - r));
  if (r > 0) arc(a - r, s * b, a - r, s * (b - r), sense);
  line(r - a, s * b);
  if (r > 0) arc(-a, s * (b - r), r - a, s * (b - r), sense);
  line(-a, s * (r - b));
  if (r > 0) arc(r - a, -s * b, r - a, s * (r - b), sense);
  line(a - r, -s * b);
  if (r > 0) arc(a, s * (r - b), a - r, s * (r - b), sense);
  return line(a, 0);
}

// Rows 8 mm apart that keep 1 mm from the border.
Miller& Miller::zigzag() {
  double side = 1;
  for (double v = -12; v <= 12; v += 8) {
    line(side * -22, v).line(side * 22, v);
    side = -side;
  }
  return line(22, 0).border().home();
}

// The innermost shape is the line from -10 to 10.
Miller& Miller::contour_parallel() {
  line(-10, 0).line(10, 0);
  round(16.25, 6.25, 0);
  return border().home();
}

// Circles of radius 4, 3 mm on from one another, in rows along the length, one row at -10, 0, 10.
Miller& Miller::trochoidal() {
  for (const double v : {-10.0, 0.0, 10.0}) {
    line(-16, v);
    for (double u = -20; u <= 20; u += 3) {
      line(u + 4, v);
      arc(u + 4, v, u, v, -1);
    }
  }
  return border().home();
}

std::vector<Record> rough(Way way, const Job& job, double centre_x, double centre_y,
                          double degrees) {
  Miller miller(job, centre_x, centre_y, degrees);
  miller.approach();
  for (const double depth : {-3.75, -7.5}) {
    miller.plunge(depth);
    way == Way::zigzag             ? miller.zigzag()
    : way == Way::contour_parallel ? miller.contour_parallel()
                                   : miller.trochoidal();
  }
  return miller.end().records();
}

}  // namespace gonogo::oracle
