// SPDX-License-Identifier: GPL-3.0-or-later
//
// The records that one judge has taken, for another one whose reference has said the same so far.
#pragma once

#include <functional>
#include <optional>
#include <variant>
#include <vector>

#include "oracle/judge/program_input.hpp"
#include "reference/profile.hpp"
#include "reference/record.hpp"

namespace gonogo::oracle {

// Records in their order. Those that are the reference's own take no memory: it is asked for them
// again.
class RecordLog {
 public:
  void add(const reference::Record& record) { parts_.emplace_back(record); }
  // The reference's own item of that number, counted from 1, to which no open path leads. `named`:
  // as the subject put it; null: not known, and without a clause.
  void add_own(std::size_t item, const reference::Record* named);

  // What takes memory: records of others, and runs of the reference's own.
  std::size_t parts() const { return parts_.size(); }

  // Hands all of them out. `profile`: that of the reference so far.
  void replay(const reference::Profile& profile, const ProgramText& program,
              const std::function<void(const reference::Record&)>& take) const;

 private:
  // Items one behind the other. Only of the last does it matter how the subject put it.
  struct Run {
    std::size_t first;
    std::size_t last;
    std::optional<reference::Record> named;
  };
  std::vector<std::variant<Run, reference::Record>> parts_;
};

}  // namespace gonogo::oracle
