// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/corpus/recheck.hpp"

namespace gonogo::oracle {

std::optional<std::string> recheck(const Case& test) {
  for (const Expectation& expected : test.expect) {
    reference::Profile profile = test.profile;
    for (const auto& [reading, value] : expected.when) {
      if (auto error = reference::set_reading(profile, reading, value)) return error->message;
    }
    Expectation now = expectation_of(profile, test.program);
    now.when = expected.when;
    if (expectation_json(now) != expectation_json(expected)) {
      return "The reference says otherwise: " + expectation_json(now);
    }
  }
  return std::nullopt;
}

}  // namespace gonogo::oracle
