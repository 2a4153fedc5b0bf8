// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a run differs from one of a whole corpus under the subject's own numbers.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "oracle/records/fresh_counts.hpp"
#include "oracle/records/subject_outcome.hpp"

namespace gonogo::oracle {

struct RunConditions {
  std::vector<std::string> granted;  // by the certifier: "tolerance 1000 mm"
  std::vector<std::string> part;     // of the cases of the dialects: "shard 1/300"
  struct NotCompared {
    std::string what;    // "M functions"
    std::string beside;  // " (g74, g84 of rs274 pass some on themselves)"; or empty
  };
  std::vector<NotCompared> not_compared;
  bool strict = false;
  std::string sandbox;               // of a subject that is a process: "bubblewrap", "none"
  std::uint64_t seed = 0;            // of the order of the cases; 0: there is none
  std::optional<FreshCounts> fresh;  // programs beside the cases; nothing: the footer does not say

  // None, or strictness alone, which grants nothing.
  bool are_none() const { return granted.empty() && part.empty() && not_compared.empty(); }
  // "; granted: tolerance 1000 mm; a part: shard 1/300; not compared: M functions"; or empty.
  std::string text() const;
  // "tolerance 1000 mm, shard 1/300, without M functions"; or empty.
  std::string short_text() const;
};

// For the header of a results file, and its footer where there is one.
RunConditions conditions_of(const nlohmann::ordered_json& header,
                            const nlohmann::ordered_json& footer = {});

// The dialects and features that the subject declares, as the header of a results file has them.
// Nothing: a header of format 1 may not say.
std::optional<SubjectInfo> declared_in(const nlohmann::ordered_json& header);

}  // namespace gonogo::oracle
