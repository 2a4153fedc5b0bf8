// SPDX-License-Identifier: GPL-3.0-or-later
//
// A long hunt, in rounds. A round depends on the folder alone, and is written as a whole: an
// interrupted round is done again, and the findings are those of a hunt without interruption.
// Shard I of N does its own rounds, in its own folder.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "campaign/results_lock.hpp"
#include "fuzz/hunt/campaign_state.hpp"
#include "fuzz/hunt/finding_files.hpp"

namespace gonogo::hunt {

class HuntCampaign {
 public:
  // Continues the hunt in `folder`, or begins one. Throws std::invalid_argument where what lies
  // there is another hunt (its message says what differs) or cannot be read,
  // oracle::ResultsRefused where another process hunts there, oracle::SubjectUnusable.
  HuntCampaign(std::string folder, CampaignState wanted, SubjectMaker maker, TrialOptions trial,
               HuntOptions options, std::string gonogo);

  // Gets each new finding, reduced and written, with its id.
  using Tell = std::function<void(const Finding&, const std::string& id)>;
  // Is asked before each program; false ends the round, of which nothing counts except the files
  // of its findings.
  using GoOn = std::function<bool(const Hunt&)>;
  // One round: what became of its programs; nothing where it was interrupted. Throws
  // oracle::SubjectUnusable, std::system_error.
  std::optional<HuntCount> round(const Tell& tell, const GoOn& go_on);

  const CampaignState& state() const { return state_; }

 private:
  void keep(const Hunt& hunt);

  std::string folder_;
  std::unique_ptr<oracle::ResultsLock> lock_;  // of the folder's state
  CampaignState state_;
  SubjectMaker maker_;
  TrialOptions trial_;
  HuntOptions options_;
  std::string gonogo_;
};

}  // namespace gonogo::hunt
