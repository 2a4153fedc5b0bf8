// SPDX-License-Identifier: GPL-3.0-or-later
//
// The two paths of a case that is not GO: the subject's from the recorded trace, the reference's
// computed again from the program.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <variant>

#include "publish/report/figure.hpp"
#include "publish/report/path.hpp"
#include "reference/profile.hpp"

namespace gonogo::oracle::report {

// Keeps the order of keys, so that records are shown as they were written.
using Json = nlohmann::ordered_json;

// A path, and why it is missing or ends early: a sentence, or empty.
struct DrawnPath {
  Path path;
  std::string note;
};

// The profile that a case was judged under: `profile` holds the keys that differ from the defaults.
std::variant<reference::Profile, std::string> case_profile(const std::string& dialect,
                                                           const Json& profile);

// What the manual fixes where it leaves the path of the program open.
std::vector<Limit> limits_of_program(const reference::Profile& profile, std::string_view program);
DrawnPath reference_path(const reference::Profile& profile, std::string_view program);
DrawnPath subject_path(const reference::Position& start, const Json& trace);

// A point given as a JSON object of axes; `at` lends the axes that it does not name.
std::optional<Point3> read_point(const Json& point, const Point3& at);

}  // namespace gonogo::oracle::report
