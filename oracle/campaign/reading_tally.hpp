// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which assignments of open readings explain all passes of a campaign.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "oracle/judge/judge_session.hpp"

namespace gonogo::oracle {

// The open readings that a passed case touched, and the assignments under which it passes.
struct OpenReadings {
  std::vector<std::string> open;                  // names
  std::vector<std::string> explaining;            // "k=v k=v"; a name that is not there stays open
  VerdictKind verdict = VerdictKind::pass_exact;  // under them
};
// Nothing when no reading was open.
std::optional<OpenReadings> open_readings(const SessionVerdict& session);

// Its memory grows with the number of different sets of assignments, not with that of the cases.
class ReadingTally {
 public:
  // Takes a passed case in. False when no assignment is left that explains it and all before; the
  // case is then left out.
  bool add(const OpenReadings& readings);
  // "gsk.pocket.end=initial gsk.x-depth=radius", sorted; empty when no reading was open.
  std::vector<std::string> texts() const;

 private:
  // Reading -> alternative, of those that were open somewhere.
  using Assignment = std::map<std::string, std::string>;
  static constexpr std::size_t kMost = 4'096;
  static Assignment parsed(const std::string& text);

  std::vector<Assignment> left_ = {{}};
  std::set<std::vector<std::string>> taken_;  // what a second time would change nothing
};

}  // namespace gonogo::oracle
