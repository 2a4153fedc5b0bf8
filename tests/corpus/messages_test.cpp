// SPDX-License-Identifier: GPL-3.0-or-later
//
// What alarms of the corpus say: one that compares values names them.
#include <gtest/gtest.h>

#include <array>
#include <regex>

#include "corpus_testing.hpp"
#include "reference/expander.hpp"

namespace gonogo::testing {
namespace {

using reference::AlarmClass;

std::vector<reference::Alarm> alarms_of(const oracle::Case& test) {
  grammar::MemorySource bytes(test.program);
  grammar::LineSource lines(bytes);
  reference::Expander expander(test.profile, lines, reference::OpenPaths::shown);
  while (const reference::Item* item = expander.next()) {
    if (const auto* report = std::get_if<reference::AlarmReport>(item)) return report->alarms;
  }
  return {};
}

bool compares(AlarmClass alarm) {
  constexpr std::array kComparing = {
      AlarmClass::value_out_of_range,  AlarmClass::value_sign,     AlarmClass::not_an_integer,
      AlarmClass::tool_too_large,      AlarmClass::step_too_large, AlarmClass::depth_exceeds_tool,
      AlarmClass::taper_limit,         AlarmClass::retract_ratio,  AlarmClass::reference_plane,
      AlarmClass::allowance_too_large, AlarmClass::pocket_size,    AlarmClass::machining_type,
      AlarmClass::direction_parameter, AlarmClass::arc_end_point,  AlarmClass::arc_radius};
  return std::ranges::find(kComparing, alarm) != kComparing.end();
}

// That an arc has no radius or ends where it starts is no comparison of values.
bool is_of_one_place(const std::string& message) {
  for (const char* const place : {"where it starts", "is zero", "its centre", "is the start",
                                 "has no value"}) {
    if (message.find(place) != std::string::npos) return true;
  }
  return false;
}

// A number that is not the index of a word, as that of R101, of G76 and of #1 is.
bool has_value(const std::string& message) {
  static const std::regex kValue(R"((^|[^A-Za-z0-9_.#])-?[0-9])");
  static const std::regex kWordValue(R"([A-Z][0-9]*=?-?[0-9]*\.?[0-9]+ (has|lies|is)\b)");
  return std::regex_search(message, kValue) || std::regex_search(message, kWordValue);
}

TEST(Messages, OfAlarmsThatCompareNameTheValues) {
  std::size_t seen = 0;
  for (const auto& [id, test] : checked_in_cases()) {
    for (const reference::Alarm& alarm : alarms_of(test)) {
      if (!compares(alarm.alarm) || is_of_one_place(alarm.message)) continue;
      ++seen;
      EXPECT_TRUE(has_value(alarm.message)) << id << ": " << alarm.message;
    }
  }
  EXPECT_GT(seen, 500U);
}

}  // namespace
}  // namespace gonogo::testing
