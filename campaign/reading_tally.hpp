// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which combinations of open readings explain all passes of a campaign.
#pragma once

#include <map>
#include <optional>
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
  std::string known;  // why it is known to contradict the others: the reason; empty: it is not
};
// Why no assignment explains a case and those before it.
struct ReadingConflict {
  std::string message;  // a sentence, which names the alternatives
  std::string against;  // the case that showed the other one; empty: several did together
};
// Nothing when no reading was open.
std::optional<OpenReadings> open_readings(const SessionVerdict& session);

// Its memory grows with the number of different sets of assignments, not with that of the cases.
class ReadingTally {
 public:
  // Takes a passed case. A conflict when no assignment is left that explains this case and all
  // before; the case is then left out.
  std::optional<ReadingConflict> add(const std::string& id, const OpenReadings& readings);
  // "gsk.pocket.end=initial gsk.x-depth=radius", sorted; empty when no reading was open.
  std::vector<std::string> texts() const;

 private:
  // Reading -> alternative, of those that were open somewhere.
  using Assignment = std::map<std::string, std::string>;
  static constexpr std::size_t kMost = 4'096;
  static Assignment parsed(const std::string& text);
  // Reading -> the alternatives that explain a case, of those that it always needs.
  using Shown = std::map<std::string, std::set<std::string>>;
  static Shown shown_by(const std::vector<Assignment>& choices);
  ReadingConflict conflict(const Shown& shown) const;

  std::vector<Assignment> left_ = {{}};
  // Reading -> alternatives -> the first case that they explain.
  std::map<std::string, std::map<std::set<std::string>, std::string>> shown_;
  std::set<std::vector<std::string>> taken_;  // what a second time would change nothing
};

}  // namespace gonogo::oracle
