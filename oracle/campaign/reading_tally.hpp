// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which assignments of open readings explain all passes of a campaign.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "oracle/judge/judge_session.hpp"

namespace gonogo::oracle {

// An assignment of the readings that were open somewhere: reading -> alternative.
using Assignment = std::map<reference::ReadingKey, std::string>;

class ReadingTally {
 public:
  // Takes a passed case in: it is explained by any of `session.explaining` over `session.open`.
  // False when no assignment is left that explains it and all before.
  bool add(const SessionVerdict& session);
  // "gsk.pocket.end=initial gsk.x-depth=radius", sorted; empty when no reading was open.
  std::vector<std::string> texts() const;

 private:
  static constexpr std::size_t kMost = 4'096;
  std::vector<Assignment> left_ = {{}};
};

}  // namespace gonogo::oracle
