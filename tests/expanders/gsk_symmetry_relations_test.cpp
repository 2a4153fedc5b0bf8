// SPDX-License-Identifier: GPL-3.0-or-later
// One program of cutting cycles, helical pockets and threads, elsewhere, mirrored, in diameters, in
// increments, and with its repeats written out.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

using Point = std::array<long, 3>;

// How the program is written; lengths are thousandths.
struct Way {
  Point shift = {0, 0, 0};
  std::array<long, 3> sign = {1, 1, 1};
  bool diameter = false;
  bool incremental = false;
  bool spelled_out = false;
  // What the program holds; the same on both sides of a comparison.
  bool pockets = true;
  bool threads = true;
};

long any(long low, long high) {
  // At the full size: a range of size 0 is its lower end.
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high + 1));
}
Point any_point() {
  return {any(-50'000, 50'000), any(-50'000, 50'000), any(-50'000, 50'000)};
}

std::string word(char address, long thousandths) {
  return std::string(" ") + address + millimetres(thousandths);
}

// In G17; valid but for a taper now and then.
struct Work {
  Point start = any_point();
  std::array<Point, 9> ends = {any_point(), any_point(), any_point(), any_point(), any_point(),
                               any_point(), any_point(), any_point(), any_point()};
  std::array<long, 3> taper = {any(-3'000, 3'000), any(-3'000, 3'000), any(-3'000, 3'000)};
  std::array<long, 4> depth = {any(1, 9'000), any(1, 9'000), any(1, 9'000), any(1, 9'000)};
  std::array<long, 4> to_r = {any(0, 5'000), any(0, 5'000), any(0, 5'000), any(0, 5'000)};
  bool clockwise = *rc::gen::arbitrary<bool>();
  bool internal = *rc::gen::arbitrary<bool>();
  long turns = any(1, 9);
  long tool = any(1'000, 5'000);
  long radius = tool + any(1, 9'000);
  long height = any(1, tool);
  long infeed = height / 4 + any(1, height);
  long lead = any(1'000, 9'000);
  long run_out = any(0, 6'000);
  long angle = any(0, 360'000);

  std::string text(const Way& way) const {
    std::string program = "G17 G0" + to(way, start, start, true, 3) + "\n";
    for (std::size_t i = 0; i < 3; ++i) program += cut(way, i);
    if (way.pockets) program += pockets(way);
    if (way.threads) program += threads(way);
    return program;
  }

 private:
  // Axis words of the first `axes` axes; a depth increment counts from `from`.
  static std::string to(const Way& way, const Point& end, const Point& from, bool absolute,
                        std::size_t axes) {
    std::string words;
    for (std::size_t i = 0; i < axes; ++i) {
      const bool increment = way.incremental && !absolute;
      long value = way.sign[i] * (increment ? end[i] - from[i] : end[i]);
      if (!increment) value += way.shift[i];
      words += word((increment ? "UVW" : "XYZ")[i], value * (way.diameter && i == 0 ? 2 : 1));
    }
    return words;
  }

  // G94, G90 and G92: the repeat changes X alone.
  std::string cut(const Way& way, std::size_t i) const {
    const std::string code = i == 0 ? "G94" : i == 1 ? "G90" : "G92";
    const std::string r = word('R', taper[i] * (i == 0 ? way.sign[0] : way.sign[1]));
    const Point next = {ends[i + 3][0], ends[i][1], 0};
    return code + to(way, ends[i], start, false, 2) + r + " F2\n" +
           (way.spelled_out ? code + to(way, next, start, false, 2) + r + " F2"
                            : to(way, next, start, false, 1)) +
           "\n";
  }

  // Words of a site: centre, bottom and R.
  std::string site(const Way& way, std::size_t i, const Point& from, bool absolute) const {
    const long r_plane = start[2] - to_r[i];
    const Point end = {ends[i][0], ends[i][1], r_plane - depth[i]};
    const std::string plane = to(way, end, from, absolute, 2);
    const std::string all = to(way, end, {0, 0, r_plane}, false, 3);
    return plane + all.substr(all.find(way.incremental ? " W" : " Z")) +
           word('R', -way.sign[2] * to_r[i]);
  }
  // The mirror in one axis of the plane turns the sense.
  std::string code(const Way& way, int even) const {
    const bool even_code = clockwise == (way.sign[0] * way.sign[1] > 0);
    return "G" + std::to_string(even + (even_code ? 0 : 1));
  }

  std::string pockets(const Way& way) const {
    const std::string retained = word('I', radius) + word('D', tool) + " F100";
    return code(way, 112) + site(way, 0, start, false) + retained + " L" + std::to_string(turns) +
           "\n" + (way.spelled_out ? code(way, 112) + retained : "") +
           site(way, 1, ends[0], false) + "\n";
  }
  // From where a thread ends no increment leads to a point of the raster.
  std::string threads(const Way& way) const {
    const std::string words = word('I', lead) + word('J', run_out) + word('K', angle) +
                              word('E', 2 * tool + radius) + word('P', height) + word('Q', infeed) +
                              word('D', tool);
    const std::string mode = code(way, internal ? 116 : 114);
    return mode + site(way, 2, way.pockets ? ends[1] : start, false) + words + "\n" +
           (way.spelled_out ? mode : "") + site(way, 3, ends[2], true) + words + "\n";
  }
};

struct RecordFields {
  std::string kind;
  std::map<std::string, double> fields;  // the centre as ci and cj
};

std::vector<RecordFields> record_fields_of(const Outcome& outcome) {
  std::vector<RecordFields> all;
  for (const std::string& record : outcome.records) {
    std::istringstream text(record);
    RecordFields motion;
    text >> motion.kind;
    for (std::string field; text >> field;) {
      const std::size_t equals = field.find('=');
      const std::string key = field.substr(0, equals);
      const std::string value = field.substr(equals + 1);
      if (key == "c" && value.find(',') != std::string::npos) {
        motion.fields["ci"] = std::stod(value);
        motion.fields["cj"] = std::stod(value.substr(value.find(',') + 1));
      } else {
        motion.fields[key] = std::stod(value);
      }
    }
    all.push_back(motion);
  }
  return all;
}

// What `way` makes of a field of the program as it is.
double changed(const Way& way, const std::string& key, double value) {
  static const std::map<std::string, std::size_t> kAxes = {
      {"x", 0}, {"y", 1}, {"z", 2}, {"ci", 0}, {"cj", 1}};
  if (key == "rot") return value * static_cast<double>(way.sign[0] * way.sign[1]);
  const auto axis = kAxes.find(key);
  if (axis == kAxes.end()) return value;
  return value * static_cast<double>(way.sign[axis->second]) +
         static_cast<double>(way.shift[axis->second]) / 1000;
}

void expect_the_same(const Work& work, const Way& way) {
  Way as_it_is;
  as_it_is.pockets = way.pockets;
  as_it_is.threads = way.threads;
  const Outcome plain = run(work.text(as_it_is), R"({"x_diameter":false})");
  const Outcome other =
      run(work.text(way), way.diameter ? R"({"x_diameter":true})" : R"({"x_diameter":false})");
  RC_TAG(plain.alarm.empty() ? std::string("no alarm") : plain.alarm);
  RC_ASSERT(other.alarm == plain.alarm);
  RC_ASSERT(other.alarm_block == plain.alarm_block);
  RC_ASSERT(other.blocks == plain.blocks);
  const std::vector<RecordFields> want = record_fields_of(plain);
  const std::vector<RecordFields> got = record_fields_of(other);
  RC_ASSERT(got.size() == want.size());
  for (std::size_t i = 0; i < want.size(); ++i) {
    RC_ASSERT(got[i].kind == want[i].kind);
    RC_ASSERT(got[i].fields.size() == want[i].fields.size());
    for (const auto& [key, value] : want[i].fields) {
      const double wanted = changed(way, key, value);
      // A run-out that is almost straight has a far centre.
      RC_ASSERT(std::abs(got[i].fields.at(key) - wanted) <= kNear * (1 + std::abs(wanted) / 1000));
    }
  }
}

RC_GTEST_PROP(GskSymmetry, ATranslatedProgramMovesByTheSameShift, ()) {
  Way way;
  way.shift = any_point();
  expect_the_same(Work(), way);
}

// The side on which a path begins is open (gsk.helix.entry-side, gsk.thread.path) and does not turn
// with the sense: this expander enters pockets along q and threads along p.
RC_GTEST_PROP(GskSymmetry, TheOtherSenseIsTheMirrorImageInQ, ()) {
  Way way;
  way.sign[1] = -1;
  way.pockets = false;
  expect_the_same(Work(), way);
}

RC_GTEST_PROP(GskSymmetry, TheOtherSenseIsTheMirrorImageInP, ()) {
  Way way;
  way.sign[0] = -1;
  way.threads = false;
  expect_the_same(Work(), way);
}

RC_GTEST_PROP(GskSymmetry, ACycleUpwardsIsTheMirrorImageInD, ()) {
  Way way;
  way.sign[2] = -1;
  expect_the_same(Work(), way);
}

RC_GTEST_PROP(GskSymmetry, ADiameterIsTwiceTheRadius, ()) {
  Way way;
  way.diameter = true;
  expect_the_same(Work(), way);
}

RC_GTEST_PROP(GskSymmetry, IncrementsLeadWhereAbsoluteWordsLead, ()) {
  Way way;
  way.incremental = true;
  expect_the_same(Work(), way);
}

RC_GTEST_PROP(GskSymmetry, ARepeatHasTheCodeAndTheRetainedWordsWithoutWritingThem, ()) {
  Way way;
  way.spelled_out = true;
  expect_the_same(Work(), way);
}

}  // namespace
}  // namespace gonogo::expanders::testing
