// SPDX-License-Identifier: GPL-3.0-or-later
//
// The example programs of the pages: for each section of a manual programs to draw, for each
// reading one in which it matters, for each alarm one that raises it. Kept in examples/*.toml.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gonogo::oracle::manual {

struct Example {
  std::string section;  // Clause::source
  std::string key;      // names its drawing
  std::string title;
  std::string program;
  std::string profile;  // TOML lines without the dialect; empty: the defaults
};

struct ReadingExample {
  std::string name;  // of the reading
  std::string program;
  std::string profile;
  std::vector<std::string> values;  // to try besides the reading's alternatives
};

struct AlarmExample {
  std::string clause;
  std::string alarm;  // its class
  std::string program;
  std::string profile;
};

struct Examples {
  std::string_view dialect;  // whose page shows them
  std::vector<Example> examples;
  std::vector<ReadingExample> readings;
  std::vector<AlarmExample> alarms;
};

// The example files that the page of a dialect shows, one for most dialects. A later dialect that
// shares something with an earlier one refers to the page of that one.
std::vector<Examples> examples_of(std::string_view dialect);

}  // namespace gonogo::oracle::manual
