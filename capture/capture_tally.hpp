// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a campaign over recorded output reports beside its verdicts: how noisy its samples are, from
// which tolerance on its cases are GO, and which files and cases have no partner. A function
// of the lines of the results and of the names in the folder.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "reference/axis.hpp"

namespace gonogo::oracle {

class CaptureTally {
 public:
  // A case line of the results.
  void take(const std::string& line);
  // The smallest of 1, 2, 5, 10, ... by 1e-4 mm that is at least 1.5 times the noise, and at which
  // nine of ten cases are GO, except those that no tolerance decides; nothing when there is none up
  // to 1 mm.
  std::optional<reference::Number> suggested_tolerance() const;
  // Sentences for people, each a line; empty when no case was judged from samples.
  std::string text() const;
  // Files of the folder that belong to no case, and cases that no file belongs to. `is_case`: of
  // the whole corpus; it is asked only for what is left.
  std::string files_text(const std::string& folder, const std::string& manifest,
                         const std::function<std::set<std::string>()>& all_cases) const;

 private:
  std::size_t go_at(const reference::Number& tolerance) const;
  std::vector<reference::Number> go_from_;  // of GO cases: the worst deviation
  std::size_t never_ = 0;                   // departs at any tolerance
  std::size_t too_fine_ = 0;                // the tolerance is below the noise
  reference::Number noise_ = 0;
  reference::Number following_ = 0;
  reference::Number longest_ = 0;  // s, between two samples
  reference::Number unseen_ = 0;   // mm
  std::size_t with_holes_ = 0;
  reference::Number worst_ = 0;
  std::string worst_where_;
  std::set<std::string> judged_;
  std::set<std::string> missing_;  // skipped for want of a file
};

}  // namespace gonogo::oracle
