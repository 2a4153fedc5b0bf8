// SPDX-License-Identifier: GPL-3.0-or-later
//
// Axis positions sampled on a machine, from CSV: a header line that names the columns, then a line
// for each sample, perhaps an alarm last.
//
//   t,x,z,f,line          t or time: seconds; x y z: mm as true lengths (X of a lathe is a radius);
//   0,50,5,0,1            a c: degrees. Optional: f (feed as the machine shows it, not judged),
//   0.004,49.9,5,,1       block or line (source line of the program that was run), alarm.
//   alarm,PS0061,3        what ends a program that alarms: class or the machine's own name, line
//
// Other names and units: sample_columns.hpp. Every number is an exact decimal and never passes
// through binary floating point. Empty lines are skipped; CR LF and a byte order mark
// are accepted; so are lines without a time, each of which makes a hole. The first line shows what
// separates: a semicolon where it has one, else a tab, else the comma; where the comma does not
// separate, it may stand for the point of a decimal.
#pragma once

#include <array>
#include <cstdint>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "capture/sample_columns.hpp"
#include "oracle/records/subject_outcome.hpp"

namespace gonogo::oracle {

struct Sample {
  Number time;              // s
  reference::Position at;   // axes without a column keep what was there
  std::uint64_t block = 0;  // 0: not given
  std::uint64_t line = 0;   // of the file, from 1
  std::size_t number = 0;   // from 0
  bool after_hole = false;  // samples whose time is missing stand before it
};

// The file cannot be read as samples: file, line, column and a sentence.
class SampleFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class SampleReader {
 public:
  // Reads the header line: the first line, or, where columns are named, the first that has the
  // column of the time. Throws SampleFault.
  explicit SampleReader(const std::string& path, const SampleColumns& columns = {});
  // The next sample; false after the last one. Throws SampleFault.
  bool next(Sample& sample);
  // After the last sample: whether others without a time follow it.
  bool ends_in_hole() const { return after_hole_; }
  // ... the alarm that closed the file.
  const std::optional<SubjectAlarm>& alarm() const { return alarm_; }
  // The axes that have a column.
  reference::AxisSet axes() const { return axes_; }
  // Decimals with which times were written so far.
  int time_decimals() const { return time_decimals_; }

 private:
  bool next_line();
  bool lacks_time() const;
  void split();
  void find_separator();
  bool is_header(const SampleColumns& columns) const;
  void read_header(const SampleColumns& columns);
  SampleColumn column_of(const std::string& cell, std::size_t place) const;
  void read_row(Sample& sample);
  void read_alarm_row();
  void set_alarm(const std::string& name, std::size_t column);
  std::string decimal_at(std::size_t column) const;
  Number number_at(std::size_t column) const;
  std::uint64_t line_number_at(std::size_t column) const;
  [[noreturn]] void fail(std::size_t column, const std::string& sentence) const;

  std::string path_;
  std::ifstream file_;
  std::string text_;
  std::vector<std::string> cells_;
  std::vector<SampleColumn> columns_;
  char separator_ = ',';
  reference::AxisSet axes_;
  std::uint64_t line_ = 0;
  std::size_t samples_ = 0;
  bool after_hole_ = false;
  std::optional<Number> last_time_;
  std::optional<SubjectAlarm> alarm_;
  int time_decimals_ = 0;
};

}  // namespace gonogo::oracle
