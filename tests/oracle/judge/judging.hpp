// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/judge/judge_session.hpp"

namespace gonogo::oracle {

// What the subject declares and the certifier grants.
struct Judging {
  // "k=v"; what the default profile leaves open is as `expand` shows it. Empty: none.
  std::string reading = {};
  bool blocks = true;
  bool m = false;
  std::string chord = {};       // mm
  std::string resolution = {};  // declared, mm
  bool binary64 = false;
  std::string_view dialect = "gsk988ta";
  std::string tool = {};       // radius of tool 1, mm
  std::string tolerance = {};  // granted, mm
  bool strict = false;
  bool exact = false;  // it says that none of its numbers is rounded
};

// A trace in JSON lines, judged under the default profile with one reading changed ("k=v") or none.
// An alarm record closes it.
Verdict judge_trace(std::string_view program, std::string_view trace, const Judging& judging);
Verdict judge_trace(std::string_view program, std::string_view trace,
                    std::string_view reading = {});

// The record of a G00 X130 Z5 in line 1, where X is a diameter.
inline const std::string kRapidToStart = R"({"k":"rapid","b":1,"to":{"x":"65","z":"5"}})"
                                         "\n";

// A trace in the making. Coordinates by axis letter; numbers are written with nine decimals.
struct AxisTo {
  char axis;
  double value;
};
class TraceText {
 public:
  explicit TraceText(int block, double feed = 0) : block_(block), feed_(feed) {}
  TraceText& rapid(std::initializer_list<AxisTo> to);
  TraceText& feed(std::initializer_list<AxisTo> to);
  TraceText& arc(std::string_view plane, std::initializer_list<AxisTo> centre, int rot,
                 std::initializer_list<AxisTo> to);
  TraceText& line(std::string_view json);
  TraceText& block(int block, double feed);
  // Ends and centres from here on as a controller with so many decimals writes them.
  TraceText& decimals(int count);
  const std::string& text() const { return text_; }

 private:
  std::string axes(std::initializer_list<AxisTo> to) const;
  int block_;
  double feed_;
  int decimals_ = 9;
  std::string text_;
};

}  // namespace gonogo::oracle
