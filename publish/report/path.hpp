// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exact records as polylines to draw. Together with approximate(), the only place where exact
// numbers become doubles; no verdict depends on them.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "reference/expander.hpp"

namespace gonogo::oracle::report {

// mm, base coordinate system.
struct Point3 {
  double x = 0;
  double y = 0;
  double z = 0;
  // Along a linear axis.
  double& operator[](reference::Axis axis) {
    return axis == reference::Axis::x ? x : axis == reference::Axis::y ? y : z;
  }
  double operator[](reference::Axis axis) const {
    return axis == reference::Axis::x ? x : axis == reference::Axis::y ? y : z;
  }
  friend bool operator==(const Point3&, const Point3&) = default;
};
inline Point3 operator+(const Point3& a, const Point3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Point3 operator-(const Point3& a, const Point3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Point3 operator*(double k, const Point3& a) {
  return {k * a.x, k * a.y, k * a.z};
}
inline double dot(const Point3& a, const Point3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

// A place in double, each coordinate held within +-1e9 mm.
Point3 approximate(const reference::Position& position);

// One record as it is drawn and shown beside the drawing.
struct Motion {
  std::string_view kind;  // that of the record; "alarm", "not-covered"
  bool rapid = false;
  std::uint64_t block = 0;     // source line; 0: not known
  std::string clause;          // id, empty: none
  std::string text;            // the record as JSON, exact numbers
  std::vector<Point3> points;  // at least two when it moves; else where the machine stands
  bool moves() const { return points.size() > 1; }
  bool is_thread() const { return kind == "thread"; }
};

// The points, planes and axes of a cycle under the names that its text gives them.
struct NamedPoint {
  std::string name;  // "A"
  Point3 at;
};
struct NamedPlane {
  std::string name;  // "R plane"
  char axis = 'Z';   // that it stands across
  double at = 0;     // mm
};
struct Names {
  std::uint64_t block = 0;  // source line
  std::vector<NamedPoint> points;
  std::vector<NamedPlane> planes;
  std::map<char, char> axes;  // 'p' -> 'Z'
  bool empty() const { return points.empty() && planes.empty() && axes.empty(); }
};

struct Path {
  std::vector<Motion> motions;    // one a record, in order
  std::vector<Names> names = {};  // of the cycles that are run, in order
  bool cut = false;               // more records or segments than are drawn

  // Whether the program's end is among the records.
  bool is_ended() const {
    return !motions.empty() && (motions.back().kind == "end" || motions.back().kind == "alarm");
  }
};

inline constexpr std::size_t kMaxRecords = 20'000;
inline constexpr std::size_t kMaxSegments = 20'000;

// Samples records one by one. Lines become one segment, arcs, helices and circles in space 128 a
// turn, the radius of an arc linear in its angle.
class PathSampler {
 public:
  explicit PathSampler(const reference::Position& start, std::size_t max_segments = kMaxSegments);

  // `text` is shown beside the motion; empty: the record's own JSON. False when the limits are
  // reached; the record is then left out and the path is cut.
  bool add(const reference::Record& record, std::string text = {});
  // What ends a program without being a record: no geometry.
  void add_end(std::string_view kind, std::uint64_t block, std::string_view clause,
               std::string text);
  // The position gets a new name; nothing is drawn.
  void rename(const reference::Position& shift);
  // What a cycle calls its places; one place with several names has them together.
  void add_names(std::uint64_t block, const reference::CyclePlaces& places);
  void mark_cut() { path_.cut = true; }
  Path take() { return std::move(path_); }

 private:
  std::vector<Point3> sample(const reference::Record& record, const Point3& to) const;

  Path path_;
  reference::Position at_;
  Point3 here_;
  std::size_t segments_left_;
};

// For the cycle that one block runs; 0: for the first one.
Names names_in(const Path& path, std::uint64_t block);

}  // namespace gonogo::oracle::report
