// SPDX-License-Identifier: GPL-3.0-or-later
//
// The records that judges have taken, for another one.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "oracle/steps/program_input.hpp"
#include "reference/profile.hpp"
#include "reference/record.hpp"

namespace gonogo::oracle {

// Records in their order. Those that are the reference's own take no memory: it is asked for them
// again.
class RecordLog {
 public:
  void add(const reference::Record& record) { parts_.emplace_back(record); }
  // The item of that number, counted from 1, of the reference under `profile`, to which no open
  // path leads. `named`: as the subject put it; null: not known, and without a clause.
  void add_own(const std::shared_ptr<const reference::Profile>& profile, std::size_t item,
               const reference::Record* named);

  // What takes memory: records of others, and runs of the reference's own.
  std::size_t parts() const { return parts_.size(); }

  // Hands them out until `take` says false.
  void replay(const ProgramText& program,
              const std::function<bool(const reference::Record&)>& take) const;

 private:
  // Items in a row. How the subject put them matters only for the last.
  struct Run {
    std::shared_ptr<const reference::Profile> profile;
    std::size_t first;
    std::size_t last;
    std::optional<reference::Record> named;
  };
  std::vector<std::variant<Run, reference::Record>> parts_;
};

}  // namespace gonogo::oracle
