// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reduces the folder of a long hunt: programs that show nothing which others do not show go,
// and findings that their programs do not show any more are marked as mended.
#pragma once

#include <string>
#include <vector>

#include "fuzz/hunt/campaign_state.hpp"

namespace gonogo::hunt {

enum class FindingStand {
  stands,     // its program shows it, or departs otherwise
  mended,     // its program is GO
  cannot_say  // it was not judged, or flickers
};

struct TriedFinding {
  Signature signature;
  std::string id;
  FindingStand stand = FindingStand::stands;
};

struct Pruned {
  std::size_t inputs_before = 0;
  std::size_t inputs = 0;    // that stay
  std::size_t features = 0;  // of the reference that they show, as many as before
  std::vector<TriedFinding> findings;
};

// The programs, cheapest to judge first, of which each shows something that those before it do not;
// together they show all that those given show. `features`, if asked for, is how much that is.
std::vector<generate::GeneratedProgram> needed_programs(
    std::vector<generate::GeneratedProgram> programs, std::size_t* features = nullptr);

// One shard's folder, whose subject is tried again on each finding alone. What was mended and is
// shown again stands again. Throws std::runtime_error where the folder has no hunt,
// oracle::SubjectUnusable, std::system_error.
Pruned prune_campaign(const std::string& folder, Trial& trial);

}  // namespace gonogo::hunt
