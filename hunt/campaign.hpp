// SPDX-License-Identifier: GPL-3.0-or-later
//
// A long hunt, in rounds. A round begins from what lies in the folder and nothing else, and is
// written whole: one that was broken off is done again, and the findings are those of a hunt that
// never was. Shard I of N does rounds of its own, in a folder of its own.
#pragma once

#include <functional>
#include <optional>

#include "hunt/campaign_state.hpp"
#include "hunt/finding_files.hpp"

namespace gonogo::hunt {

class HuntCampaign {
 public:
  // Goes on with what lies in `folder`, or begins. Throws std::invalid_argument where what lies
  // there is another hunt (its message says what differs), std::runtime_error where it cannot be
  // read, oracle::SubjectUnusable.
  HuntCampaign(std::string folder, CampaignState wanted, SubjectMaker maker, TrialOptions trial,
               HuntOptions options, std::string gonogo);

  // Is told of each new finding, made small and written, with its id.
  using Tell = std::function<void(const Finding&, const std::string& id)>;
  // Is asked before each program; false breaks the round off, and nothing of it counts but the
  // files of its findings.
  using GoOn = std::function<bool(const Hunt&)>;
  // One round: what became of its programs; nothing where it was broken off. Throws
  // oracle::SubjectUnusable, std::system_error.
  std::optional<HuntCount> round(const Tell& tell, const GoOn& go_on);

  const CampaignState& state() const { return state_; }

 private:
  void keep(const Hunt& hunt);

  std::string folder_;
  CampaignState state_;
  SubjectMaker maker_;
  TrialOptions trial_;
  HuntOptions options_;
  std::string gonogo_;
};

}  // namespace gonogo::hunt
