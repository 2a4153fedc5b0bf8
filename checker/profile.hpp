// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the checker needs to know of a profile, of the open readings and of a program's text.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "checker/corpus.hpp"

namespace gonogo::checker {

// The value of a reading where a profile does not say it; nothing for one that is unknown.
std::optional<std::string_view> default_reading(std::string_view key);
// In force under the profile: what it says, else the default. Throws Fault for an unknown one.
std::string reading(const Json& profile, std::string_view key);
// The same, of an open one what an expectation that does not say its value is made with.
std::string shown_reading(const Json& profile, std::string_view key);
// Whether the expectation is one of those that the profile admits.
bool is_admissible(const Readings& when, const Json& profile);

// The profile's resolution, mm.
Rational resolution(std::string_view dialect, const Json& profile);
// A parameter of the machine; `otherwise` when the profile does not say it.
Rational parameter(const Json& profile, std::string_view name, const Rational& otherwise);
// Where the axes stand at the start.
Position initial_position(const Json& profile);
bool alarms_at_load(const Json& profile);  // alarm_timing = program

// Whether this record is shown for one of many admissible paths.
bool is_open_path(const Record& record, std::string_view dialect, const Json& profile);

long line_count(std::string_view program);
// The first line that has the G code, be it in a comment; 0: none.
long line_of_code(std::string_view program, long code);
// Whether the line says this M function, be it in a comment, or one that has to be calculated.
bool says_m_function(std::string_view program, long line, long number);
// The first line that may rename the position (G50 of GSK, G92 of HNC) without a record; 0: none.
long renaming_line(std::string_view dialect, std::string_view program);
// Whether the program may have loops or subroutines, whose lines come more than once: rs274 with a
// line that begins with an O word, or with M98 or M99.
bool lines_come_again(std::string_view dialect, std::string_view program);

}  // namespace gonogo::checker
