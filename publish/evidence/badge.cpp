// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/badge.hpp"

#include "campaign/encoding.hpp"
#include "oracle/records/text.hpp"
#include "publish/report/case_paths.hpp"
#include "publish/report/json_value.hpp"

namespace gonogo::oracle::evidence {

// Green is a whole corpus under the subject's own numbers alone (J-RUN-01).
std::string badge_json(const RunState& state) {
  const Json& headline = state.summary["headline"];
  std::string colour = "yellow";
  if (state.decision == "GO") {
    colour = headline["whole"] == true ? "brightgreen" : "yellowgreen";
  } else if (state.decision == "NO-GO") {
    colour = "red";
  }
  return dump({{"schemaVersion", 1},
               {"label", "gonogo"},
               {"message", visible(report::text_of(headline, "short"))},
               {"color", colour}}) +
         "\n";
}

}  // namespace gonogo::oracle::evidence
