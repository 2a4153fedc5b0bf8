// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "oracle/subject.hpp"

namespace gonogo::oracle {

// A subject that is a process beside the runs: it may break down where it is told to stop.
class Farewell {
 public:
  virtual ~Farewell() = default;
  // Behind the last run: ends the process. How it broke down in that; nothing: it did not.
  virtual std::optional<RunEnd> finish() = 0;
};

// The same of any subject.
inline std::optional<RunEnd> finish(Subject& subject) {
  auto* const process = dynamic_cast<Farewell*>(&subject);
  return process == nullptr ? std::nullopt : process->finish();
}

}  // namespace gonogo::oracle
