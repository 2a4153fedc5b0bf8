// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/evidence/badge.hpp"

#include <fmt/format.h>

#include "oracle/evidence/text.hpp"
#include "oracle/report/case_paths.hpp"

namespace gonogo::oracle::evidence {

std::string badge_json(const RunState& state) {
  const Json& headline = state.summary["headline"];
  const auto all = headline["cases"].get<std::size_t>();
  std::string message = fmt::format("{} \xC2\xB7 {} cases", state.decision, grouped(all));
  std::string colour = "yellow";
  if (state.decision == "GO") {
    colour = "brightgreen";
  } else if (state.decision == "NO-GO") {
    colour = "red";
    message = fmt::format("NO-GO \xC2\xB7 {} of {} cases",
                          grouped(headline["noGo"].get<std::size_t>()), grouped(all));
  }
  return report::dump(
             {{"schemaVersion", 1}, {"label", "gonogo"}, {"message", message}, {"color", colour}}) +
         "\n";
}

}  // namespace gonogo::oracle::evidence
