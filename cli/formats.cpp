// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/formats.hpp"

#include <fmt/format.h>

#include <optional>

#include "publish/manual/motion_text.hpp"
#include "reference/outcome_text.hpp"

namespace gonogo::cli {
namespace {

using oracle::manual::capital;
using oracle::manual::point_text;
using oracle::manual::shown_number;
using reference::Record;
using reference::RecordKind;

class JsonLines : public RecordFormat {
 public:
  void record(const Record& record, std::string& out) override {
    append_json(record, out);
    out += '\n';
  }
  void alarm(const reference::AlarmReport& report, std::string& out) override {
    append_json(report, out);
    out += '\n';
  }
  void not_covered(const reference::NotCovered& outside, std::string& out) override {
    append_json(outside, out);
    out += '\n';
  }
};

std::string end_point(const Record& record) {
  return point_text(record.to, record.axes);
}

class Table : public RecordFormat {
 public:
  void record(const Record& record, std::string& out) override {
    if (!headed_) {
      out += fmt::format("{:>6}  {:<6} {:<36} {:<30} {:<12} {}\n", "line", "motion",
                         "to (mm, X as radius)", "centre, turns; lead, start", "feed", "clause");
      headed_ = true;
    }
    std::string line = record.block != 0 ? std::to_string(record.block) : std::string("-");
    std::string what = end_point(record);
    std::string detail;
    if (record.kind == RecordKind::arc) {
      const reference::PlaneAxes axes = reference::axes_of(record.plane);
      detail = fmt::format("{}{} {}{} {:+d}", capital(axes.p), shown_number(record.centre[0]),
                           capital(axes.q), shown_number(record.centre[1]), record.rot);
    }
    if (record.kind == RecordKind::arc3) detail = "via " + point_text(record.via, record.via_axes);
    if (record.kind == RecordKind::thread) {
      detail = fmt::format("lead {} mm, start {} deg", shown_number(record.lead),
                           shown_number(record.start));
    }
    if (record.kind == RecordKind::dwell) what = fmt::format("{} s", shown_number(record.seconds));
    if (record.kind == RecordKind::m) what = fmt::format("M{}", record.m);
    std::string feed;
    if (record.kind == RecordKind::feed || record.kind == RecordKind::arc ||
        record.kind == RecordKind::arc3) {
      feed = shown_number(record.feed);
      if (record.feed_mode == reference::FeedMode::per_revolution) feed += "/rev";
    }
    out += fmt::format("{:>6}  {:<6} {:<36} {:<30} {:<12} {}\n", line, name(record.kind), what,
                       detail, feed, reference::clause_name(record.clause));
  }
  void alarm(const reference::AlarmReport& report, std::string& out) override {
    const reference::Alarm& first = report.alarms.front();
    out += fmt::format("{:>6}  alarm  {} ({})\n", report.block, reference::name(first.alarm),
                       reference::clause_name(first.clause));
  }
  void not_covered(const reference::NotCovered& outside, std::string& out) override {
    const bool lacks = !outside.lacks.empty();
    out +=
        fmt::format("{:>6}  {}: {}\n", outside.block, lacks ? "the profile lacks" : "not covered",
                    lacks ? outside.lacks : outside.code);
  }

 private:
  bool headed_ = false;
};

// Plain codes that any control reads: absolute, millimetres, X as a radius.
class PlainCodes : public RecordFormat {
 public:
  void record(const Record& record, std::string& out) override {
    if (!headed_) {
      out += "G21 G90\n";
      headed_ = true;
    }
    switch (record.kind) {
      case RecordKind::rapid:
        out += fmt::format("G00 {}\n", end_point(record));
        break;
      case RecordKind::feed:
        out += fmt::format("{}G01 {} F{}\n", feed_mode(record), end_point(record),
                           shown_number(record.feed));
        break;
      case RecordKind::arc:
        arc(record, out);
        break;
      case RecordKind::dwell:
        out += fmt::format("G04 P{}\n", shown_number(record.seconds));
        break;
      case RecordKind::m:
        ended_ = ended_ || record.m == 2 || record.m == 30;
        out += fmt::format("M{}\n", record.m);
        break;
      default:
        break;
    }
    for (reference::Axis axis : reference::kAllAxes) {
      if (record.axes.has(axis)) at_[axis] = record.to[axis];
    }
  }
  void alarm(const reference::AlarmReport& report, std::string& out) override {
    out += fmt::format("(alarm in line {}: {})\n", report.block,
                       reference::name(report.alarms.front().alarm));
  }
  void not_covered(const reference::NotCovered& outside, std::string& out) override {
    out += fmt::format("(line {}: {} is not covered)\n", outside.block, outside.code);
  }
  void finish(std::string& out) override {
    if (!ended_) out += "M30\n";
  }
  explicit PlainCodes(const reference::Position& start) : at_(start) {}

 private:
  std::string feed_mode(const Record& record) {
    if (feed_mode_ == record.feed_mode) return "";
    feed_mode_ = record.feed_mode;
    return record.feed_mode == reference::FeedMode::per_revolution ? "G95\n" : "G94\n";
  }
  void arc(const Record& record, std::string& out) {
    const reference::PlaneAxes axes = reference::axes_of(record.plane);
    out += feed_mode(record);
    if (plane_ != record.plane) out += fmt::format("G{}\n", plane_code(record.plane));
    plane_ = record.plane;
    out += fmt::format("{} {} {}{} {}{} F{}\n", record.rot < 0 ? "G02" : "G03", end_point(record),
                       "IJK"[index(axes.p)], shown_number(record.centre[0] - at_[axes.p]),
                       "IJK"[index(axes.q)], shown_number(record.centre[1] - at_[axes.q]),
                       shown_number(record.feed));
  }

  reference::Position at_;
  std::optional<reference::Plane> plane_;
  std::optional<reference::FeedMode> feed_mode_;
  bool headed_ = false;
  bool ended_ = false;
};

}  // namespace

std::unique_ptr<RecordFormat> make_record_format(std::string_view name,
                                                 const reference::Profile& profile,
                                                 std::string_view program_name,
                                                 std::uint64_t named_block) {
  if (name == "table") return std::make_unique<Table>();
  if (name == "ngc") return std::make_unique<PlainCodes>(profile.initial.at);
  if (name == "svg") return make_svg_format(profile, program_name, named_block);
  return std::make_unique<JsonLines>();
}

}  // namespace gonogo::cli
